/* Lines, words, variables, formulas, flow of scripts. */
#include "math/fit.h"
#include "script_case.h"

START_TEST(precedence)
{
	expect_value("-2^2", 4);
	expect_value("2^3^2", 64);
	expect_value("2^-1", 0.5);
	expect_value("7-2-3", 2);
	expect_value("1+2*3.5", 8);
	expect_value("(1+2)*3.5", 10.5);
	expect_value("17%5*2", 4);
	expect_value("84/7/3", 4);
	expect_value("1 || 0 && 0", 1);
	expect_value("1<2 == 3<4", 1);
	expect_value("2 == 2 > 1", 0);
	expect_value("1+1 >= 2", 1);
	expect_value("!0+3", 4);
	expect_value("!(2>1)", 0);
	expect_value("3!=3", 0);
	expect_value("1 |^ 1", 0);
	expect_value("1.5e-3*2E3", 3);
	expect_value(".5+5.", 5.5);
	expect_value("--3", 3);
}
END_TEST

START_TEST(functions)
{
	expect_value("sqrt(7.29)", 2.7);
	expect_value("exp(ln(2.385))", exp(log(2.385)));
	expect_value("log(1000)", 3);
	expect_value("abs(-3.25)", 3.25);
	expect_value("cos(PI)", -1);
	expect_value("sin(0.3)^2+cos(0.3)^2", 1);
	expect_value("tan(atan(0.7))", tan(atan(0.7)));
	expect_value("asin(0.4)+acos(0.4)", asin(0.4) + acos(0.4));
	expect_value("atan2(-1,-1)", atan2(-1, -1));
	expect_value("ceil(2.1)+floor(2.9)+round(2.5)", 8);
	expect_value("round(-2.5)", -2);
	expect_value("round(-2.51)+round(0.49999999999999994)", -3);
	expect_value("vdisplace(3.5,100)", 3.5);
	expect_value("stagger(1000,100)", 100);
	expect_value("logfreq(10,4,10)", 10);
}
END_TEST

/* A seed has one stream; draws differ, stay within bounds, and start anew with another simulation.
 */
START_TEST(random_streams)
{
	double a = value("random(2,5,4711)"), b = value("random(2,5,4711)");
	struct tsim *other = tsim_open();
	double again;

	ck_assert(a > 2 && a < 5 && b > 2 && b < 5 && (a < b || a > b));
	ck_assert_int_eq(tsim_value(other, "random(2,5,4711)", &again), 0);
	ck_assert(again >= a && again <= a);
	ck_assert_int_eq(tsim_value(other, "random(2,5,4712)", &again), 0);
	ck_assert(again < a || again > a);
	ck_assert_int_eq(tsim_value(other, "normal(0,1,3)", &again), 0);
	tsim_close(other);
}
END_TEST

START_TEST(formula_errors)
{
	expect_error("variable a equal 3/(2-2)\nprint \"$a\"", 1, 19, 1, "division of 3 by zero");
	expect_error("print \"$(7 % 0)\"", 1, 12, 1, "division of 7 by zero");
	expect_error("print \"$(sqrt(-4))\"", 1, 10, 8, "not a real number");
	expect_error("print \"x $(exp(1e4)) y\"", 1, 12, 8, "infinite");
	expect_error("print \"$(10^400)\"", 1, 12, 1, "too large");
	expect_error("print \"$(sqr(4))\"", 1, 10, 3, "did you mean 'sqrt'");
	expect_error("print \"$(2*v_widht)\"", 1, 12, 7, "unknown variable 'widht'");
	expect_error("variable width equal 2\nprint \"$(2*v_widht)\"", 2, 12, 7, "did you mean 'width'");
	expect_error("print \"$(2*width)\"", 1, 12, 5, "did you mean 'v_width'");
	expect_error("print \"$(atan2(1))\"", 1, 10, 8, "takes 2 arguments, found 1");
	expect_error("print \"$(sin(1,2))\"", 1, 10, 6, "takes 1 argument");
	expect_error("print \"$(sin())\"", 1, 10, 5, "takes 1 argument, found 0");
	expect_error("print \"$(2+)\"", 1, 11, 1, "found the end of the formula");
	expect_error("print \"$((2+3)\"", 1, 8, 2, "'$(' is never closed");
	expect_error("variable f string a\nprint \"$(is_file(${f}))\"", 2, 18, 4, "not replaced inside $( )");
	expect_error("print \"$(2 3)\"", 1, 12, 1, "expected an operator");
	expect_error("print \"$(2+3x)\"", 1, 12, 2, "'3x' is not a number");
	expect_error("print \"$(1.2.3)\"", 1, 10, 5, "'1.2.3' is not a number");
	expect_error("print \"$(2 + #)\"", 1, 14, 1, "expected a number or a name, found '#'");
	expect_error("print \"$(random(0,1,-5))\"", 1, 10, 14, "seed must be");
	expect_error("print \"$(slope(v_width))\"", 1, 16, 7, "vector of a compute or fix");
	expect_error("print \"$(slope(c_none))\"", 1, 16, 6, "none");
	expect_error("print \"$(normal(0,-1,5))\"", 1, 10, 14, "must not be negative");
}
END_TEST

