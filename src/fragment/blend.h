/* The general path's end: from colours to the buffer (GL 1.5, 4.1.8 "Blending", 4.1.10 "Logical
 * Operation", 4.2.2 "Fine Control of Buffer Updates"). */
#ifndef FGL_FRAGMENT_BLEND_H
#define FGL_FRAGMENT_BLEND_H

#include "fragment/pixel.h"

/* OSMesa rule: normalised colour is rounded to the buffer's precision first; blending is then integer
 * arithmetic, with one rounding for each product and saturating sums. (t + (t >> n) + 2^(n-1)) >> n divides t by
 * 2^n - 1. */
static FGL_ALWAYS_INLINE uint16_t byte_mul(uint8_t a, uint8_t b)
{
    const uint16_t t = (uint16_t)(a * b), rounded = (uint16_t)(t + (t >> 8) + 128); /* no more than 65407 */
    return rounded >> 8;
}

static FGL_ALWAYS_INLINE uint32_t word_mul(uint32_t a, uint32_t b)
{
    const uint32_t t = a * b;
    return (t + (t >> 16) + 32768) >> 16;
}

/* OSMesa rule: images of one component are blended so, where the factors are a number and its complement. */
static FGL_ALWAYS_INLINE uint8_t byte_lerp(uint8_t a, uint8_t b, uint8_t f)
{
    return (uint8_t)(b + (((a - b) * (f + (f >> 7)) + 128) >> 8));
}

static FGL_ALWAYS_INLINE uint32_t word_lerp(uint32_t a, uint32_t b, uint32_t f)
{
    return (b + (uint32_t)((((int64_t)a - b) * (f + (f >> 15))) >> 16)) & 65535; /* here the product is cut */
}

static FGL_ALWAYS_INLINE uint32_t saturating_add(uint32_t a, uint32_t b, uint32_t max)
{
    return a + b < max ? a + b : max;
}

/* Buffers of 8 bits: channel 0 has the packed pixels, channel 3 their alpha in each byte; both factors are packed alike. */
#define CHANNEL uint32_t
#define ELEMENT uint8_t
#define ELEMENTS (4 * FRAGMENT_GROUP)
#define FACTOR_OUT 0
#define T(name) byte_##name
#define MUL(a, b) byte_mul(a, b)
#define LERP(a, b, f) byte_lerp(a, b, f)
#define COMPLEMENT(a) (~(a))
#define ADD(a, b) ((uint16_t)((a) + (b)) < 255 ? (uint16_t)((a) + (b)) : 255)
#define SUB(a, b) ((a) > (b) ? (a) - (b) : 0)
#include "fragment/blend_template.h"

/* 16 bits. */
#define CHANNEL uint32_t
#define ELEMENT uint32_t
#define ELEMENTS FRAGMENT_GROUP
#define FACTOR_OUT 0
#define T(name) word_##name
#define MUL(a, b) word_mul(a, b)
#define LERP(a, b, f) word_lerp(a, b, f)
#define COMPLEMENT(a) (max - (a))
#define ADD(a, b) saturating_add(a, b, max)
#define SUB(a, b) ((a) > (b) ? (a) - (b) : 0)
#include "fragment/blend_template.h"

/* OSMesa rule: float colour blends unclamped. */
#define CHANNEL real
#define ELEMENT real
#define ELEMENTS FRAGMENT_GROUP
#define FACTOR_OUT 1
#define T(name) real_##name
#define MUL(a, b) ((a) * (b))
#define LERP(a, b, f) ((f) * (a) + (max - (f)) * (b)) /* images of floats are not drawn to */
#define COMPLEMENT(a) (max - (a))
#define ADD(a, b) ((a) + (b))
#define SUB(a, b) ((a) - (b))
#include "fragment/blend_template.h"

