/* The kernels of one instruction set and one arithmetic that see the whole pipeline; see vertex/kernels.c. */
#include "base/cpu.h"
#include "pipeline/clip_kernel.h"
#include "pipeline/fetch_kernel.h"
#include "pipeline/place_kernel.h"
#include "pipeline/sieve_kernel.h"

extern const struct clip_kernels FGL_KERNELS(clip);
const struct clip_kernels FGL_KERNELS(clip) = {clip_triangle, clip_line, place, sieve, fetch_any_floats};
