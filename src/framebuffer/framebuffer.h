/* The framebuffer: colour, depth, stencil and accumulation buffers of a context (GL 1.5, chapter 4). Layer 2.
 *
 * Private storage, as OSMesa's: the caller's buffer changes only when it is copied out (osmesa/osmesa.c, at glFlush and glFinish).
 * Row 0 is the top of the window, and the bottom of a framebuffer object (y_up). Which of the two it is shows in the viewport's transformation,
 * in the rows that level edges own, and where window coordinates become rows: fgl_row, fgl_turned. Every row is padded to a multiple of
 * FB_ALIGN pixels and starts on 64 bytes, so that a kernel may read and write back whole aligned groups of pixels that reach over the right
 * edge. */
#ifndef FGL_FRAMEBUFFER_FRAMEBUFFER_H
#define FGL_FRAMEBUFFER_FRAMEBUFFER_H

#include "base/fgl.h"

enum { FB_ALIGN = 64 }; /* pixels */

/* How colour is stored: the precision of the caller's buffer type. */
enum color_kind {
    COLOR_UNORM8,  /* uint32_t a pixel: red in the low byte, then green, blue, alpha */
    COLOR_UNORM16, /* four uint16_t a pixel: red, green, blue, alpha */
    COLOR_FLOAT,   /* four floats a pixel, neither rounded nor clamped */
    COLOR_565,     /* uint16_t a pixel: red in the high 5 bits */
    COLOR_INDEX8   /* uint8_t a pixel: a colour index (colour index mode) */
};

struct framebuffer {
    int width, height;
    int stride; /* pixels from a row to the next: width rounded up to FB_ALIGN */
    enum color_kind color_kind;
    bool y_up;      /* row 0 is the lowest. OSMesa rule: in framebuffer objects */
    bool has_alpha; /* false for RGB formats: alpha reads as 1 */
    bool reordered;     /* the caller's bytes are in another order than red, green, blue, alpha, or three */
    bool one_component; /* of an image that keeps no more of a colour */
    uint8_t image_bits[4]; /* of red, green, blue, alpha, where an image has fewer than are drawn to; else 0 */
    bool rounds;         /* of an image with fewer bits than the 8 that are drawn to: */
    uint8_t rounded[4][256]; /* what it keeps of a byte of red, green, blue, alpha */
    void *color;
    uint32_t *depth;    /* 0..depth_max; NULL when the context has none */
    uint32_t depth_max; /* 2^depth_bits - 1 */
    int depth_bits, stencil_bits, accum_bits;
    uint8_t *stencil;   /* NULL until first used */
    int16_t *accum;     /* four a pixel, 32767 = 1.0; NULL until first used */
    bool accum_waits;   /* all of it was cleared to accum_cleared, which is done when it is used: fgl_accum_ready */
    int16_t accum_cleared[4];
    bool drawn;         /* something was rendered since the last copy to the caller's buffer */
};

/* All buffers zero but depth, which is depth_max. Returns false when memory is short; *fb is then unchanged. */
bool fgl_framebuffer_resize(struct framebuffer *fb, int width, int height, enum color_kind kind);
bool fgl_framebuffer_need_stencil(struct framebuffer *fb);
bool fgl_framebuffer_need_accum(struct framebuffer *fb);
void fgl_framebuffer_free(struct framebuffer *fb);

struct rect {
    int x0, y0, x1, y1; /* columns and rows, half open */
};

/* The row of window coordinate y (y up), and the other way around. */
static inline int fgl_row(const struct framebuffer *fb, int y)
{
    return fb->y_up ? y : fb->height - 1 - y;
}

/* The rows of a rectangle of window pixels (y up), and the other way around. */
static inline struct rect fgl_turned(const struct framebuffer *fb, struct rect r)
{
    return fb->y_up ? r : (struct rect){r.x0, fb->height - r.y1, r.x1, fb->height - r.y0};
}

/* Window y (y up), not only of pixels, from where it is among the rows, and the other way around. */
static inline float fgl_turned_y(const struct framebuffer *fb, float y)
{
    return fb->y_up ? y : (float)fb->height - y;
}

/* clear.c (GL 1.5, 4.2.3). Colour as given to glClearColor; only channels in mask. drawn: not all of the buffer is cleared; OSMesa
 * draws a rectangle then, whose values may be rounded differently. */
void fgl_clear_color(struct framebuffer *fb, struct rect r, const float color[4], const bool mask[4], bool drawn);
/* Colour index mode: as given to glClearIndex; only bits in writemask. */
void fgl_clear_index(struct framebuffer *fb, struct rect r, float index, unsigned writemask);
void fgl_clear_depth(struct framebuffer *fb, struct rect r, double depth, bool drawn);
void fgl_clear_stencil(struct framebuffer *fb, struct rect r, int value, unsigned writemask);

/* Colour in [0,1] to n bits: round half to even of v * (2^n - 1); below 0 and NaN give 0. */
static inline uint32_t fgl_unorm(float v, float max)
{
    const float c = v < 1.0f ? (v > 0.0f ? v : 0.0f) : (v >= 1.0f ? 1.0f : 0.0f);
    const float magic = 8388608.0f; /* 2^23: adding it rounds to an integer, half to even */
    const float s = c * max;
    return max < 8388608.0f ? (uint32_t)(s + magic - magic) : (uint32_t)s;
}

#endif
