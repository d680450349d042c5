/* Scripts that are too deep, too long, circular, or torn: each ends with an error that names the place, or
 * runs. */
#include "script_case.h"

#include <time.h>
#include <unistd.h>

enum { DEEP = 10000, LONG = 1000000 };

/* A text of n copies of a piece, between others. Freed by the caller. */
static char *repeated(const char *before, const char *piece, size_t n, const char *after)
{
	size_t length = strlen(piece);
	char *text = malloc(strlen(before) + n * length + strlen(after) + 1), *to = text;

	ck_assert_ptr_nonnull(text);
	to += snprintf(to, strlen(before) + 1, "%s", before);
	for (size_t k = 0; k < n; k++, to += length)
		memcpy(to, piece, length);
	memcpy(to, after, strlen(after) + 1);
	return text;
}

static void expect_failure(char *script, const char *message)
{
	ck_assert_msg(tsim_string(sim, script) != 0, "no error: %.60s", script);
	ck_assert_msg(strstr(tsim_error(sim), message) != NULL, "%.60s gives: %s", script, tsim_error(sim));
	ck_assert_msg(strncmp(tsim_error(sim), "string:", 7) == 0, "no place: %s", tsim_error(sim));
	ck_assert_uint_lt(strlen(tsim_error(sim)), 3000);
	tsim_error_clear(sim);
	free(script);
}

static void expect_success(char *script)
{
	ck_assert_msg(tsim_string(sim, script) == 0, "%.60s: %.300s", script, tsim_error(sim));
	free(script);
}

START_TEST(deep_formulas)
{
	static const char *const openings[] = { "(",	 "sqrt(",      "1+(", "2^(-",
						"min([", "ternary(1,", "x[",  "1 == (" };

	for (size_t k = 0; k < sizeof openings / sizeof *openings; k++)
		expect_failure(repeated("variable a equal '", openings[k], DEEP, "1'\nprint ${a}\n"),
			       "nested too deeply");
	for (size_t k = 0; k < sizeof openings / sizeof *openings; k++)
		expect_failure(repeated("if '", openings[k], DEEP, "1' then 'print x'\n"),
			       "nested too deeply");
	/* what is long but not deep is no matter; signs are not deep */
	expect_success(repeated("variable s equal '", "-", 2 * DEEP, "2'\n"));
	expect_value("v_s", 2);
	expect_success(repeated("variable s equal '", "!", 2 * DEEP, "2'\n"));
	expect_value("v_s", 1);
	expect_success(repeated("variable b equal '1", "+1*1-1^2", 100 * DEEP, "'\n"));
	expect_value("v_b", 1);
	expect_success(repeated("variable c equal '", "(1)+", 10 * DEEP, "1'\n"));
	expect_value("v_c", 10 * DEEP + 1);
}
END_TEST

/* A chain of variables without a circle, too long for any stack. */
START_TEST(long_chain_of_variables)
{
	char *text = malloc((size_t)DEEP * 40), *to = text;

	ck_assert_ptr_nonnull(text);
	to += snprintf(to, 40, "variable a0 equal 1\n");
	for (int k = 1; k < DEEP; k++)
		to += snprintf(to, 40, "variable a%d equal v_a%d+1\n", k, k - 1);
	expect_success(text);
	expect_value("v_a400", 401);
	ck_assert_int_ne(tsim_value(sim, "v_a9999", &(double){ 0 }), 0);
	ck_assert_ptr_nonnull(strstr(tsim_error(sim), "nested too deeply"));
	tsim_error_clear(sim);
	expect_value("v_a400", 401);
}
END_TEST

