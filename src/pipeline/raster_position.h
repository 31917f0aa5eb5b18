/* The current raster position and its associated data (GL 1.5, 2.13 "Current Raster Position"). Layer 4. */
#ifndef FGL_PIPELINE_RASTER_POSITION_H
#define FGL_PIPELINE_RASTER_POSITION_H

#include "state/context.h"

/* glRasterPos: object coordinates go the way of a vertex. The position becomes invalid when clipped, or when a context has no
 * framebuffer yet. */
void fgl_raster_position_set(struct context *ctx, const float object[4]);
/* glWindowPos: window coordinates, z clamped and mapped to the depth range. */
void fgl_raster_position_set_window(struct context *ctx, float x, float y, float z);

#endif
