/* Functions that are compiled for several instruction sets; the loader selects the best one. As
 * contraction is off all versions give the same bits. For inner loops over field rows, marked `#pragma
 * omp simd` (without it the compiler must prove that rows do not overlap, and gives up); not for
 * functions that open parallel regions, nor for inline functions. */
#ifndef TS_BASE_CLONES_H
#define TS_BASE_CLONES_H

#if defined(__x86_64__) && defined(__gnu_linux__) && defined(__GNUC__) && !defined(__clang__) && \
	defined(__OPTIMIZE__) && !defined(__SANITIZE_ADDRESS__) && !defined(__AVX2__)
#define TS_CLONES __attribute__((target_clones("avx512f", "avx2", "default")))
/* For the rest of a file: unrolls small inner loops first, also with -O2, so that the loops around them
 * can be vectorised. Put it before all other includes. */
#define TS_UNROLLED _Pragma("GCC optimize(\"O3\")")
#else
#define TS_UNROLLED
#define TS_CLONES
#endif

#endif
