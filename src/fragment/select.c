/* Which kernels this processor runs. */
#include "fragment/fragment.h"

FGL_KERNEL_TABLE(fragment);

const struct fragment_kernels *fgl_fragment_kernels_of(enum fgl_isa isa, enum fgl_arith arith)
{
    return kernels_of[isa][arith];
}
const struct fragment_kernels *fgl_fragment_kernels(enum fgl_arith arith)
{
    return kernels_of[fgl_cpu_isa()][arith];
}