START_TEST(circular_variables)
{
	expect_error("variable p equal v_q+1\nvariable q equal 2*v_p\nprint \"${p}\"", 2, 20, 3,
		     "formula of variable 'p' uses itself");
	/* and can be used again afterwards */
	expect_output("variable q equal 2.5\nprint \"${p}\"\n", "3.5\n");
}
END_TEST

START_TEST(deep_formula)
{
	char text[2000];

	memset(text, '(', 999);
	text[999] = '\0';
	ck_assert_int_ne(tsim_value(sim, text, &(double){ 0 }), 0);
	ck_assert_ptr_nonnull(strstr(tsim_error(sim), "nested too deeply"));
}
END_TEST

START_TEST(substitution)
{
	expect_output("variable long index 7.25\nvariable x string ab\n"
		      "print \"${long} $x${x} $(v_long*2)\"\n",
		      "7.25 abab 14.5\n");
	expect_output("variable third equal 1/3\nprint \"${third} $(1/3)\"\n",
		      "0.333333333333333 0.33333333333333331483\n");
	expect_output("print \"$(2/3:%.3f) $(1e5:%g) $(-2:%+08.2e)\"\n", "0.667 100000 -2.00e+00\n");
	/* quotes inside the text of print keep what is in them */
	expect_output("print \"'$x' $x don't $x\"\n", "'$x' ab don't ab\n");
	/* v_ follows, ${} is frozen */
	expect_output("variable b equal 2\nvariable f equal ${b}*10\nvariable g equal v_b*10\n"
		      "variable b equal 3\nprint \"${f} ${g}\"\n",
		      "20 30\n");
	expect_error("print ${lnog}", 1, 7, 7, "did you mean 'long'");
	expect_error("print a${long", 1, 8, 2, "'${' is never closed");
	expect_error("print \"a $ b\"", 1, 10, 1, "must be followed by the name");
	expect_error("print $(2:%s)", 1, 11, 2, "expected a format");
	expect_output("print '$(2.5:%d) $(-2:%03d) ${b:%5.2f}| $(50:%g%%)'\n", "3 -02  3.00| 50%\n");
	expect_error("print $()", 1, 7, 3, "needs a formula");
}
END_TEST

START_TEST(words_and_comments)
{
	expect_output("print one # two\n", "one\n");
	expect_output("print \"one # two\" # three\n", "one # two\n");
	expect_output("   \t\n# don't\nprint 'a \"b\" c'\n", "a \"b\" c\n");
	expect_output("print \"\"\"a \"b\" 'c'\"\"\"\n", "a \"b\" 'c'\n");
	expect_output("print \"one &\n  two\"\n", "one   two\n");
	expect_output("print \"\"\"one\n two\"\"\"\n", "one\n two\n");
	/* a comment that ends in & swallows the next line */
	expect_output("# note &\nprint lost\nprint kept\n", "kept\n");
	/* & before a comment does not continue: it is a word */
	expect_error("print one & # note\n", 1, 11, 1, "&");
	expect_output("print a\r\nprint b\r\n", "a\nb\n");
	expect_error("print \"a\"b", 1, 9, 2, "a blank must follow the closing quote");
	expect_error("print \"abc", 1, 7, 1, "never closed");
}
END_TEST

