/* Which triangles may cover a pixel (GL 1.5, 3.5.1 "Basic Polygon Rasterization"): neither culled, nor without area, nor between the pixels'
 * centres. The tests are those of the rasterizer (raster/coverage.h), on the vertices that it has snapped. Kernels.
 *
 * What a small triangle covers is found out here for good: within a few pixels the edge functions fit 32 bits. E = a (x_i - X) - b (y_i - Y) + owns,
 * less 1, is not negative for the pixels inside of the edge from i to j; a, b, owns as in coverage.h. */
#ifndef FGL_PIPELINE_SIEVE_KERNEL_H
#define FGL_PIPELINE_SIEVE_KERNEL_H

#include "pipeline/pipeline.h"

#include <string.h>

enum {
    SIEVE_SIZE = 4 * SIEVE_GROUP, /* triangles that go through together: so many that no load waits for the stores before it */
    SMALL_EXTENT = SMALL_SIDE * 256,
    AREA_MAX = 1 << 20 /* areas above it are all the same: large */
};

/* Triangles, an array for each number. Coordinates in 1/256 pixel; those of special vertices are 0. */
struct sieved {
    int n;       /* whole groups */
    int32_t cut; /* 1: some box is not within bounds */
    int32_t x[3][SIEVE_SIZE], y[3][SIEVE_SIZE];
    int32_t special[SIEVE_SIZE], ccw[SIEVE_SIZE];                            /* 0 or 1 */
    int32_t left[SIEVE_SIZE], top[SIEVE_SIZE];                               /* first pixel of the bounding box */
    int32_t x0[SIEVE_SIZE], y0[SIEVE_SIZE], x1[SIEVE_SIZE], y1[SIEVE_SIZE];  /* the box within bounds */
    int32_t small[SIEVE_SIZE], kept[SIEVE_SIZE];                             /* 0 or 1 */
    uint32_t mask[SIEVE_SIZE];
};

/* An edge function less 1, at the first pixel of each triangle's box, and its steps from pixel to pixel. Unsigned: what overflows belongs to
 * triangles that are not small. */
struct sieve_edge {
    uint32_t e[SIEVE_SIZE], right[SIEVE_SIZE], down[SIEVE_SIZE];
};

static FGL_ALWAYS_INLINE int whole_sieve_groups(int n)
{
    return n & ~(SIEVE_GROUP - 1);
}
#define FOR_SIEVED(i, s) for (int i = 0, end_##i = whole_sieve_groups((s)->n); i < end_##i; i++)

static void sieve_load(struct sieved *FGL_RESTRICT s, const struct snapped *snapped, const uint32_t (*vertex)[3])
{
    struct snapped corner[3][SIEVE_SIZE];

    FOR_SIEVED (i, s)
        for (int k = 0; k < 3; k++)
            corner[k][i] = snapped[vertex[i][k]];
    FOR_SIEVED (i, s)
        s->special[i] = (corner[0][i].x == SNAP_SPECIAL) | (corner[1][i].x == SNAP_SPECIAL) | (corner[2][i].x == SNAP_SPECIAL);
    for (int k = 0; k < 3; k++)
        FOR_SIEVED (i, s) {
            const struct snapped at = corner[k][i];
            s->x[k][i] = s->special[i] ? 0 : at.x;
            s->y[k][i] = s->special[i] ? 0 : at.y;
        }
}

/* Orientation, and with it which triangles are culled. Returns whether any is kept or special. */
static bool sieve_orient(struct sieved *FGL_RESTRICT s, const struct raster_plan *plan)
{
    const int32_t keep_ccw = !plan->cull_ccw, keep_cw = !plan->cull_cw;
    int32_t any = 0;

    FOR_SIEVED (i, s) {
        const int32_t px = s->x[0][i], py = s->y[0][i], qx = s->x[1][i], qy = s->y[1][i], rx = s->x[2][i], ry = s->y[2][i];
        const double area = (double)(px - qx) * (double)(ry - py) - (double)(rx - px) * (double)(py - qy); /* exact: below 2^53 */
        s->ccw[i] = area > 0;
        s->kept[i] = ((area > 0) & keep_ccw) | ((area < 0) & keep_cw);
        any |= s->kept[i] | s->special[i];
    }
    return any;
}