/* GL 1.5, table 4.2. Bits of source and destination, all of a channel's. */
static inline void logic_op(GLenum op, uint32_t *FGL_RESTRICT s, const uint32_t *FGL_RESTRICT d, uint32_t max)
{
    /* clang-format off */
    switch (op) {
    case GL_CLEAR:         FOR_GROUP(i) s[i] = 0; break;
    case GL_AND:           FOR_GROUP(i) s[i] = s[i] & d[i]; break;
    case GL_AND_REVERSE:   FOR_GROUP(i) s[i] = s[i] & ~d[i]; break;
    case GL_AND_INVERTED:  FOR_GROUP(i) s[i] = ~s[i] & d[i]; break;
    case GL_NOOP:          FOR_GROUP(i) s[i] = d[i]; break;
    case GL_XOR:           FOR_GROUP(i) s[i] = s[i] ^ d[i]; break;
    case GL_OR:            FOR_GROUP(i) s[i] = s[i] | d[i]; break;
    case GL_NOR:           FOR_GROUP(i) s[i] = ~(s[i] | d[i]); break;
    case GL_EQUIV:         FOR_GROUP(i) s[i] = ~(s[i] ^ d[i]); break;
    case GL_INVERT:        FOR_GROUP(i) s[i] = ~d[i]; break;
    case GL_OR_REVERSE:    FOR_GROUP(i) s[i] = s[i] | ~d[i]; break;
    case GL_COPY_INVERTED: FOR_GROUP(i) s[i] = ~s[i]; break;
    case GL_OR_INVERTED:   FOR_GROUP(i) s[i] = ~s[i] | d[i]; break;
    case GL_NAND:          FOR_GROUP(i) s[i] = ~(s[i] & d[i]); break;
    case GL_SET:           FOR_GROUP(i) s[i] = ~0u; break;
    default: break; /* GL_COPY */
    }
    /* clang-format on */
    FOR_GROUP(i) s[i] &= max;
}

static inline uint32_t to_norm(real v, uint32_t max)
{
    return (uint32_t)r_round_small(r_saturate(v) * (real)max);
}

/* Alpha's part of the state that is not RGB's, too. */
static inline bool blends_alpha_apart(const struct color_buffer_state *s)
{
    return s->blend_equation[0] != s->blend_equation[1] || s->blend_src_rgb != s->blend_src_alpha ||
           s->blend_dst_rgb != s->blend_dst_alpha || s->blend_src_rgb == GL_SRC_ALPHA_SATURATE;
}

static inline void blend_packed(const struct color_buffer_state *s, bool lerp, const uint32_t *FGL_RESTRICT src,
                                const uint32_t *FGL_RESTRICT dst, uint32_t *FGL_RESTRICT result)
{
    _Alignas(64) uint32_t src_alpha[FRAGMENT_GROUP], dst_alpha[FRAGMENT_GROUP], apart[FRAGMENT_GROUP];
    const uint32_t color = pack_unorm8((real)s->blend_color[0], (real)s->blend_color[1], (real)s->blend_color[2],
                                       (real)s->blend_color[3]);
    const uint32_t each = 0x01010101, alpha = 0xff000000, constant[4] = {color, color, color, (color >> 24) * each};
    const uint32_t *const a[4] = {src, src, src, src_alpha}, *const b[4] = {dst, dst, dst, dst_alpha};
    FOR_GROUP(i) src_alpha[i] = (src[i] >> 24) * each;
    FOR_GROUP(i) dst_alpha[i] = (dst[i] >> 24) * each;
    byte_blend_channel(s, lerp, 0, a, b, constant, ~0u, result);
    if (!blends_alpha_apart(s))
        return;
    byte_blend_channel(s, lerp, 3, a, b, constant, ~0u, apart);
    FOR_GROUP(i) result[i] = (result[i] & ~alpha) | (apart[i] & alpha);
}

/* OSMesa rule: blending is done with 8 bits, but what was stored has kept no more than the image has. */
static FGL_NOINLINE void round_stored(const struct framebuffer *fb, uint32_t *FGL_RESTRICT dst)
{
    FOR_GROUP(i)
        dst[i] = fb->rounded[0][dst[i] & 255] | (uint32_t)fb->rounded[1][dst[i] >> 8 & 255] << 8 |
                 (uint32_t)fb->rounded[2][dst[i] >> 16 & 255] << 16 | (uint32_t)fb->rounded[3][dst[i] >> 24] << 24;
}

