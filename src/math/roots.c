/* The root is that of R. E. Goldschmidt with a final correction by the exact residual; the reciprocal that of
 * Newton, both by fused multiplications and additions (P. W. Markstein, IBM J. Res. Dev. 34 (1990) 111; M. Cornea,
 * J. Harrison, P. T. P. Tang, Scientific Computing on Itanium-based Systems, 2002).
 *
 * Root: before the last rounding the relative error is below 2^-101. It is rounded wrongly only if a boundary m
 * between two results is as near: 4 x 2^k = m^2 + K, m odd, with |K| < 2^8. There are some hundred such x, which
 * tests/math/check_roots.c tests, all of them.
 *
 * Reciprocal of b: a last step from an approximation y within one unit in the last place gives the correctly rounded
 * result unless all bits of the mantissa of b are 1 (Markstein's theorem); for those and for numbers
 * near the ends of the range of exponents the instructions of the processor are used. */
#include "math/roots.h"

#include <math.h>

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define BY_MULTIPLICATION
#include <immintrin.h>
#endif

#include "base/clones.h"

#include "base/banned.h"

#ifdef BY_MULTIPLICATION
#define AVX512 __attribute__((target("avx512f")))
#define AVX512_INLINE AVX512 __attribute__((always_inline)) static inline

/* Whether all numbers are within 2^-510 .. 2^510: positive, and no residual is too small for a normal number. */
AVX512_INLINE int all_usual(__m512d x)
{
	const __m512i least = _mm512_set1_epi64((1023LL - 510) << 52), span = _mm512_set1_epi64(1020LL << 52);

	return _mm512_cmplt_epu64_mask(_mm512_sub_epi64(_mm512_castpd_si512(x), least), span) == 0xff;
}

struct root {
	__m512d root, half_inverse; /* correctly rounded, within some units in the last place */
};

AVX512_INLINE struct root root_of(__m512d x)
{
	const __m512d half = _mm512_set1_pd(0.5);
	__m512d y = _mm512_rsqrt14_pd(x), g = _mm512_mul_pd(x, y), h = _mm512_mul_pd(half, y);

	for (int k = 0; k < 2; k++) { /* 14, 27, 53 bits */
		__m512d r = _mm512_fnmadd_pd(g, h, half);

		g = _mm512_fmadd_pd(g, r, g);
		h = _mm512_fmadd_pd(h, r, h);
	}
	g = _mm512_fmadd_pd(_mm512_fnmadd_pd(g, g, x), h, g);
	return (struct root){ g, h };
}

/* 1/b from an approximation y. */
AVX512_INLINE __m512d inverse_of(__m512d b, __m512d y)
{
	const __m512d one = _mm512_set1_pd(1);

	for (int k = 0; k < 2; k++)
		y = _mm512_fmadd_pd(_mm512_fnmadd_pd(b, y, one), y, y);
	return y;
}

/* Whether all bits of the mantissa of a number are 1. */
AVX512_INLINE int any_full(__m512d b)
{
	const __m512i rest = _mm512_set1_epi64(~((1LL << 52) - 1));

	return _mm512_cmpeq_epi64_mask(_mm512_or_si512(_mm512_castpd_si512(b), rest), _mm512_set1_epi64(-1));
}

AVX512 static void roots_avx512(const double *x, double *root, size_t n)
{
	for (size_t k = 0; k < n; k += TS_ROOTS_AT_ONCE) {
		__m512d a = _mm512_load_pd(x + k);

		_mm512_store_pd(root + k, all_usual(a) ? root_of(a).root : _mm512_sqrt_pd(a));
	}
}

AVX512 static void roots_and_inverses_avx512(const double *x, double *root, double *inverse, size_t n)
{
	for (size_t k = 0; k < n; k += TS_ROOTS_AT_ONCE) {
		__m512d a = _mm512_load_pd(x + k);
		struct root r = root_of(a);

		if (all_usual(a) && !any_full(r.root)) {
			r.half_inverse =
				inverse_of(r.root, _mm512_add_pd(r.half_inverse, r.half_inverse));
		} else {
			r.root = _mm512_sqrt_pd(a);
			r.half_inverse = _mm512_maskz_div_pd(
				_mm512_cmp_pd_mask(r.root, _mm512_setzero_pd(), _CMP_GT_OQ),
				_mm512_set1_pd(1), r.root);
		}
		_mm512_store_pd(root + k, r.root);
		_mm512_store_pd(inverse + k, r.half_inverse);
	}
}
#endif

TS_CLONES static void roots(const double *x, double *root, size_t n)
{
#pragma omp simd
	for (size_t k = 0; k < n; k++)
		root[k] = sqrt(x[k]);
}

TS_CLONES static void roots_and_inverses(const double *x, double *root, double *inverse, size_t n)
{
#pragma omp simd
	for (size_t k = 0; k < n; k++) {
		root[k] = sqrt(x[k]);
		inverse[k] = root[k] > 0 ? 1 / root[k] : 0;
	}
}

void ts_roots(const double *x, double *root, size_t n)
{
#ifdef BY_MULTIPLICATION
	if (__builtin_cpu_supports("avx512f")) {
		roots_avx512(x, root, n);
		return;
	}
#endif
	roots(x, root, n);
}

void ts_roots_and_inverses(const double *x, double *root, double *inverse, size_t n)
{
#ifdef BY_MULTIPLICATION
	if (__builtin_cpu_supports("avx512f")) {
		roots_and_inverses_avx512(x, root, inverse, n);
		return;
	}
#endif
	roots_and_inverses(x, root, inverse, n);
}
