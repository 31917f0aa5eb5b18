/* One image, filtered: nearest or linear (GL 1.5, 3.8.8 "Texture Minification"). Kernels only.
 *
 * Two roads: packed texels of 8 bits a channel, filtered in OSMesa's fixed point; and floats for all else. */
#ifndef FGL_FRAGMENT_TEXTURE_FILTER_H
#define FGL_FRAGMENT_TEXTURE_FILTER_H

#include "fragment/texture_wrap.h"

/* Texture coordinates of a group, ready to address an image. */
struct texture_coords {
    real s[3][FRAGMENT_GROUP]; /* s t r; for a cube map s and t on its face */
    real compare[FRAGMENT_GROUP]; /* what depth texels are compared with */
    int32_t face[FRAGMENT_GROUP];
};

/* ---- fixed point ---- */

/* a + weight (b - a) / 256, rounded, for four channels. */
static FGL_ALWAYS_INLINE uint32_t lerp_packed(uint32_t weight, uint32_t a, uint32_t b)
{
    const uint32_t even = 0x00ff00ff, half = 0x00800080, rest = 256 - weight;
    const uint32_t low = (a & even) * rest + (b & even) * weight + half;
    const uint32_t high = (a >> 8 & even) * rest + (b >> 8 & even) * weight + half;
    return (low >> 8 & even) | (high & ~even);
}

/* Texel (x, y) of every fragment. cube: each has its own face. */
static FGL_ALWAYS_INLINE void fetch_packed(const struct texture_level *level, const struct texture_coords *at,
                                           const int32_t *x, const int32_t *y, const int32_t *z, const int dimensions,
                                           const bool cube, uint32_t *FGL_RESTRICT texel)
{
    const uint32_t *texels = level->texels[0];
    const int width = level->size[0], height = level->size[1];
    int32_t index[FRAGMENT_GROUP];
    FOR_GROUP(i) index[i] = dimensions == 1   ? x[i]
                            : dimensions == 2 ? y[i] * width + x[i]
                                              : (z[i] * height + y[i]) * width + x[i];
    if (cube)
        FOR_GROUP(i) texel[i] = ((const uint32_t *)level->texels[at->face[i]])[index[i]];
    else
        FOR_GROUP(i) texel[i] = texels[index[i]];
}

static FGL_ALWAYS_INLINE void lerp_group(const int32_t *weight, const uint32_t *a, const uint32_t *b, uint32_t *to)
{
    FOR_GROUP(i) to[i] = lerp_packed((uint32_t)weight[i], a[i], b[i]);
}

static FGL_ALWAYS_INLINE void filter_packed(const struct texture_level *level, const struct texture_coords *at,
                                            const int dimensions, const bool cube, const enum texture_filter filter,
                                            const GLenum wrap[3], uint32_t *FGL_RESTRICT texel)
{
    struct texel_pair axis[3];
    const int y_axis = dimensions > 1 ? 1 : 0, z_axis = dimensions > 2 ? 2 : 0; /* 0: not used */
    if (filter == FILTER_NEAREST) {
        for (int k = 0; k < dimensions; k++)
            wrap_nearest(at->s[k], level->size[k], wrap[k], axis[k].i0);
        fetch_packed(level, at, axis[0].i0, axis[y_axis].i0, axis[z_axis].i0, dimensions, cube, texel);
        return;
    }
    uint32_t slice[2][FRAGMENT_GROUP];
    for (int k = 0; k < dimensions; k++)
        wrap_linear_fixed(at->s[k], level->size[k], wrap[k], &axis[k]);
    for (int z = 0; z < (dimensions > 2 ? 2 : 1); z++) {
        uint32_t row[2][FRAGMENT_GROUP];
        const int32_t *slice_index = z ? axis[z_axis].i1 : axis[z_axis].i0;
        for (int y = 0; y < (dimensions > 1 ? 2 : 1); y++) {
            uint32_t left[FRAGMENT_GROUP], right[FRAGMENT_GROUP];
            const int32_t *row_index = y ? axis[y_axis].i1 : axis[y_axis].i0;
            fetch_packed(level, at, axis[0].i0, row_index, slice_index, dimensions, cube, left);
            fetch_packed(level, at, axis[0].i1, row_index, slice_index, dimensions, cube, right);
            lerp_group(axis[0].weight, left, right, row[y]);
        }
        if (dimensions > 1)
            lerp_group(axis[1].weight, row[0], row[1], slice[z]);
        else
            memcpy(slice[z], row[0], sizeof row[0]);
    }
    if (dimensions > 2)
        lerp_group(axis[2].weight, slice[0], slice[1], texel);
    else
        memcpy(texel, slice[0], sizeof slice[0]);
}

/* OSMesa rule: a product with 1/255, where the specification divides. */
static FGL_ALWAYS_INLINE real from_unorm8(uint32_t v)
{
    return R_EXACT ? (real)v / 255 : (real)v * (real)(1.0f / 255.0f);
}

static FGL_ALWAYS_INLINE void unpack_texels(const uint32_t *texel, real to[4][FRAGMENT_GROUP])
{
    for (int c = 0; c < 4; c++)
        FOR_GROUP(i) to[c][i] = from_unorm8(texel[i] >> (8 * c) & 255);
}

/* ---- floats ---- */

