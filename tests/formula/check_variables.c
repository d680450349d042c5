/* Styles of variables. */
#include "script_case.h"

#include <unistd.h>

/* Defining one that exists: some styles keep the old one, the others replace it, none changes style. */
START_TEST(redefinition)
{
	enter_directory();
	write_file("a.txt", "7.5\n8.5\n");
	write_file("b.txt", "1\n");
	write_file("s.txt", "1\n1 2.5\n");
	expect_output("variable a index 1 2\nvariable a index 3\nprint $a\n"
		      "variable b loop 5\nvariable b loop 7 9\nprint $b\n"
		      "variable c world x\nvariable c world y\nprint $c\n"
		      "variable d universe p q\nvariable d universe r\nprint $d\n"
		      "variable e uloop 4 pad\nvariable e uloop 10\nprint $e\n"
		      "variable f file a.txt\nvariable f file b.txt\nprint $f\n"
		      "variable s atomfile s.txt\nvariable s atomfile none.txt\n",
		      "1\n1\nx\np\n1\n7.5\n");
	expect_output("variable g string 1\nvariable g string 2\nprint $g\n"
		      "variable h equal 1\nvariable h equal 2\nprint $h\n"
		      "variable i internal 1\nvariable i internal 2.5\nprint $i\n"
		      "variable j format h %.1f\nvariable j format h %.3f\nprint $j\n"
		      "variable k vector [1]\nvariable k vector [1,2]\nprint $k\n"
		      "variable t timer\nvariable t timer\n",
		      "2\n2\n2.5\n2.000\n[1,2]\n");
	expect_error("variable g equal 3", 1, 10, 1, "exists with style string");
	expect_error("variable a string 3", 1, 10, 1, "exists with style index");
	expect_output("variable g delete\nvariable g equal 3\nprint $g\n", "3\n");
	ck_assert_int_eq(unlink("a.txt") + unlink("b.txt") + unlink("s.txt"), 0);
	leave_directory();
}
END_TEST

START_TEST(lists_of_words)
{
	expect_output("variable w universe a b\nprint $w\nnext w\nprint $w\nnext w\n"
		      "jump SELF nowhere\nprint gone\n",
		      "a\nb\ngone\n");
	expect_output("variable u uloop 9 11\n", "");
	expect_output("variable n loop 9 10 pad\nprint $n\nnext n\nprint $n\n", "09\n10\n");
	expect_output("variable m loop -1 1\nprint $m\nnext m\nprint $m\nnext m\nprint $m\n", "-1\n0\n1\n");
	expect_error("variable v world a b", 1, 20, 1, "takes one word");
	expect_error("variable v loop 1 2 3", 1, 21, 1, "takes 'N', 'N1 N2'");
	expect_error("variable v loop 1 2 3 pad", 1, 23, 3, "takes 3 words");
	expect_error("variable v loop pad", 1, 17, 3, "whole number");
	expect_error("variable v loop 2.5", 1, 17, 3, "whole number");
	expect_error("variable v loop 0", 1, 17, 1, "has no values");
	expect_error("variable v world a\nnext v", 2, 6, 1, "style world");
}
END_TEST

START_TEST(values_from_files)
{
	enter_directory();
	write_file("a.txt", "# heights\n\n 7.25 metres\n\t8.5 # last but one\nnorth");
	expect_output("variable f file a.txt\nprint $f\nnext f\nprint $(v_f*2)\nnext f\nprint $f\n"
		      "next f\njump SELF nowhere\n",
		      "7.25\n17\nnorth\n");
	/* gone, so it can be opened anew; next() in a formula gives the present one and goes on */
	expect_output("variable f file a.txt\nvariable g equal next(f)+0.5\nprint $g\nprint $g\n",
		      "7.75\n9\n");
	expect_error("print $g", 2, 23, 1, "'north', which is no number");
	expect_error("variable q file none.txt", 1, 17, 8, "cannot open 'none.txt'");
	write_file("a.txt", "# nothing\n");
	expect_error("variable q file a.txt", 1, 17, 5, "has no values");
	write_file("a.txt", "2\n1 7.5\n2 x\n");
	expect_error("variable q atomfile a.txt", 3, 3, 1, "expected a number, found 'x'");
	write_file("a.txt", "3\n1 7.5\n");
	expect_error("variable q atomfile a.txt", 3, 0, 0, "2 more were announced");
	write_file("a.txt", "2\n1 7.5 8\n");
	expect_error("variable q atomfile a.txt", 2, 1, 1, "found 3 words");
	write_file("a.txt", "-1\n");
	expect_error("variable q atomfile a.txt", 1, 1, 2, "number of values");
	expect_error("variable e equal 1\nprint $(next(e))", 2, 14, 1, "needs a variable of style file");
	ck_assert_int_eq(unlink("a.txt"), 0);
	leave_directory();
}
END_TEST

