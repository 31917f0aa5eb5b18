#include "base/cpu.h"

#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

#if FGL_X86_ISAS
int fgl_cpu_has(enum fgl_isa isa)
{
    __builtin_cpu_init();
    switch (isa) {
    case FGL_ISA_BASE: return 1;
    case FGL_ISA_AVX2: return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
    case FGL_ISA_AVX512:
        return fgl_cpu_has(FGL_ISA_AVX2) && __builtin_cpu_supports("avx512f") &&
               __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512dq") &&
               __builtin_cpu_supports("avx512bw");
    default: return 0;
    }
}
#else
int fgl_cpu_has(enum fgl_isa isa)
{
    return isa == FGL_ISA_BASE;
}
#endif

static enum fgl_isa find(void)
{
    static const char *const name[FGL_ISA_COUNT] = {"sse2", "avx2", "avx512"};
    const char *asked = getenv("FIXEDGL_ISA");
    int isa = FGL_ISA_COUNT - 1;

    for (int i = 0; asked && i < FGL_ISA_COUNT; i++)
        if (strcmp(asked, name[i]) == 0)
            isa = i;
    while (!fgl_cpu_has((enum fgl_isa)isa))
        isa--;
    return (enum fgl_isa)isa;
}

enum fgl_isa fgl_cpu_isa(void)
{
    static atomic_int known; /* 1 + the set; 0 before the first call. Threads that race find the same. */
    int isa = atomic_load_explicit(&known, memory_order_relaxed);

    if (!isa) {
        isa = 1 + (int)find();
        atomic_store_explicit(&known, isa, memory_order_relaxed);
    }
    return (enum fgl_isa)(isa - 1);
}
