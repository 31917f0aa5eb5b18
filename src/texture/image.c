/* Images. See image.h. */
#include "texture/image.h"

#include "base/unorm.h"
#include "texture/encode.h"

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
    free(image->stencil);
    *image = (struct texture_image){0};
}

bool fgl_texture_image_define(struct texture_image *image, enum texture_target target,
                              const struct image_shape *shape, bool proxy)
{
    const struct texture_format *format = shape->format;
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
    const bool stencil = format->base_format == GL_DEPTH_STENCIL;
    if (!proxy && bytes)
        new.texels = calloc(1, bytes);
    if (new.texels && stencil)
        new.stencil = calloc(1, bytes / fgl_texel_bytes(format->kind));
    if (!proxy && bytes && (!new.texels || (stencil && !new.stencil))) {
        free(new.texels);
        return false;
    }
    fgl_texture_image_clear(image);
    *image = new;
    return true;
}

/* ---- quantising ---- */

static uint32_t half_to_even(float v, int bits)
{
    const double magic = 6755399441055744.0; /* 1.5 * 2^52: adding it rounds to an integer, half to even */
    return (uint32_t)(((double)(fgl_clamp01(v) * (float)fgl_unorm_max(bits)) + magic) - magic);
}

/* [0,1] to the nearest integer of so many bits. OSMesa rule: half up, but half to even for bytes. */
static uint32_t quantise(float v, int bits)
{
    return bits == 8 ? half_to_even(v, bits) : (uint32_t)(fgl_clamp01(v) * (float)fgl_unorm_max(bits) + 0.5f);
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
            {GL_RED, {0, ZERO, ZERO, ONE}},    {GL_RG, {0, 1, ZERO, ONE}},
    };
    for (size_t i = 0; i < FGL_COUNTOF(table); i++)
        for (int c = 0; table[i].base_format == base_format && c < 4; c++)
            source[c] = table[i].source[c];
}

/* Channel c of n texels from integers of so many bits. */
static void store_channel(struct texture_image *image, size_t first, int c, int n, int bits, const uint32_t *v)
{
    if (image->kind == TEXELS_UNORM8) {
        uint8_t *out = (uint8_t *)image->texels + first + c;
        for (int i = 0; i < n; i++)
            out[4 * i] = (uint8_t)fgl_unorm_resize(v[i], bits, 8);
    } else {
        float *out = (float *)image->texels + first + c;
        for (int i = 0; i < n; i++)
            out[4 * i] = fgl_unorm_to_float(v[i], bits);
    }
}

/* As what is drawn: formats of 5 bits are cut from bytes, of 10 from words. Those of 3 bits are nearly so: OSMesa differs in a few of 100. */
static uint32_t round_drawn(const struct texture_format *format, float v, int bits)
{
    switch (format->bits[0]) {
    case 3: return (quantise(v, 8) * fgl_unorm_max(bits) + 128) >> 8;
    case 5: return quantise(v, 8) >> (8 - bits);
    case 10: return quantise(v, 16) >> (16 - bits);
    default: return half_to_even(v, bits);
    }
}

static uint32_t to_bits(const struct texture_format *format, float v, int bits, enum texel_rounding rounding)
{
    switch (rounding) {
    case ROUND_THROUGH_BYTES: return fgl_unorm_resize(quantise(v, 8), 8, bits);
    case ROUND_DRAWN: return round_drawn(format, v, bits);
    default: return quantise(v, bits);
    }
}

/* The same of an encoding of its own. source: as of `expansion`. */
static void store_encoded(struct texture_image *image, size_t first, int c, int source, int n, const float *const color[4])
{
    float v[TEXTURE_RUN], *out = (float *)image->texels + first + c;
    if (source < ZERO)
        fgl_texture_encode(image->format, source, n, color, v);
    for (int i = 0; i < n; i++)
        out[4 * i] = source < ZERO ? v[i] : source == ONE ? 1.0f : 0.0f;
}

