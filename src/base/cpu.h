/* Which instruction set the kernels of this process use. Layer 0. */
#ifndef FGL_BASE_CPU_H
#define FGL_BASE_CPU_H

enum fgl_isa {
    FGL_ISA_BASE,   /* what every CPU of the architecture has (x86-64: SSE2) */
    FGL_ISA_AVX2,   /* AVX2 and FMA */
    FGL_ISA_AVX512, /* AVX-512 F, VL, DQ, BW */
    FGL_ISA_COUNT
};

/* The best set that the CPU has and the build made kernels for, or the lower one that the environment asks
 * for: FIXEDGL_ISA=sse2|avx2|avx512. Pictures do not depend on it. Found out once, at the first call. */
enum fgl_isa fgl_cpu_isa(void);

/* Whether this CPU can run kernels of the set, whatever the environment says. */
int fgl_cpu_has(enum fgl_isa isa);

#endif
