/* Functions compiled several times, for the instruction sets of processors of different age; the loader takes
 * the best one. With contraction off all give the same bits. For the inner loops over rows of fields, marked
 * `#pragma omp simd` (without it the compiler must prove that rows do not overlap, and gives up); not for
 * functions that open parallel regions, nor for inline ones. */
#ifndef TS_BASE_CLONES_H
#define TS_BASE_CLONES_H

#if defined(__x86_64__) && defined(__gnu_linux__) && defined(__GNUC__) && !defined(__clang__) && \
	defined(__OPTIMIZE__) && !defined(__SANITIZE_ADDRESS__) && !defined(__AVX2__)
#define TS_CLONES __attribute__((target_clones("avx512f", "avx2", "default")))
/* For the rest of a file: small inner loops are unrolled first, also with -O2; else loops around them stay
 * as they are. Before all other includes. */
#define TS_UNROLLED _Pragma("GCC optimize(\"O3\")")
#else
#define TS_UNROLLED
#define TS_CLONES
#endif

#endif
