/* Triangles that set-up does not take as they are: polygon modes (GL 1.5, 3.5.4 "Options Controlling Polygon
 * Rasterization"), and filled triangles where OSMesa takes another road.
 *
 * OSMesa rules for this road, which it takes when a face is not filled and also while polygon stipple, line
 * stipple or smooth lines or points are enabled: facing comes from unsnapped window coordinates and a
 * triangle without area counts as back facing when it is culled; polygon offset is added to the vertices,
 * whose z is then clamped to [0,1]. */
#include <math.h>
#include <string.h>

#include "raster/setup.h"

struct corner {
    float lane[LANE_MAX];
};

/* What polygon offset adds to z. Not a number for a triangle without area, even where the mode's offset is
 * disabled. */
static float vertex_offset(const struct raster_plan *plan, const float *const v[3], float det, bool enabled)
{
    const float factor = enabled ? plan->offset_factor : 0.0f;
    const float units = enabled ? plan->offset_units : 0.0f;
    const float ex = v[0][LANE_X] - v[2][LANE_X], ey = v[0][LANE_Y] - v[2][LANE_Y],
                ez = v[0][LANE_Z] - v[2][LANE_Z];
    const float fx = v[1][LANE_X] - v[2][LANE_X], fy = v[1][LANE_Y] - v[2][LANE_Y],
                fz = v[1][LANE_Z] - v[2][LANE_Z];
    const float inv_det = 1.0f / det;
    const float dzdx = fabsf((ey * fz - ez * fy) * inv_det), dzdy = fabsf((ez * fx - ex * fz) * inv_det);
    return units + (dzdx > dzdy ? dzdx : dzdy) * factor;
}

static bool offset_enabled(const struct raster_plan *plan, GLenum mode)
{
    return mode == GL_POINT ? plan->offset_point : mode == GL_LINE ? plan->offset_line : plan->offset_fill;
}

/* The vertex as the front face's: a back face's colours, or the provoking vertex's, in the lanes where lines
 * and points look for them. */
static void copy_vertex(const struct raster_plan *plan, struct corner *to, const float *v, const float *color,
                        bool back)
{
    const bool secondary = plan->fragment->has_secondary;
    const int from = back && plan->two_sided ? plan->back_lane : LANE_COLOR;
    memcpy(to->lane, v, (size_t)plan->lanes * sizeof(float));
    if (plan->lanes > LANE_COLOR)
        memcpy(to->lane + LANE_COLOR, color + from, 4 * sizeof(float));
    if (secondary)
        memcpy(to->lane + LANE_SECONDARY, color + from + 4, 3 * sizeof(float));
}

/* OSMesa rule: edges in the order v2 v0, v0 v1, v1 v2. */
static void draw_edges(const struct raster_plan *plan, const struct corner *v, unsigned edges,
                       int *stipple_counter)
{
    for (int i = 0; i < 3; i++) {
        const int from = (i + 2) % 3;
        if (edges >> from & 1)
            fgl_raster_line(plan, v[from].lane, v[i].lane, v[i].lane, stipple_counter);
    }
}

/* What is left of a filled triangle: its colours are chosen and its vertices offset. */
static void fill(const struct raster_plan *plan, const struct corner *v)
{
    struct raster_plan filled = *plan;
    filled.two_sided = filled.offset_fill = false;
    plan->filled(&filled, v[0].lane, v[1].lane, v[2].lane, v[0].lane);
}

void fgl_raster_polygon_mode(const struct raster_plan *plan, const float *v0, const float *v1,
                             const float *v2, const float *provoking, unsigned edges, int *stipple_counter)
{
    const float det = (v0[LANE_X] - v2[LANE_X]) * (v1[LANE_Y] - v2[LANE_Y]) -
                      (v0[LANE_Y] - v2[LANE_Y]) * (v1[LANE_X] - v2[LANE_X]);
    const bool ccw = det < 0.0f, front = ccw == plan->front_is_ccw;
    if (front && det != 0.0f ? plan->cull_front : plan->cull_back)
        return;
    if (stipple_counter && !(edges & EDGES_GO_ON))
        *stipple_counter = 0;
    const GLenum mode = plan->polygon_mode[front ? 0 : 1];
    const float *const v[3] = {v0, v1, v2};
    struct corner corner[3];
    for (int i = 0; i < 3; i++)
        copy_vertex(plan, &corner[i], v[i], plan->flat ? provoking : v[i], !front && det != 0.0f);
    if (plan->offset_point || plan->offset_line || plan->offset_fill) {
        const float offset = vertex_offset(plan, v, det, offset_enabled(plan, mode));
        for (int i = 0; i < 3; i++)
            corner[i].lane[LANE_Z] = fgl_clamp01(corner[i].lane[LANE_Z] + offset);
    }
    if (mode == GL_FILL)
        fill(plan, corner);
    else if (mode == GL_LINE)
        draw_edges(plan, corner, edges, stipple_counter);
    else
        for (int i = 0; i < 3; i++)
            if (edges >> i & 1)
                fgl_raster_point(plan, corner[i].lane, plan->point_size);
}
