/* Random numbers, exact sums, vectors, sorted keys. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "asserts.h"
#include "base/sort.h"
#include "math/fit.h"
#include "math/exactsum.h"
#include "math/rng.h"
#include "math/vec3.h"

/* Known answers published with the reference implementation of the authors of Philox. */
START_TEST(philox_known_answers)
{
	static const struct {
		uint32_t counter[4], key[2], out[4];
	} known[] = {
		{ { 0, 0, 0, 0 }, { 0, 0 }, { 0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8 } },
		{ { 0xffffffff, 0xffffffff, 0xffffffff, 0xffffffff },
		  { 0xffffffff, 0xffffffff },
		  { 0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd } },
		{ { 0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344 },
		  { 0xa4093822, 0x299f31d0 },
		  { 0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1 } },
	};

	for (size_t k = 0; k < sizeof known / sizeof *known; k++) {
		uint32_t out[4];

		ts_rng_philox(known[k].counter, known[k].key, out);
		for (int i = 0; i < 4; i++)
			ck_assert_uint_eq(out[i], known[k].out[i]);
	}
}
END_TEST

/* Mean and variance of 10^5 draws within five standard errors. */
START_TEST(rng_moments)
{
	enum { N = 100000 };
	struct ts_rng a = ts_rng_start(86028157, 3), b = ts_rng_start(86028157, 4);
	double u = 0, u2 = 0, g = 0, g2 = 0, g4 = 0;

	for (int k = 0; k < N; k++) {
		double x = ts_rng_uniform(&a), y = ts_rng_normal(&b);

		ck_assert(x > 0 && x < 1);
		u += x;
		u2 += x * x;
		g += y;
		g2 += y * y;
		g4 += y * y * y * y;
	}
	ck_assert_double_eq_tol(u / N, 0.5, 5 * sqrt(1. / 12 / N));
	ck_assert_double_eq_tol(u2 / N, 1. / 3, 5 * sqrt(4. / 45 / N));
	ck_assert_double_eq_tol(g / N, 0, 5 * sqrt(1. / N));
	ck_assert_double_eq_tol(g2 / N, 1, 5 * sqrt(2. / N));
	ck_assert_double_eq_tol(g4 / N, 3, 5 * sqrt(96. / N));
}
END_TEST

START_TEST(rng_is_a_function)
{
	struct ts_rng a = ts_rng_start(7, 1), b = ts_rng_start(7, 1), c = ts_rng_start(7, 2);
	double x, y;

	for (int k = 0; k < 10; k++)
		x = ts_rng_uniform(&a);
	b.counter = 9;
	c.counter = 9;
	y = ts_rng_uniform(&b);
	ck_assert(x == y);
	ck_assert(x != ts_rng_uniform(&c));
}
END_TEST

/* Numbers of many streams at once are those of each stream. */
START_TEST(rng_of_streams)
{
	enum { N = 37 };
	const uint64_t seed = UINT64_C(0x123456789abcdef0), counter = UINT64_C(0xfedcba9876543210);
	int32_t stream[N];
	double out[N];

	for (int k = 0; k < N; k++)
		stream[k] = k * 57885161 % 1000003 + (k == 5 ? INT32_MAX - 1000003 : 0);
	ts_rng_uniform_of_streams(seed, counter, stream, N, out);
	for (int k = 0; k < N; k++) {
		struct ts_rng rng = { seed, (uint64_t)stream[k], counter };

		ck_assert(out[k] == ts_rng_uniform(&rng));
	}
}
END_TEST

/* The sum of two sums, added as integers. */
static double sum_as_integers(const double a[2], const double b[2])
{
	struct ts_exactsum x = ts_exactsum_start(), y = ts_exactsum_start();
	int64_t m[TS_EXACTSUM_INTEGERS], n[TS_EXACTSUM_INTEGERS];

	for (int k = 0; k < 2; k++) {
		ts_exactsum_add(&x, a[k]);
		ts_exactsum_add(&y, b[k]);
	}
	ts_exactsum_pack(&x, m);
	ts_exactsum_pack(&y, n);
	for (int k = 0; k < TS_EXACTSUM_INTEGERS; k++)
		m[k] += n[k];
	x = ts_exactsum_unpack(m);
	return ts_exactsum_value(&x);
}

START_TEST(exactsum_as_integers)
{
	ck_assert(sum_as_integers((double[]){ 1e300, -0x1p-1074 }, (double[]){ -1e300, -3.5 }) == -3.5);
	ck_assert(sum_as_integers((double[]){ 1e300, 0x1p-1074 }, (double[]){ -1e300, 0 }) == 0x1p-1074);
	ck_assert(sum_as_integers((double[]){ 1, INFINITY }, (double[]){ 2, 3 }) == INFINITY);
	ck_assert(sum_as_integers((double[]){ 1, -INFINITY }, (double[]){ -INFINITY, 3 }) == -INFINITY);
	ck_assert(isnan(sum_as_integers((double[]){ 1, INFINITY }, (double[]){ -INFINITY, 3 })));
	ck_assert(isnan(sum_as_integers((double[]){ NAN, 1 }, (double[]){ 2, 3 })));
}
END_TEST