/* Places survive joined lines and substitution. */
START_TEST(places)
{
	expect_error("variable n index 12\nprint ok &\n  scren no", 3, 3, 5, "did you mean");
	expect_error("variable cmd index prnit\n\n  ${cmd} x", 3, 3, 6, "did you mean 'print'");
	expect_error("variable who index a\nprnit ${who}", 2, 1, 5, "did you mean 'print'");
	expect_error("if \"1 > 0\" then \"print x\" \"prnit y\"", 1, 28, 5, "did you mean 'print'");
	expect_error("if \"3 > two\" then \"print x\"", 1, 9, 3, "'two' is a word here");
	ck_assert_int_ne(tsim_string(sim, "\n\tprnit x\n"), 0);
	ck_assert_str_eq(tsim_error(sim),
			 "string:2:2: error: unknown command 'prnit'; did you mean 'print'?\n"
			 "  \tprnit x\n"
			 "  \t^~~~~\n");
}
END_TEST

START_TEST(echo_shows_each_step)
{
	expect_output("echo screen\nvariable a index 5\nprint $a/$a   # twice\n", "variable a index 5\n"
										  "print $a/$a   # twice\n"
										  "print 5/$a   \n"
										  "print 5/5   \n"
										  "5/5\n");
}
END_TEST

START_TEST(variable_rules)
{
	ck_assert_int_eq(tsim_variable(sim, "wob", "17.5"), 0);
	expect_output("variable wob index 3\nprint ${wob}\n", "17.5\n");
	expect_output("variable s string a\nvariable s string b\nprint $s\n", "b\n");
	expect_output("variable n loop 8 10 pad\nprint $n\nnext n\nprint $n\n", "08\n09\n");
	expect_output("variable n delete\nvariable n loop 2\nprint $n\n", "1\n");
	expect_error("shell putenv TS_TEST=north", 1, 7, 6, "only with the option -shell yes");
	ts_script_allow_programs(sim->script_api_data, true);
	expect_output("shell putenv TS_TEST=north\nvariable e getenv TS_TEST\nprint $e\n", "north\n");
	ts_script_allow_programs(sim->script_api_data, false);
	expect_output("variable u universe 4\nprint $u\n", "4\n");
	expect_error("variable wob equal 3", 1, 10, 3, "exists with style index");
	expect_error("variable a-b index 3", 1, 10, 3, "letters, digits and _");
	expect_error("variable k equal 1 + 2", 1, 20, 1, "takes one word");
	expect_error("variable k loop 5 3", 1, 17, 1, "has no values");
	expect_error("variable k loop x", 1, 17, 1, "whole number");
	expect_error("variable k eqaul 1", 1, 12, 5, "did you mean 'equal'");
	expect_error("variable k index", 1, 10, 1, "needs a value");
	expect_output("variable none delete\n", "");
	expect_error("next s", 1, 6, 1, "index, loop or file variable");
	expect_error("variable w index abc\nvariable z equal v_w*2\nprint $z", 2, 18, 3,
		     "'abc', which is no number");
	expect_error("variable at atom x\nprint ${at}", 2, 7, 5, "for each particle");
}
END_TEST

START_TEST(loops)
{
	expect_output("variable i loop 3\nlabel top\nprint $i\nnext i\njump SELF top\nprint end\n",
		      "1\n2\n3\nend\n");
	/* the exhausted variable is gone */
	expect_error("print $i", 1, 7, 2, "unknown variable 'i'");
	expect_output("variable i loop 3\nvariable w index a b c\nlabel top\nprint $i$w\n"
		      "next i w\njump SELF top\n",
		      "1a\n2b\n3c\n");
	/* a loop in a loop; the inner one starts anew */
	expect_output("variable i loop 2\nlabel outer\nvariable j loop 2\nlabel inner\n"
		      "print $i$j\nnext j\njump SELF inner\nnext i\njump SELF outer\n",
		      "11\n12\n21\n22\n");
	/* skipped lines are not read, let alone substituted */
	expect_output("jump SELF over\nprint ${nothing} \"\nlabel over\nprint here\n", "here\n");
	expect_error("print a\njump SELF nowhere\n", 2, 11, 7, "no 'label nowhere'");
}
END_TEST

