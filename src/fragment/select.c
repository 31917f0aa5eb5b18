/* Which kernels this processor runs. */
#include "fragment/fragment.h"

#if defined(__x86_64__) && defined(__GNUC__)
extern const struct fragment_kernels fgl_fragment_kernels_sse2, fgl_fragment_kernels_avx2,
        fgl_fragment_kernels_avx512;
static const struct fragment_kernels *const kernels[FGL_ISA_COUNT] = {
        &fgl_fragment_kernels_sse2, &fgl_fragment_kernels_avx2, &fgl_fragment_kernels_avx512};
#else
extern const struct fragment_kernels fgl_fragment_kernels_base;
static const struct fragment_kernels *const kernels[FGL_ISA_COUNT] = {&fgl_fragment_kernels_base};
#endif

const struct fragment_kernels *fgl_fragment_kernels_of(enum fgl_isa isa)
{
    return kernels[isa];
}
const struct fragment_kernels *fgl_fragment_kernels(void)
{
    return kernels[fgl_cpu_isa()];
}
