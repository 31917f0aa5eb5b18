/* One image, filtered: nearest or linear (GL 1.5, 3.8.8 "Texture Minification"). Kernels only.
 *
 * Two roads: packed texels of 8 bits a channel, filtered in OSMesa's fixed point; and floats for all else. */
#ifndef FGL_FRAGMENT_TEXTURE_FILTER_H
#define FGL_FRAGMENT_TEXTURE_FILTER_H

#include "fragment/texture_wrap.h"

/* Texture coordinates of a group, ready to address an image. */
struct texture_coords {
    _Alignas(64) real s[3][FRAGMENT_GROUP]; /* s t r; for a cube map s and t on its face */
    real compare[FRAGMENT_GROUP]; /* what depth texels are compared with */
    int32_t face[FRAGMENT_GROUP];
};

/* ---- fixed point ---- */

/* a + weight (b - a) / 256, rounded, for four channels; weight: 0 to 256. */
static FGL_ALWAYS_INLINE uint32_t lerp_packed(uint32_t weight, uint32_t a, uint32_t b)
{
    const uint32_t even = 0x00ff00ff, half = 0x00800080;
    const uint32_t a0 = a & even, a1 = a >> 8 & even, b0 = b & even, b1 = b >> 8 & even;
    const uint32_t low = (a0 << 8) + (b0 - a0) * weight + half; /* what one channel borrows the next gives back */
    const uint32_t high = (a1 << 8) + (b1 - a1) * weight + half;
    return (low >> 8 & even) | (high & ~even);
}

/* Texel (x, y, z) of every fragment. cube: each has its own face. */
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

static FGL_ALWAYS_INLINE void nearest_packed(const struct texture_level *level, const struct texture_coords *at,
                                             const GLenum wrap[3], const int dimensions, const bool cube,
                                             uint32_t *FGL_RESTRICT texel)
{
    int32_t x[FRAGMENT_GROUP], y[FRAGMENT_GROUP], z[FRAGMENT_GROUP];
    wrap_nearest(at->s[0], level->size[0], (real)level->scale[0], wrap[0], x);
    if (dimensions > 1)
        wrap_nearest(at->s[1], level->size[1], (real)level->scale[1], wrap[1], y);
    if (dimensions > 2)
        wrap_nearest(at->s[2], level->size[2], (real)level->scale[2], wrap[2], z);
    fetch_packed(level, at, x, y, z, dimensions, cube, texel);
}

static FGL_ALWAYS_INLINE void lerp_group(const int32_t *weight, const uint32_t *a, const uint32_t *b, uint32_t *FGL_RESTRICT to)
{
    FOR_GROUP(i) to[i] = lerp_packed((uint32_t)weight[i], a[i], b[i]);
}

/* Two neighbours along x, mixed; then of those two along y; then along z. Written without loops over the neighbours: compilers unroll
 * loops inside of another loop before they can make vectors of them. */
static FGL_ALWAYS_INLINE void linear_row(const struct texture_level *level, const struct texture_coords *at,
                                         const struct texel_pair axis[3], const int32_t *y, const int32_t *z,
                                         const int dimensions, const bool cube, uint32_t *FGL_RESTRICT texel)
{
    uint32_t left[FRAGMENT_GROUP], right[FRAGMENT_GROUP];
    fetch_packed(level, at, axis[0].i0, y, z, dimensions, cube, left);
    fetch_packed(level, at, axis[0].i1, y, z, dimensions, cube, right);
    lerp_group(axis[0].weight, left, right, texel);
}

static FGL_ALWAYS_INLINE void linear_slice(const struct texture_level *level, const struct texture_coords *at,
                                           const struct texel_pair axis[3], const int32_t *z, const int dimensions,
                                           const bool cube, uint32_t *FGL_RESTRICT texel)
{
    uint32_t upper[FRAGMENT_GROUP], lower[FRAGMENT_GROUP];
    linear_row(level, at, axis, axis[1].i0, z, dimensions, cube, upper);
    linear_row(level, at, axis, axis[1].i1, z, dimensions, cube, lower);
    lerp_group(axis[1].weight, upper, lower, texel);
}

static FGL_ALWAYS_INLINE void linear_packed(const struct texture_level *level, const struct texture_coords *at,
                                            const GLenum wrap[3], const int dimensions, const bool cube,
                                            uint32_t *FGL_RESTRICT texel)
{
    struct texel_pair axis[3];
    uint32_t front[FRAGMENT_GROUP], back[FRAGMENT_GROUP];
    wrap_linear_fixed(at->s[0], level->size[0], (real)level->scale[0], wrap[0], &axis[0]);
    if (dimensions == 1) {
        linear_row(level, at, axis, NULL, NULL, 1, false, texel);
        return;
    }
    wrap_linear_fixed(at->s[1], level->size[1], (real)level->scale[1], wrap[1], &axis[1]);
    if (dimensions == 2) {
        linear_slice(level, at, axis, NULL, 2, cube, texel);
        return;
    }
    wrap_linear_fixed(at->s[2], level->size[2], (real)level->scale[2], wrap[2], &axis[2]);
    linear_slice(level, at, axis, axis[2].i0, 3, false, front);
    linear_slice(level, at, axis, axis[2].i1, 3, false, back);
    lerp_group(axis[2].weight, front, back, texel);
}

/* An instance for each target and filter. */
#define PACKED(filter, name, dimensions, cube)                                                                         \
    static FGL_NOINLINE void filter##_##name(const struct texture_level *level, const struct texture_coords *at,       \
                                             const GLenum wrap[3], uint32_t *FGL_RESTRICT texel)                       \
    {                                                                                                                  \
        filter##_packed(level, at, wrap, dimensions, cube, texel);                                                     \
    }
PACKED(nearest, 1d, 1, false)
PACKED(nearest, 2d, 2, false)
PACKED(nearest, 3d, 3, false)
PACKED(nearest, cube, 2, true)
PACKED(linear, 1d, 1, false)
PACKED(linear, 2d, 2, false)
PACKED(linear, 3d, 3, false)
PACKED(linear, cube, 2, true)
#undef PACKED

typedef void filter_packed_fn(const struct texture_level *level, const struct texture_coords *at, const GLenum wrap[3],
                              uint32_t *FGL_RESTRICT texel);
static filter_packed_fn *const filter_packed[TEXTURE_TARGETS][2] = {
        {nearest_1d, linear_1d}, {nearest_2d, linear_2d}, {nearest_2d, linear_2d}, {nearest_3d, linear_3d}, {nearest_cube, linear_cube}};

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
        wrap_linear(at->s[k], level->size[k], (real)level->scale[k], sampler->wrap[k], to);
        return;
    }
    wrap_nearest(at->s[k], level->size[k], (real)level->scale[k], sampler->wrap[k], to->i0);
    memcpy(to->i1, to->i0, sizeof to->i1);
    memset(to->f, 0, sizeof to->f);
    if (!rounded)
        return;
    wrap_linear(at->s[k], level->size[k], (real)level->scale[k], sampler->wrap[k], &around);
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