START_TEST(conditions)
{
	expect_output("variable n index 4\n"
		      "if \"${n} > 3 && ${n} != 5\" then \"print yes\" \"print again\" else 'print no'\n",
		      "yes\nagain\n");
	expect_output("if \"$n == 3\" then \"print 3\" elif \"$n == 4\" \"print four\" else \"print e\"\n",
		      "four\n");
	expect_output("if \"$n == 1\" then \"print 1\" elif \"$n == 2\" then \"print 2\" else \"print e\"\n",
		      "e\n");
	expect_output("if \"0\" then \"print 0\"\nif 1 then \"print 1\"\n", "1\n");
	expect_output("variable mode index drill\nif \"${mode} == drill\" then \"print a\"\n"
		      "if \"${mode} != drill\" then \"print b\" else \"print c\"\n"
		      "if \"${mode} == 'drill'\" then \"print d\" &\n\n",
		      "a\nc\nd\n");
	/* bare words may be paths; in formulas the same signs calculate */
	expect_output("variable f index /tmp/x-1/rock.7\nif \"${f} == make\" then \"print m\" else \"print "
		      "r\"\n"
		      "if \"${f} == /tmp/x-1/rock.7\" then \"print same\"\n"
		      "variable g index ../q\nif \"${g} != ../q\" then \"print wrong\"\n"
		      "variable v equal 7\nif \"v_v/2 == 3.5 && 4-1 == 3\" then \"print half\"\n",
		      "r\nsame\nhalf\n");
	/* what stands behind a jump is not run */
	expect_output("if \"1\" then \"jump SELF out\" \"print wrong\"\nprint wrong\nlabel out\n"
		      "print right\n",
		      "right\n");
	expect_output("if \"yes && !(no || off)\" then \"print a\"\nif \"yes == true\" then \"print b\"\n"
		      "if \"(1 > 2 |^ 3 == 3) && 'a b' == ' a b'\" then \"print c\" else \"print d\"\n"
		      "if property_youngsModulus then \"print e\" else \"print f\"\n"
		      "if \"!property_k && 1\" then \"print g\"\n",
		      "a\nd\nf\ng\n");
	expect_output("partition yes 1 print a\npartition no 1 print b\npartition no 2* print c\n"
		      "partition yes 2*4 print d\npartition yes * print e\n",
		      "a\nc\ne\n");
	expect_error("partition yes 0 print a", 1, 15, 1, "expected numbers of partitions");
	expect_error("partition yes x print a", 1, 15, 1, "expected numbers of partitions");
	expect_error("partition yes 1 prnit a", 1, 17, 5, "did you mean 'print'");
	expect_error("if 1 then \"include x\"", 1, 12, 7, "include is not allowed within an if");
	expect_error("python f input 1", 1, 1, 6, "Python in scripts is not supported");
	expect_error("if \"1\" \"print x\"", 1, 1, 2, "expected");
	expect_error("if \"1\" than \"print x\"", 1, 8, 4, "expected 'then'");
	expect_error("if \"0\" then \"print x\" else", 1, 23, 4, "expected a command");
	expect_error("if \"1 >\" then \"print x\"", 1, 7, 1, "found the end");
	expect_error("if \"a < b\" then \"print x\"", 1, 5, 1, "'a' is a word");
}
END_TEST

START_TEST(quit_ends_all)
{
	int status;

	expect_output("print a\nif \"1\" then \"quit 3\"\nprint b\n", "a\n");
	ck_assert(ts_script_quit(sim->script_api_data, &status));
	ck_assert_int_eq(status, 3);
}
END_TEST

