/* What every file of FixedGL may rely on: the portable names of compiler features, and small integer helpers.
 * Layer 0: the C library only. */
#ifndef FGL_BASE_FGL_H
#define FGL_BASE_FGL_H

#include <assert.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#if defined(__GNUC__)
#define FGL_ALWAYS_INLINE inline __attribute__((always_inline))
#define FGL_NOINLINE __attribute__((noinline))
#define FGL_LIKELY(x) __builtin_expect(!!(x), 1)
#define FGL_UNLIKELY(x) __builtin_expect(!!(x), 0)
#define FGL_RESTRICT __restrict__
#define FGL_TLS_FAST __attribute__((tls_model("initial-exec")))
#else
#define FGL_ALWAYS_INLINE inline
#define FGL_NOINLINE
#define FGL_LIKELY(x) (x)
#define FGL_UNLIKELY(x) (x)
#define FGL_RESTRICT restrict
#define FGL_TLS_FAST
#endif

/* Before a loop of a few iterations that is to become vectors: Clang would unroll it first; GCC too, where it is inside of another loop. */
#if defined(__clang__)
#define FGL_VECTOR_LOOP _Pragma("clang loop unroll(disable)")
#define FGL_INNER_VECTOR_LOOP FGL_VECTOR_LOOP
#elif defined(__GNUC__)
#define FGL_VECTOR_LOOP
#define FGL_INNER_VECTOR_LOOP _Pragma("GCC unroll 1")
#else
#define FGL_VECTOR_LOOP
#define FGL_INNER_VECTOR_LOOP
#endif

#define FGL_COUNTOF(a) (sizeof(a) / sizeof((a)[0]))

static inline int fgl_min(int a, int b) { return a < b ? a : b; }
static inline int fgl_max(int a, int b) { return a > b ? a : b; }
static inline int fgl_clamp(int v, int lo, int hi) { return fgl_max(lo, fgl_min(v, hi)); }
static inline int fgl_lowest_bit(uint32_t bits) /* its number; bits: not 0 */
{
#if defined(__GNUC__)
    return __builtin_ctz(bits);
#else
    int n = 0;
    for (; !(bits & 1); bits >>= 1)
        n++;
    return n;
#endif
}
static inline float fgl_clamp01(float v) { return v > 0.0f ? (v < 1.0f ? v : 1.0f) : 0.0f; } /* NaN -> 0 */

#endif
