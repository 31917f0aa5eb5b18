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

/* OSMesa rule: 8-bit colour is rounded to 8 bits before it is compared, alpha and reference, if it can be drawn; that of fewer bits is not. */
static inline void alpha_test(struct fragments *f, const struct fragment_plan *plan)
{
    const GLenum func = plan->color_buffer.alpha_test_func;
    const real ref = (real)plan->color_buffer.alpha_test_ref;
    if (plan->fb->color_kind == COLOR_UNORM8 && !plan->fb->image_bits[0] && plan->color_buffer.draw_buffer != GL_NONE) {
        const int32_t ref8 = r_round_small(r_saturate(ref) * 255);
        FOR_GROUP(i) f->live[i] &= compare(func, r_round_small(r_saturate(f->color[3][i]) * 255), ref8);
    } else {
        FOR_GROUP(i) f->live[i] &= compare_real(func, f->color[3][i], ref);
    }
}

/* ---- stencil: lanes of 8 bits, masks of all bits or none ---- */

typedef uint8_t stencil_lanes[FRAGMENT_GROUP];

static FGL_ALWAYS_INLINE void stencil_compare(GLenum func, uint8_t ref, uint8_t mask, const stencil_lanes old,
                                              stencil_lanes ok)
{
    const uint8_t less = (uint8_t)-(func & 1), equal = (uint8_t)-(func >> 1 & 1), greater = (uint8_t)-(func >> 2 & 1), a = ref & mask;
    FOR_GROUP(i) {
        const uint8_t b = old[i] & mask;
        ok[i] = (uint8_t)((a < b ? less : 0) | (a == b ? equal : 0) | (a > b ? greater : 0));
    }
}

/* What a stencil operation makes of values. */
static FGL_ALWAYS_INLINE void stencil_operation(GLenum op, uint8_t ref, const stencil_lanes old, stencil_lanes result)
{
    /* clang-format off */
    switch (op) {
    case GL_ZERO:      FOR_GROUP(i) result[i] = 0; break;
    case GL_REPLACE:   FOR_GROUP(i) result[i] = ref; break;
    case GL_INCR:      FOR_GROUP(i) result[i] = (uint8_t)(old[i] + (old[i] != 255)); break;
    case GL_DECR:      FOR_GROUP(i) result[i] = (uint8_t)(old[i] - (old[i] != 0)); break;
    case GL_INCR_WRAP: FOR_GROUP(i) result[i] = (uint8_t)(old[i] + 1); break;
    case GL_DECR_WRAP: FOR_GROUP(i) result[i] = (uint8_t)(old[i] - 1); break;
    case GL_INVERT:    FOR_GROUP(i) result[i] = (uint8_t)~old[i]; break;
    default:           FOR_GROUP(i) result[i] = old[i]; break; /* GL_KEEP */
    }
    /* clang-format on */
}

/* Leaves those that pass in f->live; whether there are any. `pass`: of the depth test; NULL without one. */
static FGL_ALWAYS_INLINE bool stencil_test(struct fragments *f, const struct fragment_plan *plan, const int32_t *pass)
{
    const struct stencil_state *s = &plan->stencil;
    uint8_t *stencil = plan->fb->stencil + f->row * (ptrdiff_t)plan->fb->stride + f->x;
    const uint8_t write = s->stencil_writemask & 255, ref = (uint8_t)fgl_clamp(s->stencil_ref, 0, 255);
    stencil_lanes old, ok, live, result, failed;
    uint8_t any = 0;
    memcpy(old, stencil, sizeof old);
    FOR_GROUP(i) live[i] = (uint8_t)f->live[i];
    stencil_compare(s->stencil_func, ref, s->stencil_value_mask & 255, old, ok);
    stencil_operation(s->stencil_pass_depth_pass, ref, old, result);
    if (pass) {
        stencil_operation(s->stencil_pass_depth_fail, ref, old, failed);
        FOR_GROUP(i) result[i] = pass[i] ? result[i] : failed[i];
    }
    stencil_operation(s->stencil_fail, ref, old, failed);
    FOR_GROUP(i) {
        const uint8_t value = (uint8_t)((result[i] & ok[i]) | (failed[i] & ~ok[i]));
        stencil[i] = (uint8_t)(old[i] ^ ((old[i] ^ value) & write & live[i]));
    }
    FOR_GROUP(i) any |= ok[i] & live[i];
    FOR_GROUP(i) f->live[i] &= (int32_t)(int8_t)ok[i];
    return any;
}

/* ---- depth ---- */

/* The depth of each fragment, and which pass. */
static inline void depth_compare(struct fragments *f, const struct fragment_plan *plan,
                                 const struct planes *p, const int32_t *old, int32_t *pass)
{
    const real depth_max = (real)plan->fb->depth_max;
    const float *given = plan->pixels ? plan->pixels->depth : NULL;
    real z[FRAGMENT_GROUP];
    if (given) {
        FOR_GROUP(i) f->depth[i] = depth_from_z((real)given[f->x + i], depth_max);
    } else {
        plane_values(p, LANE_Z, FRAGMENT_GROUP, f->fx, f->fy, z);
        FOR_GROUP(i) f->depth[i] = depth_from_z(z[i] + PLANES(p)->z_offset, depth_max);
    }
    FOR_GROUP(i) pass[i] = compare(plan->depth_func, f->depth[i], old[i]);
}

/* Stencil and depth together, since the stencil's new value depends on both. Whether any fragment passes. */
static inline bool stencil_depth_test(struct fragments *f, const struct fragment_plan *plan,
                                      const struct planes *p)
{
    if (!plan->depth_test)
        return stencil_test(f, plan, NULL);
    int32_t *depth = (int32_t *)plan->fb->depth + f->row * (ptrdiff_t)plan->fb->stride + f->x;
    int32_t pass[FRAGMENT_GROUP];
    depth_compare(f, plan, p, depth, pass);
    if (plan->stencil_test)
        stencil_test(f, plan, pass);
    FOR_GROUP(i) f->live[i] &= pass[i];
    if (plan->depth_write)
        FOR_GROUP(i) depth[i] = f->live[i] ? f->depth[i] : depth[i];
    return any_live(f);
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
