/* Copies between images and framebuffers. See surface.h. */
#include "pipeline/surface.h"

#include "base/unorm.h"

#include <string.h>

enum { MAX_DEPTH_BITS = 24 }; /* that fragments are tested with */

/* How colours of an image are kept while they are drawn to: bytes, or words where the image has more bits. */
static enum color_kind drawn_kind(const struct texture_image *image)
{
    return image && image->kind == TEXELS_FLOAT && image->format->encoding == ENCODED_UNORM ? COLOR_UNORM16 : COLOR_UNORM8;
}

bool fgl_surface_is_plain(const struct texture_image *image)
{
    const struct texture_format *f = image->format;
    return (f->base_format == GL_RGBA || f->base_format == GL_RGB) && f->bits[0] == (drawn_kind(image) == COLOR_UNORM16 ? 16 : 8);
}

/* GL 1.5, 4.1.8: without alpha it reads as 1. */
static bool stores_alpha(const struct texture_image *image)
{
    const GLenum base = image->format->base_format;
    return base == GL_ALPHA || base == GL_LUMINANCE_ALPHA || base == GL_RGBA;
}

/* The first pixel of the framebuffer's row in which row y of an image is. */
static size_t row_of(const struct framebuffer *fb, int y)
{
    return (size_t)y * (size_t)fb->stride;
}

/* ---- colour ---- */

static void load_bytes(struct framebuffer *fb, const struct surface *s, int y)
{
    const uint8_t *in = (const uint8_t *)s->image->texels + 4 * fgl_texel_index(s->image, 0, y, s->slice);
    uint32_t *out = (uint32_t *)fb->color + row_of(fb, y);
    for (int x = 0; x < fb->width; x++)
        out[x] = in[4 * x] | (uint32_t)in[4 * x + 1] << 8 | (uint32_t)in[4 * x + 2] << 16 | (uint32_t)in[4 * x + 3] << 24;
}

/* sRGB: what is drawn to are the values on the curve. */
static void load_encoded(struct framebuffer *fb, const struct surface *s, int y)
{
    uint32_t plane[4][TEXTURE_RUN];
    uint32_t *const planes[4] = {plane[0], plane[1], plane[2], plane[3]};
    uint32_t *out = (uint32_t *)fb->color + row_of(fb, y);
    for (int x = 0; x < fb->width; x += TEXTURE_RUN) {
        const int n = fgl_min(TEXTURE_RUN, fb->width - x);
        fgl_texture_load_integers(s->image, x, y, s->slice, n, planes);
        for (int i = 0; i < n; i++)
            out[x + i] = plane[0][i] | plane[1][i] << 8 | plane[2][i] << 16 | plane[3][i] << 24;
    }
}

static void load_words(struct framebuffer *fb, const struct surface *s, int y)
{
    const float *in = (const float *)s->image->texels + 4 * fgl_texel_index(s->image, 0, y, s->slice);
    uint16_t *out = (uint16_t *)fb->color + 4 * row_of(fb, y);
    for (int i = 0; i < 4 * fb->width; i++)
        out[i] = (uint16_t)fgl_unorm(in[i], 65535.0f);
}

/* GL 1.5, 4.3.2: luminance and intensity are red alone. */
static void load_floats(struct framebuffer *fb, const struct surface *s, int y)
{
    float plane[4][TEXTURE_RUN];
    float *const planes[4] = {plane[0], plane[1], plane[2], plane[3]};
    float *out = (float *)fb->color + 4 * row_of(fb, y);
    for (int x = 0; x < fb->width; x += TEXTURE_RUN) {
        const int n = fgl_min(TEXTURE_RUN, fb->width - x);
        fgl_texture_load_color(s->image, x, y, s->slice, n, planes);
        for (int i = 0; i < n; i++)
            for (int c = 0; c < 4; c++)
                out[4 * (x + i) + c] = plane[c][i];
    }
}

static void load_color(struct framebuffer *fb, const struct surface *s, int y)
{
    switch (fb->color_kind) {
    case COLOR_UNORM8: s->image->kind == TEXELS_UNORM8 ? load_bytes(fb, s, y) : load_encoded(fb, s, y); break;
    case COLOR_UNORM16: load_words(fb, s, y); break;
    default: load_floats(fb, s, y); break;
    }
}

/* Whether a texel is a pixel as it stands. */
static bool is_rgba8(const struct texture_image *image)
{
    return image->kind == TEXELS_UNORM8 && image->format->base_format == GL_RGBA && fgl_surface_is_plain(image);
}

static void store_bytes(const struct framebuffer *fb, const struct surface *s, int y)
{
    uint8_t *out = (uint8_t *)s->image->texels + 4 * fgl_texel_index(s->image, 0, y, s->slice);
    const uint32_t *in = (const uint32_t *)fb->color + row_of(fb, y);
    for (int x = 0; x < fb->width; x++)
        for (int c = 0; c < 4; c++)
            out[4 * x + c] = (uint8_t)(in[x] >> 8 * c);
}

/* n colours of the framebuffer in [0,1]. */
static void fetch_colors(const struct framebuffer *fb, size_t first, int n, float plane[4][TEXTURE_RUN])
{
    const uint32_t *bytes = (const uint32_t *)fb->color + first;
    const uint16_t *words = (const uint16_t *)fb->color + 4 * first;
    for (int i = 0; i < n; i++)
        for (int c = 0; c < 4; c++)
            plane[c][i] = fb->color_kind == COLOR_UNORM16 ? (float)words[4 * i + c] * (1.0f / 65535.0f)
                                                          : (float)(bytes[i] >> 8 * c & 255) * (1.0f / 255.0f);
}