START_TEST(exactsum_cancels)
{
	struct ts_exactsum s = ts_exactsum_start();

	ts_exactsum_add(&s, 1e300);
	ts_exactsum_add(&s, 1);
	ts_exactsum_add(&s, 0x1p-1074);
	ts_exactsum_add(&s, -1e300);
	ck_assert(ts_exactsum_value(&s) == 1);
	ts_exactsum_add(&s, -1);
	ck_assert(ts_exactsum_value(&s) == 0x1p-1074);
	ts_exactsum_add(&s, -0x1p-1073);
	ck_assert(ts_exactsum_value(&s) == -0x1p-1074);
	ts_exactsum_add(&s, 0x1p-1074);
	ck_assert(ts_exactsum_value(&s) == 0);
}
END_TEST

/* The sum of the two largest doubles overflows and comes back. */
START_TEST(exactsum_range)
{
	struct ts_exactsum s = ts_exactsum_start();
	const double most = 0x1.fffffffffffffp1023;

	ts_exactsum_add(&s, most);
	ck_assert(ts_exactsum_value(&s) == most);
	ts_exactsum_add(&s, most);
	ck_assert(isinf(ts_exactsum_value(&s)));
	ts_exactsum_add(&s, -most);
	ck_assert(ts_exactsum_value(&s) == most);
	ts_exactsum_add(&s, INFINITY);
	ck_assert(ts_exactsum_value(&s) == (double)INFINITY);
	ts_exactsum_add(&s, -INFINITY);
	ck_assert(isnan(ts_exactsum_value(&s)));
}
END_TEST

/* Ties go to even, anything beyond a tie goes up. */
START_TEST(exactsum_rounding)
{
	static const struct {
		double a, b, c, sum;
	} known[] = {
		{ 0x1p53, 1, 0, 0x1p53 },	  { 0x1p53, 1, 0x1p-1074, 0x1p53 + 2 },
		{ 0x1p53 + 2, 1, 0, 0x1p53 + 4 }, { 0x1p53 + 2, 1, -0x1p-1074, 0x1p53 + 2 },
		{ 0x1p53 - 1, 0.5, 0, 0x1p53 },	  { 0x1p53 - 2, 0.25, 0x1p-60, 0x1p53 - 2 },
	};

	for (size_t k = 0; k < sizeof known / sizeof *known; k++)
		for (int sign = -1; sign <= 1; sign += 2) {
			struct ts_exactsum s = ts_exactsum_start();

			ts_exactsum_add(&s, sign * known[k].a);
			ts_exactsum_add(&s, sign * known[k].b);
			ts_exactsum_add(&s, sign * known[k].c);
			ck_assert(ts_exactsum_value(&s) == sign * known[k].sum);
		}
}
END_TEST

/* Any order, and any split into partial sums, gives the same bits. */
START_TEST(exactsum_order)
{
	enum { N = 5000 };
	static double term[N];
	struct ts_rng rng = ts_rng_start(49979687, 0);
	struct ts_exactsum forth = ts_exactsum_start(), part[3];

	for (int p = 0; p < 3; p++)
		part[p] = ts_exactsum_start();
	for (int k = 0; k < N; k++) {
		term[k] = ldexp(ts_rng_normal(&rng), (int)(600 * ts_rng_uniform(&rng)) - 300);
		ts_exactsum_add(&forth, term[k]);
		ts_exactsum_add(&part[k % 3], term[k]);
	}
	ts_exactsum_merge(&part[2], &part[0]);
	ts_exactsum_merge(&part[2], &part[1]);
	ck_assert(ts_exactsum_value(&forth) == ts_exactsum_value(&part[2]));
	for (int k = N - 1; k >= 0; k--)
		ts_exactsum_add(&forth, -term[k]);
	ck_assert(ts_exactsum_value(&forth) == 0);
}
END_TEST

