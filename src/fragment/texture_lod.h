/* Which images of a texture each fragment reads: scale factor and level of detail (GL 1.5, 3.8.8 "Texture Minification"). Kernels only.
 *
 * OSMesa rules: but for cube maps both are found once for each square of 2 x 2 pixels at even columns and rows, from the differences of
 * its upper left pixel to its neighbours; the scale factor is kept squared, but for 1D textures; its logarithm is linear between powers of two. */
#ifndef FGL_FRAGMENT_TEXTURE_LOD_H
#define FGL_FRAGMENT_TEXTURE_LOD_H

#include "fragment/texture_filter.h"

/* For each fragment: mag is used on level 0, or min on `level` and, where f is not 0, on the next. magnify_beside: what the fragment in the
 * same column of the quad's other row does; only for cube maps, the rows of all others agree. */
struct level_choice {
    _Alignas(64) int32_t magnify[FRAGMENT_GROUP], magnify_beside[FRAGMENT_GROUP], level[FRAGMENT_GROUP];
    int32_t mag[FRAGMENT_GROUP]; /* magnify, if mag differs from min */
    real f[FRAGMENT_GROUP];
    uint32_t used; /* bit: a level on which a live fragment uses min; USED_MAG: one uses mag */
};
#define USED_MAG 0x80000000u

/* One of s t r at n pixels of a row. */
static FGL_ALWAYS_INLINE void coordinate_at(const struct planes *p, int lane, const int n, const real *fx, real fy, const real *w,
                                            const real *over_q, real *FGL_RESTRICT to)
{
    plane_values(p, lane, n, fx, fy, to);
    for (int i = 0; i < n; i++)
        to[i] = to[i] * w[i] * over_q[i];
}

/* s t r at n pixels of a row, divided by q. OSMesa rule: multiplied by 1/q, also where q was never given. */
static FGL_ALWAYS_INLINE void coordinates_at(const struct texture_stage *stage, const struct planes *p, const int n, const real *fx,
                                             real fy, const real *w, const int count, real to[3][FRAGMENT_GROUP])
{
    real over_q[FRAGMENT_GROUP];
    const int lane = stage->lane;
    if (stage->source == COORDINATES_CONSTANT) {
        const real scale = 1 / (real)stage->constant[3];
        for (int c = 0; c < count; c++)
            for (int i = 0; i < n; i++)
                to[c][i] = (real)stage->constant[c] * scale;
        return;
    }
    plane_values(p, lane + 3, n, fx, fy, over_q);
    for (int i = 0; i < n; i++)
        over_q[i] = 1 / (over_q[i] * w[i]);
    coordinate_at(p, lane, n, fx, fy, w, over_q, to[0]);
    if (count > 1)
        coordinate_at(p, lane + 1, n, fx, fy, w, over_q, to[1]);
    if (count > 2)
        coordinate_at(p, lane + 2, n, fx, fy, w, over_q, to[2]);
}

/* The same where w is still to be found. */
static FGL_ALWAYS_INLINE void coordinates_of_row(const struct texture_stage *stage, const struct planes *p, const int n, const real *fx,
                                                 int row, const int count, real to[3][FRAGMENT_GROUP])
{
    real w[FRAGMENT_GROUP];
    plane_values(p, LANE_OOW, n, fx, (real)row, w);
    for (int i = 0; i < n; i++)
        w[i] = 1 / w[i];
    coordinates_at(stage, p, n, fx, (real)row, w, count, to);
}

enum { QUADS = FRAGMENT_GROUP / 2 }; /* squares of 2 x 2 pixels of which a group is a row */
#define FOR_QUADS(k) FGL_VECTOR_LOOP for (int k = 0; k < QUADS; k++)

static FGL_ALWAYS_INLINE void add_squares(const real *to, const real *from, real n, real sum[QUADS])
{
    FOR_QUADS(k) {
        const real d = (to[k] - from[k]) * n;
        sum[k] += d * d;
    }
}

/* For each quad the greater of the squared lengths of the derivatives by x and y, in texels of the base level; of one coordinate, of the
 * lengths themselves. at, right, below: coordinates at the quad's first pixel and at its neighbours. */
