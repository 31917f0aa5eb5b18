/* Clearing (GL 1.5, 4.2.3 "Clearing the Buffers"). */
#include "framebuffer/framebuffer.h"

#include "base/color_index.h"

#include <string.h>

static void fill32(uint32_t *p, int n, uint32_t value, uint32_t mask)
{
    if (mask == ~0u) {
        for (int i = 0; i < n; i++)
            p[i] = value;
        return;
    }
    for (int i = 0; i < n; i++)
        p[i] = (p[i] & ~mask) | (value & mask);
}

static void fill16(uint16_t *p, int n, uint16_t value, uint16_t mask)
{
    for (int i = 0; i < n; i++)
        p[i] = (uint16_t)((p[i] & ~mask) | (value & mask));
}

/* OSMesa rule: in buffers of other than 8 bits, halves are rounded up. */
static uint32_t unorm_half_up(float v, float max)
{
    return (uint32_t)(fgl_clamp01(v) * max + 0.5f);
}

static void clear_row_unorm16(uint16_t *p, int n, const float color[4], const bool mask[4], bool drawn)
{
    for (int c = 0; c < 4; c++) {
        const uint16_t v = (uint16_t)(drawn ? fgl_unorm(color[c], 65535.0f) : unorm_half_up(color[c], 65535.0f));
        for (int i = 0; mask[c] && i < n; i++)
            p[4 * i + c] = v;
    }
}

static void clear_row_float(float *p, int n, const float color[4], const bool mask[4])
{
    for (int c = 0; c < 4; c++)
        for (int i = 0; mask[c] && i < n; i++)
            p[4 * i + c] = color[c];
}

/* OSMesa rule: what is drawn loses the last bits of 8-bit values. */
static uint16_t pack_565(const float color[4], bool drawn)
{
    static const int bits[3] = {5, 6, 5}, shift[3] = {11, 5, 0};
    uint32_t pixel = 0;
    for (int c = 0; c < 3; c++)
        pixel |= (drawn ? fgl_unorm(color[c], 255.0f) >> (8 - bits[c]) : unorm_half_up(color[c], (float)((1 << bits[c]) - 1))) << shift[c];
    return (uint16_t)pixel;
}

static void clear_row(struct framebuffer *fb, size_t at, int n, const float color[4], const bool mask[4], bool drawn)
{
    switch (fb->color_kind) {
    case COLOR_UNORM8: {
        uint32_t value = 0, bits = 0;
        for (int c = 0; c < 4; c++) {
            value |= fgl_unorm(color[c], 255.0f) << (8 * c);
            bits |= mask[c] ? 255u << (8 * c) : 0;
        }
        fill32((uint32_t *)fb->color + at, n, value, bits);
        break;
    }
    case COLOR_UNORM16: clear_row_unorm16((uint16_t *)fb->color + 4 * at, n, color, mask, drawn); break;
    case COLOR_FLOAT: clear_row_float((float *)fb->color + 4 * at, n, color, mask); break;
    case COLOR_INDEX8: break; /* fgl_clear_index */
    case COLOR_565: {
        const uint32_t bits = (mask[0] ? 0xf800u : 0) | (mask[1] ? 0x07e0u : 0) | (mask[2] ? 0x001fu : 0);
        fill16((uint16_t *)fb->color + at, n, pack_565(color, drawn), (uint16_t)bits);
        break;
    }
    }
}

void fgl_clear_color(struct framebuffer *fb, struct rect r, const float color[4], const bool mask[4], bool drawn)
{
    for (int y = r.y0; y < r.y1; y++)
        clear_row(fb, (size_t)y * (size_t)fb->stride + (size_t)r.x0, r.x1 - r.x0, color, mask, drawn);
}

/* The bits in mask of a plane of bytes. */
static void clear_bytes(uint8_t *plane, int stride, struct rect r, uint8_t value, uint8_t mask)
{
    for (int y = r.y0; y < r.y1; y++) {
        uint8_t *p = plane + (size_t)y * (size_t)stride + r.x0;
        for (int i = 0; i < r.x1 - r.x0; i++)
            p[i] = (uint8_t)((p[i] & ~mask) | (value & mask));
    }
}

/* The integer part of the index counts. */
void fgl_clear_index(struct framebuffer *fb, struct rect r, float index, unsigned writemask)
{
    clear_bytes(fb->color, fb->stride, r, (uint8_t)fgl_index_mask((double)index), (uint8_t)writemask);
}

/* OSMesa rule: the depth of a drawn rectangle goes through the viewport transformation. */
static double drawn_depth(double depth, uint32_t depth_max)
{
    const float window = (float)(depth * 2.0 - 1.0) * 0.5f + 0.5f;
    return (double)(fgl_clamp01(window) * (float)depth_max);
}

void fgl_clear_depth(struct framebuffer *fb, struct rect r, double depth, bool drawn)
{
    if (!fb->depth)
        return;
    const double d = depth < 0.0 ? 0.0 : depth > 1.0 ? 1.0 : depth;
    const double magic = 6755399441055744.0; /* 1.5 * 2^52: adding it rounds to an integer, half to even (OSMesa rule) */
    const double scaled = drawn ? drawn_depth(d, fb->depth_max) : d * fb->depth_max;
    const uint32_t value = (uint32_t)((scaled + magic) - magic);
    for (int y = r.y0; y < r.y1; y++)
        fill32(fb->depth + (size_t)y * (size_t)fb->stride + (size_t)r.x0, r.x1 - r.x0, value, ~0u);
}

void fgl_clear_stencil(struct framebuffer *fb, struct rect r, int value, unsigned writemask)
{
    if (!fb->stencil_bits || !fgl_framebuffer_need_stencil(fb))
        return;
    clear_bytes(fb->stencil, fb->stride, r, (uint8_t)value, (uint8_t)writemask);
}