static void store_colors(const struct framebuffer *fb, const struct surface *s, int y)
{
    float plane[4][TEXTURE_RUN];
    const float *const planes[4] = {plane[0], plane[1], plane[2], plane[3]};
    for (int x = 0; x < fb->width; x += TEXTURE_RUN) {
        const int n = fgl_min(TEXTURE_RUN, fb->width - x);
        fetch_colors(fb, row_of(fb, y) + (size_t)x, n, plane);
        fgl_texture_store_color(s->image, x, y, s->slice, n, planes, ROUND_DRAWN);
    }
}

/* ---- depth and stencil ---- */

static void load_depth(struct framebuffer *fb, const struct surface *s, int y)
{
    const float *in = (const float *)s->image->texels + fgl_texel_index(s->image, 0, y, s->slice);
    uint32_t *out = fb->depth + row_of(fb, y);
    for (int x = 0; x < fb->width; x++)
        out[x] = (uint32_t)((double)in[x] * (double)fb->depth_max + 0.5);
}

static void store_depth(const struct framebuffer *fb, const struct surface *s, int y)
{
    const int bits = s->image->format->bits[0];
    const uint32_t *in = fb->depth + row_of(fb, y);
    uint32_t depth[TEXTURE_RUN];
    for (int x = 0; x < fb->width; x += TEXTURE_RUN) {
        const int n = fgl_min(TEXTURE_RUN, fb->width - x);
        for (int i = 0; i < n; i++)
            depth[i] = fgl_unorm_resize(in[x + i], fb->depth_bits, bits);
        fgl_texture_store_depth(s->image, x, y, s->slice, n, depth);
    }
}

static uint8_t *stencil_row(const struct surface *s, int y)
{
    return s->image->stencil + fgl_texel_index(s->image, 0, y, s->slice);
}

/* ---- all of it ---- */

/* What an image of the format keeps of bytes, by storing all of them. */
static void find_rounding(struct framebuffer *fb, const struct texture_image *color)
{
    uint8_t texels[256][4];
    float byte[TEXTURE_RUN];
    const float *const planes[4] = {byte, byte, byte, byte};
    for (int c = 0; c < 4; c++)
        fb->image_bits[c] = color && color->format->bits[c] < (color->kind == TEXELS_FLOAT ? 16 : 8) ? (uint8_t)color->format->bits[c] : 0;
    fb->rounds = color && color->kind == TEXELS_UNORM8 && !fgl_texture_format_keeps_bytes(color->format);
    if (!fb->rounds)
        return;
    struct texture_image all = {.width = 256, .height = 1, .depth = 1, .format = color->format, .kind = color->kind, .texels = texels};
    for (int i = 0; i < 256; i++)
        byte[i] = (float)i * (1.0f / 255.0f);
    fgl_texture_store_color(&all, 0, 0, 0, 256, planes, ROUND_DRAWN);
    for (int c = 0; c < 4; c++)
        for (int i = 0; i < 256; i++)
            fb->rounded[c][i] = texels[i][c];
}

/* Empty planes that fit the surfaces. */
static bool make_planes(struct framebuffer *fb, int width, int height, const struct surface *color, const struct surface *depth,
                        const struct surface *stencil, enum color_kind kind)
{
    const int depth_bits = depth->image ? fgl_min(depth->image->format->bits[0], MAX_DEPTH_BITS) : 0;
    const int stencil_bits = stencil->image ? 8 : 0;
    if (fb->depth_bits != depth_bits || fb->stencil_bits != stencil_bits)
        fgl_framebuffer_free(fb);
    fb->y_up = true;
    fb->depth_bits = depth_bits;
    fb->depth_max = (uint32_t)((1ull << depth_bits) - 1);
    fb->stencil_bits = stencil_bits;
    fb->has_alpha = !color->image || stores_alpha(color->image);
    const GLenum base = color->image ? color->image->format->base_format : GL_NONE;
    fb->one_component = base == GL_ALPHA || base == GL_LUMINANCE || base == GL_INTENSITY || base == GL_RED;
    find_rounding(fb, color->image);
    return fgl_framebuffer_resize(fb, width, height, kind) && fgl_framebuffer_need_stencil(fb);
}

bool fgl_surface_load(struct framebuffer *fb, int width, int height, const struct surface *color, const struct surface *depth,
                      const struct surface *stencil, bool reading)
{
    const bool as_floats = reading && color->image && !fgl_surface_is_plain(color->image);
    if (!make_planes(fb, width, height, color, depth, stencil, as_floats ? COLOR_FLOAT : drawn_kind(color->image)))
        return false;
    for (int y = 0; y < fb->height; y++) {
        if (color->image)
            load_color(fb, color, y);
        if (depth->image)
            load_depth(fb, depth, y);
        if (stencil->image)
            memcpy(fb->stencil + row_of(fb, y), stencil_row(stencil, y), (size_t)fb->width);
    }
    fb->drawn = false;
    return true;
}

void fgl_surface_store(const struct framebuffer *fb, const struct surface *color, const struct surface *depth,
                       const struct surface *stencil)
{
    for (int y = 0; y < fb->height; y++) {
        if (color->image && is_rgba8(color->image))
            store_bytes(fb, color, y);
        else if (color->image)
            store_colors(fb, color, y);
        if (depth->image)
            store_depth(fb, depth, y);
        if (stencil->image)
            memcpy(stencil_row(stencil, y), fb->stencil + row_of(fb, y), (size_t)fb->width);
    }
}
