/* The general path's end: from colours to the buffer (GL 1.5, 4.1.8 "Blending", 4.1.10 "Logical
 * Operation", 4.2.2 "Fine Control of Buffer Updates"). */
#ifndef FGL_FRAGMENT_BLEND_H
#define FGL_FRAGMENT_BLEND_H

#include "fragment/pixel.h"

/* OSMesa rule: normalised colour is rounded to the buffer's precision first; blending is then integer
 * arithmetic, with one rounding for each product and saturating sums. max is 2^n - 1; (t + (t >> n) +
 * 2^(n-1)) >> n divides t by it. */
static FGL_ALWAYS_INLINE uint32_t norm_mul(uint32_t a, uint32_t b, uint32_t max)
{
    const uint32_t t = a * b;
    return max == 255 ? (t + (t >> 8) + 128) >> 8 : (t + (t >> 16) + 32768) >> 16;
}

#define CHANNEL uint32_t
#define FACTOR_OUT false
#define T(name) norm_##name
#define MUL(a, b) norm_mul(a, b, max)
#define COMPLEMENT(a) (max - (a))
#define ADD(a, b) ((a) + (b) < max ? (a) + (b) : max)
#define SUB(a, b) ((a) > (b) ? (a) - (b) : 0)
#include "fragment/blend_template.h"

/* OSMesa rule: float colour blends unclamped. */
#define CHANNEL real
#define FACTOR_OUT true
#define T(name) real_##name
#define MUL(a, b) ((a) * (b))
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

/* UNORM8, UNORM16, 565. */
static inline void write_norm(const struct fragments *f, const struct fragment_plan *plan)
{
    const uint32_t max = plan->fb->color_kind == COLOR_UNORM16 ? 65535 : 255;
    const struct color_buffer_state *s = &plan->color_buffer;
    uint32_t src[4][FRAGMENT_GROUP], dst[4][FRAGMENT_GROUP], constant[4];
    load_norm(plan->fb, f->row, f->x, dst);
    for (int c = 0; c < 4; c++)
        FOR_GROUP(i) src[c][i] = to_norm(f->color[c][i], max);
    if (plan->blend) {
        for (int c = 0; c < 4; c++)
            constant[c] = to_norm((real)s->blend_color[c], max);
        norm_blend(s, src, dst, constant, max);
    } else if (plan->logic_op) {
        for (int c = 0; c < 4; c++)
            logic_op(s->logic_op_mode, src[c], dst[c], max);
    }
    for (int c = 0; c < 4; c++) {
        const int32_t write = -(int32_t)plan->channel_write[c];
        FOR_GROUP(i) src[c][i] = f->live[i] & write ? src[c][i] : dst[c][i];
    }
    store_norm(plan->fb, f->row, f->x, src);
}

static inline void write_float(struct fragments *f, const struct fragment_plan *plan)
{
    const float *blend_color = plan->color_buffer.blend_color;
    const real constant[4] = {(real)blend_color[0], (real)blend_color[1], (real)blend_color[2], (real)blend_color[3]};
    real dst[4][FRAGMENT_GROUP];
    load_float(plan->fb, f->row, f->x, dst);
    if (plan->blend)
        real_blend(&plan->color_buffer, f->color, dst, constant, 1);
    for (int c = 0; c < 4; c++) {
        const int32_t write = -(int32_t)plan->channel_write[c];
        FOR_GROUP(i) f->color[c][i] = f->live[i] & write ? f->color[c][i] : dst[c][i];
    }
    store_float(plan->fb, f->row, f->x, f->color);
}

#endif
