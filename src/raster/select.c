/* Which kernels this processor runs. */
#include "raster/raster.h"

FGL_KERNEL_TABLE(raster);

const struct raster_kernels *fgl_raster_kernels_of(enum fgl_isa isa, enum fgl_arith arith)
{
    return kernels_of[isa][arith];
}
const struct raster_kernels *fgl_raster_kernels(enum fgl_arith arith)
{
    return kernels_of[fgl_cpu_isa()][arith];
}
