/* What the kernels share: the group of neighbouring pixels that one loop works on, planes, and conversions to
 * integers. Included by kernels.c only, which is compiled once for each instruction set.
 *
 * A group is FRAGMENT_GROUP pixels of one row (FUSED_GROUP in the fused kernels), starting at a multiple of that, so that loops have a
 * constant length and the compiler makes vector code of them. Pixels of a group that are not covered are read
 * and written back unchanged; rows of the framebuffer are padded for that. */
#ifndef FGL_FRAGMENT_GROUP_H
#define FGL_FRAGMENT_GROUP_H

#include <string.h>

#include "fragment/planes.h"

/* What a group costs as a whole counts for more in the general path, and small primitives for more in the fused kernels. */
#ifdef __AVX512F__
enum { FRAGMENT_GROUP = 16, FUSED_GROUP = 16 };
#elif defined(__AVX2__)
enum { FRAGMENT_GROUP = 16, FUSED_GROUP = 8 };
#else
enum { FRAGMENT_GROUP = 8, FUSED_GROUP = 8 };
#endif

/* Fog's coefficients in the arithmetic's type. */
#if R_EXACT
#define FOG_NUMBERS(plan) (&(plan)->exact_fog)
#else
#define FOG_NUMBERS(plan) (&(plan)->fog)
#endif

/* One plane by value: in loops that write memory, a compiler that does not know it apart from the planes would load it again. */
struct plane {
    real a00, dadx, dady;
};

static FGL_ALWAYS_INLINE struct plane plane_of(const struct planes *p, int lane)
{
    return (struct plane){PLANES(p)->a00[lane], PLANES(p)->dadx[lane], PLANES(p)->dady[lane]};
}

static FGL_ALWAYS_INLINE real value_at(struct plane plane, real x, real y)
{
    return r_fma(plane.dady, y, r_fma(plane.dadx, x, plane.a00));
}

/* Where fused multiply-add has to be emulated: whether it need not be for this plane, since sums are exact in double. The largest
 * exponent of the three numbers and the least, below which lie 23 bits of mantissa, say how many bits a sum may have; x and y have at
 * most 15, the sums two more: 23 + 1 + 15 + 2 of 53 leave 12. What was rounded to float before has no bits below. */
static FGL_ALWAYS_INLINE bool is_plain(struct plane plane)
{
#if FGL_FMA_EMULATED && !R_EXACT
    const real number[3] = {plane.a00, plane.dadx, plane.dady};
    int low = 255, high = 0;
    for (int k = 0; k < 3; k++) {
        const int exponent = (int)(fgl_float_bits(number[k]) >> 23 & 255), shift = k == 0 ? 0 : 15;
        low = number[k] != 0 && exponent < low ? exponent : low;
        high = number[k] != 0 && exponent + shift > high ? exponent + shift : high;
    }
    return high - low <= 27;
#else
    (void)plane;
    return false;
#endif
}

/* The same value, in the way that is_plain says. */
static FGL_ALWAYS_INLINE real value_if(const bool plain, struct plane plane, real x, real y)
{
#if FGL_FMA_EMULATED && !R_EXACT
    if (plain)
        return fgl_fma_plain(plane.dady, y, fgl_fma_plain(plane.dadx, x, plane.a00));
#endif
    (void)plain;
    return value_at(plane, x, y);
}

/* A function of its own: of loops inside of others GCC 12 makes wrong code on the way from float to double and back. */
static FGL_NOINLINE void plain_values(struct plane plane, const int n, const real *FGL_RESTRICT x, real y, real *FGL_RESTRICT to)
{
    for (int i = 0; i < n; i++)
        to[i] = value_if(true, plane, x[i], y);
}

/* At n pixels of a row. */
static FGL_ALWAYS_INLINE void plane_values(const struct planes *p, int lane, const int n, const real *FGL_RESTRICT x, real y,
                                           real *FGL_RESTRICT to)
{
    const struct plane plane = plane_of(p, lane);
    if (is_plain(plane))
        plain_values(plane, n, x, y, to);
    else
        FGL_VECTOR_LOOP for (int i = 0; i < n; i++) to[i] = value_at(plane, x[i], y);
}

/* Window z to the depth buffer's integer: round half to even of z * (2^bits - 1), OSMesa's in float arithmetic. */
static FGL_ALWAYS_INLINE int32_t depth_from_z(real z, real depth_max)
{
    return r_round_depth(r_saturate(z) * depth_max);
}

static FGL_ALWAYS_INLINE uint32_t pack_unorm8(real r, real g, real b, real a)
{
    return (uint32_t)r_round_small(r_saturate(r) * 255) | (uint32_t)r_round_small(r_saturate(g) * 255) << 8 |
           (uint32_t)r_round_small(r_saturate(b) * 255) << 16 | (uint32_t)r_round_small(r_saturate(a) * 255) << 24;
}

/* OSMesa rule: a product with 1/255, where the specification divides. */
static FGL_ALWAYS_INLINE real from_unorm8(uint32_t v)
{
    const real whole = (real)(int32_t)v;
    return R_EXACT ? whole / 255 : whole * (real)(1.0f / 255.0f);
}

#endif
