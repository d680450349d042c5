/* Numbers as text, beside printf. */
#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "asserts.h"
#include "io/decimal.h"

static void same_as_printf(double value)
{
	static const int digits[] = { 1, 2, 6, 15, 16, 17 };

	for (size_t k = 0; k < sizeof digits / sizeof *digits; k++) {
		char text[TS_DECIMAL_SIZE], expected[64];
		size_t n = ts_decimal_g(value, digits[k], text);

		snprintf(expected, sizeof expected, "%.*g", digits[k], value);
		ck_assert_msg(n == strlen(expected) && memcmp(text, expected, n) == 0,
			      "%a with %d digits is '%.*s', expected '%s'", value, digits[k], (int)n, text,
			      expected);
	}
}

/* Of all sizes, just half way between two roundings, and at the ends of both ways to write them. */
START_TEST(decimals)
{
	static const double some[] = { 0,
				       1,
				       0.5,
				       100000,
				       999999,
				       999999.5,
				       1e6,
				       1234565,
				       1234575,
				       0.0001,
				       0.00009999995,
				       9.9999995e-5,
				       1e-5,
				       1e22,
				       1e23,
				       9.999995e26,
				       1e27,
				       1e-17,
				       9.99e-18,
				       1e-22,
				       5e-324,
				       2.2250738585072014e-308,
				       1.7976931348623157e308,
				       4.35,
				       0.1,
				       2.5e-4,
				       INFINITY };
	uint64_t bits = 88172645463325252u;

	for (size_t k = 0; k < sizeof some / sizeof *some; k++)
		for (int sign = -1; sign <= 1; sign += 2) {
			same_as_printf(sign * some[k]);
			same_as_printf(sign * nextafter(some[k], INFINITY));
			same_as_printf(sign * nextafter(some[k], 0));
		}
	same_as_printf(NAN);
	for (int k = 0; k < 60000; k++) {
		double value, power = pow(10, k % 60 - 30);

		bits ^= bits << 13;
		bits ^= bits >> 7;
		bits ^= bits << 17;
		memcpy(&value, &bits, sizeof value);
		same_as_printf(value);
		same_as_printf((double)(bits % 4000001) * power);	  /* few digits */
		same_as_printf(((double)(bits % 1000000) + 0.5) * power); /* half way, or nearly */
		same_as_printf((double)(bits >> 11) / 9007199254740992.0 * power);
	}
}
END_TEST

START_TEST(whole_decimals)
{
	static const long long some[] = { 0, 1, -1, 9, 10, -10, 1234567890123, LLONG_MAX, LLONG_MIN };

	for (size_t k = 0; k < sizeof some / sizeof *some; k++) {
		char text[TS_DECIMAL_SIZE], expected[64];
		size_t n = ts_decimal_lld(some[k], text);

		snprintf(expected, sizeof expected, "%lld", some[k]);
		ck_assert_uint_eq(n, strlen(expected));
		ck_assert_mem_eq(text, expected, n);
	}
}
END_TEST

/* Whether the text is that of the fewest digits from 15 on which strtod reads as the value. */
static void shortest_of(double value)
{
	char text[TS_DECIMAL_SIZE], expected[64];
	size_t n = ts_decimal_shortest(value, text);

	for (int digits = 15; digits <= 17; digits++) {
		snprintf(expected, sizeof expected, "%.*g", digits, value);
		if (!(strtod(expected, NULL) < value) && !(strtod(expected, NULL) > value))
			break;
	}
	ck_assert_msg(n == strlen(expected) && memcmp(text, expected, n) == 0, "%a is '%.*s', expected '%s'",
		      value, (int)n, text, expected);
}

/* Of all sizes, of few digits, whole, and the neighbours of all. */
START_TEST(shortest_decimals)
{
	uint64_t bits = 88172645463325252u;

	for (int k = 0; k < 100000; k++) {
		double power = pow(10, k % 60 - 30), some[6] = { 0 };

		bits ^= bits << 13;
		bits ^= bits >> 7;
		bits ^= bits << 17;
		memcpy(some, &bits, sizeof *some);
		some[1] = (double)(bits % 4000001) * power;
		some[2] = (double)(bits >> 11) / 9007199254740992.0 * power;
		some[3] = (double)(bits >> (bits & 63));
		some[4] = (double)(bits % 1000) * 4.9406564584124654e-324;
		some[5] = (double)(bits % 10000) * 1e-311;
		for (int j = 0; j < 6; j++) {
			shortest_of(some[j]);
			shortest_of(-nextafter(some[j], INFINITY));
			shortest_of(nextafter(some[j], 0));
		}
	}
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("decimal");
	TCase *tests = tcase_create("decimal");
	SRunner *runner;
	int failed;

	suite_add_tcase(suite, tests);
	tcase_set_timeout(tests, 60);
	tcase_add_test(tests, decimals);
	tcase_add_test(tests, whole_decimals);
	tcase_add_test(tests, shortest_decimals);
	runner = srunner_create(suite);
	srunner_run_all(runner, CK_NORMAL);
	failed = srunner_ntests_failed(runner);
	srunner_free(runner);
	return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
