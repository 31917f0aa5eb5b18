/* The results of a vertex batch in the arithmetic's type (base/arith.h). Kernels only. Layer 0. */
#ifndef FGL_BASE_BATCH_RESULTS_H
#define FGL_BASE_BATCH_RESULTS_H

#include "base/arith.h"
#include "base/batch.h"

#if R_EXACT
typedef struct lanes4_exact real_lanes4;
#define RESULTS(batch) (&(batch)->exact)
#else
typedef struct lanes4 real_lanes4;
#define RESULTS(batch) (batch)
#endif

#endif
