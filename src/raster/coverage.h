/* Coverage: which pixels a convex polygon covers (GL 1.5, 3.5.1 "Basic Polygon Rasterization"), exactly.
 *
 * Vertices are rounded to 1/256 of a pixel; everything after is integer arithmetic. With row 0 above the others, a pixel (X,
 * Y) is inside the edge from vertex i to j of a polygon that runs counter-clockwise if E = c -
 * 256 a X + 256 b Y > 0,    a = y_i - y_j,  b = x_i - x_j,  c = a x_i - b y_i where c is one greater for the
 * edges that own the pixel centres on them (OSMesa rule: left ones, a < 0, and of level ones, a = 0, those that are lower in the window:
 * b < 0, but b > 0 where the rows of a framebuffer object go up). A row of a convex polygon is an interval, which each edge bounds on one side:
 *     a > 0:  X < ceil(N/D) = floor((N-1)/D) + 1,  N = c + 256 b Y,  D = 256 a
 *     a < 0:  X >= floor(-N/D) + 1,                                  D = -256 a
 * so that a bound is floor(K/D) + 1 on either side. Level edges bound rows, which the bounding box does
 * exactly.
 *
 * K and D are integers in doubles, and the quotient is divided as a double: its floor is exact while |K| <
 * 2^53, since a quotient that is no integer is at least 1/D from the next one, more than half a unit in its
 * last place. Bit budget: coordinates below 2^25 (RASTER_LIMIT), a and b below 2^26, products below 2^51, K
 * below 2^53. */
#ifndef FGL_RASTER_COVERAGE_H
#define FGL_RASTER_COVERAGE_H

#include "base/arith.h"
#include "raster/raster.h"

/* Primitives with a coordinate of this many pixels or more are not drawn; no viewport that GL accepts leads
 * there. */
enum { RASTER_LIMIT = 1 << 17 };

static inline bool within_limit(const real *v) /* false for NaN */
{
    return r_abs(v[LANE_X]) < RASTER_LIMIT && r_abs(v[LANE_Y]) < RASTER_LIMIT;
}

#define ROUNDING_MAGIC 6755399441055744.0 /* 1.5 * 2^52: the last place of a sum with it is 1 */

/* The nearest integer, half to even, for |v| < 2^51; some integer for other values and NaN. */
static FGL_ALWAYS_INLINE int64_t round_even(double v)
{
    return (int64_t)(fgl_double_bits(v + ROUNDING_MAGIC) - fgl_double_bits(ROUNDING_MAGIC));
}

/* OSMesa rule: a triangle's window coordinate goes to the nearest 1/256 pixel, half to even. */
static FGL_ALWAYS_INLINE int64_t snap(real v)
{
    return round_even((double)((v - (real)0.5) * 256));
}

static FGL_ALWAYS_INLINE int64_t min2(int64_t a, int64_t b)
{
    return a < b ? a : b;
}
static FGL_ALWAYS_INLINE int64_t max2(int64_t a, int64_t b)
{
    return a > b ? a : b;
}

/* The smallest rectangle around a polygon, in 1/256 pixel. */
struct extent {
    int64_t x0, y0, x1, y1;
};

static FGL_ALWAYS_INLINE struct extent extent_of(const struct polygon *p, const int n)
{
    struct extent e = {p->x[0], p->y[0], p->x[0], p->y[0]};
    for (int i = 1; i < n; i++)
        e = (struct extent){min2(e.x0, p->x[i]), min2(e.y0, p->y[i]), max2(e.x1, p->x[i]),
                            max2(e.y1, p->y[i])};
    return e;
}

/* Whether all coordinates are within RASTER_LIMIT. False where one was not a number or infinite. */
static FGL_ALWAYS_INLINE bool extent_within_limit(struct extent e)
{
    const uint64_t limit = 256 * (uint64_t)RASTER_LIMIT;
    return (((uint64_t)e.x0 + limit) | ((uint64_t)e.y0 + limit) | ((uint64_t)e.x1 + limit) |
            ((uint64_t)e.y1 + limit)) < 2 * limit;
}

/* The pixels whose centres lie in the extent, within bounds. */
static FGL_ALWAYS_INLINE struct rect pixels_of(struct extent e, const struct raster_plan *plan)
{
    const struct rect *bounds = &plan->bounds;
    const int y0 = (int)e.y0 - plan->first_row_owned, y1 = (int)e.y1 - plan->first_row_owned;
    return (struct rect){fgl_max(bounds->x0, ((int)e.x0 + 255) >> 8), fgl_max(bounds->y0, (y0 >> 8) + 1),
                         fgl_min(bounds->x1, ((int)e.x1 + 255) >> 8), fgl_min(bounds->y1, (y1 >> 8) + 1)};
}

/* For each edge, K of the next row, its step from row to row, and D. Columns count from the one left of the
 * box. */
struct edges {
    double k[POLYGON_EDGES], step[POLYGON_EDGES], d[POLYGON_EDGES];
    double below[POLYGON_EDGES]; /* 1: a < 0, the edge bounds x from below; 0: from above */
};

/* The edge from (x0, y0) to (x1, y1). reverse: -1 if the polygon runs clockwise, else 0. Without branches,
 * which would be taken at random: for a mask m of 0 or -1, (v ^ m) - m is v or -v. */
static FGL_ALWAYS_INLINE void edge_setup(struct edges *e, int i, int64_t x0, int64_t y0, int64_t x1,
                                         int64_t y1, int64_t reverse, const struct rect *box)
{
    const int64_t a = ((y0 - y1) ^ reverse) - reverse, b = ((x0 - x1) ^ reverse) - reverse;
    const int64_t below = a >> 63, level = a == 0;
    const int64_t owns = -below, n = a * x0 - b * y0 + owns + 256 * b * box->y0;
    const int64_t d = 256 * ((a ^ below) - below);
    e->k[i] = (double)(((n - 1) ^ below) - d * (box->x0 - 1) + (level << 60));
    e->step[i] = (double)((256 * b ^ below) - below);
    e->d[i] = (double)(d + level);
    e->below[i] = (double)-below;
}

static FGL_ALWAYS_INLINE double min_double(double a, double b)
{
    return a < b ? a : b;
}
static FGL_ALWAYS_INLINE double max_double(double a, double b)
{
    return a > b ? a : b;
}

/* The runs of rows first.. of the box; call for each group of rows in turn. Returns whether any is not empty.
 */
static FGL_ALWAYS_INLINE bool cover_rows(struct edges *e, const int n, const struct rect *box, int first,
                                         struct runs *runs)
{
    const double width = box->x1 - box->x0, far = 1e30; /* beyond any bound */
    const int rows = fgl_min(RUNS_MAX, box->y1 - box->y0 - first);
    int32_t any = 0;
    runs->y = box->y0 + first;
    runs->n = rows;
    for (int i = 0; i < rows; i++) {
        double lo = 0.0, hi = width;
        for (int j = 0; j < n; j++) {
            const double bound = e->k[j] / e->d[j];
            lo = max_double(bound * e->below[j], lo);
            hi = min_double(bound + far * e->below[j], hi);
            e->k[j] += e->step[j];
        }
        runs->x0[i] = box->x0 + (int32_t)min_double(lo, width);
        runs->x1[i] = box->x0 + (int32_t)max_double(hi, 0.0);
        any |= runs->x0[i] - runs->x1[i]; /* negative when not empty */
    }
    return any < 0;
}

#endif
