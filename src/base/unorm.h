/* Unsigned normalized integers: 0 to 2^bits - 1 stand for 0 to 1. Layer 0. */
#ifndef FGL_BASE_UNORM_H
#define FGL_BASE_UNORM_H

#include "base/fgl.h"

/* bits: 1..32, in all of these. */
static inline uint32_t fgl_unorm_max(int bits)
{
    return 0xffffffffu >> (32 - bits);
}

/* To another width. OSMesa rule: fewer bits are rounded, more bits repeat the pattern. */
static inline uint32_t fgl_unorm_resize(uint32_t v, int from, int to)
{
    if (to < from)
        return (uint32_t)(((uint64_t)v * fgl_unorm_max(to) + (fgl_unorm_max(from) >> 1)) / fgl_unorm_max(from));
    const int rest = to % from;
    return v * (fgl_unorm_max(to) / fgl_unorm_max(from)) + (rest ? v >> (from - rest) : 0);
}

/* OSMesa rule: v * (1 / max) in float. */
static inline float fgl_unorm_to_float(uint32_t v, int bits)
{
    return (float)v * (1.0f / (float)fgl_unorm_max(bits));
}

#endif
