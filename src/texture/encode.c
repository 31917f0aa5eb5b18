/* Encodings of texels. OSMesa rules: floats of 16 bits and fewer are cut, not rounded, and what is too large becomes the largest number; those
 * without sign have no denormalized numbers. */
#include "texture/encode.h"

#include "base/arith_fma.h"
#include "base/unorm.h"

#include <math.h>

/* ---- small floats: an exponent of 5 bits with bias 15 ---- */

enum { SMALLEST_EXPONENT = -14, LARGEST_EXPONENT = 15, FLOAT_MANTISSA = 23 };

/* |v| cut to so many bits of mantissa; NaN stays. */
static float cut(float v, int mantissa, bool denormals)
{
    const float magnitude = fabsf(v), largest = ldexpf(2.0f - ldexpf(1.0f, -mantissa), LARGEST_EXPONENT);
    const float smallest = ldexpf(1.0f, SMALLEST_EXPONENT);
    if (magnitude > largest)
        return isinf(v) ? magnitude : largest;
    if (magnitude < smallest) {
        const float step = ldexpf(smallest, -mantissa);
        return denormals ? floorf(magnitude / step) * step : 0.0f;
    }
    return fgl_bits_float(fgl_float_bits(magnitude) & ~0u << (FLOAT_MANTISSA - mantissa));
}

static float half(float v)
{
    return copysignf(cut(v, 10, true), v);
}

static float unsigned_float(float v, int bits)
{
    return v < 0.0f ? 0.0f : cut(v, bits - 5, false);
}

/* GL_EXT_texture_shared_exponent, 3.8.x "Encoding of Special Internal Formats": N = 9 bits of mantissa, bias B = 15. */
static float shared(float v, const float rgb[3])
{
    enum { N = 9, B = 15 };
    const float largest = (float)((1 << N) - 1) / (float)(1 << N) * (float)(1 << 16);
    float most = 0.0f;
    for (int c = 0; c < 3; c++)
        most = fmaxf(most, fminf(fmaxf(rgb[c], 0.0f), largest)); /* NaN becomes 0 */
    int exponent = most > 0.0f ? fgl_max(-B - 1, ilogbf(most)) + 1 + B : 0;
    if (floorf(ldexpf(most, B + N - exponent) + 0.5f) == (float)(1 << N))
        exponent++;
    const float clamped = fminf(fmaxf(v, 0.0f), largest);
    return ldexpf(floorf(ldexpf(clamped, B + N - exponent) + 0.5f), exponent - B - N);
}

/* ---- integers ---- */

static float snorm(float v, int bits)
{
    const float max = (float)fgl_unorm_max(bits - 1);
    return v == v ? rintf(fminf(fmaxf(v, -1.0f), 1.0f) * max) * (1.0f / max) + 0.0f : 0.0f; /* no -0 */
}

static float byte_of(float v)
{
    return rintf(fgl_clamp01(v) * 255.0f);
}

/* OSMesa rule: the sRGB curve (GL_EXT_texture_sRGB) is a cubic, within 0.0011 of it; x: 0..255. */
static float linear_from_srgb(float x)
{
    const float v = x / 255.0f;
    return x <= 15.0f ? v / 12.6f : ((0.3012f * v + 0.6935f) * v + 0.0030f) * v + 0.0023f;
}

int fgl_srgb_byte(float linear)
{
    int low = 0, high = 255; /* the answer is from low to high */
    while (low < high) {
        const int middle = (low + high) / 2;
        if (linear_from_srgb((float)middle) < linear)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

float fgl_srgb_from_linear(float v)
{
    return v <= 0.0031308f ? v * 12.92f : (float)(1.055 * pow((double)v, 1 / 2.4) - 0.055);
}

static float encoded(const struct texture_format *format, int c, const float rgba[4])
{
    const float v = rgba[c];
    const int bits = format->bits[c];
    switch (format->encoding) {
    case ENCODED_SNORM: return snorm(v, bits);
    case ENCODED_SRGB: return c == 3 ? byte_of(v) / 255.0f : linear_from_srgb(byte_of(v));
    case ENCODED_FLOAT: return bits == 16 ? half(v) : v;
    case ENCODED_PACKED_FLOAT: return unsigned_float(v, bits);
    case ENCODED_SHARED_EXPONENT: return shared(v, rgba);
    default: return v;
    }
}

void fgl_texture_encode(const struct texture_format *format, int c, int n, const float *const color[4], float *out)
{
    for (int i = 0; i < n; i++) {
        const float rgba[4] = {color[0][i], color[1][i], color[2][i], color[3][i]};
        out[i] = encoded(format, c, rgba);
    }
}