void fgl_texture_store_bytes(struct texture_image *image, int x, int y, int z, int n, const uint8_t *pixels, size_t step,
                             const int place[4])
{
    int source[4];
    uint8_t *out = (uint8_t *)image->texels + 4 * fgl_texel_index(image, x, y, z);
    expansion(image->format->base_format, source);
    bool same = step == 4;
    for (int c = 0; c < 4; c++)
        same = same && source[c] == c && place[c] == c;
    if (same) {
        memcpy(out, pixels, 4 * (size_t)n);
        return;
    }
    for (int c = 0; c < 4; c++) {
        const int at = source[c] < ZERO ? place[source[c]] : -1, missing = source[c] == ONE || source[c] == 3 ? 255 : 0;
        for (int i = 0; i < n; i++)
            out[4 * i + c] = (uint8_t)(at >= 0 ? pixels[(size_t)i * step + (size_t)at] : missing);
    }
}

void fgl_texture_store_color(struct texture_image *image, int x, int y, int z, int n, const float *const color[4],
                             enum texel_rounding rounding)
{
    int source[4];
    uint32_t v[TEXTURE_RUN];
    assert(n <= TEXTURE_RUN);
    expansion(image->format->base_format, source);
    const size_t first = 4 * fgl_texel_index(image, x, y, z);
    for (int c = 0; c < 4; c++) {
        const int s = source[c], bits = s < ZERO ? image->format->bits[s] : 8;
        if (image->format->encoding != ENCODED_UNORM) {
            store_encoded(image, first, c, s, n, color);
            continue;
        }
        for (int i = 0; i < n; i++)
            v[i] = s == ZERO ? 0 : s == ONE ? 255 : to_bits(image->format, color[s][i], bits, rounding);
        store_channel(image, first, c, n, bits, v);
    }
}

/* OSMesa rule: 16 bits are multiplied by the reciprocal in float, more are divided in double. */
static float depth_of(uint32_t z, int bits)
{
    return bits == 16 ? fgl_unorm_to_float(z, bits) : (float)((double)z / (double)fgl_unorm_max(bits));
}

void fgl_texture_store_depth(struct texture_image *image, int x, int y, int z, int n, const uint32_t *depth)
{
    float *out = (float *)image->texels + fgl_texel_index(image, x, y, z);
    for (int i = 0; i < n; i++)
        out[i] = depth_of(depth[i], image->format->bits[0]);
}

/* GL 1.5, table 6.1: luminance and intensity are red alone. */
static void load_sources(GLenum base, int source[4])
{
    expansion(base, source);
    if (base == GL_LUMINANCE || base == GL_LUMINANCE_ALPHA || base == GL_INTENSITY)
        source[1] = source[2] = ZERO;
    if (base == GL_INTENSITY)
        source[3] = ONE;
}

void fgl_texture_load_color(const struct texture_image *image, int x, int y, int z, int n, float *const color[4])
{
    int source[4];
    load_sources(image->format->base_format, source);
    const size_t first = 4 * fgl_texel_index(image, x, y, z);
    for (int c = 0; c < 4; c++) {
        const int s = source[c];
        const int bits = s < ZERO ? image->format->bits[s] : 8;
        const float step = 1.0f / (float)fgl_unorm_max(bits);
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

/* A kept float as an integer of 16 bits; of an sRGB format of 8. */
static uint32_t integer_of(const struct texture_format *format, int c, float v)
{
    if (format->encoding != ENCODED_SRGB)
        return (uint32_t)(v * 65535.0f + 0.5f);
    return c < 3 ? (uint32_t)fgl_srgb_byte(v) : (uint32_t)(v * 255.0f + 0.5f);
}

void fgl_texture_load_integers(const struct texture_image *image, int x, int y, int z, int n, uint32_t *const color[4])
{
    int source[4];
    load_sources(image->format->base_format, source);
    const size_t first = 4 * fgl_texel_index(image, x, y, z);
    const uint32_t one = image->format->bits[0] == 16 || image->format->bits[3] == 16 ? 65535 : 255;
    for (int c = 0; c < 4; c++)
        for (int i = 0; i < n; i++) {
            const size_t at = first + 4 * (size_t)i + (size_t)c;
            if (source[c] >= ZERO)
                color[c][i] = source[c] == ZERO ? 0 : one;
            else if (image->kind == TEXELS_UNORM8)
                color[c][i] = ((const uint8_t *)image->texels)[at];
            else
                color[c][i] = integer_of(image->format, c, ((const float *)image->texels)[at]);
        }
}
