/* The row kernels (rows.h) of one instruction set and one arithmetic. The build compiles this file once for each set, with
 * FGL_ISA naming it, and for each arithmetic, with FGL_ARITH naming it. Pixels are read and written as bytes, which vectorises where shifts of the whole pixel would need
 * permutations. */
#include "base/arith.h"
#include "framebuffer/rows.h"

/* Number i of a pixel lies in byte i ^ BYTE_FLIP of it: red is its low byte. */
#if defined(__BYTE_ORDER__) && __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__
enum { BYTE_FLIP = 3 };
#else
enum { BYTE_FLIP = 0 };
#endif

static void unorm8_to_float(const uint32_t *FGL_RESTRICT pixel, int n, float *FGL_RESTRICT color)
{
    const uint8_t *FGL_RESTRICT byte = (const uint8_t *)pixel;
    for (int i = 0; i < 4 * n; i++)
        color[i] = (float)byte[i ^ BYTE_FLIP] * (1.0f / 255.0f);
}

static FGL_ALWAYS_INLINE int32_t unorm8(float v)
{
    return (int32_t)r_round_small(r_saturate((real)v) * 255);
}

static void float_to_unorm8(const float *FGL_RESTRICT color, int n, uint32_t *FGL_RESTRICT pixel)
{
    uint8_t *FGL_RESTRICT byte = (uint8_t *)pixel;
    for (int i = 0; i < 4 * n; i++)
        byte[i ^ BYTE_FLIP] = (uint8_t)unorm8(color[i]);
}

static void planes_to_unorm8(const float *const channel[4], int n, uint32_t *FGL_RESTRICT pixel)
{
    const float *FGL_RESTRICT r = channel[0], *FGL_RESTRICT g = channel[1], *FGL_RESTRICT b = channel[2],
                              *FGL_RESTRICT a = channel[3];
    for (int i = 0; i < n; i++)
        pixel[i] = (uint32_t)(unorm8(r[i]) | unorm8(g[i]) << 8 | unorm8(b[i]) << 16) | (uint32_t)unorm8(a[i]) << 24;
}

/* The product with the reciprocal has, rounded to float, the bits of the quotient for all depths of 16 and 24 bits
 * (tests/unit/framebuffer_rows.c). */
static void depth_to_float(const uint32_t *FGL_RESTRICT depth, int n, uint32_t max, float *FGL_RESTRICT out)
{
    const double step = 1.0 / max;
    for (int i = 0; i < n; i++)
        out[i] = (float)((double)(int32_t)depth[i] * step);
}

/* Cut off, modulo 2^16; 0 for what is no 32-bit integer. */
static FGL_ALWAYS_INLINE int16_t wrapped(float v)
{
    const float cut = v > -2147483648.0f && v < 2147483648.0f ? v : 0.0f;
    return (int16_t)(uint16_t)(int32_t)cut;
}

static void accumulate(int16_t *FGL_RESTRICT accum, const float *FGL_RESTRICT color, int n, float scale, bool add)
{
    const int16_t keep = add ? -1 : 0;
    for (int i = 0; i < 4 * n; i++)
        accum[i] = (int16_t)(wrapped(color[i] * scale) + (accum[i] & keep));
}

static void accum_multiply(int16_t *FGL_RESTRICT accum, int n, float value)
{
    for (int i = 0; i < 4 * n; i++)
        accum[i] = wrapped((float)accum[i] * value);
}

static void accum_to_unorm8(const int16_t *FGL_RESTRICT accum, int n, float scale, uint32_t *FGL_RESTRICT pixel)
{
    uint8_t *FGL_RESTRICT byte = (uint8_t *)pixel;
    for (int i = 0; i < 4 * n; i++)
        byte[i ^ BYTE_FLIP] = (uint8_t)unorm8((float)accum[i] * scale);
}

extern const struct row_kernels FGL_KERNELS(row);
const struct row_kernels FGL_KERNELS(row) = {
    .unorm8_to_float = unorm8_to_float,
    .float_to_unorm8 = float_to_unorm8,
    .planes_to_unorm8 = planes_to_unorm8,
    .depth_to_float = depth_to_float,
    .accumulate = accumulate,
    .accum_multiply = accum_multiply,
    .accum_to_unorm8 = accum_to_unorm8,
};
