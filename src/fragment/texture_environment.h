/* Texture environments and texture functions (GL 1.5, 3.8.13), and the units one after the other (3.8.15 "Texture Application").
 * Kernels only. */
#ifndef FGL_FRAGMENT_TEXTURE_ENVIRONMENT_H
#define FGL_FRAGMENT_TEXTURE_ENVIRONMENT_H

#include "fragment/texture_sample.h"

/* What combiners may read, a group of each. */
struct combine_inputs {
    real texel[FGL_MAX_TEXTURE_UNITS][4][FRAGMENT_GROUP]; /* by stage */
    real primary[4][FRAGMENT_GROUP];
    int stage_of_unit[FGL_MAX_TEXTURE_UNITS]; /* -1: the unit draws no texture */
};

/* Component c of a source before its operand, or NULL: black. */
static inline const real *source_component(const struct combine_inputs *in, const struct texture_environment *e, int stage,
                                           GLenum source, const struct fragments *f, int c, real constant[FRAGMENT_GROUP])
{
    switch (source) {
    case GL_TEXTURE: return in->texel[stage][c];
    case GL_PRIMARY_COLOR: return in->primary[c];
    case GL_PREVIOUS: return f->color[c];
    case GL_CONSTANT: FOR_GROUP(i) constant[i] = (real)e->color[c]; return constant;
    default: { /* GL_TEXTUREi: crossbar */
        const int other = in->stage_of_unit[source - GL_TEXTURE0];
        FOR_GROUP(i) constant[i] = 0;
        return other >= 0 ? in->texel[other][c] : constant;
    }
    }
}

static inline bool complements(const struct combine *combine, int k)
{
    return combine->operand[k] == GL_ONE_MINUS_SRC_COLOR || combine->operand[k] == GL_ONE_MINUS_SRC_ALPHA;
}

/* Argument k of a combiner for component c before it is complemented (GL 1.5, tables 3.25 and 3.26). */
static inline void plain_argument(const struct combine_inputs *in, const struct texture_environment *e, int stage,
                            const struct combine *combine, int k, const struct fragments *f, int c, real to[FRAGMENT_GROUP])
{
    const GLenum operand = combine->operand[k];
    const bool alpha = operand == GL_SRC_ALPHA || operand == GL_ONE_MINUS_SRC_ALPHA;
    real constant[FRAGMENT_GROUP];
    const real *from = source_component(in, e, stage, combine->source[k], f, alpha ? 3 : c, constant);
    FOR_GROUP(i) to[i] = from[i];
}

static inline void argument(const struct combine_inputs *in, const struct texture_environment *e, int stage,
                            const struct combine *combine, int k, const struct fragments *f, int c, real to[FRAGMENT_GROUP])
{
    plain_argument(in, e, stage, combine, k, f, c, to);
    if (complements(combine, k))
        FOR_GROUP(i) to[i] = 1 - to[i];
}

/* Arguments 0 and 1 mixed by argument 2. OSMesa rule: 1 - (1 - x) is x. */
static inline void interpolate(const struct combine_inputs *in, const struct texture_environment *e, int stage,
                               const struct combine *combine, const struct fragments *f, int c, real to[FRAGMENT_GROUP])
{
    real a[FRAGMENT_GROUP], b[FRAGMENT_GROUP], weight[FRAGMENT_GROUP], rest[FRAGMENT_GROUP];
    argument(in, e, stage, combine, 0, f, c, a);
    argument(in, e, stage, combine, 1, f, c, b);
    plain_argument(in, e, stage, combine, 2, f, c, weight);
    const bool complement = complements(combine, 2);
    FOR_GROUP(i) rest[i] = complement ? weight[i] : 1 - weight[i];
    FOR_GROUP(i) weight[i] = complement ? 1 - weight[i] : weight[i];
    switch (combine->form) {
    case COMBINE_FIRST_ALONE: memcpy(to, a, sizeof a); break;
    case COMBINE_BY_FIRST: FOR_GROUP(i) to[i] = a[i] * (weight[i] + b[i]); break;
    case COMBINE_BY_SECOND: FOR_GROUP(i) to[i] = b[i] * (a[i] + rest[i]); break;
    default: FOR_GROUP(i) to[i] = a[i] * weight[i] + b[i] * rest[i];
    }
}

/* Argument k - 1/2. OSMesa rule: in one step of a complemented one. */
static inline void signed_argument(const struct combine_inputs *in, const struct texture_environment *e, int stage,
                                   const struct combine *combine, int k, const struct fragments *f, int c, real to[FRAGMENT_GROUP])
{
    plain_argument(in, e, stage, combine, k, f, c, to);
    const bool complement = complements(combine, k);
    FOR_GROUP(i) to[i] = complement ? (real)0.5 - to[i] : to[i] - (real)0.5;
}

/* 4 (a - 1/2) . (b - 1/2) */
static inline void dot3(const struct combine_inputs *in, const struct texture_environment *e, int stage,
                        const struct combine *combine, const struct fragments *f, real to[FRAGMENT_GROUP])
{
    real product[3][FRAGMENT_GROUP];
    for (int c = 0; c < 3; c++) {
        real a[FRAGMENT_GROUP], b[FRAGMENT_GROUP];
        argument(in, e, stage, combine, 0, f, c, a);
        argument(in, e, stage, combine, 1, f, c, b);
        FOR_GROUP(i) product[c][i] = (a[i] * 2 - 1) * (b[i] * 2 - 1);
    }
    FOR_GROUP(i) to[i] = (product[2][i] + product[1][i]) + product[0][i];
}