static const char three[] = "boundary f f f\n"
			    "region box block -1 2 -1 2 -1 2 units box\n"
			    "create_box 2 box\n"
			    "create_atoms 1 single 0.385 0 0 units box\n"
			    "create_atoms 2 single 1.1 0.2 0 units box\n"
			    "create_atoms 1 single 0.7 0.9 -0.3 units box\n"
			    "region low block -1 1 INF INF INF INF units box\n"
			    "group first id 1 2\n";

START_TEST(values_of_particles)
{
	enter_directory();
	write_file("a.txt", "2\n1 7.25\n3 2.385\n# second set\n1\n2 4\n");
	ck_assert_int_eq(tsim_string(sim, three), 0);
	expect_output("variable a atom x*10+id\nvariable b atomfile a.txt\n"
		      "variable c atom v_b+gmask(first)*100+rmask(low)*10000+grmask(first,low)*1e6\n"
		      "variable d atom type==1\n",
		      "");
	expect_value("v_a[2]", 13);
	expect_value("v_b[1]+v_b[2]*10+v_b[3]*100", 7.25 + 238.5);
	expect_value("v_c[1]", 1010107.25);
	expect_value("v_c[2]", 100);
	expect_value("v_c[3]", 10002.385);
	expect_value("v_d[1]+10*v_d[2]+100*v_d[3]", 101);
	expect_value("x[1+2]+x[v_d[1]]", 0.7 + 0.385);
	expect_output("variable e atom next(b)\n", "");
	expect_value("v_e[3]", 2.385);
	expect_value("v_e[2]", 4);
	expect_error("print $(v_e[2])", 1, 22, 1, "unknown variable 'b'");
	expect_error("print $(v_a[7])", 1, 9, 6, "no particle with id 7");
	expect_error("print $(v_a)", 1, 9, 3, "a value for each particle");
	expect_error("print $(x[0])", 1, 10, 3, "from 1 on");
	expect_error("print $(x[1.5])", 1, 10, 5, "whole number");
	expect_error("print $(gmask(all))", 1, 9, 10, "style atom");
	ck_assert_int_eq(unlink("a.txt"), 0);
	leave_directory();
}
END_TEST

START_TEST(vectors)
{
	expect_output("variable v vector [1,2.5,2^3]\nvariable n index 2\nprint ${v}\n"
		      "variable w vector v_v*2+v_v[1]\nprint '${w} $(v_w[2]) $(v_w[v_n+1])'\n"
		      "variable s vector sort([3,-1,2])\nvariable r vector rsort(v_s)\n"
		      "print '${s} ${r}'\n"
		      "variable m vector sqrt(v_v^2)\nprint ${m}\n"
		      "variable one vector 7\nprint ${one}\n"
		      "variable p vector atan2([1,1],[1,-1])*4/PI\nprint ${p}\n",
		      "[1,2.5,8]\n[3,6,17] 6 17\n[-1,2,3] [3,2,-1]\n[1,2.5,8]\n[7]\n[1,3]\n");
	expect_value("sum(v_v)+ave([1,2,6])+min(v_s)+max(v_s)", 11.5 + 3 - 1 + 3);
	expect_value("length([1,2,4])", 3);
	expect_value("trap([1,2,4])+slope([1,3,5.5])", 4.5 + 2.25);
	expect_value("sum([2])+trap([7])", 2);
	expect_value("sum([max([1,5]),2,3,4])", 14);
	expect_value("max([sum([1,2]),sum([30,4,5]),7])", 39);
	expect_error("print $(v_v[4])", 1, 9, 6, "variable 'v' has 3");
	expect_error("print $(v_v)", 1, 9, 3, "v_v[k]");
	expect_error("print $([1,2])", 1, 9, 1, "a list [..]");
	expect_error("print $(sort([1,2]))", 1, 9, 11, "gives a list");
	expect_error("print $(slope(7))", 1, 15, 1, "expected a list");
	expect_error("print $(slope([7]))", 1, 9, 10, "at least 2 numbers");
	expect_error("variable q vector v_v+[1,2]\nprint ${q}", 1, 19, 9, "lists of 3 and 2 numbers");
	expect_error("variable q vector [1,]\nprint ${q}", 1, 22, 1, "expected a number or a name");
	expect_error("variable q vector [1\nprint ${q}", 1, 20, 1, "found the end");
	expect_error("print $(v_n[1])", 1, 9, 6, "has one value");
}
END_TEST

