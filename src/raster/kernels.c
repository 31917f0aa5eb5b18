/* Filled polygons (GL 1.5, 3.5 "Polygons"), and what is made of them, for one instruction set and one arithmetic. The
 * build compiles this file once for each set, with FGL_ISA naming it (sse2, avx2, avx512; base elsewhere) and the
 * compiler's options to match, and for each arithmetic, with FGL_ARITH naming it. */
#include "base/batch_results.h"
#include "raster/coverage.h"
#include "raster/setup.h"

/* The planes of a triangle whose facing is known. Vertices are in set-up order. */
static FGL_ALWAYS_INLINE void setup_planes(const struct raster_plan *plan, struct planes *planes,
                                           const real *const v[3], const real *provoking, bool front)
{
    const struct gradients g = gradients_of_triangle(v);
    const bool back = plan->two_sided && !front, secondary = plan->secondary;
    const int color = back ? plan->back_lane : LANE_COLOR;

    plane_lanes(planes, 0, LANE_COLOR, false, &g, v, 0);
    for (int lane = LANE_COLOR; lane < plan->lanes; lane += LANE_GROUP)
        plane_lanes(planes, lane, LANE_GROUP, true, &g, v, lane);
    if (plan->flat) {
        flat_planes(planes, provoking + color, secondary);
    } else if (back) {
        plane_lanes(planes, LANE_COLOR, 4, true, &g, v, color);
        if (secondary)
            plane_lanes(planes, LANE_SECONDARY, 3, true, &g, v, color + 4);
    }
    if (plan->face_lane && !front)
        fgl_plane_set(planes, R_EXACT ? ARITH_EXACT : ARITH_COMPATIBLE, plan->face_lane, 1);
    PLANES(planes)->z_offset = plan->offset_fill ? polygon_offset(plan, v) : 0;
    planes->smoothing = plan->polygon_smoothing;
    planes->stipple = plan->polygon_stipple ? plan->stipple : NULL;
}

/* The triangles of a smooth line or point: no culling, no offset, no stipple. */
static void setup_smooth_planes(const struct raster_plan *plan, struct planes *planes,
                                const real *const v[3], const real *provoking, enum smoothing smoothing)
{
    const struct gradients g = gradients_of_triangle(v);
    for (int lane = LANE_COLOR; lane < plan->lanes; lane += LANE_GROUP)
        plane_lanes(planes, lane, LANE_GROUP, true, &g, v, lane);
    plane_lanes(planes, 0, LANE_COLOR, false, &g, v, 0);
    plane_lanes(planes, LANE_SMOOTH, 4, true, &g, v, LANE_SMOOTH);
    if (plan->flat)
        flat_planes(planes, provoking + LANE_COLOR, plan->secondary);
    PLANES(planes)->z_offset = 0;
    planes->smoothing = smoothing;
    planes->stipple = NULL;
}

/* Snaps, orients, culls, covers; then set-up, but only if a pixel is covered, and the fragments. */
static FGL_ALWAYS_INLINE void draw_triangle(const struct raster_plan *plan, const real *v0, const real *v1,
                                            const real *v2, const real *provoking,
                                            const enum smoothing smoothing)
{
    const struct polygon p = {{snap(v0[LANE_X]), snap(v1[LANE_X]), snap(v2[LANE_X])},
                              {snap(v0[LANE_Y]), snap(v1[LANE_Y]), snap(v2[LANE_Y])}};
    const struct extent extent = extent_of(&p, 3);
    if (!extent_within_limit(extent))
        return;
    const struct rect box = pixels_of(extent, plan);
    if (box.x0 >= box.x1 || box.y0 >= box.y1)
        return;
    const int64_t area = (p.x[0] - p.x[1]) * (p.y[2] - p.y[0]) - (p.x[2] - p.x[0]) * (p.y[0] - p.y[1]);
    const bool ccw = area > 0;
    if (area == 0 || (!smoothing && (ccw ? plan->cull_ccw : plan->cull_cw)))
        return;

    const real *const v[3] = {ccw ? v0 : v1, ccw ? v1 : v0, v2}; /* in set-up order */
    const struct fragment_plan *fragment = plan->fragment;
    fragment_fill_fn *fill = smoothing || plan->polygon_stipple ? fragment->general : fragment->fill;
    struct edges edges;
    struct planes planes;
    struct runs runs;
    bool ready = false;
    for (int i = 0; i < 3; i++)
        edge_setup(&edges, i, p.x[i], p.y[i], p.x[(i + 1) % 3], p.y[(i + 1) % 3], area >> 63, &box);
    for (int first = 0; first < box.y1 - box.y0; first += RUNS_MAX) {
        if (!cover_rows(&edges, 3, &box, first, &runs))
            continue;
        if (!ready && smoothing)
            setup_smooth_planes(plan, &planes, v, provoking, smoothing);
        else if (!ready)
            setup_planes(plan, &planes, v, provoking, ccw == plan->front_is_ccw);
        ready = true;
        fill(fragment, &planes, &runs);
    }
}

static void triangle(const struct raster_plan *plan, const void *v0, const void *v1, const void *v2,
                     const void *provoking)
{
    draw_triangle(plan, v0, v1, v2, provoking, SMOOTH_NONE);
}

/* Half of a smooth line or point; the vertices have LANE_SMOOTH. */
static void smooth_triangle(const struct raster_plan *plan, const real *v0, const real *v1, const real *v2,
                            const real *provoking, enum smoothing smoothing)
{
    if (smoothing == SMOOTH_LINE)
        draw_triangle(plan, v0, v1, v2, provoking, SMOOTH_LINE);
    else
        draw_triangle(plan, v0, v1, v2, provoking, SMOOTH_POINT);
}

/* A convex polygon of four corners, counter-clockwise where row 0 is above the others. */
static void quad(const struct raster_plan *plan, const struct polygon *corners, const struct planes *planes)
{
    const struct extent extent = extent_of(corners, POLYGON_EDGES);
    const struct rect box = pixels_of(extent, plan);
    if (!extent_within_limit(extent) || box.x0 >= box.x1)
        return;
    struct edges edges;
    struct runs runs;
    for (int i = 0; i < POLYGON_EDGES; i++) {
        const int j = (i + 1) % POLYGON_EDGES;
        edge_setup(&edges, i, corners->x[i], corners->y[i], corners->x[j], corners->y[j], 0, &box);
    }
    for (int first = 0; first < box.y1 - box.y0; first += RUNS_MAX)
        if (cover_rows(&edges, POLYGON_EDGES, &box, first, &runs))
            plan->fragment->fill(plan->fragment, planes, &runs);
}

static void snap_vertices(const struct vertex_batch *batch, struct snapped *out)
{
    const real limit = RASTER_LIMIT;
    const real *x = RESULTS(batch)->win.c[0], *y = RESULTS(batch)->win.c[1];
    for (int i = 0; i < batch->n; i++) {
        const bool near =
                (x[i] > -limit) & (x[i] < limit) & (y[i] > -limit) & (y[i] < limit) & (batch->outcode[i] == 0);
        out[i].x = near ? (int32_t)snap(x[i]) : SNAP_SPECIAL;
        out[i].y = near ? (int32_t)snap(y[i]) : 0;
    }
}

#include "raster/line_kernel.h"
#include "raster/point_kernel.h"
#include "raster/polygon_kernel.h"
#include "raster/small_kernel.h"

extern const struct raster_kernels FGL_KERNELS(raster);
const struct raster_kernels FGL_KERNELS(raster) = {triangle, polygon_mode, draw_line, draw_point, snap_vertices,
                                                  draw_small_pixels};
