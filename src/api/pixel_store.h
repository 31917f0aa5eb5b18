/* Polygon stipples in the program's memory and in the state (GL 1.5, 3.5.2 "Stippling", 3.6.1 "Pixel Storage
 * Modes"). */
#ifndef FGL_API_PIXEL_STORE_H
#define FGL_API_PIXEL_STORE_H

#include "state/context.h"

/* Stores a stipple, rows as in struct polygon_stipple_state; for glPolygonStipple and for its replay from a
 * display list (OP_POLYGON_STIPPLE: the payload is the 32 rows). */
void fgl_polygon_stipple_set(struct context *ctx, const uint32_t row[32]);

#endif
