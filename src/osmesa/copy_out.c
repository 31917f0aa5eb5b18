/* From the private buffers to the caller's, as glFlush and glFinish do: whole rows, in the format and type of the context. */
#include "osmesa/osmesa.h"

#include <string.h>

typedef void copy_row_fn(void *to, const void *from, int n);

static void row_index(void *to, const void *from, int n) { memcpy(to, from, (size_t)n); }
static void row_rgba(void *to, const void *from, int n) { memcpy(to, from, (size_t)n * 4); }
static void row_rgba16(void *to, const void *from, int n) { memcpy(to, from, (size_t)n * 8); }
static void row_float(void *to, const void *from, int n) { memcpy(to, from, (size_t)n * 16); }
static void row_565(void *to, const void *from, int n) { memcpy(to, from, (size_t)n * 2); }

static void row_bgra(void *to, const void *from, int n)
{
    uint8_t *t = to;
    const uint32_t *f = from;
    for (int i = 0; i < n; i++, t += 4) {
        t[0] = (uint8_t)(f[i] >> 16);
        t[1] = (uint8_t)(f[i] >> 8);
        t[2] = (uint8_t)f[i];
        t[3] = (uint8_t)(f[i] >> 24);
    }
}

static void row_argb(void *to, const void *from, int n)
{
    uint8_t *t = to;
    const uint32_t *f = from;
    for (int i = 0; i < n; i++, t += 4) {
        t[0] = (uint8_t)(f[i] >> 24);
        t[1] = (uint8_t)f[i];
        t[2] = (uint8_t)(f[i] >> 8);
        t[3] = (uint8_t)(f[i] >> 16);
    }
}

static void row_rgb(void *to, const void *from, int n)
{
    uint8_t *t = to;
    const uint32_t *f = from;
    for (int i = 0; i < n; i++)
        for (int c = 0; c < 3; c++)
            t[3 * i + c] = (uint8_t)(f[i] >> (8 * c));
}

static void row_bgr(void *to, const void *from, int n)
{
    uint8_t *t = to;
    const uint32_t *f = from;
    for (int i = 0; i < n; i++)
        for (int c = 0; c < 3; c++)
            t[3 * i + c] = (uint8_t)(f[i] >> (16 - 8 * c));
}

static void row_rgb16(void *to, const void *from, int n)
{
    for (int i = 0; i < n; i++)
        memcpy((uint16_t *)to + 3 * i, (const uint16_t *)from + 4 * i, 6);
}

static void row_rgb_float(void *to, const void *from, int n)
{
    for (int i = 0; i < n; i++)
        memcpy((float *)to + 3 * i, (const float *)from + 4 * i, 12);
}

/* How rows of this context are copied, with the bytes of a pixel on either side. */
static copy_row_fn *choose(const struct osmesa_context *c, size_t *to_bytes, size_t *from_bytes)
{
    const bool rgb = c->format == OSMESA_RGB || c->format == OSMESA_BGR;
    switch (c->fb.color_kind) {
    case COLOR_INDEX8: *to_bytes = *from_bytes = 1; return row_index;
    case COLOR_565: *to_bytes = *from_bytes = 2; return row_565;
    case COLOR_UNORM16: *to_bytes = rgb ? 6 : 8; *from_bytes = 8; return rgb ? row_rgb16 : row_rgba16;
    case COLOR_FLOAT: *to_bytes = rgb ? 12 : 16; *from_bytes = 16; return rgb ? row_rgb_float : row_float;
    default: break;
    }
    *from_bytes = 4;
    *to_bytes = rgb ? 3 : 4;
    switch (c->format) {
    case OSMESA_BGRA: return row_bgra;
    case OSMESA_ARGB: return row_argb;
    case OSMESA_RGB: return row_rgb;
    case OSMESA_BGR: return row_bgr;
    default: return row_rgba;
    }
}

void fgl_osmesa_copy_color(struct osmesa_context *c)
{
    size_t to_bytes, from_bytes;
    copy_row_fn *copy = choose(c, &to_bytes, &from_bytes);
    const struct framebuffer *fb = &c->fb;
    const size_t row = (size_t)(c->row_length ? c->row_length : fb->width) * to_bytes;
    for (int y = 0; y < fb->height; y++) {
        const int to_row = c->y_up ? fb->height - 1 - y : y;
        copy((char *)c->buffer + (size_t)to_row * row, (const char *)fb->color + (size_t)y * (size_t)fb->stride * from_bytes,
             fb->width);
    }
}

void fgl_osmesa_copy_depth(struct osmesa_context *c)
{
    const struct framebuffer *fb = &c->fb;
    for (int y = 0; y < fb->height; y++) {
        const size_t from = (size_t)y * (size_t)fb->stride;
        const size_t to = (size_t)(fb->height - 1 - y) * (size_t)fb->width;
        for (int x = 0; x < fb->width; x++) {
            const uint32_t z = fb->depth[from + (size_t)x];
            if (fb->depth_bits == 16)
                ((uint16_t *)c->depth_snapshot)[to + (size_t)x] = (uint16_t)z;
            else
                ((uint32_t *)c->depth_snapshot)[to + (size_t)x] = z | (fb->stencil ? (uint32_t)fb->stencil[from + (size_t)x] << 24 : 0);
        }
    }
}
