/* Colour indexes (GL 1.5, colour index mode): floating-point numbers in place of fixed-point ones with bits to
 * the right of the binary point. Layer 0. */
#ifndef FGL_BASE_COLOR_INDEX_H
#define FGL_BASE_COLOR_INDEX_H

#include "base/fgl.h"

enum { FGL_INDEX_BITS = 8, FGL_INDEX_MAX = 255 };

/* GL 1.5, 2.14.6 "Clamping or Masking": the integer part is masked with 2^8 - 1, the bits to the right of the
 * point are left alone. In [0,256). Numbers of 2^39 and more give 0, as does NaN: no float has bits below 2^8
 * there. */
static inline double fgl_index_mask(double v)
{
    const double pages = v * (1.0 / 256.0), limit = 2147483648.0;
    const double inside = pages > -limit && pages < limit ? pages : 0.0;
    const double cut = (double)(int32_t)inside, whole = cut > inside ? cut - 1.0 : cut;
    const double rest = (inside - whole) * 256.0;
    return rest < 256.0 ? rest : 0.0;
}

#endif