/* A component of at most 8 bits. OSMesa rule: here it counts with the bits that its format stores, in fixed point with all 8. */
static inline real unorm_component(const struct sampler *sampler, int c, uint8_t v)
{
    return R_EXACT ? (real)(v >> sampler->shift[c]) / (real)(255 >> sampler->shift[c])
                   : (real)(v >> sampler->shift[c]) * (real)(1.0f / (float)(255 >> sampler->shift[c]));
}

static inline real compare_depth(GLenum func, real r, real texel)
{
    return (real)((((int)func & (r < texel)) | ((int)(func >> 1) & (r == texel)) | ((int)(func >> 2) & (r > texel))) & 1);
}

/* OSMesa rule: depths of 24 bits are multiplied by the reciprocal of their largest value, where the specification divides. */
static inline real sampled_depth(const struct sampler *sampler, float depth)
{
    if (R_EXACT || sampler->depth_bits != 24)
        return (real)depth;
    return (real)(int32_t)((double)depth * 16777215.0 + 0.5) * (real)(1.0f / 16777215.0f);
}

/* One texel, RGBA; outside of the image: the border. */
static inline void fetch_texel(const struct sampler *sampler, const struct texture_level *level, const struct texture_coords *at,
                               int i, int x, int y, int z, real to[4])
{
    const int w = level->size[0], h = level->size[1], d = level->size[2];
    const bool inside = x >= 0 && x < w && y >= 0 && y < h && z >= 0 && z < d;
    const size_t index = inside ? ((size_t)z * (size_t)h + (size_t)y) * (size_t)w + (size_t)x : 0;
    const void *texels = level->texels[sampler->target == TEXTURE_CUBE_MAP ? at->face[i] : 0];
    for (int c = 0; c < 4; c++)
        to[c] = !inside                           ? (real)sampler->border[c]
                : sampler->kind == TEXELS_UNORM8 ? unorm_component(sampler, c, ((const uint8_t *)texels)[4 * index + (size_t)c])
                : sampler->kind == TEXELS_FLOAT  ? (real)((const float *)texels)[4 * index + (size_t)c]
                                                 : sampled_depth(sampler, ((const float *)texels)[index]);
    if (sampler->compare_func)
        to[0] = compare_depth(sampler->compare_func, at->compare[i], to[0]);
}

static inline real lerp_real(real f, real a, real b)
{
    return r_fma(f, b - a, a);
}

/* The texels around the coordinates along axis k; for the nearest filter both are the same. rounded: see sample_real. */
static inline void wrap_real(const struct sampler *sampler, const struct texture_level *level, const struct texture_coords *at, int k,
                             enum texture_filter filter, const int32_t *rounded, struct texel_pair *to)
{
    struct texel_pair around;
    if (filter == FILTER_LINEAR) {
        wrap_linear(at->s[k], level->size[k], sampler->wrap[k], to);
        return;
    }
    wrap_nearest(at->s[k], level->size[k], sampler->wrap[k], to->i0);
    memcpy(to->i1, to->i0, sizeof to->i1);
    memset(to->f, 0, sizeof to->f);
    if (!rounded)
        return;
    wrap_linear(at->s[k], level->size[k], sampler->wrap[k], &around);
    FOR_GROUP(i) to->i0[i] = rounded[i] ? around.i0[i] : to->i0[i];
    FOR_GROUP(i) to->i1[i] = rounded[i] ? around.i1[i] : to->i1[i];
    FOR_GROUP(i) to->f[i] = rounded[i] && around.f[i] > (real)0.5 ? 1 : 0;
}

static inline void filter_real(const struct sampler *sampler, const struct texture_level *level, const struct texture_coords *at,
                               enum texture_filter filter, const int32_t *rounded, real texel[4][FRAGMENT_GROUP])
{
    struct texel_pair axis[3];
    const bool linear = filter == FILTER_LINEAR || rounded;
    for (int k = 0; k < 3; k++) {
        if (k < sampler->dimensions)
            wrap_real(sampler, level, at, k, filter, rounded, &axis[k]);
        else
            memset(&axis[k], 0, sizeof axis[k]);
    }
    FOR_GROUP(i) {
        real slice[2][4];
        for (int z = 0; z < (linear && sampler->dimensions > 2 ? 2 : 1); z++) {
            real row[2][4];
            for (int y = 0; y < (linear && sampler->dimensions > 1 ? 2 : 1); y++) {
                const int ty = y ? axis[1].i1[i] : axis[1].i0[i], tz = z ? axis[2].i1[i] : axis[2].i0[i];
                real right[4];
                fetch_texel(sampler, level, at, i, axis[0].i0[i], ty, tz, row[y]);
                if (!linear)
                    continue;
                fetch_texel(sampler, level, at, i, axis[0].i1[i], ty, tz, right);
                for (int c = 0; c < 4; c++)
                    row[y][c] = lerp_real(axis[0].f[i], row[y][c], right[c]);
            }
            for (int c = 0; c < 4; c++)
                slice[z][c] = linear && sampler->dimensions > 1 ? lerp_real(axis[1].f[i], row[0][c], row[1][c]) : row[0][c];
        }
        for (int c = 0; c < 4; c++)
            texel[c][i] = linear && sampler->dimensions > 2 ? lerp_real(axis[2].f[i], slice[0][c], slice[1][c]) : slice[0][c];
    }
}

#endif