START_TEST(circles)
{
	static const char uses_itself[] = "uses itself";

	expect_error("variable a equal v_b\nvariable b equal v_c\nvariable c equal v_a\nprint ${a}", 3, 18, 3,
		     uses_itself);
	expect_error("variable v vector v_v\nprint ${v}", 1, 19, 3, uses_itself);
	expect_error("variable v vector sum(v_v)\nprint $(v_v[1])", 1, 23, 3, uses_itself);
	expect_error("variable f format g %g\nvariable g format f %g\nprint ${f}", 2, 19, 1, uses_itself);
	expect_error("variable s index x\nvariable s delete\nvariable s equal ${s}", 3, 18, 4,
		     "unknown variable 's'");
	expect_error("variable t equal v_t\nif \"v_t > 1\" then \"print x\"", 1, 18, 3, uses_itself);
	/* commands that run themselves */
	expect_error("variable r string 'if 1 then \"${r}\"'\nif 1 then \"${r}\"", 2, 12, 4,
		     "nested more than 50 deep");
}
END_TEST

START_TEST(long_lines)
{
	expect_success(repeated("# ", "comment ", LONG / 8, "\n"));
	expect_success(repeated("variable w index ", "word ", LONG / 5, "\n"));
	expect_success(repeated("variable s string '", "$x don`t ", LONG / 9, "'\n"));
	expect_success(repeated("variable s string ", "&\n", LONG / 2, "short\nprint ${s}\n"));
	expect_success(repeated("variable x index 7\nvariable y index ", "$x ", LONG / 10, "\n"));
	expect_success(repeated("variable y index ", "\"a b\" ", LONG / 6, "\n"));
	expect_failure(repeated("print ", "word ", LONG / 5, "\n"), "unknown keyword");
	expect_failure(repeated("", "w", LONG, "\n"), "unknown command");
	expect_failure(repeated("print '", "w", LONG, "\n"), "this quote ' is never closed");
	expect_failure(repeated("print ", "\"\" ", LONG / 3, "\"\n"), "never closed");
	expect_failure(repeated("print ${", "w", LONG, "}\n"), "unknown variable");
	expect_failure(repeated("print ${", "w", LONG, "\n"), "'${' is never closed");
	expect_failure(repeated("print $(", "(", LONG, "\n"), "'$(' is never closed");
	expect_failure(repeated("print $(", "w", LONG, ")\n"), "unknown name");
	expect_failure(repeated("print $(c_", "w", LONG, ")\n"), "is malformed");
	expect_failure(repeated("print $(1", "0", LONG, ")\n"), "is not a number");
	expect_failure(repeated("print $(sqrt(1", ",1", LONG / 2, "))\n"), "takes 1 argument");
	expect_failure(repeated("print $(count(all", ",1", LONG / 2, "))\n"), "too many arguments");
	expect_failure(repeated("variable ", "w", LONG, " eqaul 1\n"), "did you mean 'equal'");
	expect_failure(repeated("jump SELF ", "w", LONG, "\n"), "there is no 'label");
	expect_failure(repeated("print \"\"\"", "a\n", LONG / 2, "\n"), "never closed");
}
END_TEST

START_TEST(torn_quotes)
{
	expect_error("print \"a", 1, 7, 1, "never closed");
	expect_error("print 'a\nprint b", 1, 7, 1, "never closed");
	expect_error("print \"\"\"a\nprint b", 1, 7, 1, "never closed");
	expect_error("if \"1\" then 'print \"a'", 1, 20, 1, "never closed");
	expect_error("if \"'a == 1\" then \"print x\"", 1, 5, 1, "never closed");
	expect_error("print $(", 1, 7, 2, "never closed");
	expect_error("print $", 1, 7, 1, "must be followed");
	expect_error("print ${}", 1, 7, 3, "unknown variable ''");
	expect_error("print $(c_a[)", 1, 12, 1, "found the end");
	expect_error("print $(sum([1)", 1, 7, 2, "'$(' is never closed");
}
END_TEST

