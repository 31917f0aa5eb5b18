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

enum { COVER_ROWS = 4 }; /* worked on at once */

/* Triangles of more than this area, in units of 1/256 pixel squared, are not drawn, nor are those whose area is not a number. */
#define LARGEST_AREA 1125899906842624.0 /* 2^50 */

/* Lines and points with a coordinate of this many pixels or more are not drawn. No viewport that GL accepts leads there; below it units of 1/256 pixel
 * stay under 2^25, a and b under 2^26, c and K under 2^53. */
#define RASTER_LIMIT 131072.0f

/* Bounding boxes end here, outside of every framebuffer and within int. */
#define FAR (256.0 * (FGL_MAX_VIEWPORT + 2))

static inline bool within_limit(const float *v) /* false for NaN */
{
    return fabsf(v[LANE_X]) < RASTER_LIMIT && fabsf(v[LANE_Y]) < RASTER_LIMIT;
}

/* Round half to even, |v| < 2^51. */
static FGL_ALWAYS_INLINE double round_even(double v)
{
    const double magic = 6755399441055744.0; /* 1.5 * 2^52: the sum's last place is 1 */
    return (v + magic) - magic;
}

/* OSMesa rule: a triangle's window coordinate goes to the nearest 1/256 pixel, half to even. */
static FGL_ALWAYS_INLINE double snap(float v) { return round_even((double)((v - 0.5f) * 256.0f)); }

static FGL_ALWAYS_INLINE double min2(double a, double b) { return a < b ? a : b; }
static FGL_ALWAYS_INLINE double max2(double a, double b) { return a > b ? a : b; }

static FGL_ALWAYS_INLINE double min3(double a, double b, double c) { return min2(min2(a, b), c); }
static FGL_ALWAYS_INLINE double max3(double a, double b, double c) { return max2(max2(a, b), c); }

/* A snapped coordinate as an integer. */
static FGL_ALWAYS_INLINE int32_t near_int(double v) { return (int32_t)min2(max2(v, -FAR), FAR); }

/* The pixels that the polygon may cover, within bounds. */
static FGL_ALWAYS_INLINE struct rect bounding_box(const struct polygon *p, const struct rect *bounds)
{
    const double x0 = min2(min3(p->x[0], p->x[1], p->x[2]), p->x[3]), x1 = max2(max3(p->x[0], p->x[1], p->x[2]), p->x[3]);
    const double y0 = min2(min3(p->y[0], p->y[1], p->y[2]), p->y[3]), y1 = max2(max3(p->y[0], p->y[1], p->y[2]), p->y[3]);
    return (struct rect){fgl_max(bounds->x0, (near_int(x0) + 255) >> 8), fgl_max(bounds->y0, (near_int(y0) >> 8) + 1),
                         fgl_min(bounds->x1, (near_int(x1) + 255) >> 8), fgl_min(bounds->y1, (near_int(y1) >> 8) + 1)};
}

/* For each edge, the integers K (of the box's first row, and its step from row to row) and D. Columns count from the one left of the box. */
struct edges {
    double k[POLYGON_EDGES], step[POLYGON_EDGES], d[POLYGON_EDGES];
    double below[POLYGON_EDGES]; /* 1: a < 0, the edge bounds x from below; 0: from above */
};

/* Edges from p to q. sign: 1 if they run counter-clockwise as GL sees it, -1 if clockwise. */
static FGL_ALWAYS_INLINE void edges_setup(struct edges *FGL_RESTRICT e, const struct polygon *p, const struct polygon *q, double sign,
                                          const struct rect *box)
{
    const double left = box->x0 - 1, top = 256.0 * box->y0;
    for (int i = 0; i < POLYGON_EDGES; i++) {
        const double a = (p->y[i] - q->y[i]) * sign, b = (p->x[i] - q->x[i]) * sign;
        const double own = (a < 0.0) | ((a == 0.0) & (b < 0.0)) ? 1.0 : 0.0;
        const double c = (a * p->x[i] - b * p->y[i]) + own + b * top;
        const double d = 256.0 * fabs(a);
        e->below[i] = a < 0.0 ? 1.0 : 0.0;
        e->step[i] = a < 0.0 ? -256.0 * b : 256.0 * b;
        e->k[i] = (a < 0.0 ? -c : a > 0.0 ? c - 1.0 : c) - d * left;
        e->d[i] = a == 0.0 ? 1.0 / 65536.0 : d; /* level edge: K is E, whose sign admits all columns of the row or none */
    }
}

/* The runs of rows first.. of the box. Returns whether any is not empty. */
static FGL_ALWAYS_INLINE bool cover_rows(const struct edges *e, const int n, const struct rect *box, int first, struct runs *runs)
{
    const double width = box->x1 - box->x0, far = 1e30; /* beyond any bound */
    const int rows = fgl_min(RUNS_MAX, box->y1 - box->y0 - first);
    int32_t any = 0;
    runs->y = box->y0 + first;
    runs->n = rows;
    for (int r = 0; r < rows; r += COVER_ROWS)
        for (int i = r; i < r + COVER_ROWS; i++) {
            double lo = 0.0, hi = width;
            for (int j = 0; j < n; j++) {
                const double bound = (e->k[j] + e->step[j] * (first + i)) / e->d[j];
                lo = max2(bound * e->below[j], lo);
                hi = min2(bound + far * e->below[j], hi);
            }
            runs->x0[i] = box->x0 + (int32_t)min2(lo, width);
            runs->x1[i] = box->x0 + (int32_t)max2(hi, 0.0);
            any |= runs->x0[i] - runs->x1[i]; /* negative when not empty */
        }
    return any < 0;
}

#endif