static FGL_ALWAYS_INLINE void scale_factors(const struct sampler *sampler, const int count, real at[3][FRAGMENT_GROUP],
                                            real right[3][FRAGMENT_GROUP], real below[3][FRAGMENT_GROUP], real rho[QUADS])
{
    const real width = (real)sampler->level[0].size[0], height = (real)sampler->level[0].size[1],
               depth = (real)sampler->level[0].size[2];
    real x[QUADS] = {0}, y[QUADS] = {0};
    if (count == 1) {
        FOR_QUADS(k) rho[k] = r_max(r_abs((right[0][k] - at[0][k]) * width), r_abs((below[0][k] - at[0][k]) * width));
        return;
    }
    add_squares(right[0], at[0], width, x);
    add_squares(below[0], at[0], width, y);
    add_squares(right[1], at[1], height, x);
    add_squares(below[1], at[1], height, y);
    if (count > 2) {
        add_squares(right[2], at[2], depth, x);
        add_squares(below[2], at[2], depth, y);
    }
    FOR_QUADS(k) rho[k] = r_max(x[k], y[k]);
}

/* From quads to their fragments: as pairs where they are floats, since stores of half vectors delay the loads of whole ones. */
static FGL_ALWAYS_INLINE void spread(const real *of_quad, real *FGL_RESTRICT to)
{
#if R_EXACT
    FOR_QUADS(k) to[2 * k] = to[2 * k + 1] = of_quad[k];
#else
    uint64_t pair[QUADS];
    FOR_QUADS(k) pair[k] = fgl_float_bits(of_quad[k]) * UINT64_C(0x100000001);
    memcpy(to, pair, sizeof pair);
#endif
}

static FGL_ALWAYS_INLINE void quad_scale_factors(const struct fragments *fragments, const struct planes *p,
                                                 const struct texture_stage *stage, const int count, real rho[FRAGMENT_GROUP])
{
    real fx[2][QUADS], at[3][FRAGMENT_GROUP], right[3][FRAGMENT_GROUP], below[3][FRAGMENT_GROUP], of_quad[QUADS];
    const int first = fragments->x, upper = fragments->row & ~1;
    FOR_QUADS(k) fx[0][k] = (real)(first + 2 * k);
    FOR_QUADS(k) fx[1][k] = (real)(first + 2 * k + 1);
    coordinates_of_row(stage, p, QUADS, fx[0], upper, count, at);
    coordinates_of_row(stage, p, QUADS, fx[1], upper, count, right);
    coordinates_of_row(stage, p, QUADS, fx[0], upper + 1, count, below);
    scale_factors(&stage->sampler, count, at, right, below, of_quad);
    spread(of_quad, rho);
}

/* The major axis of a direction: that of its greatest component. OSMesa rule: where components are equal z goes before y, y before x. */
static FGL_ALWAYS_INLINE int major_axis(real x, real y, real z)
{
    return r_abs(z) >= r_max(r_abs(x), r_abs(y)) ? 2 : r_abs(x) > r_abs(y) ? 0 : 1;
}

/* The derivative of a coordinate c / 2m on a face, in texels, squared. */
static FGL_ALWAYS_INLINE real face_derivative2(real dc, real c, real dm_over_m, real half_over_m, real n)
{
    const real d = (dc - c * dm_over_m) * half_over_m * n;
    return d * d;
}

/* The same on the faces of a cube map, whose s t r are directions. OSMesa rule: for each fragment by itself, from its row's and its
 * column's difference; without mipmaps for the upper left fragment of each quad; 0 where there is no direction, which gives no number. */
