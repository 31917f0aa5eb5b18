#include "framebuffer/accum.h"

static int16_t *accum_at(struct framebuffer *fb, int x, int y)
{
    return fb->accum + 4 * ((size_t)y * (size_t)fb->stride + (size_t)x);
}

static int16_t wrapped(float v)
{
    return v > -2147483648.0f && v < 2147483648.0f ? (int16_t)(uint16_t)(int32_t)v : 0;
}

void fgl_accum_clear(struct framebuffer *fb, struct rect r, const float value[4])
{
    int16_t clear[4];
    for (int c = 0; c < 4; c++) /* OSMesa rule: as GL 1.5, table 4.7 converts to 16 bits */
        clear[c] = (int16_t)((int32_t)(65535.0f * value[c] - 1.0f) / 2);
    for (int y = r.y0; y < r.y1; y++) {
        int16_t *a = accum_at(fb, r.x0, y);
        for (int i = 0; i < 4 * (r.x1 - r.x0); i++)
            a[i] = clear[i & 3];
    }
}

static void fetch_color(const struct framebuffer *fb, size_t at, float color[4])
{
    switch (fb->color_kind) {
    case COLOR_UNORM8: {
        const uint32_t p = ((const uint32_t *)fb->color)[at];
        for (int c = 0; c < 4; c++)
            color[c] = (float)(p >> (8 * c) & 255) * (1.0f / 255.0f);
        break;
    }
    case COLOR_UNORM16:
        for (int c = 0; c < 4; c++)
            color[c] = (float)((const uint16_t *)fb->color)[4 * at + (size_t)c] * (1.0f / 65535.0f);
        break;
    case COLOR_FLOAT:
        for (int c = 0; c < 4; c++)
            color[c] = ((const float *)fb->color)[4 * at + (size_t)c];
        break;
    case COLOR_565: {
        const uint32_t p = ((const uint16_t *)fb->color)[at];
        color[0] = (float)(p >> 11) * (1.0f / 31.0f);
        color[1] = (float)(p >> 5 & 63) * (1.0f / 63.0f);
        color[2] = (float)(p & 31) * (1.0f / 31.0f);
        break;
    }
    }
    if (!fb->has_alpha)
        color[3] = 1.0f;
}

void fgl_accum_color(struct framebuffer *fb, struct rect r, float value, bool add)
{
    const float scale = value * 32767.0f;
    for (int y = r.y0; y < r.y1; y++) {
        int16_t *a = accum_at(fb, r.x0, y);
        const size_t at = (size_t)y * (size_t)fb->stride;
        for (int x = r.x0; x < r.x1; x++, a += 4) {
            float color[4] = {0.0f, 0.0f, 0.0f, 1.0f};
            fetch_color(fb, at + (size_t)x, color);
            for (int c = 0; c < 4; c++)
                a[c] = (int16_t)(wrapped(color[c] * scale) + (add ? a[c] : 0));
        }
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
    for (int y = r.y0; y < r.y1; y++) {
        int16_t *a = accum_at(fb, r.x0, y);
        for (int i = 0; i < 4 * (r.x1 - r.x0); i++)
            a[i] = wrapped((float)a[i] * value);
    }
}

void fgl_accum_return(struct framebuffer *fb, struct rect r, float value, const bool mask[4])
{
    const float scale = value / 32767.0f;
    for (int y = r.y0; y < r.y1; y++) {
        const int16_t *a = accum_at(fb, r.x0, y);
        for (int x = r.x0; x < r.x1; x++, a += 4) {
            float color[4];
            for (int c = 0; c < 4; c++)
                color[c] = (float)a[c] * scale;
            fgl_clear_color(fb, (struct rect){x, y, x + 1, y + 1}, color, mask);
        }
    }
}
