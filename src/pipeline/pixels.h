/* Fragments that pixel rectangles and bitmaps make (GL 1.5, 3.6.4, 3.7 "Bitmaps"): they take the associated data of the raster position
 * and pass the same stages as those of other primitives. Layer 4. */
#ifndef FGL_PIPELINE_PIXELS_H
#define FGL_PIPELINE_PIXELS_H

#include "fragment/fragment.h"

struct pixel_draw {
    struct fragment_plan fragment;
    struct rect bounds; /* pixels that may be drawn: framebuffer and scissor */
    struct planes planes;
    struct pixel_inputs inputs; /* what differs by pixel; the caller's arrays */
};

enum pixel_kind { PIXELS_COLOR, PIXELS_DEPTH, PIXELS_BITMAP };

/* Prepares *draw for the current state and raster position. The context has a framebuffer. */
void fgl_pixels_begin(struct context *ctx, enum pixel_kind kind, struct pixel_draw *draw);

/* Whether colours go to a buffer of bytes as they come, so that they may as well come as bytes: inputs.unorm8. */
bool fgl_pixels_take_unorm8(const struct pixel_draw *draw);

/* Draws pixels, all inside the bounds; x0 <= x < x1 of row y. */
void fgl_pixels_runs(const struct pixel_draw *draw, const struct runs *runs);
void fgl_pixels_run(const struct pixel_draw *draw, int y, int x0, int x1);

#endif