static FGL_ALWAYS_INLINE void cube_scale_factors(const struct sampler *sampler, real at[3][FRAGMENT_GROUP],
                                                 real upper[3][FRAGMENT_GROUP], real lower[3][FRAGMENT_GROUP],
                                                 real rho[FRAGMENT_GROUP])
{
    const real n = (real)sampler->level[0].size[0];
    FOR_GROUP(i) {
        const int axis = major_axis(at[0][i], at[1][i], at[2][i]), u = axis == 0 ? 2 : 0, v = axis == 1 ? 2 : 1;
        const int left = i & ~1, right = i | 1;
        const real over_m = 1 / at[axis][i], half = over_m * (real)0.5;
        const real x = (at[axis][right] - at[axis][left]) * over_m, y = (lower[axis][i] - upper[axis][i]) * over_m;
        const real x2 = face_derivative2(at[u][right] - at[u][left], at[u][i], x, half, n) +
                        face_derivative2(at[v][right] - at[v][left], at[v][i], x, half, n);
        const real y2 = face_derivative2(lower[u][i] - upper[u][i], at[u][i], y, half, n) +
                        face_derivative2(lower[v][i] - upper[v][i], at[v][i], y, half, n);
        rho[i] = r_max(r_max(x2, y2), 0);
    }
    if (sampler->mip == MIP_NONE)
        FOR_GROUP(i) rho[i] = rho[i & ~1];
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

/* From rho to the level of detail (GL 1.5, equations 3.17 and 3.18). */
static FGL_ALWAYS_INLINE void levels_of_detail(const struct sampler *sampler, const int count, const real *rho, real *lod)
{
    const real bias = (real)sampler->lod_bias, least = (real)sampler->min_lod, most = (real)sampler->max_lod;
    FOR_GROUP(i) {
        const real v = log2_of(count == 1 ? rho[i] * rho[i] : rho[i]) * (real)0.5 + bias;
        lod[i] = r_max(r_min(v, most), least);
    }
    if (least == most)
        FOR_GROUP(i) lod[i] = least;
}

/* From rho to levels, which may not be there. */
static FGL_ALWAYS_INLINE void levels_wanted(const struct sampler *sampler, const int count, const real *rho,
                                            struct level_choice *FGL_RESTRICT to)
{
    real lod[FRAGMENT_GROUP];
    FOR_GROUP(i) to->f[i] = 0;
#if !R_EXACT
    if (!sampler->adjusts_lod && sampler->mip != MIP_LINEAR) {
        FOR_GROUP(i) to->magnify[i] = -(int32_t)!(rho[i] > 1);
        if (count == 1)
            FOR_GROUP(i) to->level[i] = exponent_of(rho[i] * 1.41421356f);
        else
            FOR_GROUP(i) to->level[i] = (exponent_of(rho[i]) + 1) >> 1;
        return;
    }
#endif
    levels_of_detail(sampler, count, rho, lod);
    const real magnify_below = R_EXACT ? (real)sampler->magnify_below : 0;
    FOR_GROUP(i) to->magnify[i] = -(int32_t)!(lod[i] > magnify_below);
    if (sampler->mip == MIP_LINEAR) {
        FOR_GROUP(i) to->level[i] = to_int(r_floor(lod[i]));
        FOR_GROUP(i) to->f[i] = lod[i] - r_floor(lod[i]);
    } else {
        FOR_GROUP(i) to->level[i] = to_int(R_EXACT ? -r_floor((real)0.5 - lod[i]) : round_even_of(lod[i]));
    }
}

/* Levels that are there. */
static FGL_ALWAYS_INLINE void levels_kept(const struct sampler *sampler, const int32_t *live, struct level_choice *FGL_RESTRICT to)
{
    const int32_t last = sampler->last_level, differ = -(int32_t)(sampler->min != sampler->mag);
    uint32_t used = 0;
    FOR_GROUP(i) {
        const int32_t level = to->level[i], min = ~to->magnify[i];
        const real f = r_select((level >= 0) & (level < last) & (min != 0), to->f[i], 0);
        const int32_t mag = to->magnify[i] & differ, kept = fgl_clamp(level, 0, last) & min;
        used |= (uint32_t)live[i] & (mag ? USED_MAG : (f > 0 ? 3u : 1u) << kept);
        to->f[i] = f;
        to->level[i] = kept;
        to->mag[i] = mag;
    }
    to->used = used;
}

/* at: the coordinates of this row. */
static FGL_ALWAYS_INLINE void choose_cube_levels(const struct fragments *fragments, const struct planes *p,
                                                 const struct texture_stage *stage, real at[3][FRAGMENT_GROUP],
                                                 struct level_choice *to)
{
    const struct sampler *sampler = &stage->sampler;
    const bool odd = fragments->row & 1, mipmaps = sampler->mip != MIP_NONE;
    real other[3][FRAGMENT_GROUP], rho[FRAGMENT_GROUP];
    coordinates_of_row(stage, p, FRAGMENT_GROUP, fragments->fx, fragments->row ^ 1, 3, other);
    cube_scale_factors(sampler, odd && !mipmaps ? other : at, odd ? other : at, odd ? at : other, rho);
    levels_wanted(sampler, 3, rho, to);
    if (mipmaps && !R_EXACT) {
        struct level_choice beside;
        cube_scale_factors(sampler, other, odd ? other : at, odd ? at : other, rho);
        levels_wanted(sampler, 3, rho, &beside);
        memcpy(to->magnify_beside, beside.magnify, sizeof beside.magnify);
    }
}

static FGL_NOINLINE void choose_levels(const struct fragments *fragments, const struct planes *p,
                                       const struct texture_stage *stage, const int count, real at[3][FRAGMENT_GROUP],
                                       struct level_choice *to)
{
    const struct sampler *sampler = &stage->sampler;
    if (sampler->target == TEXTURE_CUBE_MAP) {
        choose_cube_levels(fragments, p, stage, at, to);
    } else {
        real rho[FRAGMENT_GROUP];
        quad_scale_factors(fragments, p, stage, count, rho);
        levels_wanted(sampler, count, rho, to);
    }
    levels_kept(sampler, fragments->live, to);
}

#endif
