/* Which kernels this processor runs. */
#include "raster/raster.h"

#if defined(__x86_64__) && defined(__GNUC__)
extern const struct raster_kernels fgl_raster_kernels_sse2, fgl_raster_kernels_avx2,
        fgl_raster_kernels_avx512;
static const struct raster_kernels *const kernels[FGL_ISA_COUNT] = {
        &fgl_raster_kernels_sse2, &fgl_raster_kernels_avx2, &fgl_raster_kernels_avx512};
#else
extern const struct raster_kernels fgl_raster_kernels_base;
static const struct raster_kernels *const kernels[FGL_ISA_COUNT] = {&fgl_raster_kernels_base};
#endif

const struct raster_kernels *fgl_raster_kernels_of(enum fgl_isa isa)
{
    return kernels[isa];
}
const struct raster_kernels *fgl_raster_kernels(void)
{
    return kernels[fgl_cpu_isa()];
}