/* A vector and its elements where styles read numbers. */
START_TEST(vectors_as_inputs)
{
	ck_assert_int_eq(tsim_string(sim, three), 0);
	expect_output("variable v vector [1,2.5,count(all)]\n"
		      "fix a all ave/time 1 1 1 v_v mode vector\nfix b all vector 1 v_v[3]\n"
		      "fix m all nve\ntimestep 1e-3\nthermo_style custom step\n",
		      "");
	ck_assert_int_eq(tsim_string(sim, "run 2"), 0);
	expect_value("f_a[2]", 2.5);
	expect_value("f_b[1]+sum(f_b)", 3 + 9);
	expect_value("sum(f_a)", 6.5);
}
END_TEST

START_TEST(formatted)
{
	expect_output("variable x equal 2/3\nvariable f format x %8.3f|\nvariable g format f %.1f\n"
		      "print '${f}${x:%.2e}'\nvariable h format x '%+.1f %%'\nprint '${h}'\n",
		      "   0.667|6.67e-01\n+0.7 %\n");
	expect_error("variable k format x %s", 1, 21, 2, "expected a format");
	expect_error("variable k format x %f%f", 1, 21, 4, "expected a format");
	expect_error("variable k format x none", 1, 21, 4, "expected a format");
	expect_error("variable k format x %*f", 1, 21, 3, "expected a format");
	expect_error("variable k format x %1000f", 1, 21, 6, "expected a format");
	expect_error("variable k format x", 1, 10, 1, "NAME FORMAT");
	expect_error("variable k format none %g\nprint $k", 1, 19, 4, "unknown variable 'none'");
	expect_error("print ${x:%q}", 1, 11, 2, "expected a format");
	expect_error("variable l format l %g\nprint $l", 1, 19, 1, "uses itself");
}
END_TEST

START_TEST(set_by_the_program)
{
	struct ts_place here = { .line = 0 };

	expect_output("variable x internal 2.5\nvariable y equal v_x^2\nprint $y\n", "6.25\n");
	ck_assert_int_eq(sim->script_api->set(sim->script_api_data, "x", &here, 3), TS_OK);
	expect_value("v_y", 9);
	ck_assert_int_eq(sim->script_api->set(sim->script_api_data, "y", &here, 3), TS_STATE);
	tsim_error_clear(sim);
	expect_error("variable q internal a", 1, 21, 1, "expected a number");
}
END_TEST

/* What is drawn does not depend on the order of particles, and goes on behind a restart file. */
START_TEST(random_numbers)
{
	double first, second, third, again[3];
	struct ts_archive *archive = ts_archive_new(sim, true), *copy;
	const unsigned char *bytes;
	struct tsim *first_sim;
	size_t n;

	ck_assert_int_eq(tsim_string(sim, three), 0);
	expect_output("variable a atom random(0,1,17)\nvariable b atom normal(0,1,18)\n", "");
	first = value("v_a[2]");
	value("random(0,1,17)");
	value("normal(0,1,4711)");
	ck_assert_int_eq(sim->script_api->archive(sim->script_api_data, archive), TS_OK);
	ck_assert_int_eq(ts_archive_bytes(archive, &bytes, &n), TS_OK);
	second = value("v_a[3]");
	third = value("random(0,1,17)");
	ck_assert(first < second || first > second);
	copy = ts_archive_new(sim, false);
	ck_assert_int_eq(ts_archive_from(copy, bytes, n), TS_OK);
	ck_assert_int_eq(sim->script_api->archive(sim->script_api_data, copy), TS_OK);
	again[2] = value("v_a[3]");
	ck_assert(again[2] <= second && again[2] >= second);
	first_sim = sim;
	sim = tsim_open();
	tsim_screen(sim, NULL);
	ck_assert_int_eq(tsim_string(sim, three), 0);
	ck_assert_int_eq(tsim_string(sim, "variable a atom random(0,1,17)"), 0);
	ts_archive_free(copy);
	copy = ts_archive_new(sim, false);
	ck_assert_int_eq(ts_archive_from(copy, bytes, n), TS_OK);
	ck_assert_int_eq(sim->script_api->archive(sim->script_api_data, copy), TS_OK);
	again[0] = value("v_a[3]");
	again[1] = value("random(0,1,17)");
	ck_assert(again[0] <= second && again[0] >= second);
	ck_assert(again[1] <= third && again[1] >= third);
	ts_archive_free(copy);
	tsim_close(sim);
	sim = first_sim;
	ts_archive_free(archive);
	expect_error("variable c atom random(0,1,id)\nprint $(v_c[1])", 1, 28, 2,
		     "one number is needed here");
}
END_TEST

static void add(TCase *all)
{
	tcase_add_test(all, redefinition);
	tcase_add_test(all, lists_of_words);
	tcase_add_test(all, values_from_files);
	tcase_add_test(all, values_of_particles);
	tcase_add_test(all, vectors);
	tcase_add_test(all, vectors_as_inputs);
	tcase_add_test(all, formatted);
	tcase_add_test(all, set_by_the_program);
	tcase_add_test(all, random_numbers);
}

int main(void)
{
	return case_main("variables", add);
}