START_TEST(files)
{
	char line[64];
	FILE *file;

	enter_directory();
	write_file("inner.in", "print \"inner ${v}\"\nvariable k loop 2\nlabel again\nprint $k\n"
			       "next k\njump SELF again\n");
	write_file("self.in", "include self.in\n");
	write_file("other.in", "print lost\nlabel here\nprint found\n");
	write_file("bad.in", "print fine\n  prnit x\n");
	expect_output("variable v index 9\ninclude inner.in\nprint outer\n", "inner 9\n1\n2\nouter\n");
	expect_output("jump other.in here\nprint never\n", "found\n");
	expect_error("include self.in", 1, 9, 7, "more than 50 deep");
	expect_error("include none.in", 1, 9, 7, "cannot open script 'none.in'");
	expect_error("include bad.in", 2, 3, 5, "unknown command 'prnit'");
	expect_output("print \"x $v\" append out.txt screen no\nprint y append out.txt\n", "y\n");
	file = fopen("out.txt", "r");
	ck_assert_ptr_nonnull(fgets(line, sizeof line, file));
	ck_assert_str_eq(line, "x 9\n");
	ck_assert_ptr_nonnull(fgets(line, sizeof line, file));
	ck_assert_str_eq(line, "y\n");
	fclose(file);
	expect_output("shell mkdir post\nshell mkdir post\nshell mv out.txt post/a\nshell rm post/a\n"
		      "shell rmdir post\nshell rm inner.in self.in other.in bad.in\n",
		      "");
	expect_output("log one.log\nprint a\nlog none\nprint b\nlog one.log append\nprint c\nlog none\n",
		      "a\nb\nc\n");
	file = fopen("one.log", "r");
	ck_assert_ptr_nonnull(file);
	line[fread(line, 1, sizeof line - 1, file)] = '\0';
	fclose(file);
	ck_assert_str_eq(line, "a\nc\n");
	expect_output("shell rm one.log\n", "");
	expect_output("shell mkdir -p a/b/c a/d\nshell cd a/b/c\nshell cd ../../..\n"
		      "shell rmdir a/b/c a/b a/d a\n",
		      "");
	ck_assert_int_eq(sim->log.warnings, 0);
	ck_assert_int_eq(tsim_string(sim, "shell rm -rf nothing\nshell rmdir nothing"), 0);
	ck_assert_int_eq(sim->log.warnings, 2);
	expect_error("shell cd nowhere", 1, 10, 7, "failed: No such file");
	expect_error("shell mkdir /dev/null/x", 1, 13, 11, "failed");
	expect_error("shell touch program", 1, 7, 5, "only with the option -shell yes");
	ts_script_allow_programs(sim->script_api_data, true);
	expect_output("shell echo written >program\nshell rm program\n", "");
	ts_script_allow_programs(sim->script_api_data, false);
	file = fopen("stdin.in", "w+");
	fputs("print a\njump SELF\n", file);
	rewind(file);
	ck_assert_int_ne(ts_script_stream(sim->script_api_data, file, "stdin"), TS_OK);
	ck_assert_ptr_nonnull(strstr(tsim_error(sim), "stdin:2:6: error: a script on standard input"));
	tsim_error_clear(sim);
	fclose(file);
	expect_output("shell rm stdin.in\n", "");
	expect_error("shell mkdr a", 1, 7, 4, "did you mean 'mkdir'");
	leave_directory();
}
END_TEST

START_TEST(unused_variables)
{
	ck_assert_int_eq(tsim_variable(sim, "viscosty", "3"), 0);
	ck_assert_int_eq(tsim_variable(sim, "used", "3"), 0);
	expect_output("variable used index 1\nprint ${used}\n", "3\n");
	ts_script_warn_unused(sim->script_api_data);
	ck_assert_int_eq(sim->log.warnings, 1);
}
END_TEST

/* Quote ends, and how a place is found inside a word. */
START_TEST(text_helpers)
{
	struct ts_place word = { "f", "  'abc'", 1, 3, 5 }, place;

	ck_assert_uint_eq(ts_quote_end("a'b'c", 1), 4);
	ck_assert_uint_eq(ts_quote_end("don't", 3), 3);
	ck_assert_uint_eq(ts_quote_end("\"\"\"a\"b\"\"\"c", 0), 9);
	ck_assert(!ts_line_quote_open("a # \"\"\""));
	ck_assert(ts_line_quote_open("a \"\"\"b"));
	place = ts_place_inside(&word, 3, 1, 2);
	ck_assert_int_eq(place.column, 5);
	ck_assert_int_eq(place.length, 2);
	/* not what was written: the whole word */
	place = ts_place_inside(&word, 7, 1, 2);
	ck_assert_int_eq(place.column, 3);
	ck_assert_int_eq(place.length, 5);
}
END_TEST

