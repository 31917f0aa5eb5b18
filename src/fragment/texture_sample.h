/* Texels of a group of fragments: coordinates, level, filter (GL 1.5, 3.8.6 to 3.8.14). Kernels only. */
#ifndef FGL_FRAGMENT_TEXTURE_SAMPLE_H
#define FGL_FRAGMENT_TEXTURE_SAMPLE_H

#include "fragment/texture_lod.h"

/* GL 1.5, table 3.19: the face of a direction and the coordinates on it. OSMesa rules: no direction is
 * the middle of a face; where a level is chosen, its coordinates are not a number. */
static inline void choose_faces(const struct sampler *sampler, struct texture_coords *at)
{
    const bool middle = !sampler->needs_lod || R_EXACT;
    FOR_GROUP(i) {
        const real x = at->s[0][i], y = at->s[1][i], z = at->s[2][i];
        const int axis = major_axis(x, y, z);
        const real major = axis == 2 ? z : axis == 0 ? x : y, scale = ((major == 0) & middle) ? 0 : (real)0.5 / r_abs(major);
        const bool negative = major < 0;
        const real s = axis == 2 ? (negative ? -x : x) : axis == 0 ? (negative ? z : -z) : x;
        const real t = axis == 1 ? (negative ? -z : z) : -y;
        at->face[i] = 2 * axis + negative;
        at->s[0][i] = s * scale + (real)0.5;
        at->s[1][i] = t * scale + (real)0.5;
    }
}

/* Fixed point: OSMesa rule: levels are mixed in steps of 1/256, rounded down. */
static FGL_NOINLINE void mix_level(const struct level_choice *choice, int level, const uint32_t *next, uint32_t *FGL_RESTRICT texel)
{
    FOR_GROUP(i) {
        const int32_t min = ~choice->mag[i], here = min & -(choice->level[i] == level),
                      above = min & -(choice->level[i] + 1 == level);
        const uint32_t weight = (uint32_t)((int32_t)(choice->f[i] * 256) & above);
        const uint32_t mixed = lerp_packed(weight, texel[i], next[i]); /* weight 0: texel */
        texel[i] = here ? next[i] : mixed;
    }
}

/* What is filtered first is taken for all fragments: those that read another level are given it later, and the one above it last. */
static inline void sample_packed(const struct sampler *sampler, const struct texture_coords *at,
                                 const struct level_choice *choice, uint32_t texel[FRAGMENT_GROUP])
{
    filter_packed_fn *const *const filter = filter_packed[sampler->target];
    bool first = true;
    if (!sampler->needs_lod || choice->used & USED_MAG) {
        filter[sampler->mag](&sampler->level[0], at, sampler->wrap, texel);
        first = false;
    }
    if (!sampler->needs_lod)
        return;
    for (int level = 0; level <= sampler->last_level; level++) {
        uint32_t next[FRAGMENT_GROUP];
        if (!(choice->used >> level & 1))
            continue;
        filter[sampler->min](&sampler->level[level], at, sampler->wrap, first ? texel : next);
        if (!first)
            mix_level(choice, level, next, texel);
        first = false;
    }
    if (first) /* no live fragment */
        FOR_GROUP(i) texel[i] = 0;
}

/* OSMesa rule: where one fragment of a block of 4 x 2 needs the linear filter, all are filtered linearly, those that need the nearest texel
 * with weights rounded to 0 and 1. Marks these. */
static inline bool round_weights(const struct sampler *sampler, const struct level_choice *choice, int32_t rounded[FRAGMENT_GROUP])
{
    const int32_t flip = sampler->mag == FILTER_LINEAR ? 0 : -1;
    const int32_t *beside =
            sampler->target == TEXTURE_CUBE_MAP && sampler->mip != MIP_NONE ? choice->magnify_beside : choice->magnify;
    int32_t any = 0;
    for (int block = 0; block < FRAGMENT_GROUP; block += 4) {
        int32_t linear = 0;
        for (int i = block; i < block + 4; i++)
            linear |= (choice->magnify[i] ^ flip) | (beside[i] ^ flip);
        for (int i = block; i < block + 4; i++)
            any |= rounded[i] = linear & ~(choice->magnify[i] ^ flip);
    }
    return any != 0;
}

