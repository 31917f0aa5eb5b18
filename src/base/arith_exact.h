/* The `exact` arithmetic (see arith.h): double, in the specification's order, with the answers of docs/lighting.md
 * where the specification has none. Included by arith.h only. Results are rounded to float once, where they leave
 * the kernels; until then relative errors stay near 1e-15. */
#ifndef FGL_BASE_ARITH_EXACT_H
#define FGL_BASE_ARITH_EXACT_H

#define R_EXACT 1

typedef double real;

struct real3 {
    real x, y, z;
};
struct real4 {
    real x, y, z, w;
};

static FGL_ALWAYS_INLINE real r_abs(real a)
{
    return fabs(a);
}

static FGL_ALWAYS_INLINE real r_fma(real a, real b, real c)
{
    return a * b + c;
}

/* On bits: see arith_compatible.h. */
static FGL_ALWAYS_INLINE real r_select(bool condition, real x, real y)
{
    const uint64_t mask = 0u - (uint64_t)condition;
    return fgl_bits_double((fgl_double_bits(x) & mask) | (fgl_double_bits(y) & ~mask));
}

static FGL_ALWAYS_INLINE real r_sqrt(real x)
{
    return sqrt(x);
}

/* 0 for 0: a vector without a direction stays 0 when it is made a unit vector. */
static FGL_ALWAYS_INLINE real r_rsqrt(real x)
{
    return r_select(x > 0, 1 / sqrt(x), 0);
}

static FGL_ALWAYS_INLINE real r_floor(real x)
{
    return floor(x);
}
static FGL_ALWAYS_INLINE real r_ceil(real x)
{
    return ceil(x);
}

static FGL_ALWAYS_INLINE real r_saturate(real x)
{
    return x > 0 ? (x < 1 ? x : 1) : 0;
}

/* In the sum with 2^52 the last place is 1, so that the low bits are the integer. */
static FGL_ALWAYS_INLINE int32_t r_round_depth(real x)
{
    return (int32_t)(uint32_t)fgl_double_bits(x + 0x1p52);
}
static FGL_ALWAYS_INLINE int32_t r_round_small(real x)
{
    return r_round_depth(x);
}

/* A term that is no number counts as 0. */
static FGL_ALWAYS_INLINE real r_term(real x)
{
    return r_select(x == x, x, 0);
}

/* 1 / x; the largest float for 0. */
static FGL_ALWAYS_INLINE real r_attenuation(real x)
{
    return r_select(x == 0, (real)FLT_MAX, 1 / x);
}

static FGL_ALWAYS_INLINE real r_dot3(struct real3 a, struct real3 b)
{
    return (a.x * b.x + a.y * b.y) + a.z * b.z;
}
static FGL_ALWAYS_INLINE real r_row3(struct real3 n, const double m[3])
{
    return (n.x * m[0] + n.y * m[1]) + n.z * m[2];
}
static FGL_ALWAYS_INLINE real r_row4(struct real4 p, const double m[13])
{
    return ((p.x * m[0] + p.y * m[4]) + p.z * m[8]) + p.w * m[12];
}
static FGL_ALWAYS_INLINE real r_row4_w_first(struct real4 p, const double m[13])
{
    return r_row4(p, m);
}

/* 2^x, relative error under 1e-15: a polynomial of degree 13 (the exponential series; even and odd powers apart, which do not wait
 * for each other) on what is left of x beside its nearest integer, at most 1/2. Not below 2^-300, which no float shows, so that products stay normal; not above
 * 2^1023. Adding 1.5 * 2^52 rounds to an integer and leaves it in the low bits, which vectorises where
 * conversions to integers do not. */
static FGL_ALWAYS_INLINE real r_exp2(real x)
{
    const real magic = 0x1.8p52;
    const real y = r_select(x < 1023, r_select(x > -300, x, -300), 1023);
    const real shifted = y + magic;
    const real t = (y - (shifted - magic)) * 0.69314718055994530942, t2 = t * t;
    real even = 1.0 / 479001600, odd = 1.0 / 6227020800, p;

    even = even * t2 + 1.0 / 3628800;
    even = even * t2 + 1.0 / 40320;
    even = even * t2 + 1.0 / 720;
    even = even * t2 + 1.0 / 24;
    even = even * t2 + 0.5;
    even = even * t2 + 1;
    odd = odd * t2 + 1.0 / 39916800;
    odd = odd * t2 + 1.0 / 362880;
    odd = odd * t2 + 1.0 / 5040;
    odd = odd * t2 + 1.0 / 120;
    odd = odd * t2 + 1.0 / 6;
    odd = odd * t2 + 1;
    p = odd * t + even;
    p = p * fgl_bits_double((fgl_double_bits(shifted) + 1023) << 52);
    return r_select(x == x, p, x);
}

/* log2(x) of a positive, normal x, error under 1e-15 of the greater of it and 1: the exponent plus the series of
 * (2 / ln 2) artanh s, s = (m - 1) / (m + 1), |s| < 0.172, m the mantissa in [sqrt(1/2), sqrt(2)]. */
static FGL_ALWAYS_INLINE real r_log2(real x)
{
    const uint64_t half_up = 0x3ff0000000000000 - 0x3fe6a09e667f3bcd; /* bits from sqrt(1/2) to 1 */
    const uint64_t bits = fgl_double_bits(x) + half_up;
    const real exponent = fgl_bits_double((bits >> 52) | 0x4330000000000000) - (0x1p52 + 1023);
    const real m = fgl_bits_double((bits & 0x000fffffffffffff) + 0x3fe6a09e667f3bcd);
    const real s = (m - 1) / (m + 1), z = s * s, z2 = z * z;
    real even = 1.0 / 21, odd = 1.0 / 19;

    even = even * z2 + 1.0 / 17;
    even = even * z2 + 1.0 / 13;
    even = even * z2 + 1.0 / 9;
    even = even * z2 + 1.0 / 5;
    even = even * z2 + 1;
    odd = odd * z2 + 1.0 / 15;
    odd = odd * z2 + 1.0 / 11;
    odd = odd * z2 + 1.0 / 7;
    odd = odd * z2 + 1.0 / 3;
    return s * (odd * z + even) * 2.8853900817779268147 + exponent;
}

/* x^y for y >= 0; x below the normal range counts as 0; 1 for y = 0, whatever x. */
static FGL_ALWAYS_INLINE real r_pow(real x, real y)
{
    const real power = r_select(x >= DBL_MIN, r_exp2(r_log2(x) * y), r_select(x == x, 0, x));
    return r_select(y == 0, 1, power);
}

#endif