/* UNORM8, 565. */
static inline void write_packed(const struct fragments *f, const struct fragment_plan *plan)
{
    const struct color_buffer_state *s = &plan->color_buffer;
    const uint32_t *given = plan->pixels ? plan->pixels->unorm8 : NULL;
    _Alignas(64) uint32_t src[FRAGMENT_GROUP], dst[FRAGMENT_GROUP], blended[FRAGMENT_GROUP];
    load_packed(plan->fb, f->row, f->x, dst);
    if (FGL_UNLIKELY(plan->fb->rounds))
        round_stored(plan->fb, dst);
    if (given)
        FOR_GROUP(i) src[i] = given[f->x + i];
    else
        FOR_GROUP(i) src[i] = pack_unorm8(f->color[0][i], f->color[1][i], f->color[2][i], f->color[3][i]);
    if (plan->blend)
        blend_packed(s, plan->blend_lerp, src, dst, blended);
    else if (plan->logic_op)
        logic_op(s->logic_op_mode, src, dst, ~0u);
    const uint32_t *out = plan->blend ? blended : src;
    FOR_GROUP(i) {
        const uint32_t write = (uint32_t)f->live[i] & plan->write_bits;
        dst[i] = (out[i] & write) | (dst[i] & ~write);
    }
    store_packed(plan->fb, f->row, f->x, dst);
}

static inline void write_words(const struct fragments *f, const struct fragment_plan *plan)
{
    const uint32_t max = 65535;
    const struct color_buffer_state *s = &plan->color_buffer;
    uint32_t src[4][FRAGMENT_GROUP], dst[4][FRAGMENT_GROUP], out[4][FRAGMENT_GROUP], constant[4];
    const uint32_t *const a[4] = {src[0], src[1], src[2], src[3]}, *const b[4] = {dst[0], dst[1], dst[2], dst[3]};
    load_words(plan->fb, f->row, f->x, dst);
    for (int c = 0; c < 4; c++)
        FOR_GROUP(i) src[c][i] = to_norm(f->color[c][i], max);
    for (int c = 0; c < 4; c++)
        constant[c] = to_norm((real)s->blend_color[c], max);
    for (int c = 0; c < 4; c++) {
        const int32_t write = -(int32_t)plan->channel_write[c];
        if (plan->blend)
            word_blend_channel(s, plan->blend_lerp, c, a, b, constant, max, out[c]);
        else
            memcpy(out[c], src[c], sizeof out[c]);
        if (plan->logic_op)
            logic_op(s->logic_op_mode, out[c], dst[c], max);
        FOR_GROUP(i) out[c][i] = f->live[i] & write ? out[c][i] : dst[c][i];
    }
    store_words(plan->fb, f->row, f->x, out);
}

static inline void write_float(const struct fragments *f, const struct fragment_plan *plan)
{
    const float *blend_color = plan->color_buffer.blend_color;
    const real constant[4] = {(real)blend_color[0], (real)blend_color[1], (real)blend_color[2], (real)blend_color[3]};
    real dst[4][FRAGMENT_GROUP], out[4][FRAGMENT_GROUP];
    const real *const a[4] = {f->color[0], f->color[1], f->color[2], f->color[3]}, *const b[4] = {dst[0], dst[1], dst[2], dst[3]};
    load_float(plan->fb, f->row, f->x, dst);
    for (int c = 0; c < 4; c++) {
        const int32_t write = -(int32_t)plan->channel_write[c];
        if (plan->blend)
            real_blend_channel(&plan->color_buffer, false, c, a, b, constant, 1, out[c]);
        else
            memcpy(out[c], f->color[c], sizeof out[c]);
        FOR_GROUP(i) out[c][i] = f->live[i] & write ? out[c][i] : dst[c][i];
    }
    store_float(plan->fb, f->row, f->x, out);
}

#endif