static inline void sample_real(const struct sampler *sampler, const struct texture_coords *at, const struct level_choice *choice,
                               real texel[4][FRAGMENT_GROUP])
{
    int32_t rounded[FRAGMENT_GROUP];
    if (!sampler->needs_lod) {
        filter_real(sampler, &sampler->level[0], at, sampler->mag, NULL, texel);
        return;
    }
    const bool mixed = !R_EXACT && sampler->min != sampler->mag && round_weights(sampler, choice, rounded);
    memset(texel, 0, 4 * sizeof texel[0]);
    if (choice->used & USED_MAG)
        filter_real(sampler, &sampler->level[0], at, sampler->mag, mixed ? rounded : NULL, texel);
    for (int level = 0; level <= sampler->last_level; level++) {
        real next[4][FRAGMENT_GROUP];
        if (!(choice->used >> level & 1))
            continue;
        filter_real(sampler, &sampler->level[level], at, sampler->min, mixed ? rounded : NULL, next);
        for (int c = 0; c < 4; c++)
            FOR_GROUP(i) {
                const bool here = !choice->mag[i] && choice->level[i] == level;
                const bool above = !choice->mag[i] && choice->level[i] + 1 == level && choice->f[i] > 0;
                texel[c][i] = here    ? next[c][i]
                              : above ? lerp_real(choice->f[i], texel[c][i], next[c][i])
                                      : texel[c][i];
            }
    }
}

/* GL 1.5, 3.8.14: a depth texture's value as luminance, intensity or alpha. */
static inline void apply_depth_mode(GLenum mode, real texel[4][FRAGMENT_GROUP])
{
    for (int c = 1; c < 4; c++)
        memcpy(texel[c], texel[0], sizeof texel[0]);
    if (mode == GL_LUMINANCE)
        FOR_GROUP(i) texel[3][i] = 1;
    if (mode == GL_ALPHA)
        for (int c = 0; c < 3; c++)
            FOR_GROUP(i) texel[c][i] = 0;
}

/* GL_EXT_texture_swizzle: components exchanged, or constants. */
static inline void apply_swizzle(const uint8_t swizzle[4], real texel[4][FRAGMENT_GROUP])
{
    real from[SWIZZLE_ONE + 1][FRAGMENT_GROUP];
    memcpy(from, texel, 4 * sizeof texel[0]);
    FOR_GROUP(i) {
        from[SWIZZLE_ZERO][i] = 0;
        from[SWIZZLE_ONE][i] = 1;
    }
    for (int c = 0; c < 4; c++)
        memcpy(texel[c], from[swizzle[c]], sizeof texel[c]);
}

/* Where and on which levels the texture of a unit is read. */
static inline void find_texels(const struct fragments *fragments, const struct planes *p, const struct texture_stage *stage,
                               struct texture_coords *at, struct level_choice *choice)
{
    const struct sampler *sampler = &stage->sampler;
    const bool cube = sampler->target == TEXTURE_CUBE_MAP;
    const int count = cube ? 3 : sampler->dimensions;
    coordinates_at(stage, p, FRAGMENT_GROUP, fragments->fx, fragments->fy, fragments->w, sampler->compare_func ? 3 : count, at->s);
    if (sampler->compare_func)
        FOR_GROUP(i) at->compare[i] = r_min(r_max(at->s[2][i], 0), 1);
    if (sampler->needs_lod)
        choose_levels(fragments, p, stage, count, at->s, choice);
    if (cube)
        choose_faces(sampler, at);
}

/* The texels of a unit for every live fragment. */
static inline void sample_texture(const struct fragments *fragments, const struct planes *p, const struct texture_stage *stage,
                                  real texel[4][FRAGMENT_GROUP])
{
    const struct sampler *sampler = &stage->sampler;
    struct texture_coords at;
    struct level_choice choice;
    find_texels(fragments, p, stage, &at, &choice);
    if (sampler->fixed_point && !R_EXACT) {
        uint32_t packed[FRAGMENT_GROUP];
        sample_packed(sampler, &at, &choice, packed);
        unpack_texels(packed, texel);
    } else {
        sample_real(sampler, &at, &choice, texel);
    }
    if (sampler->kind == TEXELS_DEPTH)
        apply_depth_mode(sampler->depth_mode, texel);
    if (sampler->swizzled)
        apply_swizzle(sampler->swizzle, texel);
}

#endif
