/* Which kernels this processor runs. */
#include "pipeline/pipeline.h"

FGL_KERNEL_TABLE(clip);

const struct clip_kernels *fgl_clip_kernels(enum fgl_arith arith)
{
    return kernels_of[fgl_cpu_isa()][arith];
}
