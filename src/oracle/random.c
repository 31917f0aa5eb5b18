#include "oracle/random.h"

#include <math.h>

/* SplitMix64 (Steele, Lea, Flood 2014). */
static uint64_t next(struct random *random)
{
    uint64_t z = random->state += UINT64_C(0x9e3779b97f4a7c15);
    z = (z ^ (z >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
    z = (z ^ (z >> 27)) * UINT64_C(0x94d049bb133111eb);
    return z ^ (z >> 31);
}

struct random random_stream(uint64_t seed, uint64_t number)
{
    struct random random = {seed};
    random.state = next(&random) ^ (number * UINT64_C(0xd1342543de82ef95));
    return random;
}

uint32_t random_bits(struct random *random)
{
    return (uint32_t)(next(random) >> 32);
}

int random_below(struct random *random, int count)
{
    return (int)(random_bits(random) % (uint32_t)count);
}

static double unit_interval(struct random *random)
{
    return (double)(next(random) >> 11) * 0x1p-53;
}

float random_between(struct random *random, float low, float high)
{
    return (float)((double)low + ((double)high - (double)low) * unit_interval(random));
}

float random_magnitude(struct random *random, float low, float high)
{
    const double from = log((double)low), to = log((double)high);
    return (float)exp(from + (to - from) * unit_interval(random));
}

void random_unit(struct random *random, float v[3])
{
    double p[3], square;
    do {
        square = 0;
        for (int i = 0; i < 3; i++) {
            p[i] = 2 * unit_interval(random) - 1;
            square += p[i] * p[i];
        }
    } while (square > 1 || square < 0.01);
    for (int i = 0; i < 3; i++)
        v[i] = (float)(p[i] / sqrt(square));
}
