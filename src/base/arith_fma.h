/* fgl_fma(a, b, c): a * b + c with one rounding, the same bits on every machine. Layer 0.
 *
 * Where the instruction set has it, it is one instruction. Elsewhere it is emulated with doubles, exactly and without a
 * branch, so that a loop over it still vectorises: the product of two floats is exact in double (48 bits of 53); the sum
 * with c is rounded to odd, which loses nothing that the last rounding, to float, could need (53 >= 24 + 2). */
#ifndef FGL_BASE_ARITH_FMA_H
#define FGL_BASE_ARITH_FMA_H

#include "base/fgl.h"

#include <string.h>

static inline uint32_t fgl_float_bits(float x)
{
    uint32_t u;
    memcpy(&u, &x, sizeof u);
    return u;
}

static inline float fgl_bits_float(uint32_t u)
{
    float x;
    memcpy(&x, &u, sizeof x);
    return x;
}

static inline uint64_t fgl_double_bits(double x)
{
    uint64_t u;
    memcpy(&u, &x, sizeof u);
    return u;
}

static inline double fgl_bits_double(uint64_t u)
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
    double error = (p - (s - t)) + (q - t); /* s + error is the exact sum (Knuth's TwoSum); NaN when s is not finite */
    double product = error * s;             /* only its sign is used; it can neither overflow nor reach zero */
    uint64_t toward_zero = product < 0.0 ? 1 : 0;
    uint64_t inexact = (error < 0.0 ? 1 : 0) | (error > 0.0 ? 1 : 0);
    return (float)fgl_bits_double((fgl_double_bits(s) - toward_zero) | inexact);
}

static FGL_ALWAYS_INLINE float fgl_fma(float a, float b, float c)
{
#if defined(__FMA__) || defined(__ARM_FEATURE_FMA)
    return __builtin_fmaf(a, b, c);
#else
    return fgl_fma_emulated(a, b, c);
#endif
}

#endif
