/* Pairs of doubles: hi + lo, lo what the rounding of hi left, so that sums and products have 106 bits. Not for kernels:
 * fma may be a call of the C library. Layer 0. */
#ifndef FGL_BASE_PAIR_H
#define FGL_BASE_PAIR_H

#include <math.h>

struct pair {
    double hi, lo;
};

static inline struct pair pair_of(double a)
{
    return (struct pair){a, 0};
}

static inline struct pair pair_product(double a, double b)
{
    const double p = a * b;
    return (struct pair){p, fma(a, b, -p)};
}

static inline struct pair pair_sum(struct pair a, struct pair b)
{
    const double s = a.hi + b.hi, t = s - a.hi;
    const double error = (a.hi - (s - t)) + (b.hi - t) + (a.lo + b.lo);
    const double hi = s + error;
    return (struct pair){hi, error - (hi - s)};
}

static inline struct pair pair_multiply(struct pair a, struct pair b)
{
    struct pair p = pair_product(a.hi, b.hi);
    p.lo += a.hi * b.lo + a.lo * b.hi;
    return pair_sum(p, pair_of(0));
}

#endif
