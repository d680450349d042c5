/* The root is that of R. E. Goldschmidt with a final correction by the exact residual, the reciprocal that of Newton, both
 * by fused multiplications and additions (P. W. Markstein, IBM J. Res. Dev. 34 (1990) 111; M. Cornea, J. Harrison, P. T.
 * P. Tang, Scientific Computing on Itanium-based Systems, 2002).
 *
 * Root of x: before the last rounding the relative error is below 2^-102. So it is rounded wrongly only if the root is
 * that near to a boundary between two results: 4^k x = m^2 + r, m odd with 54 bits, |r| < 2^8. There are some hundred such
 * x; tests/contact/check_contact_roots.c tests all of them.
 *
 * Reciprocal of b: from an approximation within one unit in the last place a step of Newton with exact residual gives the
 * correctly rounded result unless all bits of the mantissa of b are 1 (Markstein's theorem). For those, and for numbers
 * near the ends of the range of exponents, the instructions of the processor are used. */
#include "base/clones.h"
TS_UNROLLED

#include "contact/contact_roots.h"

#include <math.h>
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define BY_MULTIPLICATION
#include <immintrin.h>
#endif

#include "base/banned.h"

TS_CLONES static void by_division(const struct ts_contact_roots *columns, size_t n)
{
	const struct ts_contact_roots c = *columns;

#pragma omp simd
	for (size_t k = 0; k < n; k++) {
		double x = c.d[0][k], y = c.d[1][k], z = c.d[2][k], distance = sqrt(x * x + y * y + z * z);

		c.distance[k] = distance;
		c.inverse[k] = distance > 0 ? 1 / distance : 0;
	}
	if (!c.r_eff)
		return;
#pragma omp simd
	for (size_t k = 0; k < n; k++)
		c.root[k] = sqrt(c.r_eff[k] * (c.radius[0][k] + c.radius[1][k] - c.distance[k]));
}

#ifdef BY_MULTIPLICATION
#define AVX512 __attribute__((target("avx512f")))
#define AVX512_INLINE AVX512 __attribute__((always_inline)) static inline

/* A length and its reciprocal. */
struct length {
	__m512d value, inverse;
};

/* Whether all numbers are within 2^-510 .. 2^510: positive, and no residual is too small for a normal number. */
AVX512_INLINE int all_usual(__m512d x)
{
	const __m512i least = _mm512_set1_epi64((1023LL - 510) << 52), span = _mm512_set1_epi64(1020LL << 52);

	return _mm512_cmplt_epu64_mask(_mm512_sub_epi64(_mm512_castpd_si512(x), least), span) == 0xff;
}

/* Whether all bits of the mantissa of a number are 1. */
AVX512_INLINE int any_full(__m512d b)
{
	const __m512i rest = _mm512_set1_epi64(~((1LL << 52) - 1));

	return _mm512_cmpeq_epi64_mask(_mm512_or_si512(_mm512_castpd_si512(b), rest), _mm512_set1_epi64(-1));
}

/* Root of x, correctly rounded, and an approximation of its reciprocal. */
AVX512_INLINE struct length root_of(__m512d x)
{
	const __m512d half = _mm512_set1_pd(0.5);
	/* root and half of its reciprocal; 14 bits */
	__m512d y = _mm512_rsqrt14_pd(x), g = _mm512_mul_pd(x, y), h = _mm512_mul_pd(half, y);

	for (int k = 0; k < 2; k++) { /* 27, then 53 bits */
		__m512d r = _mm512_fnmadd_pd(g, h, half);

		g = _mm512_fmadd_pd(g, r, g);
		h = _mm512_fmadd_pd(h, r, h);
	}
	return (struct length){ _mm512_fmadd_pd(_mm512_fnmadd_pd(g, g, x), h, g), _mm512_add_pd(h, h) };
}

/* 1/b from an approximation y: the first step brings it within one unit in the last place. */
AVX512_INLINE __m512d reciprocal(__m512d b, __m512d y)
{
	for (int k = 0; k < 2; k++)
		y = _mm512_fmadd_pd(_mm512_fnmadd_pd(b, y, _mm512_set1_pd(1)), y, y);
	return y;
}

AVX512_INLINE struct length length_by_division(__m512d square)
{
	__m512d root = _mm512_sqrt_pd(square);
	__mmask8 positive = _mm512_cmp_pd_mask(root, _mm512_setzero_pd(), _CMP_GT_OQ);

	return (struct length){ root, _mm512_maskz_div_pd(positive, _mm512_set1_pd(1), root) };
}

AVX512_INLINE struct length length_of(__m512d square)
{
	struct length length = root_of(square);

	if (!all_usual(square) || any_full(length.value))
		return length_by_division(square);
	length.inverse = reciprocal(length.value, length.inverse);
	return length;
}

AVX512_INLINE __m512d square_of(const struct ts_contact_roots *c, size_t k)
{
	__m512d x = _mm512_load_pd(c->d[0] + k), y = _mm512_load_pd(c->d[1] + k),
		z = _mm512_load_pd(c->d[2] + k);

	return _mm512_add_pd(_mm512_add_pd(_mm512_mul_pd(x, x), _mm512_mul_pd(y, y)), _mm512_mul_pd(z, z));
}

AVX512_INLINE void by_multiplication(const struct ts_contact_roots *columns, size_t n, int rooted)
{
	const struct ts_contact_roots c = *columns;

	for (size_t k = 0; k < n; k += 8) {
		struct length length = length_of(square_of(&c, k));

		_mm512_store_pd(c.distance + k, length.value);
		_mm512_store_pd(c.inverse + k, length.inverse);
		if (rooted) {
			__m512d radii = _mm512_add_pd(_mm512_load_pd(c.radius[0] + k),
						      _mm512_load_pd(c.radius[1] + k)),
				overlap = _mm512_sub_pd(radii, length.value);

			_mm512_store_pd(c.root + k,
					_mm512_sqrt_pd(_mm512_mul_pd(_mm512_load_pd(c.r_eff + k), overlap)));
		}
	}
}

AVX512 static void lengths(const struct ts_contact_roots *c, size_t n)
{
	by_multiplication(c, n, 0);
}

AVX512 static void lengths_and_roots(const struct ts_contact_roots *c, size_t n)
{
	by_multiplication(c, n, 1);
}

void ts_contact_roots(const struct ts_contact_roots *c, size_t n)
{
	(__builtin_cpu_supports("avx512f") ? c->r_eff ? lengths_and_roots : lengths : by_division)(c, n);
}
#else
void ts_contact_roots(const struct ts_contact_roots *c, size_t n)
{
	by_division(c, n);
}
#endif
