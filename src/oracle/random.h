/* A small generator of random numbers, the same everywhere for the same seed. */
#ifndef ORACLE_RANDOM_H
#define ORACLE_RANDOM_H

#include <stdint.h>

struct random {
    uint64_t state;
};

/* A stream of its own for each pair of seed and number. */
struct random random_stream(uint64_t seed, uint64_t number);

uint32_t random_bits(struct random *random);
int random_below(struct random *random, int count); /* 0 to count - 1 */
float random_between(struct random *random, float low, float high);

/* Evenly distributed over the orders of magnitude of [low, high], both positive. */
float random_magnitude(struct random *random, float low, float high);

/* A direction, of length 1 to the precision of float. */
void random_unit(struct random *random, float v[3]);

#endif
