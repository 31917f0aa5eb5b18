/* Zoomed pixel rectangles that the window's edge cuts (GL 1.5, 3.6.4). Layer 4.
 *
 * OSMesa rule: the two triangles of such a rectangle are clipped as those of polygons are, and the image's coordinates of what is left
 * are set up anew for each piece: their last bits, and with them the pixel that a centre between two shows, are others than those of the
 * whole rectangle (raster/zoom.h). */
#ifndef FGL_PIPELINE_ZOOM_CLIP_H
#define FGL_PIPELINE_ZOOM_CLIP_H

#include "raster/zoom.h"

/* Takes the window pixels x0 <= x < x1 of row y; pixel x shows column[x] and row[x] of the image. */
typedef void zoomed_run_fn(void *taker, int y, int x0, int x1, const int *column, const int *row);

/* Hands all pixels of the rectangle within bounds to take(); depth is the raster position's. False when memory is short. */
bool fgl_zoom_clip(const struct zoom *zoom, const struct framebuffer *fb, const struct rect *bounds, zoomed_run_fn *take, void *taker);

#endif
