/* The table of sweeps. */
#include "oracle/sweeps.h"

#include <math.h>

#include "oracle/generators.h"

/* clang-format off */
const struct oracle_sweep oracle_sweeps[] = {
        {"distance from light to vertex", generate_distance, 1e-38, 1e38, true, 77},
        {"distance from viewer to vertex", generate_viewer_distance, 1e-38, 1e38, true, 77},
        {"length of normals, GL_NORMALIZE", generate_normalized_normals, 1e-38, 1e38, true, 77},
        {"length of a directional light's vector", generate_direction_length, 1e-38, 1e38, true, 77},
        {"shininess", generate_shininess, 0, 128, false, 65},
        {"degrees from the edge of a cone", generate_near_cone_edge, 1e-8, 10, true, 55},
        {"scale of the modelview matrix, GL_NORMALIZE", generate_uniform_scale, 1e-18, 1e18, true, 73},
        {"condition of the modelview matrix", generate_condition, 1, 1e9, true, 55},
        {"distance of the world from its origin", generate_large_world, 1, 1e7, true, 57},
};
/* clang-format on */

const int oracle_sweep_count = (int)(sizeof oracle_sweeps / sizeof oracle_sweeps[0]);

double oracle_sweep_at(const struct oracle_sweep *sweep, int step)
{
    const double t = (double)step / (sweep->steps - 1);
    return sweep->logarithmic ? sweep->from * pow(sweep->to / sweep->from, t)
                              : sweep->from + t * (sweep->to - sweep->from);
}