/* Many terms are added together, few one by one: the same bits, whatever their sizes. */
START_TEST(exactsum_together)
{
	static const struct {
		int least, range; /* exponents of the terms */
	} size[] = { { -20, 20 },   { -1, 1 },	 { -70, 90 }, { -1060, 70 },
		     { -1074, 30 }, { 900, 60 }, { 940, 60 } };
	struct ts_rng rng = ts_rng_start(32452843, 0);

	for (size_t k = 0; k < sizeof size / sizeof *size; k++)
		for (int n = 1; n < 700; n += 1 + n / 9) {
			struct ts_exactsum together = ts_exactsum_start(), alone = ts_exactsum_start(),
					   blocks = ts_exactsum_start();
			double block[TS_EXACTSUM_WAITING];
			const int length = 1 + n % TS_EXACTSUM_WAITING;

			for (int i = 0; i < n; i++) {
				int exponent = size[k].least + (int)(size[k].range * ts_rng_uniform(&rng));
				double term = ldexp(ts_rng_normal(&rng), exponent);
				struct ts_exactsum one = ts_exactsum_start();

				term = i % 11 ? term : 0;
				ts_exactsum_add(&one, term);
				ts_exactsum_add(&together, term);
				ts_exactsum_merge(&alone, &one);
				block[i % length] = term;
				if (i % length == length - 1 || i == n - 1)
					ts_exactsum_add_block(&blocks, block, (size_t)(i % length) + 1);
			}
			ck_assert(ts_exactsum_value(&together) == ts_exactsum_value(&alone));
			ck_assert(ts_exactsum_value(&together) == ts_exactsum_value(&blocks));
			ts_exactsum_add(&together, -ts_exactsum_value(&alone));
			ts_exactsum_add(&alone, -ts_exactsum_value(&alone));
			ck_assert(ts_exactsum_value(&together) == ts_exactsum_value(&alone));
		}
}
END_TEST

/* A term that is not a number, or infinite, among many others. */
START_TEST(exactsum_special_among_many)
{
	for (int k = 0; k < 3; k++) {
		struct ts_exactsum s = ts_exactsum_start();

		for (int i = 0; i < 300; i++)
			ts_exactsum_add(&s, i == 77		? (k ? INFINITY : NAN)
					    : i == 78 && k == 2 ? -INFINITY
								: 1);
		ck_assert(k == 1 ? ts_exactsum_value(&s) == INFINITY : isnan(ts_exactsum_value(&s)));
	}
}
END_TEST

/* Integers too large for doubles, against 64-bit arithmetic. */
START_TEST(exactsum_integers)
{
	struct ts_rng rng = ts_rng_start(15485863, 0);
	struct ts_exactsum s = ts_exactsum_start();
	int64_t sum = 0;

	for (int k = 0; k < 1000; k++) {
		double term = rint((ts_rng_uniform(&rng) - 0.4) * 0x1p52);

		sum += (int64_t)term;
		ts_exactsum_add(&s, term);
	}
	ck_assert(ts_exactsum_value(&s) == (double)sum);
}
END_TEST

START_TEST(vectors)
{
	const double a[3] = { 2.385, -0.5, 1.25 }, b[3] = { 0.75, 3, -1.5 };
	double c[3], d[3] = { 2.385, -0.5, 1.25 };

	ts_cross(a, b, c);
	ck_assert_double_eq_tol(ts_dot(a, c), 0, 1e-14);
	ck_assert_double_eq_tol(ts_dot(b, c), 0, 1e-14);
	ck_assert_double_eq_tol(ts_dot(c, c) + ts_dot(a, b) * ts_dot(a, b), ts_dot(a, a) * ts_dot(b, b),
				1e-12);
	ts_cross(d, b, d);
	ck_assert(d[0] == c[0] && d[1] == c[1] && d[2] == c[2]);
}
END_TEST

/* Lists of every length up to some that are merged, of keys with and without the highest bit. */
START_TEST(keys_sorted)
{
	enum { MOST = 300 };
	uint64_t key[MOST], spare[MOST];
	struct ts_rng rng = ts_rng_start(15485863, 1);

	for (size_t n = 0; n <= MOST; n++) {
		uint64_t all = 0;

		for (size_t k = 0; k < n; k++) { /* the last bits differ */
			key[k] = (uint64_t)(ts_rng_uniform(&rng) * 0x1p53) << 11;
			key[k] = (key[k] & ~(uint64_t)511) | k;
			all ^= key[k];
		}
		ts_sort_keys(key, spare, n);
		for (size_t k = 0; k < n; k++) {
			ck_assert(k == 0 || key[k - 1] < key[k]);
			all ^= key[k];
		}
		ck_assert_uint_eq(all, 0);
	}
}
END_TEST

/* Keys of which many are equal, and whose high digits are all the same. */
START_TEST(equal_keys_sorted)
{
	enum { MOST = 700, VALUES = 300 };
	uint64_t key[MOST], spare[MOST];
	struct ts_rng rng = ts_rng_start(32452843, 1);

	for (size_t n = 0; n <= MOST; n += 50) {
		size_t count[VALUES] = { 0 };

		for (size_t k = 0; k < n; k++) {
			size_t value = (size_t)(ts_rng_uniform(&rng) * VALUES);

			key[k] = (uint64_t)1 << 63 | value;
			count[value]++;
		}
		ts_sort_equal_keys(key, spare, n);
		for (size_t k = 0; k < n; k++) {
			ck_assert(k == 0 || key[k - 1] <= key[k]);
			count[key[k] & 0xffff]--;
		}
		for (size_t value = 0; value < VALUES; value++)
			ck_assert_uint_eq(count[value], 0);
	}
}
END_TEST

