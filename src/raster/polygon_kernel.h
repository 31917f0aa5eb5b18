/* Triangles that set-up does not take as they are: polygon modes (GL 1.5, 3.5.4 "Options Controlling Polygon
 * Rasterization"), and filled triangles where OSMesa takes another road.
 *
 * OSMesa rules for this road, which it takes when a face is not filled and also while polygon stipple, line
 * stipple or smooth lines or points are enabled: facing comes from unsnapped window coordinates and a
 * triangle without area counts as back facing when it is culled; polygon offset is added to the vertices,
 * whose z is then clamped to [0,1]. Kernels. */
#ifndef FGL_RASTER_POLYGON_KERNEL_H
#define FGL_RASTER_POLYGON_KERNEL_H

#include "raster/setup.h"

struct corner {
    real lane[LANE_MAX];
};

/* What polygon offset adds to z. Not a number for a triangle without area, even where the mode's offset is
 * disabled. */
static real vertex_offset(const struct raster_plan *plan, const real *const v[3], real det, bool enabled)
{
    const real factor = enabled ? (real)plan->offset_factor : 0;
    const real units = enabled ? (real)plan->offset_units : 0;
    const real ex = v[0][LANE_X] - v[2][LANE_X], ey = v[0][LANE_Y] - v[2][LANE_Y],
                ez = v[0][LANE_Z] - v[2][LANE_Z];
    const real fx = v[1][LANE_X] - v[2][LANE_X], fy = v[1][LANE_Y] - v[2][LANE_Y],
                fz = v[1][LANE_Z] - v[2][LANE_Z];
    const real inv_det = 1 / det;
    const real dzdx = r_abs((ey * fz - ez * fy) * inv_det), dzdy = r_abs((ez * fx - ex * fz) * inv_det);
    return units + (dzdx > dzdy ? dzdx : dzdy) * factor;
}

static bool offset_enabled(const struct raster_plan *plan, GLenum mode)
{
    return mode == GL_POINT ? plan->offset_point : mode == GL_LINE ? plan->offset_line : plan->offset_fill;
}

/* The vertex as the front face's: a back face's colours, or the provoking vertex's, in the lanes where lines
 * and points look for them. */
static void copy_vertex(const struct raster_plan *plan, struct corner *to, const real *v, const real *color,
                        bool back)
{
    const bool secondary = plan->secondary;
    const int from = back && plan->two_sided ? plan->back_lane : LANE_COLOR;
    memcpy(to->lane, v, (size_t)plan->lanes * sizeof(real));
    if (plan->lanes > LANE_COLOR)
        memcpy(to->lane + LANE_COLOR, color + from, 4 * sizeof(real));
    if (back && plan->face_lane)
        to->lane[plan->face_lane] = 1;
    if (secondary)
        memcpy(to->lane + LANE_SECONDARY, color + from + 4, 3 * sizeof(real));
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
    filled.face_lane = 0;
    plan->filled(&filled, v[0].lane, v[1].lane, v[2].lane, v[0].lane);
}

static void polygon_mode(const struct raster_plan *plan, const void *a, const void *b, const void *c, const void *provoking,
                         unsigned edges, int *stipple_counter)
{
    const real *const v0 = a, *const v1 = b, *const v2 = c;
    const real det = (v0[LANE_X] - v2[LANE_X]) * (v1[LANE_Y] - v2[LANE_Y]) -
                      (v0[LANE_Y] - v2[LANE_Y]) * (v1[LANE_X] - v2[LANE_X]);
    const bool ccw = det < 0, front = ccw == plan->front_is_ccw;
    if (front && det != 0 ? plan->cull_front : plan->cull_back)
        return;
    const GLenum mode = plan->polygon_mode[front ? 0 : 1];
    if (stipple_counter && (mode != GL_LINE || !(edges & EDGES_GO_ON)))
        *stipple_counter = 0;
    const real *const v[3] = {v0, v1, v2};
    struct corner corner[3];
    for (int i = 0; i < 3; i++)
        copy_vertex(plan, &corner[i], v[i], plan->flat ? provoking : v[i], !front && det != 0);
    if (plan->offset_point || plan->offset_line || plan->offset_fill) {
        const real offset = vertex_offset(plan, v, det, offset_enabled(plan, mode));
        for (int i = 0; i < 3; i++)
            corner[i].lane[LANE_Z] = r_clamp01(corner[i].lane[LANE_Z] + offset);
    }
    if (mode == GL_FILL)
        fill(plan, corner);
    else if (mode == GL_LINE)
        draw_edges(plan, corner, edges, stipple_counter);
    else
        for (int i = 0; i < 3; i++)
            if (edges >> i & 1)
                fgl_raster_point(plan, corner[i].lane, plan->size_lane ? (float)v[i][plan->size_lane] : plan->point_size);
}

#endif
