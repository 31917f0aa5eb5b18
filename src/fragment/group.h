/* What the kernels share: the group of neighbouring pixels that one loop works on, planes, and conversions to
 * integers. Included by kernels.c only, which is compiled once for each instruction set.
 *
 * A group is FRAGMENT_GROUP pixels of one row, starting at a multiple of FRAGMENT_GROUP, so that loops have a
 * constant length and the compiler makes vector code of them. Pixels of a group that are not covered are read
 * and written back unchanged; rows of the framebuffer are padded for that. */
#ifndef FGL_FRAGMENT_GROUP_H
#define FGL_FRAGMENT_GROUP_H

#include <string.h>

#include "base/arith.h"
#include "fragment/fragment.h"

#ifdef __AVX512F__
enum { FRAGMENT_GROUP = 16 };
#else
enum { FRAGMENT_GROUP = 8 };
#endif

static FGL_ALWAYS_INLINE float plane_at(const struct planes *p, int lane, float x, float y)
{
    return fgl_fma(p->dady[lane], y, fgl_fma(p->dadx[lane], x, p->a00[lane]));
}

/* Round half to even, for 0 <= v < 2^22: in the sum with 2^23 the last place is 1, so that the low bits are
 * the integer. */
static FGL_ALWAYS_INLINE int32_t round_small(float v)
{
    return (int32_t)(fgl_float_bits(v + 8388608.0f) & 0x3fffff);
}

/* Clamped to [0,1]; NaN gives 0. Positive floats are ordered as their bits are, and vector units have the
 * minimum of integers. */
static FGL_ALWAYS_INLINE float saturate(float v)
{
    const uint32_t bits = fgl_float_bits(v > 0.0f ? v : 0.0f), one = 0x3f800000;
    return fgl_bits_float(bits < one ? bits : one);
}

/* Window z to the depth buffer's integer: round half to even of z * (2^bits - 1) in float arithmetic, as
 * OSMesa. From 2^23 on every float is an integer already. */
static FGL_ALWAYS_INLINE int32_t depth_from_z(float z, float depth_max)
{
    const float scaled = saturate(z) * depth_max, magic = scaled < 8388608.0f ? 8388608.0f : 0.0f;
    return (int32_t)((scaled + magic) - magic);
}

static FGL_ALWAYS_INLINE uint32_t pack_unorm8(float r, float g, float b, float a)
{
    return (uint32_t)round_small(saturate(r) * 255.0f) | (uint32_t)round_small(saturate(g) * 255.0f) << 8 |
           (uint32_t)round_small(saturate(b) * 255.0f) << 16 |
           (uint32_t)round_small(saturate(a) * 255.0f) << 24;
}

#endif
