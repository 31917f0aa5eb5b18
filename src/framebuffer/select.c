/* Which kernels this processor runs. */
#include "framebuffer/rows.h"

FGL_KERNEL_TABLE(row);

const struct row_kernels *fgl_row_kernels(enum fgl_arith arith)
{
    return kernels_of[fgl_cpu_isa()][arith];
}
