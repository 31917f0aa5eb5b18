/* How a setter stores a value that it has checked: nothing happens when the value is already there; otherwise
 * the vertices given under the old value are drawn first, and what depends on it is marked. */
#ifndef FGL_API_SET_H
#define FGL_API_SET_H

#include "api/errors.h"

#define SET(ctx, dirty, field, value)                                                                        \
    do {                                                                                                     \
        if ((field) != (value)) {                                                                            \
            fgl_flush_vertices((ctx), (dirty));                                                              \
            (field) = (value);                                                                               \
        }                                                                                                    \
    } while (0)

static inline bool fgl_floats_equal(const float *a, const float *b, int n)
{
    for (int i = 0; i < n; i++) {
        if (a[i] != b[i])
            return false;
    }
    return true;
}

static inline void fgl_set_floats(struct context *ctx, unsigned dirty, float *field, const float *v, int n)
{
    if (fgl_floats_equal(field, v, n))
        return;
    fgl_flush_vertices(ctx, dirty);
    for (int i = 0; i < n; i++)
        field[i] = v[i];
}

#endif
