/* The filled triangles of a draw, gathered so that filling them can be shared among threads. Assembly adds those that may cover a pixel;
 * a flush fills them in the order in which they were added, whatever the number of threads. */
#ifndef FGL_PIPELINE_TRIANGLES_H
#define FGL_PIPELINE_TRIANGLES_H

#include "base/fgl.h"
#include "raster/raster.h"

struct pipeline;

enum { TRIANGLES_MAX = 1 << 16 };

/* Numbers of vertices in the cache, c provoking. */
struct listed_triangle {
    uint32_t a, b, c;
    bool clip;      /* some vertex is outside of the view volume */
    int16_t y0, y1; /* rows that it may cover */
};

struct triangle_list {
    int n;
    int64_t area; /* of their bounding boxes, pixels */
    struct listed_triangle *triangle; /* TRIANGLES_MAX, allocated by the first draw */
};

bool fgl_triangles_init(struct triangle_list *t);
void fgl_triangles_free(struct triangle_list *t);
/* A triangle with a vertex that is special. */
void fgl_triangles_add_special(struct pipeline *p, uint32_t a, uint32_t b, uint32_t c);
/* Draws and forgets what was gathered. */
void fgl_triangles_flush(struct pipeline *p);

static inline int fgl_min3(int a, int b, int c) { return fgl_min(fgl_min(a, b), c); }
static inline int fgl_max3(int a, int b, int c) { return fgl_max(fgl_max(a, b), c); }

/* Adds the triangle of vertices a, b, c at p, q, r that are not special, unless it is culled, has no area, or no pixel centre in its bounding box. The list
 * has room. The tests are those of the rasterizer (raster/coverage.h), which makes them again. */
static FGL_ALWAYS_INLINE void fgl_triangles_add(struct triangle_list *t, const struct raster_plan *plan, struct snapped p, struct snapped q,
                                                struct snapped r, uint32_t a, uint32_t b, uint32_t c)
{
    const int64_t area = (int64_t)(p.x - q.x) * (r.y - p.y) - (int64_t)(r.x - p.x) * (p.y - q.y);
    if (area > 0 ? plan->cull_ccw : area < 0 ? plan->cull_cw : true)
        return;
    const int x0 = fgl_max(plan->bounds.x0, (fgl_min3(p.x, q.x, r.x) + 255) >> 8);
    const int x1 = fgl_min(plan->bounds.x1, (fgl_max3(p.x, q.x, r.x) + 255) >> 8);
    const int y0 = fgl_max(plan->bounds.y0, (fgl_min3(p.y, q.y, r.y) >> 8) + 1);
    const int y1 = fgl_min(plan->bounds.y1, (fgl_max3(p.y, q.y, r.y) >> 8) + 1);
    if ((x0 >= x1) | (y0 >= y1))
        return;
    t->triangle[t->n++] = (struct listed_triangle){a, b, c, false, (int16_t)y0, (int16_t)y1};
    t->area += (x1 - x0) * (y1 - y0);
}

#endif
