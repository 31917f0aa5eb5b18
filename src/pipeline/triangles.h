/* The filled triangles of a draw, gathered so that the work on them can be shared among threads. Assembly names their vertices; a flush first
 * sieves out those that cannot be seen, then shades what vertices are left (shade.c), then fills, in the order in which they were added, whatever
 * the number of threads. */
#ifndef FGL_PIPELINE_TRIANGLES_H
#define FGL_PIPELINE_TRIANGLES_H

#include "base/fgl.h"
#include "raster/raster.h"

struct pipeline;

enum {
    TRIANGLES_MAX = 1 << 16,
    SECTION_TRIANGLES = 1024, /* are sieved together */
    SECTIONS = TRIANGLES_MAX / SECTION_TRIANGLES,
    SIEVE_GROUP = 16 /* the sieve reads whole groups of triangles */
};

/* A square of this many pixels on a side holds a small triangle's. */
enum { SMALL_SIDE = 4 };

/* A triangle that is not culled and may cover a pixel. */
struct seen_triangle {
    uint32_t vertex[3]; /* numbers in the cache, the provoking one last */
    int16_t x, y0, y1;  /* rows that it may cover; the leftmost pixel that it may */
    uint16_t mask;      /* small triangles: bit SMALL_SIDE * (Y - y0) + (X - x) for each pixel covered; else 0 */
    uint8_t ccw;        /* small triangles: 1 if counter-clockwise as GL sees it */
    bool clip;          /* some vertex is outside of the view volume */
};

struct triangle_section {
    int n;        /* of its triangles that are seen: the first ones in `seen` */
    int64_t area; /* of their bounding boxes, pixels */
};

struct triangle_list {
    int n;
    uint32_t (*vertex)[3];      /* TRIANGLES_MAX, the first n in use; allocated by the first draw */
    struct seen_triangle *seen; /* those of section s from s * SECTION_TRIANGLES on */
    struct triangle_section section[SECTIONS];
};

bool fgl_triangles_init(struct triangle_list *t);
void fgl_triangles_free(struct triangle_list *t);
/* Draws and forgets what was gathered. */
void fgl_triangles_flush(struct pipeline *p);

static inline int fgl_triangles_sections(const struct triangle_list *t)
{
    return (t->n + SECTION_TRIANGLES - 1) / SECTION_TRIANGLES;
}

#endif
