/* The accumulation buffer (GL 1.5, 4.2.4): four 16-bit numbers a pixel, 32767 = 1.0. Layer 2.
 * OSMesa rule: products are cut off, sums wrap around. */
#ifndef FGL_FRAMEBUFFER_ACCUM_H
#define FGL_FRAMEBUFFER_ACCUM_H

#include "framebuffer/framebuffer.h"

/* Makes it ready for all below but fgl_accum_clear, which does so itself. False when memory is short. */
bool fgl_accum_ready(struct framebuffer *fb);

/* All work on the pixels of r. Programs clear it along with the other buffers and seldom use it, so a clear of the whole is put off until
 * then. False when memory is short. */
bool fgl_accum_clear(struct framebuffer *fb, struct rect r, const float value[4]);
/* Adds (or stores) colour times value. */
void fgl_accum_color(struct framebuffer *fb, struct rect r, float value, bool add);
void fgl_accum_add(struct framebuffer *fb, struct rect r, float value);
void fgl_accum_multiply(struct framebuffer *fb, struct rect r, float value);
/* The accumulated numbers times value become the colour, in the channels of mask. */
void fgl_accum_return(struct framebuffer *fb, struct rect r, float value, const bool mask[4]);

#endif
