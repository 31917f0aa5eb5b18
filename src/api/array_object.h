/* Vertex array objects (GL_ARB_vertex_array_object): each holds arrays and a binding of
 * GL_ELEMENT_ARRAY_BUFFER. They are not shared between contexts. What is bound lies in the context's client
 * state; the object keeps it while another is bound. */
#ifndef FGL_API_ARRAY_OBJECT_H
#define FGL_API_ARRAY_OBJECT_H

#include "state/context.h"

/* Puts saved arrays in the place of what is bound, and binds their object; drops them if the object was
 * deleted since. The references in `saved` are used up. */
void fgl_array_object_restore(struct context *ctx, struct client_array_state *saved);

void fgl_array_objects_destroy(struct context *ctx);

/* Whether an array may not be placed in client memory: array objects have buffer objects only, but for a null
 * pointer. */
static inline bool fgl_array_object_refuses(const struct context *ctx, const void *pointer)
{
    return ctx->client.arrays.object && !ctx->client.arrays.array_buffer && pointer;
}

#endif