/* GL 1.5, table 3.24. */
static inline void combine_component(const struct combine_inputs *in, const struct texture_environment *e, int stage,
                                     const struct combine *combine, const struct fragments *f, int c, real to[FRAGMENT_GROUP])
{
    real a[2][FRAGMENT_GROUP];
    if (combine->function == GL_DOT3_RGB || combine->function == GL_DOT3_RGBA) {
        dot3(in, e, stage, combine, f, to);
        return;
    }
    if (combine->function == GL_INTERPOLATE) {
        interpolate(in, e, stage, combine, f, c, to);
        return;
    }
    const int halved = combine->function != GL_ADD_SIGNED ? -1 : combine->form == COMBINE_SECOND_FIRST;
    if (halved == 0)
        signed_argument(in, e, stage, combine, 0, f, c, a[0]);
    else
        argument(in, e, stage, combine, 0, f, c, a[0]);
    if (combine->function == GL_REPLACE) {
        memcpy(to, a[0], sizeof a[0]);
        return;
    }
    if (halved == 1)
        signed_argument(in, e, stage, combine, 1, f, c, a[1]);
    else
        argument(in, e, stage, combine, 1, f, c, a[1]);
    switch (combine->function) {
    case GL_MODULATE: FOR_GROUP(i) to[i] = a[0][i] * a[1][i]; break;
    case GL_ADD:
    case GL_ADD_SIGNED: FOR_GROUP(i) to[i] = a[0][i] + a[1][i]; break;
    default: FOR_GROUP(i) to[i] = a[0][i] - a[1][i]; break; /* GL_SUBTRACT */
    }
}

static inline void apply_environment(const struct combine_inputs *in, const struct texture_stage *s, int stage, struct fragments *f)
{
    const struct texture_environment *e = &s->environment;
    real to[4][FRAGMENT_GROUP];
    for (int c = 0; c < 4; c++) {
        const struct combine *combine = c == 3 && e->rgb.function != GL_DOT3_RGBA ? &e->alpha : &e->rgb;
        combine_component(in, e, stage, combine, f, c, to[c]);
        const real scale = (real)(c == 3 ? e->alpha.scale : e->rgb.scale); /* OSMesa rule: also for GL_DOT3_RGBA */
        if (scale != 1)
            FOR_GROUP(i) to[c][i] *= scale;
        if (e->clamped)
            FOR_GROUP(i) to[c][i] = r_min(r_max(to[c][i], 0), 1);
    }
    memcpy(f->color, to, sizeof to);
}

/* ---- products: see struct texture_environment ---- */

static FGL_ALWAYS_INLINE void multiply_channel(const uint32_t *texel, int c, bool by_texel, bool keep, real *FGL_RESTRICT color)
{
    if (by_texel && keep)
        FOR_GROUP(i) color[i] *= from_unorm8(texel[i] >> (8 * c) & 255);
    else if (by_texel)
        FOR_GROUP(i) color[i] = from_unorm8(texel[i] >> (8 * c) & 255);
}

static inline void multiply_texels(const uint32_t *texel, const struct texture_environment *e, real color[4][FRAGMENT_GROUP])
{
    multiply_channel(texel, 0, e->by_texel[0], e->by_previous[0], color[0]);
    multiply_channel(texel, 1, e->by_texel[0], e->by_previous[0], color[1]);
    multiply_channel(texel, 2, e->by_texel[0], e->by_previous[0], color[2]);
    multiply_channel(texel, 3, e->by_texel[1], e->by_previous[1], color[3]);
}

static FGL_NOINLINE void apply_product(struct fragments *f, const struct planes *p, const struct texture_stage *s)
{
    uint32_t texel[FRAGMENT_GROUP];
    struct texture_coords at;
    struct level_choice choice;
    find_texels(f, p, s, &at, &choice);
    sample_packed(&s->sampler, &at, &choice, texel);
    multiply_texels(texel, &s->environment, f->color);
}

/* ---- all stages ---- */

static FGL_NOINLINE void apply_combiners(struct fragments *f, const struct fragment_plan *plan, const struct planes *p)
{
    struct combine_inputs in;
    for (int c = 0; c < 4; c++) {
        if (plan->primary_interpolated)
            interpolate_channel(f, p, LANE_COLOR + c, in.primary[c]);
        else
            memcpy(in.primary[c], f->color[c], sizeof in.primary[c]);
    }
    for (int unit = 0; unit < FGL_MAX_TEXTURE_UNITS; unit++)
        in.stage_of_unit[unit] = -1;
    for (int stage = 0; stage < plan->textures; stage++) {
        sample_texture(f, p, &plan->texture[stage], in.texel[stage]);
        in.stage_of_unit[plan->texture[stage].unit] = stage;
    }
    for (int stage = 0; stage < plan->textures; stage++)
        apply_environment(&in, &plan->texture[stage], stage, f);
}

static inline void apply_textures(struct fragments *f, const struct fragment_plan *plan, const struct planes *p)
{
    if (R_EXACT || !plan->texture_products) {
        apply_combiners(f, plan, p);
        return;
    }
    for (int stage = 0; stage < plan->textures; stage++)
        apply_product(f, p, &plan->texture[stage]);
}

#endif
