/* Drawing: from arrays of vertices to the rasterizer (GL 1.5, 2.6 "Begin/End Paradigm", 2.8 "Vertex Arrays"). Layer 4.
 * Immediate mode, vertex arrays and display lists all arrive here, as arrays. */
#ifndef FGL_PIPELINE_DRAW_H
#define FGL_PIPELINE_DRAW_H

#include "state/context.h"

/* Where one attribute's values lie. */
struct attr_source {
    const void *pointer;
    GLenum type;
    int size;   /* components */
    int stride; /* bytes, never 0 */
    bool bounded;   /* only `count` elements may be read; those beyond are 0 */
    uint32_t count;
};

struct vertex_source {
    uint32_t varying; /* bit a: attr[a] is an array; the others are current values */
    struct attr_source attr[ATTR_COUNT];
    bool compiled; /* from a display list */
    bool arrays;   /* from vertex arrays */
    bool range_unknown; /* OSMesa rule: of elements where all arrays lie in buffer objects, unless glDrawRangeElements names their range */
};

/* One primitive: vertices first .. first+count of the source, or of the elements. */
struct draw_prim {
    GLenum mode;
    int first, count;
    bool goes_on; /* a line strip whose beginning was another draw's: its stipple goes on too */
};

/* Draws n primitives. elements: NULL, or vertex numbers, all within min_index..max_index. */
void fgl_draw(struct context *ctx, const struct vertex_source *source, const struct draw_prim *prims, int n,
              const uint32_t *elements, uint32_t min_index, uint32_t max_index);

#endif
