/* Row by row, in chunks of floats that hold red, green, blue and alpha of a pixel side by side, as the buffer does. */
#include "framebuffer/accum.h"
#include "framebuffer/rows.h"

#include <string.h>

enum { ACCUM_CHUNK = 256 }; /* pixels */

static int16_t *accum_at(struct framebuffer *fb, int x, int y)
{
    return fb->accum + 4 * ((size_t)y * (size_t)fb->stride + (size_t)x);
}

static int16_t wrapped(float v)
{
    return v > -2147483648.0f && v < 2147483648.0f ? (int16_t)(uint16_t)(int32_t)v : 0;
}

static void fill(struct framebuffer *fb, struct rect r, const int16_t value[4])
{
    for (int y = r.y0; y < r.y1; y++) {
        int16_t *a = accum_at(fb, r.x0, y);
        for (int i = 0; i < r.x1 - r.x0; i++, a += 4)
            for (int c = 0; c < 4; c++)
                a[c] = value[c];
    }
}

bool fgl_accum_ready(struct framebuffer *fb)
{
    if (!fgl_framebuffer_need_accum(fb))
        return false;
    if (fb->accum_waits)
        fill(fb, (struct rect){0, 0, fb->width, fb->height}, fb->accum_cleared);
    fb->accum_waits = false;
    return true;
}

bool fgl_accum_clear(struct framebuffer *fb, struct rect r, const float value[4])
{
    const bool whole = r.x0 == 0 && r.y0 == 0 && r.x1 == fb->width && r.y1 == fb->height;
    int16_t clear[4];
    for (int c = 0; c < 4; c++) /* OSMesa rule: as GL 1.5, table 4.7 converts to 16 bits */
        clear[c] = (int16_t)((int32_t)(65535.0f * value[c] - 1.0f) / 2);
    if (whole) {
        memcpy(fb->accum_cleared, clear, sizeof clear);
        fb->accum_waits = true;
        return true;
    }
    if (!fgl_accum_ready(fb))
        return false;
    fill(fb, r, clear);
    return true;
}

static void fetch_565(const uint16_t *FGL_RESTRICT p, int n, float *FGL_RESTRICT color)
{
    for (int i = 0; i < n; i++) {
        color[4 * i + 0] = (float)(p[i] >> 11) * (1.0f / 31.0f);
        color[4 * i + 1] = (float)(p[i] >> 5 & 63) * (1.0f / 63.0f);
        color[4 * i + 2] = (float)(p[i] & 31) * (1.0f / 31.0f);
    }
}

static void fetch_color(const struct framebuffer *fb, size_t at, int n, float *FGL_RESTRICT color)
{
    const uint16_t *unorm16 = (const uint16_t *)fb->color + 4 * at;
    const float *floats = (const float *)fb->color + 4 * at;
    switch (fb->color_kind) {
    case COLOR_UNORM8: fgl_row_kernels(ARITH_COMPATIBLE)->unorm8_to_float((const uint32_t *)fb->color + at, n, color); break;
    case COLOR_565: fetch_565((const uint16_t *)fb->color + at, n, color); break;
    case COLOR_UNORM16:
        for (int i = 0; i < 4 * n; i++)
            color[i] = (float)unorm16[i] * (1.0f / 65535.0f);
        break;
    case COLOR_FLOAT:
        for (int i = 0; i < 4 * n; i++)
            color[i] = floats[i];
        break;
    case COLOR_INDEX8: /* has no accumulation buffer */
        break;
    }
    for (int i = 0; !fb->has_alpha && i < n; i++)
        color[4 * i + 3] = 1.0f;
}

void fgl_accum_color(struct framebuffer *fb, struct rect r, float value, bool add)
{
    float color[4 * ACCUM_CHUNK];
    for (int y = r.y0; y < r.y1; y++)
        for (int x = r.x0; x < r.x1; x += ACCUM_CHUNK) {
            const int n = fgl_min(ACCUM_CHUNK, r.x1 - x);
            fetch_color(fb, (size_t)y * (size_t)fb->stride + (size_t)x, n, color);
            fgl_row_kernels(ARITH_COMPATIBLE)->accumulate(accum_at(fb, x, y), color, n, value * 32767.0f, add);
        }
}

void fgl_accum_add(struct framebuffer *fb, struct rect r, float value)
{
    const int16_t increment = wrapped(value * 32767.0f);
    for (int y = r.y0; y < r.y1; y++) {
        int16_t *a = accum_at(fb, r.x0, y);
        for (int i = 0; i < 4 * (r.x1 - r.x0); i++)
            a[i] = (int16_t)(a[i] + increment);
    }
}

void fgl_accum_multiply(struct framebuffer *fb, struct rect r, float value)
{
    for (int y = r.y0; y < r.y1; y++)
        fgl_row_kernels(ARITH_COMPATIBLE)->accum_multiply(accum_at(fb, r.x0, y), r.x1 - r.x0, value);
}

static void return_pixels(struct framebuffer *fb, const int16_t *a, int x, int y, int n, float scale, const bool mask[4])
{
    for (int i = 0; i < n; i++, a += 4) {
        const float color[4] = {(float)a[0] * scale, (float)a[1] * scale, (float)a[2] * scale, (float)a[3] * scale};
        fgl_clear_color(fb, (struct rect){x + i, y, x + i + 1, y + 1}, color, mask, false);
    }
}

void fgl_accum_return(struct framebuffer *fb, struct rect r, float value, const bool mask[4])
{
    const float scale = value / 32767.0f;
    const bool plain = fb->color_kind == COLOR_UNORM8 && mask[0] && mask[1] && mask[2] && mask[3];
    for (int y = r.y0; y < r.y1; y++) {
        uint32_t *row = (uint32_t *)fb->color + (size_t)y * (size_t)fb->stride + r.x0;
        if (plain)
            fgl_row_kernels(ARITH_COMPATIBLE)->accum_to_unorm8(accum_at(fb, r.x0, y), r.x1 - r.x0, scale, row);
        else
            return_pixels(fb, accum_at(fb, r.x0, y), r.x0, y, r.x1 - r.x0, scale, mask);
    }
}
