/* The arithmetic of the kernels, as a parameter. Layer 0.
 *
 * A kernel is written once, in terms of a scalar type `real`, of vectors of it, and of the functions below;
 * the translation unit that instantiates it chooses what they mean, with FGL_ARITH:
 *   compatible   float, OSMesa's operations in OSMesa's order, bit for bit; the default
 *   exact        double, the specification's result
 *
 * An arithmetic defines `real`, R_EXACT (1: the rules of OSMesa's that depart from the specification are not
 * followed) and:
 *   r_sqrt(x)         square root
 *   r_rsqrt(x)        1 / sqrt(x)
 *   r_dot3(a, b)      three-term dot product
 *   r_row3(n, m)      n . m for a normal and a row of three numbers
 *   r_row4(p, m)      p . m for a position and a row of a matrix, m[0], m[4], m[8], m[12]
 *   r_row4_w_first(p, m)  the same, summed in the order that OSMesa uses where one component only is wanted
 *   r_exp2(x)         2 to the power x; never infinite
 *   r_log2(x)         for positive, normal x
 *   r_pow(x, y)       x to the power y for x > 0; 1 for y = 0, whatever x; else 0 for x <= 0; never infinite
 *   r_fma(a, b, c)    a * b + c, as the window coordinates have it
 *   r_attenuation(x)  1 / x
 *   r_term(x)         a term of a sum of colours
 *   r_abs(x), r_floor(x), r_ceil(x), r_select(c, x, y): c ? x : y
 *   r_saturate(x)     x clamped to [0,1]; 0 for NaN
 *   r_round_small(x)  the nearest integer, half to even, for 0 <= x < 2^22
 *   r_round_depth(x)  the same for 0 <= x < 2^31
 * All may be given any value, do not trap, and contain no branch. */
#ifndef FGL_BASE_ARITH_H
#define FGL_BASE_ARITH_H

#include "base/arith_fma.h"
#include "base/fgl.h"

#include <float.h>
#include <math.h>

#if defined(FGL_ARITH_EXACT)
#include "base/arith_exact.h"
#else
#include "base/arith_compatible.h"
#endif

static FGL_ALWAYS_INLINE struct real3 r_vec3(real x, real y, real z)
{
    return (struct real3){x, y, z};
}
static FGL_ALWAYS_INLINE struct real3 r_add3(struct real3 a, struct real3 b)
{
    return r_vec3(a.x + b.x, a.y + b.y, a.z + b.z);
}
static FGL_ALWAYS_INLINE struct real3 r_sub3(struct real3 a, struct real3 b)
{
    return r_vec3(a.x - b.x, a.y - b.y, a.z - b.z);
}
static FGL_ALWAYS_INLINE struct real3 r_scale3(struct real3 a, real s)
{
    return r_vec3(a.x * s, a.y * s, a.z * s);
}
static FGL_ALWAYS_INLINE struct real3 r_normalize3(struct real3 a)
{
    return r_scale3(a, r_rsqrt(r_dot3(a, a)));
}
static FGL_ALWAYS_INLINE real r_max(real a, real b)
{
    return a > b ? a : b;
}
static FGL_ALWAYS_INLINE real r_min(real a, real b)
{
    return a < b ? a : b;
}
static FGL_ALWAYS_INLINE real r_clamp01(real a)
{
    return a > 0 ? (a < 1 ? a : 1) : 0;
} /* NaN -> 0 */

#endif
