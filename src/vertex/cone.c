#include "vertex/cone.h"

/* cos y for 0 <= y <= pi: the cosine series. */
static struct pair cosine(struct pair y)
{
    const struct pair square = pair_multiply(y, y);
    struct pair term = pair_of(1), total = term;

    for (int n = 1; n < 44; n += 2) {
        const double divisor = n * (n + 1), quotient = 1 / divisor;
        /* 1 / divisor in two parts. */
        const struct pair inverse = {quotient, fma(-quotient, divisor, 1) * quotient};
        term = pair_multiply(pair_multiply(term, square), inverse);
        term = (struct pair){-term.hi, -term.lo};
        total = pair_sum(total, term);
    }
    return total;
}

struct pair fgl_cone_cos_square(float cutoff)
{
    const struct pair radians_per_degree = {0x1.1df46a2529d39p-6, 0x1.5c1d8becdd291p-62};

    if (cutoff == 0 || cutoff == 30 || cutoff == 45 || cutoff == 60 || cutoff == 90)
        return pair_of(cutoff == 0 ? 1 : cutoff == 30 ? 0.75 : cutoff == 45 ? 0.5 : cutoff == 60 ? 0.25 : 0);
    /* cos^2 x = (1 + cos 2x) / 2 */
    const struct pair twice = pair_multiply(pair_of(2 * (double)cutoff), radians_per_degree);
    const struct pair sum = pair_sum(pair_of(1), cosine(twice));
    return (struct pair){sum.hi / 2, sum.lo / 2};
}

static struct pair dot(const struct pair a[3], const struct pair b[3])
{
    struct pair sum = pair_multiply(a[0], b[0]);

    sum = pair_sum(sum, pair_multiply(a[1], b[1]));
    return pair_sum(sum, pair_multiply(a[2], b[2]));
}

bool fgl_cone_contains(const double from[3], const double to[3], const double axis[3], struct pair cos_square)
{
    struct pair v[3], a[3];

    for (int c = 0; c < 3; c++) {
        v[c] = pair_sum(pair_of(to[c]), pair_of(-from[c]));
        a[c] = pair_of(axis[c]);
    }
    const struct pair along = dot(v, a), lengths = pair_multiply(dot(v, v), dot(a, a));
    if (lengths.hi == 0)
        return cos_square.hi == 0;
    /* cos >= 0: the cosine along / lengths^(1/2) is compared by its square. */
    const struct pair square = pair_multiply(along, along), edge = pair_multiply(cos_square, lengths);
    const struct pair difference = pair_sum(square, (struct pair){-edge.hi, -edge.lo});
    return along.hi >= 0 && difference.hi >= 0;
}
