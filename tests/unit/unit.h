/* What the unit tests of the vertex stage share: cmocka's headers, and random numbers that repeat.
 * FIXEDGL_SEED=s gives others. */
#ifndef TESTS_UNIT_UNIT_H
#define TESTS_UNIT_UNIT_H

#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static uint64_t random_state;

static inline void random_seed(int set)
{
    const char *seed = getenv("FIXEDGL_SEED");
    random_state = 0x9E3779B97F4A7C15u * (uint64_t)(set + 1) + (seed ? strtoull(seed, NULL, 10) << 40 : 0);
}

static inline uint32_t random_bits(void)
{
    random_state ^= random_state >> 12;
    random_state ^= random_state << 25;
    random_state ^= random_state >> 27;
    return (uint32_t)((random_state * 0x2545F4914F6CDD1Du) >> 32);
}

static inline int one_of(int n)
{
    return (int)(random_bits() % (uint32_t)n);
}

static inline float between(float lo, float hi)
{
    return lo + (hi - lo) * ((float)(random_bits() >> 8) * (1.0f / 16777216.0f));
}

/* The same bits, or both NaN. */
static inline bool same_float(float a, float b)
{
    return memcmp(&a, &b, sizeof a) == 0 || (a != a && b != b);
}

#endif
