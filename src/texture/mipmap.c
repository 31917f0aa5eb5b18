/* Mipmaps by a box filter: each level from the one before it. */
#include "texture/mipmap.h"

#include "base/unorm.h"
#include "texture/encode.h"

#include <stdlib.h>

/* Two neighbouring texels of the source, and how much of the second: in 256ths, and not rounded. */
struct tap {
    int first, second, weight;
    float fraction;
};

/* OSMesa rule: level by level the image is drawn at half its size with GL_LINEAR and GL_CLAMP_TO_EDGE. */
static struct tap tap_of(int i, int from, int to)
{
    const float s = ((float)i + 0.5f) / (float)to, center = s * (float)from - 0.5f;
    const int u = (int)(s * (float)(from * 256) + 0.5f) - 128, index = u >> 8;
    return (struct tap){fgl_clamp(index, 0, from - 1), fgl_clamp(index + 1, 0, from - 1), u & 255, center - (float)index};
}

static int lerp_byte(int weight, int a, int b)
{
    return (a + ((weight * (b - a) + 128) >> 8)) & 255;
}

static float lerp_float(float fraction, float a, float b)
{
    return a + fraction * (b - a);
}

struct taps {
    struct tap x, y, z;
};

/* Index of the first component of one of the 8 texels that are averaged. */
static size_t corner(const struct texture_image *from, const struct taps *t, int i, int components)
{
    return (size_t)components * fgl_texel_index(from, i & 1 ? t->x.second : t->x.first,
                                                i & 2 ? t->y.second : t->y.first, i & 4 ? t->z.second : t->z.first);
}

static void average_bytes(const struct texture_image *from, const struct taps *t, uint8_t *out)
{
    const uint8_t *texels = from->texels;
    for (int c = 0; c < 4; c++) {
        int v[8];
        for (int i = 0; i < 8; i++)
            v[i] = texels[corner(from, t, i, 4) + (size_t)c];
        for (int i = 0; i < 4; i++)
            v[i] = lerp_byte(t->x.weight, v[2 * i], v[2 * i + 1]);
        for (int i = 0; i < 2; i++)
            v[i] = lerp_byte(t->y.weight, v[2 * i], v[2 * i + 1]);
        out[c] = (uint8_t)lerp_byte(t->z.weight, v[0], v[1]);
    }
}

static void average_floats(const struct texture_image *from, const struct taps *t, int components, float *out)
{
    const float *texels = from->texels;
    for (int c = 0; c < components; c++) {
        float v[8];
        for (int i = 0; i < 8; i++)
            v[i] = texels[corner(from, t, i, components) + (size_t)c];
        for (int i = 0; i < 4; i++)
            v[i] = lerp_float(t->x.fraction, v[2 * i], v[2 * i + 1]);
        for (int i = 0; i < 2; i++)
            v[i] = lerp_float(t->y.fraction, v[2 * i], v[2 * i + 1]);
        out[c] = lerp_float(t->z.fraction, v[0], v[1]);
    }
}

/* One texel of the next level: averaged, then quantised to the format. */
static void make_texel(const struct texture_image *from, struct texture_image *to, const struct taps *t, int x, int y, int z)
{
    float v[4];
    if (to->kind == TEXELS_DEPTH) {
        average_floats(from, t, 1, v);
        const uint32_t depth = (uint32_t)((double)v[0] * (double)fgl_unorm_max(to->format->bits[0]) + 0.5);
        fgl_texture_store_depth(to, x, y, z, 1, &depth);
        return;
    }
    if (to->kind == TEXELS_UNORM8) {
        uint8_t bytes[4];
        average_bytes(from, t, bytes);
        for (int c = 0; c < 4; c++)
            v[c] = (float)bytes[c] * (1.0f / 255.0f);
    } else {
        average_floats(from, t, 4, v);
        for (int c = 0; to->format->encoding == ENCODED_SRGB && c < 3; c++)
            v[c] = fgl_srgb_from_linear(v[c]);
    }
    const float *const planes[4] = {&v[0], &v[1], &v[2], &v[3]};
    fgl_texture_store_color(to, x, y, z, 1, planes, ROUND_DRAWN);
}

static void reduce(const struct texture_image *from, struct texture_image *to)
{
    struct taps t;
    for (int z = 0; z < to->depth; z++) {
        t.z = tap_of(z, from->depth, to->depth);
        for (int y = 0; y < to->height; y++) {
            t.y = tap_of(y, from->height, to->height);
            for (int x = 0; x < to->width; x++) {
                t.x = tap_of(x, from->width, to->width);
                make_texel(from, to, &t, x, y, z);
            }
        }
    }
}

bool fgl_texture_generate_mipmaps(struct texture_object *object, int face)
{
    const int base = fgl_texture_base_level(object);
    if (base >= FGL_MAX_TEXTURE_LEVELS || !object->image[face][base].texels)
        return true;
    const int last = fgl_min(fgl_texture_max_level(object), FGL_MAX_TEXTURE_LEVELS - 1);
    for (int level = base + 1; level <= last; level++) {
        const struct texture_image *from = &object->image[face][level - 1];
        struct texture_image *to = &object->image[face][level];
        if (from->width == 1 && from->height == 1 && from->depth == 1)
            break;
        const struct image_shape shape = {from->internal_format, from->format, fgl_max(from->width / 2, 1),
                                          fgl_max(from->height / 2, 1), fgl_max(from->depth / 2, 1), 0};
        if (!fgl_texture_image_define(to, object->target, &shape, false))
            return false;
        reduce(from, to);
    }
    fgl_texture_changed(object);
    return true;
}
