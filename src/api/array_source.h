/* The enabled vertex arrays, for the commands that draw from them. */
#ifndef FGL_API_ARRAY_SOURCE_H
#define FGL_API_ARRAY_SOURCE_H

#include "pipeline/draw.h"

void fgl_array_source(const struct context *ctx, struct vertex_source *source);

/* Elements that some array of the source has: beyond it there is nothing but zeros. UINT32_MAX when one is in client memory. */
uint32_t fgl_array_source_count(const struct vertex_source *source);

/* Whether an enabled array is in a buffer object that is mapped: drawing is then an error (GL 1.5, 2.9). */
bool fgl_arrays_mapped(const struct context *ctx);

/* One element of every enabled array through the commands of immediate mode, the position last. drawn: by a draw, else by ArrayElement. */
void fgl_array_element(struct context *ctx, const struct vertex_source *source, uint32_t i, bool drawn);

#endif
