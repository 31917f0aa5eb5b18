/* Colour between the buffer's formats (enum color_kind) and what the stages work on: packed bytes, or an array for each
 * channel. 565 is worked on with 8 bits a channel. */
#ifndef FGL_FRAGMENT_PIXEL_H
#define FGL_FRAGMENT_PIXEL_H

#include "fragment/tests.h"

static inline ptrdiff_t pixel_index(const struct framebuffer *fb, int row, int x)
{
    return row * (ptrdiff_t)fb->stride + x;
}

/* Red at `shift` of a 565 pixel with n bits, repeated to fill 8. */
static FGL_ALWAYS_INLINE uint32_t expand(uint32_t pixel, int shift, int n)
{
    const uint32_t v = pixel >> shift & ((1u << n) - 1);
    return v << (8 - n) | v >> (2 * n - 8);
}

/* Buffers of 8 bits and fewer, packed as UNORM8 is. One without alpha reads as opaque (GL 1.5, 4.1.8). */
static inline void load_packed(const struct framebuffer *fb, int row, int x, uint32_t dst[FRAGMENT_GROUP])
{
    const ptrdiff_t at = pixel_index(fb, row, x);
    const uint32_t opaque = fb->has_alpha ? 0 : 0xff000000u;
    if (fb->color_kind == COLOR_UNORM8) {
        const uint32_t *p = (const uint32_t *)fb->color + at;
        FOR_GROUP(i) dst[i] = p[i] | opaque;
    } else {
        const uint16_t *p = (const uint16_t *)fb->color + at;
        FOR_GROUP(i) dst[i] = expand(p[i], 11, 5) | expand(p[i], 5, 6) << 8 | expand(p[i], 0, 5) << 16 | opaque;
    }
}

static inline void store_packed(const struct framebuffer *fb, int row, int x, const uint32_t src[FRAGMENT_GROUP])
{
    const ptrdiff_t at = pixel_index(fb, row, x);
    if (fb->color_kind == COLOR_UNORM8) {
        uint32_t *p = (uint32_t *)fb->color + at;
        FOR_GROUP(i) p[i] = src[i];
    } else {
        uint16_t *p = (uint16_t *)fb->color + at;
        FOR_GROUP(i) p[i] = (uint16_t)((src[i] >> 3 & 31) << 11 | (src[i] >> 10 & 63) << 5 | (src[i] >> 19 & 31));
    }
}

/* Those of 16 bits. */
static inline void load_words(const struct framebuffer *fb, int row, int x, uint32_t dst[4][FRAGMENT_GROUP])
{
    const uint16_t *p = (const uint16_t *)fb->color + 4 * pixel_index(fb, row, x);
    for (int c = 0; c < 4; c++)
        FOR_GROUP(i) dst[c][i] = c == 3 && !fb->has_alpha ? 65535 : p[4 * i + c];
}

static inline void store_words(const struct framebuffer *fb, int row, int x, const uint32_t src[4][FRAGMENT_GROUP])
{
    uint16_t *p = (uint16_t *)fb->color + 4 * pixel_index(fb, row, x);
    for (int c = 0; c < 4; c++)
        FOR_GROUP(i) p[4 * i + c] = (uint16_t)src[c][i];
}

static inline void load_float(const struct framebuffer *fb, int row, int x, real dst[4][FRAGMENT_GROUP])
{
    const float *p = (const float *)fb->color + 4 * pixel_index(fb, row, x);
    for (int c = 0; c < 4; c++)
        FOR_GROUP(i) dst[c][i] = c == 3 && !fb->has_alpha ? 1 : (real)p[4 * i + c];
}

static inline void store_float(const struct framebuffer *fb, int row, int x,
                               const real src[4][FRAGMENT_GROUP])
{
    float *p = (float *)fb->color + 4 * pixel_index(fb, row, x);
    for (int c = 0; c < 4; c++)
        FOR_GROUP(i) p[4 * i + c] = (float)src[c][i];
}

#endif
