/* Arrays of floats to a batch: what fetch.c does with any type, for the commonest one. Kernels, since the tightly packed ones are vector
 * permutations. */
#ifndef FGL_PIPELINE_FETCH_KERNEL_H
#define FGL_PIPELINE_FETCH_KERNEL_H

#include "pipeline/pipeline.h"

#include <string.h>

/* Whole vertices at a time: size components each, one after the other in memory. */
static FGL_ALWAYS_INLINE void fetch_floats(struct lanes4 *FGL_RESTRICT to, const char *from, ptrdiff_t stride, int n, const int size)
{
    for (int i = 0; i < n; i++) {
        for (int c = 0; c < size; c++)
            memcpy(&to->c[c][i], from + i * stride + c * (ptrdiff_t)sizeof(float), sizeof(float));
    }
}

static void fetch_any_floats(struct lanes4 *to, const char *from, ptrdiff_t stride, int n, int size)
{
    switch (size) {
    case 1: fetch_floats(to, from, stride, n, 1); break;
    case 2: fetch_floats(to, from, stride, n, 2); break;
    case 3: stride == 12 ? fetch_floats(to, from, 12, n, 3) : fetch_floats(to, from, stride, n, 3); break;
    default: fetch_floats(to, from, stride, n, 4); break;
    }
}

#endif
