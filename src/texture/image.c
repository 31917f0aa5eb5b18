/* Images. See image.h. */
#include "texture/image.h"

#include <stdlib.h>
#include <string.h>

/* ---- room ---- */

static bool multiply(size_t *product, size_t factor)
{
    if (factor && *product > SIZE_MAX / factor)
        return false;
    *product *= factor;
    return true;
}

void fgl_texture_image_clear(struct texture_image *image)
{
    free(image->texels);
    *image = (struct texture_image){0};
}

bool fgl_texture_image_define(struct texture_image *image, enum texture_target target,
                              const struct image_shape *shape, bool proxy)
{
    const struct texture_format *format = fgl_texture_format(shape->internal_format);
    const int around = 2 * shape->border;
    struct texture_image new = {
            .width = shape->width - around,
            .height = target == TEXTURE_1D ? 1 : shape->height - around,
            .depth = target == TEXTURE_3D ? shape->depth - around : 1,
            .internal_format = fgl_texture_format_compressed(format) ? format->base_format : shape->internal_format,
            .format = format,
            .kind = format->kind,
    };
    size_t bytes = fgl_texel_bytes(format->kind);
    if (!multiply(&bytes, (size_t)new.width) || !multiply(&bytes, (size_t)new.height) ||
        !multiply(&bytes, (size_t)new.depth))
        return false;
    if (!proxy && bytes && !(new.texels = calloc(1, bytes)))
        return false;
    free(image->texels);
    *image = new;
    return true;
}

/* ---- quantising ---- */

static uint32_t max_of(int bits)
{
    return 0xffffffffu >> (32 - bits);
}

/* [0,1] to the nearest integer of so many bits, half to even. */
static uint32_t quantise(float v, int bits, bool from_bytes)
{
    const double magic = 6755399441055744.0; /* 1.5 * 2^52: adding it rounds to an integer, half to even */
    const float c = fgl_clamp01(v);
    if (from_bytes && bits > 8 && bits < 16) {
        const uint32_t byte = (uint32_t)(c * 255.0f + 0.5f);
        return byte << (bits - 8) | byte >> (16 - bits);
    }
    return (uint32_t)(((double)(c * (float)max_of(bits)) + magic) - magic);
}

/* 1 to 8 bits to 8 by repeating them. */
static uint8_t to_byte(uint32_t v, int bits)
{
    uint32_t repeated = v << (8 - bits);
    for (int have = bits; have < 8; have *= 2)
        repeated |= repeated >> have;
    return (uint8_t)repeated;
}

/* Which channel of the source each channel of a texel comes from, or a constant. */
enum { ZERO = 4, ONE = 5 };

static void expansion(GLenum base_format, int source[4])
{
    static const struct {
        GLenum base_format;
        uint8_t source[4];
    } table[] = {
            {GL_ALPHA, {ZERO, ZERO, ZERO, 3}}, {GL_LUMINANCE, {0, 0, 0, ONE}},
            {GL_LUMINANCE_ALPHA, {0, 0, 0, 3}}, {GL_INTENSITY, {0, 0, 0, 0}},
            {GL_RGB, {0, 1, 2, ONE}},          {GL_RGBA, {0, 1, 2, 3}},
    };
    for (size_t i = 0; i < FGL_COUNTOF(table); i++)
        for (int c = 0; table[i].base_format == base_format && c < 4; c++)
            source[c] = table[i].source[c];
}

void fgl_texture_store_color(struct texture_image *image, int x, int y, int z, int n, const float *const color[4],
                             bool from_bytes)
{
    int source[4];
    expansion(image->format->base_format, source);
    const size_t first = 4 * fgl_texel_index(image, x, y, z);
    for (int c = 0; c < 4; c++) {
        const int s = source[c], bits = s < ZERO ? image->format->bits[s] : 8;
        if (image->kind == TEXELS_UNORM8) {
            uint8_t *out = (uint8_t *)image->texels + first + c;
            for (int i = 0; i < n; i++)
                out[4 * i] = s < ZERO ? to_byte(quantise(color[s][i], bits, from_bytes), bits) : s == ONE ? 255 : 0;
            continue;
        }
        float *out = (float *)image->texels + first + c;
        const float step = 1.0f / (float)max_of(bits);
        for (int i = 0; i < n; i++)
            out[4 * i] = s < ZERO ? (float)quantise(color[s][i], bits, from_bytes) * step : s == ONE ? 1.0f : 0.0f;
    }
}

void fgl_texture_store_depth(struct texture_image *image, int x, int y, int z, int n, const float *depth)
{
    float *out = (float *)image->texels + fgl_texel_index(image, x, y, z);
    const double max = (double)max_of(image->format->bits[0]);
    for (int i = 0; i < n; i++) {
        const uint32_t v = (uint32_t)((double)fgl_clamp01(depth[i]) * max);
        out[i] = (float)((double)v / max);
    }
}

void fgl_texture_load_color(const struct texture_image *image, int x, int y, int z, int n, float *const color[4])
{
    int source[4];
    const GLenum base = image->format->base_format;
    const bool gray = base == GL_LUMINANCE || base == GL_LUMINANCE_ALPHA || base == GL_INTENSITY;
    expansion(base, source);
    if (gray)
        source[1] = source[2] = ZERO;
    if (base == GL_INTENSITY)
        source[3] = ONE;
    const size_t first = 4 * fgl_texel_index(image, x, y, z);
    for (int c = 0; c < 4; c++) {
        const int s = source[c];
        const int bits = s < ZERO ? image->format->bits[s] : 8;
        const float step = 1.0f / (float)max_of(bits);
        for (int i = 0; i < n; i++) {
            if (s >= ZERO)
                color[c][i] = s == ONE ? 1.0f : 0.0f;
            else if (image->kind == TEXELS_UNORM8)
                color[c][i] = (float)(((const uint8_t *)image->texels)[first + 4 * (size_t)i + c] >> (8 - bits)) * step;
            else
                color[c][i] = ((const float *)image->texels)[first + 4 * (size_t)i + c];
        }
    }
}
