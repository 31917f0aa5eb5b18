/* Coverage: which pixels a convex polygon covers (GL 1.5, 3.5.1 "Basic Polygon Rasterization"), exactly.
 *
 * Vertices are rounded to 1/256 of a pixel; everything after is integer arithmetic, done in doubles, which hold every number here
 * exactly: see RASTER_LIMIT. With y down, a pixel (X, Y) is inside the edge from vertex i to j if
 *     E = c - 256 a X + 256 b Y > 0,    a = y_i - y_j,  b = x_i - x_j,  c = a x_i - b y_i
 * where c is one greater for the edges that own the pixel centres on them (OSMesa rule: left and lower edges). A row of a convex polygon
 * is an interval, which each edge bounds on one side:
 *     a > 0:  X < ceil(N/D) = floor((N-1)/D) + 1,  N = c + 256 b Y,  D = 256 a
 *     a < 0:  X >= floor(-N/D) + 1,                                  D = -256 a
 * so that a bound is floor(K/D) + 1 on either side. The floor of the rounded quotient is the floor of the true one while |K| < 2^53:
 * a quotient that is no integer is at least 1/D from the next, more than half a unit in its last place. */
#ifndef FGL_RASTER_COVERAGE_H
#define FGL_RASTER_COVERAGE_H

#include <math.h>
#include <string.h>

#include "raster/raster.h"

enum { POLYGON_EDGES = 4, COVER_ROWS = 4 }; /* edges at most; rows worked on at once */

/* Primitives with a coordinate of this many pixels or more are not drawn: in units of 1/256 pixel coordinates then stay below 2^25, a and b below
 * 2^26, and c and K below 2^53. No viewport that GL accepts leads there. */
#define RASTER_LIMIT 131072.0f

static FGL_ALWAYS_INLINE bool within_limit(const float *v) /* false for NaN */
{
    return (fabsf(v[LANE_X]) < RASTER_LIMIT) & (fabsf(v[LANE_Y]) < RASTER_LIMIT);
}

/* Round half to even, |v| < 2^31. */
static FGL_ALWAYS_INLINE double round_even(double v)
{
    const double magic = 6755399441055744.0; /* 1.5 * 2^52: the sum's last place is 1 */
    return (v + magic) - magic;
}

/* OSMesa rule: a triangle's vertex goes to the nearest 1/256 pixel, half to even. */
static FGL_ALWAYS_INLINE struct snapped snap(const float *v)
{
    return (struct snapped){round_even((double)((v[LANE_X] - 0.5f) * 256.0f)), round_even((double)((v[LANE_Y] - 0.5f) * 256.0f))};
}

/* The pixels that a polygon with these vertices may cover, within bounds. */
static FGL_ALWAYS_INLINE struct rect bounding_box(const struct snapped *v, const int n, const struct rect *bounds)
{
    double x0 = v[0].x, x1 = v[0].x, y0 = v[0].y, y1 = v[0].y;
    for (int i = 1; i < n; i++) {
        x0 = v[i].x < x0 ? v[i].x : x0;
        x1 = v[i].x > x1 ? v[i].x : x1;
        y0 = v[i].y < y0 ? v[i].y : y0;
        y1 = v[i].y > y1 ? v[i].y : y1;
    }
    return (struct rect){fgl_max(bounds->x0, ((int)x0 + 255) >> 8), fgl_max(bounds->y0, ((int)y0 >> 8) + 1),
                         fgl_min(bounds->x1, ((int)x1 + 255) >> 8), fgl_min(bounds->y1, ((int)y1 >> 8) + 1)};
}

/* For each edge, the integers K (of the box's first row, and its step from row to row) and D. Columns count from the one left of the box. */
struct edges {
    double k[POLYGON_EDGES], step[POLYGON_EDGES], d[POLYGON_EDGES];
    bool from_below[POLYGON_EDGES]; /* a < 0: bounds x from below */
};

/* The edges of a polygon whose vertices run counter-clockwise as GL sees it. */
static FGL_ALWAYS_INLINE void edges_setup(struct edges *e, const struct snapped *v, const int n, const struct rect *box)
{
    const double left = box->x0 - 1, top = 256.0 * box->y0;
    for (int i = 0; i < n; i++) {
        const struct snapped p = v[i], q = v[i + 1 == n ? 0 : i + 1];
        const double a = p.y - q.y, b = p.x - q.x;
        const double own = (a < 0.0) | ((a == 0.0) & (b < 0.0)) ? 1.0 : 0.0;
        const double c = (a * p.x - b * p.y) + own + b * top;
        const double d = 256.0 * fabs(a);
        e->from_below[i] = a < 0.0;
        e->step[i] = a < 0.0 ? -256.0 * b : 256.0 * b;
        e->k[i] = (a < 0.0 ? -c : a > 0.0 ? c - 1.0 : c) - d * left;
        e->d[i] = a == 0.0 ? 1.0 / 65536.0 : d; /* level edge: K is E, whose sign admits all columns of the row or none */
    }
}

/* The runs of rows first.. of the box. Returns whether any is not empty. */
static FGL_ALWAYS_INLINE bool cover_rows(const struct edges *e, const int n, const struct rect *box, int first, struct runs *runs)
{
    const double width = box->x1 - box->x0;
    const int rows = fgl_min(RUNS_MAX, box->y1 - box->y0 - first);
    int32_t any = 0;
    runs->y = box->y0 + first;
    runs->n = rows;
    for (int r = 0; r < rows; r += COVER_ROWS)
        for (int i = r; i < r + COVER_ROWS; i++) {
            double lo = 0.0, hi = width;
            for (int j = 0; j < n; j++) {
                const double bound = (e->k[j] + e->step[j] * (first + i)) / e->d[j];
                const double below = e->from_below[j] ? bound : 0.0, above = e->from_below[j] ? width : bound;
                lo = below > lo ? below : lo;
                hi = above < hi ? above : hi;
            }
            lo = lo < width ? lo : width;
            hi = hi > 0.0 ? hi : 0.0;
            runs->x0[i] = box->x0 + (int32_t)lo;
            runs->x1[i] = box->x0 + (int32_t)hi;
            any |= runs->x0[i] - runs->x1[i]; /* negative when not empty */
        }
    return any < 0;
}

#endif
