/* The fragment kernels of one instruction set and one arithmetic. The build compiles this file once for each set, with
 * FGL_ISA naming it (sse2, avx2, avx512; base elsewhere) and the compiler's options to match, and for each arithmetic, with
 * FGL_ARITH naming it. */
#include "fragment/fused.h"
#include "fragment/general.h"
#include "fragment/scatter.h"
#include "fragment/texture_trace.h"
#include "fragment/index.h"

extern const struct fragment_kernels FGL_KERNELS(fragment);
const struct fragment_kernels FGL_KERNELS(fragment) = {
        .fused = {[DEPTH_OFF] = {fill_constant, fill_flat, fill_smooth, fill_image},
                  [DEPTH_LESS] = {fill_constant_less, fill_flat_less, fill_smooth_less, fill_image_less},
                  [DEPTH_LEQUAL] = {fill_constant_lequal, fill_flat_lequal, fill_smooth_lequal,
                                    fill_image_lequal}},
        .staged = {[DEPTH_OFF] = fill_staged, [DEPTH_LESS] = fill_staged_less, [DEPTH_LEQUAL] = fill_staged_lequal},
        .scatter = {[DEPTH_OFF] = {scatter_constant, scatter_flat, scatter_smooth},
                    [DEPTH_LESS] = {scatter_constant_less, scatter_flat_less, scatter_smooth_less},
                    [DEPTH_LEQUAL] = {scatter_constant_lequal, scatter_flat_lequal, scatter_smooth_lequal}},
        .general = general_fill,
        .trace_texture = trace_texture,
        .index = index_fill,
};
