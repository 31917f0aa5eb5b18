/* Which images of a texture each fragment reads: scale factor and level of detail (GL 1.5, 3.8.8 "Texture Minification"). Kernels only.
 *
 * OSMesa rules: both are found once for each square of 2 x 2 pixels at even x and y (y down), from the differences of its upper left pixel
 * to its neighbours; the scale factor is kept squared, but for 1D textures; its logarithm is linear between powers of two. */
#ifndef FGL_FRAGMENT_TEXTURE_LOD_H
#define FGL_FRAGMENT_TEXTURE_LOD_H

#include "fragment/texture_filter.h"

enum { FRAGMENT_QUADS = FRAGMENT_GROUP / 2 };

/* For each fragment: mag is used, or min on `level` and, where f is not 0, on the next. */
struct level_choice {
    int32_t magnify[FRAGMENT_GROUP], level[FRAGMENT_GROUP];
    real f[FRAGMENT_GROUP];
};

/* s t r q at the pixels of a row; s t r are divided by q. OSMesa rule: multiplied by 1/q, also where q was never given. */
static FGL_ALWAYS_INLINE void coordinates_at(const struct texture_stage *stage, const struct planes *p, const real *fx,
                                             real fy, const real *w, const int count, real to[3][FRAGMENT_GROUP])
{
    real over_q[FRAGMENT_GROUP];
    const int lane = stage->lane;
    if (stage->source == COORDINATES_CONSTANT) {
        const real scale = 1 / (real)stage->constant[3];
        for (int c = 0; c < count; c++)
            FOR_GROUP(i) to[c][i] = (real)stage->constant[c] * scale;
        return;
    }
    FOR_GROUP(i) over_q[i] = 1 / (plane_at(p, lane + 3, fx[i], fy) * w[i]);
    for (int c = 0; c < count; c++)
        FOR_GROUP(i) to[c][i] = plane_at(p, lane + c, fx[i], fy) * w[i] * over_q[i];
}

/* Half the reciprocal of a direction's greatest component: on the faces of a cube of half size 1/2. */
static FGL_ALWAYS_INLINE real to_cube(real s, real t, real r)
{
    return (real)0.5 / r_max(r_abs(s), r_max(r_abs(t), r_abs(r)));
}

static FGL_ALWAYS_INLINE void project_to_cube(real s[3][FRAGMENT_GROUP])
{
    FOR_GROUP(i) {
        const real scale = to_cube(s[0][i], s[1][i], s[2][i]);
        s[0][i] *= scale;
        s[1][i] *= scale;
        s[2][i] *= scale;
    }
}

/* The greater of the squared lengths of the derivatives by x and y, in texels of the base level. upper and lower: coordinates of the
 * quads' rows. One coordinate: not squared. */
static FGL_ALWAYS_INLINE void scale_factors(const struct sampler *sampler, const int count, real upper[3][FRAGMENT_GROUP],
                                            real lower[3][FRAGMENT_GROUP], real rho[FRAGMENT_QUADS])
{
    const int *size = sampler->level[0].size;
    const bool cube = sampler->target == TEXTURE_CUBE_MAP;
    for (int k = 0; k < FRAGMENT_QUADS; k++) {
        real x2 = 0, y2 = 0, x1 = 0, y1 = 0;
        for (int c = 0; c < count; c++) {
            const real n = cube ? 1 : (real)size[c];
            const real dx = (upper[c][2 * k + 1] - upper[c][2 * k]) * n, dy = (lower[c][2 * k] - upper[c][2 * k]) * n;
            x1 = r_abs(dx);
            y1 = r_abs(dy);
            x2 = c ? x2 + dx * dx : dx * dx;
            y2 = c ? y2 + dy * dy : dy * dy;
        }
        rho[k] = count == 1 ? r_max(x1, y1) : r_max(x2, y2) * (cube ? (real)(size[0] * size[0]) : 1);
    }
}

#if R_EXACT
static FGL_ALWAYS_INLINE real log2_of(real v)
{
    return r_select(v > 0, r_log2(v), -1000);
}
#else
static FGL_ALWAYS_INLINE int exponent_of(real v)
{
    return (int)(fgl_float_bits(v) >> 23 & 255) - 127;
}

static FGL_ALWAYS_INLINE real log2_of(real v)
{
    const real mantissa = fgl_bits_float((fgl_float_bits(v) & 0x007fffff) | 0x3f800000);
    return (real)(exponent_of(v) - 1) + mantissa;
}
#endif

/* From rho to the level, for one quad. */
static FGL_ALWAYS_INLINE void choose_level(const struct sampler *sampler, const int count, real rho, int32_t *magnify,
                                           int32_t *level, real *f)
{
    *f = 0;
#if !R_EXACT
    if (!sampler->adjusts_lod && sampler->mip != MIP_LINEAR) {
        *magnify = rho > 1 ? 0 : -1;
        *level = count == 1 ? exponent_of(rho * 1.41421356f) : (exponent_of(rho) + 1) >> 1;
        return;
    }
#endif
    real lod = log2_of(count == 1 ? rho * rho : rho) * (real)0.5 + (real)sampler->lod_bias;
    lod = r_max(r_min(lod, (real)sampler->max_lod), (real)sampler->min_lod);
    if (sampler->min_lod == sampler->max_lod)
        lod = (real)sampler->min_lod;
    *magnify = lod > (R_EXACT ? (real)sampler->magnify_below : 0) ? 0 : -1;
    if (sampler->mip == MIP_LINEAR) {
        const real below = r_floor(lod);
        *level = to_int(below);
        *f = lod - below;
    } else {
        *level = to_int(R_EXACT ? -r_floor((real)0.5 - lod) : round_even_of(lod));
    }
}

/* coordinates: of this row. s is changed for cube maps: see project_to_cube. */
static FGL_ALWAYS_INLINE void choose_levels(const struct fragments *fragments, const struct planes *p,
                                            const struct texture_stage *stage, const int count,
                                            real coordinates[3][FRAGMENT_GROUP], struct level_choice *to)
{
    const struct sampler *sampler = &stage->sampler;
    real other[3][FRAGMENT_GROUP], w[FRAGMENT_GROUP], rho[FRAGMENT_QUADS];
    const real other_row = (real)(fragments->row ^ 1);
    FOR_GROUP(i) w[i] = 1 / plane_at(p, LANE_OOW, fragments->fx[i], other_row);
    coordinates_at(stage, p, fragments->fx, other_row, w, count, other);
    if (sampler->target == TEXTURE_CUBE_MAP)
        project_to_cube(other);
    if (fragments->row & 1)
        scale_factors(sampler, count, other, coordinates, rho);
    else
        scale_factors(sampler, count, coordinates, other, rho);
    for (int k = 0; k < FRAGMENT_QUADS; k++) {
        int32_t magnify, level;
        real f;
        choose_level(sampler, count, rho[k], &magnify, &level, &f);
        if (sampler->mip == MIP_NONE || level < 0) {
            level = 0;
            f = 0;
        } else if (level >= sampler->last_level) {
            level = sampler->last_level;
            f = 0;
        }
        to->magnify[2 * k] = to->magnify[2 * k + 1] = magnify;
        to->level[2 * k] = to->level[2 * k + 1] = level;
        to->f[2 * k] = to->f[2 * k + 1] = f;
    }
}

#endif
