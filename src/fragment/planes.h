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

#endif