/* The box of pixels that may be covered. */
static void sieve_boxes(struct sieved *FGL_RESTRICT s, const struct rect bounds, const int32_t first_row_owned)
{
    int32_t cut = 0;

    FOR_SIEVED (i, s) {
        const int32_t min_x = fgl_min(fgl_min(s->x[0][i], s->x[1][i]), s->x[2][i]), max_x = fgl_max(fgl_max(s->x[0][i], s->x[1][i]), s->x[2][i]);
        const int32_t min_y = fgl_min(fgl_min(s->y[0][i], s->y[1][i]), s->y[2][i]), max_y = fgl_max(fgl_max(s->y[0][i], s->y[1][i]), s->y[2][i]);
        const int32_t left = (min_x + 255) >> 8, right = (max_x + 255) >> 8, top = ((min_y - first_row_owned) >> 8) + 1,
                      bottom = ((max_y - first_row_owned) >> 8) + 1;
        const int32_t x0 = fgl_max(bounds.x0, left), x1 = fgl_min(bounds.x1, right);
        const int32_t y0 = fgl_max(bounds.y0, top), y1 = fgl_min(bounds.y1, bottom);
        cut |= (x0 != left) | (x1 != right) | (y0 != top) | (y1 != bottom);
        s->left[i] = left;
        s->top[i] = top;
        s->x0[i] = x0;
        s->x1[i] = x1;
        s->y0[i] = y0;
        s->y1[i] = y1;
        s->small[i] = (max_x - min_x <= SMALL_EXTENT) & (max_y - min_y <= SMALL_EXTENT);
        s->kept[i] &= (x0 < x1) & (y0 < y1);
    }
    s->cut = cut;
}

static void sieve_edge(struct sieve_edge *FGL_RESTRICT edge, const struct sieved *FGL_RESTRICT s, const int from, const int to,
                       const uint32_t first_row_owned)
{
    FOR_SIEVED (i, s) {
        const uint32_t reverse = (uint32_t)s->ccw[i] - 1; /* all bits where clockwise */
        const uint32_t x = (uint32_t)s->x[from][i], y = (uint32_t)s->y[from][i];
        const uint32_t a = ((y - (uint32_t)s->y[to][i]) ^ reverse) - reverse, b = ((x - (uint32_t)s->x[to][i]) ^ reverse) - reverse;
        const uint32_t level = a == 0 ? (b ^ (0 - first_row_owned)) + first_row_owned : 0; /* b, or -b */
        const uint32_t owns = (a | level) >> 31;
        edge->e[i] = a * (x - 256 * (uint32_t)s->left[i]) - b * (y - 256 * (uint32_t)s->top[i]) + owns - 1;
        edge->right[i] = 0 - 256 * a;
        edge->down[i] = 256 * b;
    }
}

/* Bits 0, 1, 2, 3: whether the pixels of a row that begins with these values of the edge functions are inside. */
static FGL_ALWAYS_INLINE uint32_t row_mask(uint32_t p, uint32_t q, uint32_t r, uint32_t p_step, uint32_t q_step, uint32_t r_step)
{
    const uint32_t first = p | q | r, second = (p + p_step) | (q + q_step) | (r + r_step);
    const uint32_t third = (p + 2 * p_step) | (q + 2 * q_step) | (r + 2 * r_step);
    const uint32_t fourth = (p + 3 * p_step) | (q + 3 * q_step) | (r + 3 * r_step);
    return ~first >> 31 | (~second >> 31) << 1 | (~third >> 31) << 2 | (~fourth >> 31) << 3;
}

/* Takes pixels beyond bounds out of the masks. */
static FGL_NOINLINE void sieve_cut(struct sieved *s, const struct rect *bounds)
{
    FOR_SIEVED (i, s)
        for (int bit = 0; s->mask[i] && bit < SMALL_SIDE * SMALL_SIDE; bit++) {
            const int x = s->left[i] + bit % SMALL_SIDE, y = s->top[i] + bit / SMALL_SIDE;
            if (x < bounds->x0 || x >= bounds->x1 || y < bounds->y0 || y >= bounds->y1)
                s->mask[i] &= ~(1u << bit);
        }
}

