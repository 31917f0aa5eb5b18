/* Filled polygons (GL 1.5, 3.5 "Polygons"), for one instruction set. The build compiles this file once for each set, with FGL_ISA
 * naming it (sse2, avx2, avx512; base elsewhere) and the compiler's options to match. */
#include "raster/coverage.h"
#include "raster/setup.h"

/* The planes of a triangle whose facing is known. Vertices are in set-up order. */
static void setup_planes(const struct raster_plan *plan, struct planes *planes, const float *const v[3], const float *provoking)
{
    const struct gradients g = gradients_of(v);
    const bool back = plan->two_sided && !planes->front, secondary = plan->fragment->has_secondary;
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
    planes->z_offset = plan->offset_fill ? polygon_offset(plan, v) : 0.0f;
    planes->smoothing = SMOOTH_NONE;
    planes->stipple = plan->polygon_stipple ? plan->stipple : NULL;
}

/* The triangles of a smooth line or point: no culling, no offset, no stipple. */
static void setup_smooth_planes(const struct raster_plan *plan, struct planes *planes, const float *const v[3], const float *provoking,
                                enum smoothing smoothing)
{
    const struct gradients g = gradients_of(v);
    for (int lane = LANE_COLOR; lane < plan->lanes; lane += LANE_GROUP)
        plane_lanes(planes, lane, LANE_GROUP, true, &g, v, lane);
    plane_lanes(planes, 0, LANE_COLOR, false, &g, v, 0);
    plane_lanes(planes, LANE_SMOOTH, 4, true, &g, v, LANE_SMOOTH);
    if (plan->flat)
        flat_planes(planes, provoking + LANE_COLOR, plan->fragment->has_secondary);
    planes->z_offset = 0.0f;
    planes->smoothing = smoothing;
    planes->stipple = NULL;
}

enum { CULL_GROUP = 64 };

/* Snaps, orients, culls, covers; then set-up, but only if a pixel is covered, and the fragments. */
static FGL_ALWAYS_INLINE void draw_triangle(const struct raster_plan *plan, const float *v0, const float *v1, const float *v2,
                                            const float *provoking, const enum smoothing smoothing)
{
    if (!within_limit(v0) || !within_limit(v1) || !within_limit(v2))
        return;
    struct snapped s[3] = {snap(v0), snap(v1), snap(v2)};
    const double area = (s[0].x - s[1].x) * (s[2].y - s[0].y) - (s[2].x - s[0].x) * (s[0].y - s[1].y);
    const bool ccw = area > 0.0;
    if (area == 0.0 || (!smoothing && (ccw ? plan->cull_ccw : plan->cull_cw)))
        return;
    const struct rect box = bounding_box(s, 3, &plan->bounds);
    if (box.x0 >= box.x1 || box.y0 >= box.y1)
        return;
    const float *const v[3] = {ccw ? v0 : v1, ccw ? v1 : v0, v2};
    if (!ccw) {
        const struct snapped first = s[0];
        s[0] = s[1];
        s[1] = first;
    }

    const struct fragment_plan *fragment = plan->fragment;
    fragment_fill_fn *fill = smoothing || plan->polygon_stipple ? fragment->general : fragment->fill;
    struct edges edges;
    struct planes planes;
    struct runs runs;
    bool ready = false;
    planes.front = smoothing || ccw == plan->front_is_ccw;
    edges_setup(&edges, s, 3, &box);
    for (int first = 0; first < box.y1 - box.y0; first += RUNS_MAX) {
        if (!cover_rows(&edges, 3, &box, first, &runs))
            continue;
        if (!ready && smoothing)
            setup_smooth_planes(plan, &planes, v, provoking, smoothing);
        else if (!ready)
            setup_planes(plan, &planes, v, provoking);
        ready = true;
        fill(fragment, &planes, &runs);
    }
}

static void triangle(const struct raster_plan *plan, const float *v0, const float *v1, const float *v2, const float *provoking)
{
    draw_triangle(plan, v0, v1, v2, provoking, SMOOTH_NONE);
}

static void smooth_triangle(const struct raster_plan *plan, const float *v0, const float *v1, const float *v2, const float *provoking,
                            enum smoothing smoothing)
{
    if (smoothing == SMOOTH_LINE)
        draw_triangle(plan, v0, v1, v2, provoking, SMOOTH_LINE);
    else
        draw_triangle(plan, v0, v1, v2, provoking, SMOOTH_POINT);
}