START_TEST(pairs_found)
{
	int32_t pair[][2] = { { 7, 1 }, { 7, -5 }, { INT32_MIN, 3 }, { 2, 2 }, { INT32_MAX, 0 } };
	const int32_t sorted[][2] = { { INT32_MIN, 3 }, { 2, 2 }, { 7, -5 }, { 7, 1 }, { INT32_MAX, 0 } };
	enum { N = sizeof sorted / sizeof *sorted };

	ts_sort(pair, N, sizeof *pair, ts_compare_int32_pair);
	ck_assert_int_eq(memcmp(pair, sorted, sizeof sorted), 0);
	ck_assert_uint_eq(ts_find_int32(sorted, N, sizeof *sorted, INT32_MIN), 0);
	ck_assert_uint_eq(ts_find_int32(sorted, N, sizeof *sorted, 1), 1);
	ck_assert_uint_eq(ts_find_int32(sorted, N, sizeof *sorted, 7), 2);
	ck_assert_uint_eq(ts_find_int32(sorted, N, sizeof *sorted, 8), 4);
	ck_assert_uint_eq(ts_find_int32(sorted, N - 1, sizeof *sorted, 8), N - 1);
	ck_assert_uint_eq(ts_find_int32(NULL, 0, sizeof *sorted, 8), 0);
}
END_TEST

/* Deviations from a line that follow x(k + 1) = 0.9 x(k) + noise: 2 tau = (1 + 0.9)/(1 - 0.9), and the scatter of the
 * slopes of many series is that of the estimate. */
START_TEST(correlated_deviations)
{
	enum { SERIES = 400, N = 2000 };
	struct ts_rng rng = ts_rng_start(5, 7);
	double y[N], mean_factor = 0, mean_error = 0, scatter = 0;

	for (int s = 0; s < SERIES; s++) {
		struct ts_fit line;
		double x = 0;

		for (int k = -200; k < N; k++) {
			x = 0.9 * x + ts_rng_uniform(&rng) - 0.5;
			if (k >= 0)
				y[k] = 3 + 0.01 * k + x;
		}
		ck_assert_int_eq(ts_fit_line(NULL, y, N, &line), TS_OK);
		mean_factor += ts_fit_correlation(y, &line) / SERIES;
		mean_error += line.slope_error * ts_fit_correlation(y, &line) / SERIES;
		scatter += pow(line.slope - 0.01, 2) / SERIES;
	}
	ck_assert_double_eq_tol(mean_factor, sqrt(1.9 / 0.1), 0.1 * sqrt(19));
	ck_assert_double_eq_tol(mean_error / sqrt(scatter), 1, 0.12);
}
END_TEST

/* Independent ones: the factor is 1 but for noise. */
START_TEST(independent_deviations)
{
	struct ts_rng rng = ts_rng_start(9, 1);
	struct ts_fit line;
	double y[5000];

	for (int k = 0; k < 5000; k++)
		y[k] = ts_rng_uniform(&rng) - 0.2 * k;
	ck_assert_int_eq(ts_fit_line(NULL, y, 5000, &line), TS_OK);
	ck_assert_double_eq_tol(ts_fit_correlation(y, &line), 1, 0.05);
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("math");
	TCase *tests = tcase_create("math");
	SRunner *runner;
	int failed;

	tcase_add_test(tests, correlated_deviations);
	tcase_add_test(tests, independent_deviations);
	tcase_add_test(tests, philox_known_answers);
	tcase_add_test(tests, rng_moments);
	tcase_add_test(tests, rng_is_a_function);
	tcase_add_test(tests, rng_of_streams);
	tcase_add_test(tests, exactsum_cancels);
	tcase_add_test(tests, exactsum_as_integers);
	tcase_add_test(tests, exactsum_range);
	tcase_add_test(tests, exactsum_rounding);
	tcase_add_test(tests, exactsum_order);
	tcase_add_test(tests, exactsum_together);
	tcase_add_test(tests, exactsum_special_among_many);
	tcase_add_test(tests, exactsum_integers);
	tcase_add_test(tests, vectors);
	tcase_add_test(tests, keys_sorted);
	tcase_add_test(tests, equal_keys_sorted);
	tcase_add_test(tests, pairs_found);
	suite_add_tcase(suite, tests);
	runner = srunner_create(suite);
	srunner_run_all(runner, CK_NORMAL);
	failed = srunner_ntests_failed(runner);
	srunner_free(runner);
	return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
