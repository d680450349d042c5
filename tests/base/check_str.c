/* Numbers from text, beside strtod. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "asserts.h"
#include "base/str.h"

static uint64_t bits = 88172645463325252u;

static uint64_t draw(void)
{
	bits ^= bits << 13;
	bits ^= bits >> 7;
	bits ^= bits << 17;
	return bits;
}

static void same_as_strtod(const char *text)
{
	double value = 0, expected = strtod(text, NULL);
	bool is = ts_parse_real(text, &value);

	ck_assert_msg(is == isfinite(expected) && (!is || memcmp(&value, &expected, sizeof value) == 0),
		      "'%s' is %a, expected %a", text, value, expected);
}

/* Of all sizes and numbers of digits, half way between two doubles, with zeros before and behind, and with exponents. */
START_TEST(reals)
{
	for (int k = 0; k < 100000; k++) {
		char text[128];
		uint64_t whole;
		double value;

		draw();
		memcpy(&value, &bits, sizeof value);
		snprintf(text, sizeof text, "%.*g", (int)(draw() % 20) + 1, value);
		if (isfinite(value))
			same_as_strtod(text);
		snprintf(text, sizeof text, "%.*g", (int)(draw() % 20) + 1, (double)draw() / 1e20);
		same_as_strtod(text);
		whole = draw() >> (draw() & 63);
		snprintf(text, sizeof text, "%s%llue%d", draw() & 1 ? "-" : "+", (unsigned long long)whole,
			 (int)(draw() % 700) - 350);
		same_as_strtod(text);
		snprintf(text, sizeof text, "%llu", (unsigned long long)(draw() >> 10 | 1)); /* half way */
		same_as_strtod(text);
		snprintf(text, sizeof text, "%0*llu.%0*llue%d", (int)(draw() % 30),
			 (unsigned long long)(draw() & 255), (int)(draw() % 30),
			 (unsigned long long)draw() >> (draw() & 63), (int)(draw() % 60) - 30);
		same_as_strtod(text);
	}
}
END_TEST

START_TEST(odd_reals)
{
	static const char *const good[] = {
		"0",
		"-0",
		"00012",
		"1.",
		"+.5",
		".0",
		"1E5",
		"1e-400",
		"0e999",
		"0e99999999999",
		"4.9e-324",
		"2.2250738585072011e-308",
		"1.7976931348623157e308",
		"9007199254740993",
		"1e22",
		"1e23",
		"18446744073709551616",
		"0.000000000000000000000000000000000000000000012345678901234567890"
	};
	static const char *const bad[] = { "",	  ".",	  "+",	   "-",	     "-.",   "e5",   "1e",
					   "1e+", "1e5x", "1.2.3", "--1",    "0x10", "nan",  "inf",
					   " 1",  "1 ",	  "1e400", "-1e309", "1,5",  "1e5.5" };
	double value = 7;

	for (size_t k = 0; k < sizeof good / sizeof *good; k++)
		same_as_strtod(good[k]);
	for (size_t k = 0; k < sizeof bad / sizeof *bad; k++)
		ck_assert_msg(!ts_parse_real(bad[k], &value), "'%s' is taken for %g", bad[k], value);
	ck_assert(value >= 7 && value <= 7);
}
END_TEST

START_TEST(whole_numbers)
{
	static const char *const good[] = { "0",
					    "-0",
					    "7",
					    "+7",
					    "-7",
					    "0000000000000000000000000000012",
					    "999999999999999999",
					    "-999999999999999999",
					    "1000000000000000000",
					    "9223372036854775807",
					    "-9223372036854775808" };
	static const char *const bad[] = { "",
					   "-",
					   "+",
					   "--1",
					   "1-2",
					   "1.",
					   "1e2",
					   " 1",
					   "9223372036854775808",
					   "-9223372036854775809",
					   "100000000000000000000" };
	int64_t value = 7;

	for (size_t k = 0; k < sizeof good / sizeof *good; k++) {
		ck_assert_msg(ts_parse_int(good[k], &value), "'%s' is refused", good[k]);
		ck_assert_int_eq(value, strtoll(good[k], NULL, 10));
	}
	value = 7;
	for (size_t k = 0; k < sizeof bad / sizeof *bad; k++)
		ck_assert_msg(!ts_parse_int(bad[k], &value), "'%s' is taken for a number", bad[k]);
	ck_assert_int_eq(value, 7);
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("str");
	TCase *tests = tcase_create("str");
	SRunner *runner;
	int failed;

	suite_add_tcase(suite, tests);
	tcase_set_timeout(tests, 60);
	tcase_add_test(tests, reals);
	tcase_add_test(tests, odd_reals);
	tcase_add_test(tests, whole_numbers);
	runner = srunner_create(suite);
	srunner_run_all(runner, CK_NORMAL);
	failed = srunner_ntests_failed(runner);
	srunner_free(runner);
	return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
