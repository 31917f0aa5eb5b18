/* Loops over the numbers of a row of pixels, for the accumulation buffer and pixel rectangles. Layer 2. They are
 * compiled once for each instruction set and arithmetic (kernels.c); every set gives the same bytes. */
#ifndef FGL_FRAMEBUFFER_ROWS_H
#define FGL_FRAMEBUFFER_ROWS_H

#include "base/cpu.h"
#include "framebuffer/framebuffer.h"

/* n counts pixels, each of them four numbers side by side, red first, unless it is said otherwise. */
struct row_kernels {
    /* v * (1 / 255) */
    void (*unorm8_to_float)(const uint32_t *pixel, int n, float *color);
    /* Clamped, rounded half to even. */
    void (*float_to_unorm8)(const float *color, int n, uint32_t *pixel);
    /* The same from a plane for each channel. */
    void (*planes_to_unorm8)(const float *const channel[4], int n, uint32_t *pixel);
    /* n depths: v / max, rounded to float once; max is 2^24 - 1 or 2^16 - 1. */
    void (*depth_to_float)(const uint32_t *depth, int n, uint32_t max, float *out);
    /* accum + color * scale, or color * scale alone when not `add`, products cut off, sums modulo 2^16 */
    void (*accumulate)(int16_t *accum, const float *color, int n, float scale, bool add);
    void (*accum_multiply)(int16_t *accum, int n, float value);
    /* accum * scale as pixels */
    void (*accum_to_unorm8)(const int16_t *accum, int n, float scale, uint32_t *pixel);
};

/* Those of the processor's best instruction set. The arithmetic decides how floats are rounded to bytes, no more. */
const struct row_kernels *fgl_row_kernels(enum fgl_arith arith);

#endif
