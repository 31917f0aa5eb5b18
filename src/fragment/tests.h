/* The general path's tests (GL 1.5, 4.1.4 "Alpha Test", 4.1.5 "Stencil Test", 4.1.6 "Depth Buffer Test"). */
#ifndef FGL_FRAGMENT_TESTS_H
#define FGL_FRAGMENT_TESTS_H

#include "fragment/interpolate.h"

/* The eight comparisons, GL_NEVER to GL_ALWAYS: the lowest three bits of the enum say whether less, equal and
 * greater pass. */
static FGL_ALWAYS_INLINE int32_t compare(GLenum func, int32_t a, int32_t b)
{
    return -(((int32_t)func & (a < b)) | ((int32_t)(func >> 1) & (a == b)) |
             ((int32_t)(func >> 2) & (a > b)));
}

static FGL_ALWAYS_INLINE int32_t compare_real(GLenum func, real a, real b)
{
    return -(((int32_t)func & (a < b)) | ((int32_t)(func >> 1) & (a == b)) |
             ((int32_t)(func >> 2) & (a > b)));
}

/* OSMesa rule: 8-bit colour is rounded to 8 bits before it is compared, alpha and reference, if it can be drawn. */
static inline void alpha_test(struct fragments *f, const struct fragment_plan *plan)
{
    const GLenum func = plan->color_buffer.alpha_test_func;
    const real ref = (real)plan->color_buffer.alpha_test_ref;
    if (plan->fb->color_kind == COLOR_UNORM8 && plan->color_buffer.draw_buffer != GL_NONE) {
        const int32_t ref8 = r_round_small(r_saturate(ref) * 255);
        FOR_GROUP(i) f->live[i] &= compare(func, r_round_small(r_saturate(f->color[3][i]) * 255), ref8);
    } else {
        FOR_GROUP(i) f->live[i] &= compare_real(func, f->color[3][i], ref);
    }
}

/* What a stencil operation makes of 8-bit values. */
static inline void stencil_operation(GLenum op, int32_t ref, const int32_t *FGL_RESTRICT old,
                                     int32_t *FGL_RESTRICT result)
{
    /* clang-format off */
    switch (op) {
    case GL_ZERO:      FOR_GROUP(i) result[i] = 0; break;
    case GL_REPLACE:   FOR_GROUP(i) result[i] = ref; break;
    case GL_INCR:      FOR_GROUP(i) result[i] = old[i] < 255 ? old[i] + 1 : 255; break;
    case GL_DECR:      FOR_GROUP(i) result[i] = old[i] > 0 ? old[i] - 1 : 0; break;
    case GL_INCR_WRAP: FOR_GROUP(i) result[i] = (old[i] + 1) & 255; break;
    case GL_DECR_WRAP: FOR_GROUP(i) result[i] = (old[i] - 1) & 255; break;
    case GL_INVERT:    FOR_GROUP(i) result[i] = ~old[i] & 255; break;
    default:           FOR_GROUP(i) result[i] = old[i]; break; /* GL_KEEP */
    }
    /* clang-format on */
}

/* The depth of each fragment, and which pass. */
static inline void depth_compare(struct fragments *f, const struct fragment_plan *plan,
                                 const struct planes *p, const int32_t *old, int32_t *pass)
{
    const real depth_max = (real)plan->fb->depth_max;
    const float *given = plan->pixels ? plan->pixels->depth : NULL;
    if (given)
        FOR_GROUP(i) f->depth[i] = depth_from_z((real)given[f->x + i], depth_max);
    else
        FOR_GROUP(i)
            f->depth[i] = depth_from_z(plane_at(p, LANE_Z, f->fx[i], f->fy) + PLANES(p)->z_offset, depth_max);
    FOR_GROUP(i) pass[i] = compare(plan->depth_func, f->depth[i], old[i]);
}

/* Stencil and depth together, since the stencil's new value depends on both. */
static inline void stencil_depth_test(struct fragments *f, const struct fragment_plan *plan,
                                      const struct planes *p)
{
    const struct framebuffer *fb = plan->fb;
    const ptrdiff_t at = f->row * (ptrdiff_t)fb->stride + f->x;
    int32_t *depth = plan->depth_test ? (int32_t *)fb->depth + at : NULL;
    int32_t pass[FRAGMENT_GROUP];
    FOR_GROUP(i) pass[i] = -1;
    if (depth)
        depth_compare(f, plan, p, depth, pass);

    if (plan->stencil_test) {
        const struct stencil_state *s = &plan->stencil;
        uint8_t *stencil = fb->stencil + at;
        const int32_t value_mask = s->stencil_value_mask & 255, write_mask = s->stencil_writemask & 255,
                      ref = fgl_clamp(s->stencil_ref, 0, 255);
        int32_t old[FRAGMENT_GROUP], ok[FRAGMENT_GROUP], fail[FRAGMENT_GROUP], zfail[FRAGMENT_GROUP],
                zpass[FRAGMENT_GROUP];
        FOR_GROUP(i) old[i] = stencil[i];
        FOR_GROUP(i) ok[i] = compare(s->stencil_func, ref & value_mask, old[i] & value_mask);
        stencil_operation(s->stencil_fail, ref, old, fail);
        stencil_operation(s->stencil_pass_depth_fail, ref, old, zfail);
        stencil_operation(s->stencil_pass_depth_pass, ref, old, zpass);
        FOR_GROUP(i) {
            const int32_t result = ok[i] ? (pass[i] ? zpass[i] : zfail[i]) : fail[i];
            stencil[i] = (uint8_t)(old[i] ^ ((old[i] ^ result) & write_mask & f->live[i]));
        }
        FOR_GROUP(i) f->live[i] &= ok[i];
    }
    FOR_GROUP(i) f->live[i] &= pass[i];
    if (depth && plan->depth_write)
        FOR_GROUP(i) depth[i] = f->live[i] ? f->depth[i] : depth[i];
}

/* Fragments that passed all tests (GL 1.5, 4.1.7 "Occlusion Queries"). */
static inline void count_samples(const struct fragments *f, const struct fragment_plan *plan)
{
    int32_t n = 0;
    FOR_GROUP(i) n -= f->live[i];
    if (n)
        atomic_fetch_add_explicit(plan->samples_passed, (unsigned long long)n, memory_order_relaxed);
}

#endif
