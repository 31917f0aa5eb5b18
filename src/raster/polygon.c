/* Polygon modes (GL 1.5, 3.5.4 "Options Controlling Polygon Rasterization"): triangles as edges and points. */
#include "raster/coverage.h"
#include "raster/setup.h"

/* Polygon offset goes to the vertices here. OSMesa rule: z is clamped to [0,1] after it. */
static bool mode_offset(const struct raster_plan *plan, GLenum mode)
{
    return mode == GL_POINT ? plan->offset_point : mode == GL_LINE ? plan->offset_line : plan->offset_fill;
}

void fgl_raster_polygon_mode(struct raster_plan *plan, const float *v0, const float *v1, const float *v2, const float *provoking,
                             unsigned edges)
{
    /* OSMesa rule: facing comes from unsnapped window coordinates here. */
    const float area = (v0[LANE_X] - v2[LANE_X]) * (v1[LANE_Y] - v2[LANE_Y]) - (v0[LANE_Y] - v2[LANE_Y]) * (v1[LANE_X] - v2[LANE_X]);
    const bool ccw = area < 0.0f, front = ccw == plan->front_is_ccw;
    if (ccw ? plan->cull_ccw : plan->cull_cw)
        return;
    const GLenum mode = plan->polygon_mode[front ? 0 : 1];
    if (mode == GL_FILL) {
        fgl_raster_triangle(plan, v0, v1, v2, provoking);
        return;
    }

    float vertex[3][LANE_MAX];
    const float *const v[3] = {v0, v1, v2};
    const float offset = mode_offset(plan, mode) ? polygon_offset(plan, v) : 0.0f;
    for (int i = 0; i < 3; i++) {
        memcpy(vertex[i], v[i], (size_t)plan->lanes * sizeof(float));
        if (mode_offset(plan, mode))
            vertex[i][LANE_Z] = fgl_clamp01(vertex[i][LANE_Z] + offset);
        if (plan->two_sided && !front)
            memcpy(vertex[i] + LANE_COLOR, v[i] + plan->back_lane, 4 * sizeof(float));
        if (plan->two_sided && !front && plan->fragment->has_secondary)
            memcpy(vertex[i] + LANE_SECONDARY, v[i] + plan->back_lane + 4, 3 * sizeof(float));
        if (plan->flat)
            memcpy(vertex[i] + LANE_COLOR, provoking + LANE_COLOR, 4 * sizeof(float));
    }
    int counter = 0;
    for (int i = 0; i < 3; i++) {
        const int from = mode == GL_LINE ? (i + 2) % 3 : i;
        if (!(edges >> from & 1))
            continue;
        if (mode == GL_POINT)
            fgl_raster_point(plan, vertex[from], plan->point_size);
        else
            fgl_raster_line(plan, vertex[from], vertex[(from + 1) % 3], vertex[(from + 1) % 3], plan->line_stipple ? &counter : NULL);
    }
}
