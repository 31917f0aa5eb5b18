/* fgl_fma(a, b, c): a * b + c with one rounding, the same bits on every machine. Layer 0.
 *
 * Where the instruction set has it, it is one instruction. Elsewhere it is emulated with doubles, exactly and
 * without a branch, so that a loop over it still vectorises: the product of two floats is exact in double (48
 * bits of 53); the sum with c is rounded to odd, which loses nothing that the last rounding, to float, could
 * need (53 >= 24 + 2). */
#ifndef FGL_BASE_ARITH_FMA_H
#define FGL_BASE_ARITH_FMA_H

#include "base/fgl.h"

#include <string.h>

static FGL_ALWAYS_INLINE uint32_t fgl_float_bits(float x)
{
    uint32_t u;
    memcpy(&u, &x, sizeof u);
    return u;
}

static FGL_ALWAYS_INLINE float fgl_bits_float(uint32_t u)
{
    float x;
    memcpy(&x, &u, sizeof x);
    return x;
}

static FGL_ALWAYS_INLINE uint64_t fgl_double_bits(double x)
{
    uint64_t u;
    memcpy(&u, &x, sizeof u);
    return u;
}

static FGL_ALWAYS_INLINE double fgl_bits_double(uint64_t u)
{
    double x;
    memcpy(&x, &u, sizeof x);
    return x;
}

static FGL_ALWAYS_INLINE float fgl_fma_emulated(float a, float b, float c)
{
    double p = (double)a * (double)b, q = (double)c;
    double s = p + q;
    double t = s - p;
    double error = (p - (s - t)) +
                   (q - t); /* s + error is the exact sum (Knuth's TwoSum); NaN when s is not finite */

    /* s to odd. In integers, because SSE2 has no comparison that would vectorise. */
    uint64_t magnitude = fgl_double_bits(error) << 1;
    uint64_t finite = (((magnitude >> 53) + 1) >> 11) ^ 1;
    uint64_t inexact = ((magnitude | (0 - magnitude)) >> 63) & finite;
    uint64_t too_large = ((fgl_double_bits(error) ^ fgl_double_bits(s)) >> 63) & inexact;
    return (float)fgl_bits_double((fgl_double_bits(s) - too_large) | inexact);
}

#if defined(__FMA__) || defined(__ARM_FEATURE_FMA)
#define FGL_FMA_EMULATED 0
#else
#define FGL_FMA_EMULATED 1
#endif

static FGL_ALWAYS_INLINE float fgl_fma(float a, float b, float c)
{
#if FGL_FMA_EMULATED
    return fgl_fma_emulated(a, b, c);
#else
    return __builtin_fmaf(a, b, c);
#endif
}

/* The same where a * b + c is exact in double, so that it is rounded once anyhow. */
static FGL_ALWAYS_INLINE float fgl_fma_plain(float a, float b, float c)
{
    return (float)((double)a * (double)b + (double)c);
}

#endif