static FGL_ALWAYS_INLINE double min3(double a, double b, double c) { return a < b ? (a < c ? a : c) : (b < c ? b : c); }
static FGL_ALWAYS_INLINE double max3(double a, double b, double c) { return a > b ? (a > c ? a : c) : (b > c ? b : c); }

/* The bounding box of one triangle within bounds, empty when it is culled; the same arithmetic as draw_triangle's, for many at a time. */
static FGL_ALWAYS_INLINE void cull_boxes(const struct raster_plan *plan, const struct cull_input *in, int first, int n, struct rect *box)
{
    const struct rect bounds = plan->bounds;
    const bool cull_ccw = plan->cull_ccw, cull_cw = plan->cull_cw;
    const float *FGL_RESTRICT record = in->record;
    const uint32_t stride = (uint32_t)in->stride, flag = in->flag;
    int32_t x0[CULL_GROUP], x1[CULL_GROUP], y0[CULL_GROUP], y1[CULL_GROUP];
    for (int i = 0; i < n; i++) {
        const uint32_t flagged = in->a[first + i];
        const float *a = record + (size_t)(flagged & ~flag) * stride, *b = record + (size_t)in->b[first + i] * stride,
                    *c = record + (size_t)in->c[first + i] * stride;
        const struct snapped p = snap(a), q = snap(b), r = snap(c);
        const double area = (p.x - q.x) * (r.y - p.y) - (r.x - p.x) * (p.y - q.y);
        const bool ok = within_limit(a) & within_limit(b) & within_limit(c);
        const bool keep = ok & (((area > 0.0) & !cull_ccw) | ((area < 0.0) & !cull_cw));
        const double left = keep ? min3(p.x, q.x, r.x) : 0.0, right = keep ? max3(p.x, q.x, r.x) : 0.0;
        const double top = keep ? min3(p.y, q.y, r.y) : 0.0, bottom = keep ? max3(p.y, q.y, r.y) : 0.0;
        x0[i] = flagged & flag ? bounds.x0 : ((int32_t)left + 255) >> 8;
        x1[i] = flagged & flag ? bounds.x1 : ((int32_t)right + 255) >> 8;
        y0[i] = flagged & flag ? bounds.y0 : ((int32_t)top >> 8) + 1;
        y1[i] = flagged & flag ? bounds.y1 : ((int32_t)bottom >> 8) + 1;
    }
    for (int i = 0; i < n; i++)
        box[i] = (struct rect){fgl_max(bounds.x0, x0[i]), fgl_max(bounds.y0, y0[i]), fgl_min(bounds.x1, x1[i]), fgl_min(bounds.y1, y1[i])};
}

static int cull(const struct raster_plan *plan, const struct cull_input *in, int16_t *y0, int16_t *y1, uint32_t *visible, int64_t *area)
{
    struct rect box[CULL_GROUP];
    int count = 0;
    int64_t sum = 0;
    for (int first = 0; first < in->n; first += CULL_GROUP) {
        const int n = fgl_min(CULL_GROUP, in->n - first);
        cull_boxes(plan, in, first, n, box);
        for (int i = 0; i < n; i++) {
            const int width = box[i].x1 - box[i].x0, height = box[i].y1 - box[i].y0;
            const bool any = (width > 0) & (height > 0);
            y0[first + i] = (int16_t)box[i].y0;
            y1[first + i] = (int16_t)box[i].y1;
            visible[count] = (uint32_t)(first + i);
            count += any;
            sum += any ? (int64_t)width * height : 0;
        }
    }
    *area = sum;
    return count;
}

static void quad(const struct raster_plan *plan, const struct snapped corner[4], const struct planes *planes)
{
    const struct rect box = bounding_box(corner, 4, &plan->bounds);
    struct edges edges;
    struct runs runs;
    if (box.x0 >= box.x1)
        return;
    edges_setup(&edges, corner, 4, &box);
    for (int first = 0; first < box.y1 - box.y0; first += RUNS_MAX)
        if (cover_rows(&edges, 4, &box, first, &runs))
            plan->fragment->fill(plan->fragment, planes, &runs);
}

#define NAME_OF(isa) fgl_raster_kernels_##isa
#define KERNELS(isa) NAME_OF(isa)

extern const struct raster_kernels KERNELS(FGL_ISA);
const struct raster_kernels KERNELS(FGL_ISA) = {cull, triangle, smooth_triangle, quad};