/* The pixels of small triangles, within bounds. */
static void sieve_masks(struct sieved *FGL_RESTRICT s, const struct rect *bounds, uint32_t first_row_owned)
{
    struct sieve_edge p, q, r;

    sieve_edge(&p, s, 0, 1, first_row_owned);
    sieve_edge(&q, s, 1, 2, first_row_owned);
    sieve_edge(&r, s, 2, 0, first_row_owned);
    FOR_SIEVED (i, s)
        s->mask[i] = 0;
    for (int y = 0; y < SMALL_SIDE; y++)
        FOR_SIEVED (i, s) {
            s->mask[i] |= row_mask(p.e[i], q.e[i], r.e[i], p.right[i], q.right[i], r.right[i]) << (SMALL_SIDE * y);
            p.e[i] += p.down[i];
            q.e[i] += q.down[i];
            r.e[i] += r.down[i];
        }
    FOR_SIEVED (i, s)
        s->mask[i] = s->small[i] ? s->mask[i] : 0;
    if (s->cut)
        sieve_cut(s, bounds);
    FOR_SIEVED (i, s)
        s->kept[i] &= (s->small[i] == 0) | (s->mask[i] != 0);
}

/* Of the boxes of those that are kept, and of those that may have to be clipped. */
static int64_t sieved_area(const struct sieved *s)
{
    int32_t sum = 0;
    FOR_SIEVED (i, s) {
        const int32_t width = s->kept[i] * (s->x1[i] - s->x0[i]), height = s->kept[i] * (s->y1[i] - s->y0[i]);
        sum += s->special[i] * AREA_MAX + fgl_min(width * height, AREA_MAX);
    }
    return sum;
}

/* Whether a triangle with a special vertex has to be clipped: neither all outside of one plane nor too far away to draw. */
static bool sieve_clipped(const uint32_t *outcode, const uint32_t v[3])
{
    const uint32_t a = outcode[v[0]], b = outcode[v[1]], c = outcode[v[2]];
    return (a & b & c) == 0 && (a | b | c) != 0;
}

/* Writes the first n, those that are kept or to be clipped. Returns how many. */
static int sieve_write(const struct sieved *s, const struct pipeline *p, const uint32_t (*vertex)[3], int n, struct seen_triangle *seen)
{
    const struct rect *bounds = &p->plan.raster.bounds;
    struct seen_triangle *to = seen;
    for (int i = 0; i < n; i++) {
        memcpy(to->vertex, vertex[i], sizeof to->vertex);
        to->x = (int16_t)s->left[i];
        to->y0 = (int16_t)(s->mask[i] ? s->top[i] : s->y0[i]);
        to->y1 = (int16_t)s->y1[i];
        to->mask = (uint16_t)s->mask[i];
        to->ccw = (uint8_t)s->ccw[i];
        to->clip = false;
        if (FGL_UNLIKELY(s->special[i]) && sieve_clipped(p->cache.outcode, to->vertex)) {
            to->y0 = (int16_t)bounds->y0;
            to->y1 = (int16_t)bounds->y1;
            to->mask = 0;
            to->clip = true;
            to++;
        }
        to += s->kept[i];
    }
    return (int)(to - seen);
}

static struct triangle_section sieve(const struct pipeline *p, const uint32_t (*vertex)[3], int n, struct seen_triangle *seen)
{
    struct triangle_section section = {0, 0};
    struct sieved s;

    for (int first = 0; first < n; first += SIEVE_SIZE) {
        const int count = fgl_min(n - first, SIEVE_SIZE);
        s.n = whole_sieve_groups(count + SIEVE_GROUP - 1);
        sieve_load(&s, p->cache.snapped, vertex + first);
        if (!sieve_orient(&s, &p->plan.raster))
            continue;
        sieve_boxes(&s, p->plan.raster.bounds, p->plan.raster.first_row_owned);
        if (p->general)
            memset(s.mask, 0, sizeof s.mask);
        else
            sieve_masks(&s, &p->plan.raster.bounds, (uint32_t)p->plan.raster.first_row_owned);
        section.area += sieved_area(&s);
        section.n += sieve_write(&s, p, vertex + first, count, seen + section.n);
    }
    return section;
}
#undef FOR_SIEVED

#endif
