/* The filled triangles of a draw, gathered so that culling them is one loop over arrays and filling them can be shared among threads.
 * Assembly adds; a flush culls and fills, in the order in which they were added, whatever the number of threads. */
#ifndef FGL_PIPELINE_TRIANGLES_H
#define FGL_PIPELINE_TRIANGLES_H

#include "base/fgl.h"

struct pipeline;

enum {
    TRIANGLES_MAX = 1 << 16,
    TRIANGLES_ITEM = 1024, /* culled together */
    TRIANGLE_CLIP = 1 << 31 /* in a: some vertex is outside of the view volume */
};

/* Numbers of vertices in the cache, c provoking. */
struct triangle_list {
    int n;
    uint32_t *a, *b, *c;                               /* TRIANGLES_MAX of each, allocated with the pipeline's first triangle */
    int16_t *y0, *y1;                                  /* rows that the triangle may cover */
    uint32_t *visible;                                 /* each item's triangles that are left, from the item's start on */
    int visible_count[TRIANGLES_MAX / TRIANGLES_ITEM]; /* of each item */
    int64_t area[TRIANGLES_MAX / TRIANGLES_ITEM];      /* of their bounding boxes, pixels */
};

bool fgl_triangles_init(struct triangle_list *t);
void fgl_triangles_free(struct triangle_list *t);
/* Draws and forgets what was gathered. */
void fgl_triangles_flush(struct pipeline *p);

#endif