/* y = 3.1 - 0.7 x with known deviations; standard error from the closed form. */
START_TEST(straight_line)
{
	double x[] = { 0.5, 1.5, 4, 7.25 }, d[] = { 0.01, -0.02, 0.015, -0.005 }, y[4];
	double mx = 0, my = 0, sxx = 0, sxy = 0, rss = 0, slope;
	struct ts_fit fit;

	for (int i = 0; i < 4; i++) {
		y[i] = 3.1 - 0.7 * x[i] + d[i];
		mx += x[i] / 4;
		my += y[i] / 4;
	}
	for (int i = 0; i < 4; i++) {
		sxx += (x[i] - mx) * (x[i] - mx);
		sxy += (x[i] - mx) * (y[i] - my);
	}
	slope = sxy / sxx;
	for (int i = 0; i < 4; i++)
		rss += pow(y[i] - my - slope * (x[i] - mx), 2);
	ck_assert_int_eq(ts_fit_line(x, y, 4, &fit), TS_OK);
	ck_assert_double_eq_tol(fit.slope, slope, 1e-14);
	ck_assert_double_eq_tol(fit.intercept, my - slope * mx, 1e-14);
	ck_assert_double_eq_tol(fit.residual, rss, 1e-15);
	ck_assert_double_eq_tol(fit.slope_error, sqrt(rss / 2 / sxx), 1e-13 * sqrt(rss / 2 / sxx));
	ck_assert_int_eq(ts_fit_line(NULL, (double[]){ 2, 2.5, 3 }, 3, &fit), TS_OK);
	ck_assert_double_eq_tol(fit.slope, 0.5, 1e-15);
	ck_assert_int_eq(ts_fit_line(NULL, y, 1, &fit), TS_RANGE);
	ck_assert_int_eq(ts_fit_line((double[]){ 3, 3, 3 }, y, 3, &fit), TS_RANGE);
	ck_assert_int_eq(ts_fit_line(NULL, (double[]){ 2, NAN, 3 }, 3, &fit), TS_RANGE);
	ck_assert_int_eq(ts_fit_line(NULL, (double[]){ 2, 5 }, 2, &fit), TS_OK);
	ck_assert(fit.slope_error == 0);
}
END_TEST

/* Every allocation of a script with a bit of everything may fail. */
START_TEST(out_of_memory)
{
	static const char script[] = "variable a equal 2*3+sqrt(4)\nvariable i loop 2\nlabel top\n"
				     "if \"v_a > 1 && $i == 1\" then \"print 'x $(v_a)'\"\n"
				     "next i\njump SELF top\nprint \"${a} random(1,2,9)\"\n"
				     "variable v vector sort([3,v_a,1])\nvariable f format a %.2f\n"
				     "print '${f} ${v} ${a:%g} $(sum(v_v)+v_v[2]+random(0,1,5))'\n"
				     "variable w vector sqrt(v_v)*2\nprint ${w}\nvariable t timer\n"
				     "partition yes 1 print \"$(is_defined(variable,t):%d)\"\n";
	int failures = 0;

	for (long k = 1; k < 4000; k++) {
		long before = ts_alloc_balance();
		struct tsim *one;
		int status = 0;

		ts_alloc_fail_at(k);
		one = tsim_open();
		if (one)
			status = tsim_string(one, script);
		ts_alloc_fail_at(0);
		if (one && status == 0) {
			tsim_close(one);
			ck_assert_int_gt(failures, 20);
			return;
		}
		ck_assert_msg(!one || status == (int)TS_NOMEM, "allocation %ld: %s", k, tsim_error(one));
		failures++;
		tsim_close(one);
		ck_assert_int_eq(ts_alloc_balance(), before);
	}
	ck_abort_msg("the script never succeeded");
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("script");
	TCase *script = tcase_create("script"), *plain = tcase_create("plain");
	SRunner *runner;
	int failed;

	tcase_add_checked_fixture(script, case_setup, case_teardown);
	tcase_add_test(script, precedence);
	tcase_add_test(script, functions);
	tcase_add_test(script, random_streams);
	tcase_add_test(script, formula_errors);
	tcase_add_test(script, circular_variables);
	tcase_add_test(script, deep_formula);
	tcase_add_test(script, substitution);
	tcase_add_test(script, words_and_comments);
	tcase_add_test(script, places);
	tcase_add_test(script, echo_shows_each_step);
	tcase_add_test(script, variable_rules);
	tcase_add_test(script, loops);
	tcase_add_test(script, conditions);
	tcase_add_test(script, quit_ends_all);
	tcase_add_test(script, files);
	tcase_add_test(script, unused_variables);
	suite_add_tcase(suite, script);
	tcase_add_test(plain, text_helpers);
	tcase_add_test(plain, straight_line);
	tcase_add_test(plain, out_of_memory);
	suite_add_tcase(suite, plain);
	runner = srunner_create(suite);
	srunner_run_all(runner, CK_NORMAL);
	failed = srunner_ntests_failed(runner);
	srunner_free(runner);
	return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
