#include "quad.h"

#include <math.h>
#include <stdbool.h>

/* Each the sum of three doubles, 159 bits. */
static const double ln2_parts[3] = {0x1.62e42fefa39efp-1, 0x1.abc9e3b39803fp-56, 0x1.7b57a079a1934p-111};
static const double pi_parts[3] = {0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53, -0x1.f1976b7ed8fbcp-109};

static quad sum(const double part[3])
{
    return (quad)part[0] + ((quad)part[1] + (quad)part[2]);
}

static bool is_finite(quad x)
{
    return x - x == 0;
}

static quad power_of_two(int exponent)
{
    if (exponent > 1000 || exponent < -1000)
        return power_of_two(exponent / 2) * power_of_two(exponent - exponent / 2);
    return (quad)ldexp(1.0, exponent);
}

/* x = result * 2^exponent with result in [1, 2]; x > 0 and finite. */
static quad split(quad x, int *exponent)
{
    *exponent = 0;
    for (; x >= (quad)0x1p1000; *exponent += 1000)
        x *= (quad)0x1p-1000;
    for (; x < (quad)0x1p-1000; *exponent -= 1000)
        x *= (quad)0x1p1000;
    int in_double;
    frexp((double)x, &in_double);
    *exponent += in_double - 1;
    return x * power_of_two(1 - in_double);
}

quad quad_sqrt(quad x)
{
    if (x == 0 || !is_finite(x))
        return x;
    int exponent;
    quad m = split(x, &exponent);
    if (exponent & 1) {
        m *= 2;
        exponent -= 1;
    }
    /* 53, 106, 113 correct bits. */
    quad root = (quad)sqrt((double)m);
    root = (root + m / root) / 2;
    root = (root + m / root) / 2;
    return root * power_of_two(exponent / 2);
}

/* ln m = 2 atanh y with y = (m - 1) / (m + 1), |y| < 0.172: 24 terms of the series leave 2^-120. */
quad quad_log2(quad x)
{
    int exponent;
    quad m = split(x, &exponent);
    if (m > (quad)1.4142135) {
        m /= 2;
        exponent += 1;
    }
    const quad y = (m - 1) / (m + 1), square = y * y;
    quad series = 0;
    for (int k = 23; k >= 0; k--)
        series = series * square + (quad)1 / (2 * k + 1);
    return (quad)exponent + 2 * y * series / sum(ln2_parts);
}

/* 2^f = e^(f ln 2), |f ln 2| < 0.35: 28 terms leave 2^-130. */
quad quad_exp2(quad x)
{
    if (x > 16000 || x < -16000)
        return x > 0 ? x * power_of_two(16383) : 0;
    if (x != x)
        return x;
    const int whole = (int)(x < 0 ? x - (quad)0.5 : x + (quad)0.5);
    const quad t = (x - whole) * sum(ln2_parts);
    quad series = 1;
    for (int k = 28; k >= 1; k--)
        series = 1 + t * series / k;
    return series * power_of_two(whole);
}

quad quad_pow(quad x, quad y)
{
    if (y == 0)
        return 1;
    if (x == 0 || !is_finite(x))
        return x;
    return quad_exp2(y * quad_log2(x));
}

/* |x| <= pi / 2 needs 34 terms for 2^-120. */
quad quad_cos_degrees(quad angle)
{
    if (angle > 90)
        return -quad_cos_degrees(180 - angle);
    const quad x = angle * sum(pi_parts) / 180, square = x * x;
    quad series = 1;
    for (int k = 34; k >= 2; k -= 2)
        series = 1 - square * series / (k * (k - 1));
    return series;
}
