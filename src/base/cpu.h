/* Which kernels this process uses: every kernels.c is compiled once for each instruction set and each arithmetic.
 * Layer 0. */
#ifndef FGL_BASE_CPU_H
#define FGL_BASE_CPU_H

enum fgl_isa {
    FGL_ISA_BASE,   /* what every CPU of the architecture has (x86-64: SSE2) */
    FGL_ISA_AVX2,   /* AVX2 and FMA */
    FGL_ISA_AVX512, /* AVX-512 F, VL, DQ, BW */
    FGL_ISA_COUNT
};

/* The arithmetics (base/arith.h). */
enum fgl_arith { ARITH_COMPATIBLE, ARITH_EXACT, ARITH_COUNT };

/* Whether the build has the sets of x86-64: not with `make ISAS=base`. */
#if defined(__x86_64__) && defined(__GNUC__) && !defined(FGL_ONE_ISA)
#define FGL_X86_ISAS 1
#else
#define FGL_X86_ISAS 0
#endif

/* Declares the tables of a module's kernels, struct NAME_kernels, as kernels_of[instruction set][arithmetic]. */
#if FGL_X86_ISAS
#define FGL_EACH_ISA(M, name) M(name, sse2), M(name, avx2), M(name, avx512)
#else
#define FGL_EACH_ISA(M, name) M(name, base)
#endif
#define FGL_KERNELS_OF_ISA(name, isa) \
    fgl_##name##_kernels_##isa##_compatible, fgl_##name##_kernels_##isa##_exact
#define FGL_KERNEL_ENTRY(name, isa) {&fgl_##name##_kernels_##isa##_compatible, &fgl_##name##_kernels_##isa##_exact}
#define FGL_KERNEL_TABLE(name) \
    extern const struct name##_kernels FGL_EACH_ISA(FGL_KERNELS_OF_ISA, name); \
    static const struct name##_kernels *const kernels_of[FGL_ISA_COUNT][ARITH_COUNT] = { \
        FGL_EACH_ISA(FGL_KERNEL_ENTRY, name)}

/* In a kernels.c, which the build compiles with FGL_ISA and FGL_ARITH naming its set and its arithmetic: the name of
 * the table that it defines. */
#define FGL_KERNELS(name) FGL_KERNELS_EXPANDED(name, FGL_ISA, FGL_ARITH)
#define FGL_KERNELS_EXPANDED(name, isa, arith) FGL_KERNELS_NAME(name, isa, arith)
#define FGL_KERNELS_NAME(name, isa, arith) fgl_##name##_kernels_##isa##_##arith

/* The best set that the CPU has and the build made kernels for, or the lower one that the environment asks
 * for: FIXEDGL_ISA=sse2|avx2|avx512. Pictures do not depend on it. Found out once, at the first call. */
enum fgl_isa fgl_cpu_isa(void);

/* Whether this CPU can run kernels of the set, whatever the environment says. */
int fgl_cpu_has(enum fgl_isa isa);

#endif