START_TEST(values_that_are_none)
{
	expect_error("print $(1/0)", 1, 10, 1, "division of 1 by zero");
	expect_error("print $(1%0)", 1, 10, 1, "division of 1 by zero");
	expect_error("print $(0/0)", 1, 10, 1, "division of 0 by zero");
	expect_error("print $(0^-1)", 1, 10, 1, "too large");
	expect_error("print $(-8^(1/3))", 1, 11, 1, "not a real number");
	expect_error("print $(1e308*10)", 1, 14, 1, "too large");
	expect_error("print $(ln(0))", 1, 9, 5, "infinite");
	expect_error("print $(ln(-1))", 1, 9, 6, "not a real number");
	expect_error("print $(acos(2))", 1, 9, 7, "not a real number");
	expect_error("print $(1e999)", 1, 9, 5, "is not a number");
	expect_error("print $(inf)", 1, 9, 3, "unknown name 'inf'");
	expect_error("print $(nan+1)", 1, 9, 3, "unknown name 'nan'");
	expect_error("print $(ave(v_e))\n", 1, 13, 3, "unknown variable");
	expect_error("variable q atom random(0,1,5)\nprint ${q}", 2, 7, 4, "for each particle");
	expect_error("print $(random(0,1,0))", 1, 9, 13, "seed must be a positive");
	expect_error("print $(swiggle(1,2,0))", 1, 9, 14, "period must be positive");
}
END_TEST

/* Every piece of a script, cut off anywhere, ends well or with a message. */
START_TEST(cut_anywhere)
{
	static const char script[] =
		"variable a index 1 2 'x y' # c\nvariable b equal \"sqrt(4)+v_a*[\"\n"
		"variable c vector [1,$a,sum([2,3])]\nlabel top\nif \"$a == 1 && ('q r' != q)\" then &\n"
		"  'print \"\"\"in ${a:%.3f}\"\"\"' elif 0 \"jump SELF top\" else 'quit 3'\n"
		"print \"\"\"two\nlines $(v_c[2]:%g)\"\"\" screen no\nnext a\n";

	for (size_t n = 0; n < sizeof script; n++) {
		struct tsim *one = tsim_open();
		char part[sizeof script] = { 0 };

		memcpy(part, script, n);
		tsim_screen(one, NULL);
		if (tsim_string(one, part) != 0)
			ck_assert_ptr_nonnull(strstr(tsim_error(one), "string:"));
		tsim_close(one);
	}
}
END_TEST

/* No byte anywhere makes more than an error. */
START_TEST(any_byte)
{
	static const char script[] = "variable a equal v_b[2]+c_d*(1<2)\nif \"x\" then 'print $a'\n"
				     "print \"${b} $(1:%g)\"\n";

	for (size_t at = 0; at < sizeof script - 1; at++) {
		for (int byte = 1; byte < 256; byte++) {
			struct tsim *one = tsim_open();
			char text[sizeof script];

			memcpy(text, script, sizeof script);
			text[at] = (char)byte;
			tsim_screen(one, NULL);
			tsim_string(one, text);
			tsim_close(one);
		}
	}
}
END_TEST

START_TEST(odd_characters)
{
	expect_output("print 'm\xc2\xb3 \xe9' # \xb0 m\xc2\xb3 'open\nprint \xc3\xa9\n",
		      "m\xc2\xb3 \xe9\n\xc3\xa9\n");
	expect_output("\xef\xbb\xbfprint bom\n", "bom\n");
	expect_error("variable \xc3\xa9 index 1", 1, 10, 2, "letters, digits and _");
	expect_error("print $\xc3\xa9", 1, 7, 2, "unknown variable");
	expect_error("\xc2\xa0print x", 1, 1, 7, "unknown command");
	expect_error("print $(1 \xc3\x97 2)", 1, 11, 1, "expected an operator");
	expect_error("print $(3 \xe2\x88\x92 2)", 1, 11, 1, "expected an operator");
}
END_TEST

static void add(TCase *all)
{
	tcase_add_test(all, deep_formulas);
	tcase_add_test(all, long_chain_of_variables);
	tcase_add_test(all, circles);
	tcase_add_test(all, long_lines);
	tcase_add_test(all, torn_quotes);
	tcase_add_test(all, values_that_are_none);
	tcase_add_test(all, cut_anywhere);
	tcase_add_test(all, any_byte);
	tcase_add_test(all, odd_characters);
}

int main(void)
{
	return case_main("unbreakable", add);
}
