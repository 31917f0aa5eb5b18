/* The `compatible` arithmetic (see arith.h): OSMesa's float operations in OSMesa's order. Included by arith.h
 * only. a * b + c is two roundings, except where fgl_fma is written. */
#ifndef FGL_BASE_ARITH_COMPATIBLE_H
#define FGL_BASE_ARITH_COMPATIBLE_H

#define R_EXACT 0

typedef float real;

struct real3 {
    real x, y, z;
};
struct real4 {
    real x, y, z, w;
};

static FGL_ALWAYS_INLINE real r_abs(real a)
{
    return fabsf(a);
}
static FGL_ALWAYS_INLINE real r_fma(real a, real b, real c)
{
    return fgl_fma(a, b, c);
}
static FGL_ALWAYS_INLINE real r_attenuation(real x)
{
    return 1 / x;
}
static FGL_ALWAYS_INLINE real r_term(real x)
{
    return x;
}
static FGL_ALWAYS_INLINE real r_sqrt(real x)
{
    return sqrtf(x);
}
static FGL_ALWAYS_INLINE real r_rsqrt(real x)
{
    return 1.0f / sqrtf(x);
}

/* OSMesa rule: three-term dot products start with z. */
static FGL_ALWAYS_INLINE real r_dot3(struct real3 a, struct real3 b)
{
    return (a.z * b.z + a.y * b.y) + a.x * b.x;
}
static FGL_ALWAYS_INLINE real r_row3(struct real3 n, const float m[3])
{
    return (n.z * m[2] + n.y * m[1]) + n.x * m[0];
}

static FGL_ALWAYS_INLINE real r_row4(struct real4 p, const float m[13])
{
    return ((p.x * m[0] + p.y * m[4]) + p.z * m[8]) + p.w * m[12];
}

static FGL_ALWAYS_INLINE real r_row4_w_first(struct real4 p, const float m[13])
{
    return ((p.w * m[12] + p.z * m[8]) + p.y * m[4]) + p.x * m[0];
}

/* condition ? x : y, on bits, because compilers turn the operator with a constant into branches around all
 * that follows. */
static FGL_ALWAYS_INLINE real r_select(bool condition, real x, real y)
{
    uint32_t mask = 0u - (uint32_t)condition;
    return fgl_bits_float((fgl_float_bits(x) & mask) | (fgl_float_bits(y) & ~mask));
}

static FGL_ALWAYS_INLINE real r_floor(real x)
{
    return floorf(x);
}
static FGL_ALWAYS_INLINE real r_ceil(real x)
{
    return ceilf(x);
}

/* Positive floats are ordered as their bits are, and vector units have the minimum of integers. */
static FGL_ALWAYS_INLINE real r_saturate(real x)
{
    const uint32_t bits = fgl_float_bits(x > 0.0f ? x : 0.0f), one = 0x3f800000;
    return fgl_bits_float(bits < one ? bits : one);
}

/* In the sum with 2^23 the last place is 1, so that the low bits are the integer. */
static FGL_ALWAYS_INLINE int32_t r_round_small(real x)
{
    return (int32_t)(fgl_float_bits(x + 8388608.0f) & 0x3fffff);
}

/* From 2^23 on every float is an integer already. */
static FGL_ALWAYS_INLINE int32_t r_round_depth(real x)
{
    const float magic = x < 8388608.0f ? 8388608.0f : 0.0f;
    return (int32_t)((x + magic) - magic);
}

/* 2^x, within 2.6e-7 of it relatively: a polynomial of degree 5 on the fraction, even and odd powers apart.
 * 0 from -127 down, and for NaN; from 128 up (where OSMesa has infinity) the largest value, so that a product
 * with zero stays zero. */
static FGL_ALWAYS_INLINE real r_exp2(real x)
{
    x = r_select(x > -126.99999f, x, -126.99999f);
    x = r_select(x < 127.99999f, x, 127.99999f);
    int toward_zero = (int)x;
    int whole = toward_zero - ((float)toward_zero > x ? 1 : 0);
    float f = x - (float)whole, f2 = f * f;
    float even = fgl_fma(f2, fgl_fma(f2, 8.98934009049466391101e-3f, 0.240153617044375388211f), 1.0f);
    float odd = fgl_fma(f2, fgl_fma(f2, 1.87757667519147912699e-3f, 0.0558263180532956664775f),
                        0.693153073200168932794f);
    float power = fgl_bits_float((uint32_t)(whole + 127) << 23);
    return power * fgl_fma(odd, f, even);
}

/* log2(x) of a positive, normal x, within 9.5e-7 of it absolutely: the exponent plus y P(y^2), y = (m - 1) /
 * (m + 1), m the mantissa in [1,2). */
static FGL_ALWAYS_INLINE real r_log2(real x)
{
    uint32_t bits = fgl_float_bits(x);
    float exponent = (float)((int)(bits >> 23) - 127);
    float m = fgl_bits_float((bits & 0x007fffff) | 0x3f800000);
    float y = (m - 1.0f) / (m + 1.0f), z = y * y, z2 = z * z;
    float even = fgl_fma(z2, fgl_fma(z2, 0.406718052498846252698f, 0.577440339438736392009f),
                         2.88539009343309178325f);
    float odd = fgl_fma(z2, 0.403343858251329912514f, 0.961791550404184197881f);
    return fgl_fma(y, fgl_fma(odd, z, even), exponent);
}

/* 1 for y = 0, whatever x. Within 1.5e-5 absolutely for x in [0,1], y in [0,128] (measured on 10^8 random pairs). */
static FGL_ALWAYS_INLINE real r_pow(real x, real y)
{
    return r_select(x >= FLT_MIN, r_exp2(r_log2(x) * y), r_select(y == 0, 1, 0));
}

#endif
