/* A primitive's planes in the arithmetic's type (base/arith.h). Kernels only. */
#ifndef FGL_FRAGMENT_PLANES_H
#define FGL_FRAGMENT_PLANES_H

#include "base/arith.h"
#include "fragment/fragment.h"

#if R_EXACT
#define PLANES(planes) (&(planes)->exact)
#else
#define PLANES(planes) (planes)
#endif

/* Pixels of small triangles: each with its triangle's planes in a lane of its own. Behind the n-th they are of no account. */
enum { SCATTERED_MAX = 16 };
struct scattered {
    int n;
    int32_t x[SCATTERED_MAX], y[SCATTERED_MAX];
    real a00[LANE_SECONDARY][SCATTERED_MAX], dadx[LANE_SECONDARY][SCATTERED_MAX], dady[LANE_SECONDARY][SCATTERED_MAX];
};

#endif
