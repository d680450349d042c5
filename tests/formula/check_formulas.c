/* Functions of formulas that need particles, the clock, or names. */
#include "script_case.h"

#include <inttypes.h>
#include <stdio.h>

/* Three spheres of mass 2, 1 and 1 at (1,0,0), (-1,1,0), (-1,-1,0), turning about z with rate 2.5, all of
 * them moving with (0.5, 0, 0.25). Their centre of mass is the origin. */
static const char turning[] =
	"boundary f f f\nregion box block -3 3 -3 3 -3 3 units box\ncreate_box 2 box\n"
	"create_atoms 1 single 1 0 0 units box\ncreate_atoms 2 single -1 1 0 units box\n"
	"create_atoms 2 single -1 -1 0 units box\nset group all diameter 1\n"
	"set atom 1 mass 2\nset atom 2 mass 1\nset atom 3 mass 1\n"
	"set atom 1 vx 0.5 vy 2.5 vz 0.25\nset atom 2 vx -2 vy -2.5 vz 0.25\n"
	"set atom 3 vx 3 vy -2.5 vz 0.25\n"
	"group light type 2\nregion up block INF INF 0.5 INF INF INF units box\n";

static void near(const char *formula, double wanted)
{
	double got = value(formula);

	ck_assert_msg(fabs(got - wanted) <= 1e-14, "%s is %.17g, not %.17g", formula, got, wanted);
}

START_TEST(groups)
{
	ck_assert_int_eq(tsim_string(sim, turning), 0);
	near("count(all)*100+count(light)*10+count(light,up)", 321);
	near("mass(all)+10*mass(all,up)", 14);
	near("xcm(all,x)+xcm(all,y)", 0);
	near("xcm(light,x)+10*xcm(light,y,up)", 9);
	near("vcm(all,x)", 0.5);
	near("vcm(light,x,up)", -2);
	near("ke(all)", 0.5 * 4 * (0.25 + 0.0625) + 0.5 * (2 + 2 + 2) * 6.25);
	near("gyration(all)", sqrt((2 + 2 + 2) / 4.0));
	near("inertia(all,zz)", 6);
	near("inertia(all,xx)", 2);
	near("inertia(all,yy)", 4);
	near("inertia(all,xy)", 0);
	near("angmom(all,z)", 15);
	near("omega(all,z)", 2.5);
	near("omega(all,x)", 0);
	near("bound(all,ymax)+10*bound(all,xmax,up)", -9);
	near("torque(all,z)+fcm(all,x)", 0);
	expect_error("print $(count(lihgt))", 1, 15, 5, "did you mean 'light'");
	expect_error("print $(count(all,pu))", 1, 19, 2, "'pu'");
	expect_error("print $(xcm(all))", 1, 9, 8, "takes 2 to 3 arguments, found 1");
	expect_error("print $(xcm(all,w))", 1, 17, 1, "expected x, y or z");
	expect_error("print $(inertia(all,x))", 1, 21, 1, "expected xx, yy");
	expect_error("print $(bound(all,x))", 1, 19, 1, "expected xmin");
	expect_error("print $(omega(light,x))", 1, 15, 5, "lie on one line");
	expect_error("print $(mass(all,up,up))", 1, 9, 15, "takes 1 to 2 arguments");
}
END_TEST

/* Values of a function of the step at some steps. */
static void sequence(const char *function, const char *steps, const char *values)
{
	char script[64], got[200] = "";
	int64_t step;
	const char *at = steps;
	int n;

	while (sscanf(at, "%" SCNd64 "%n", &step, &n) == 1) {
		snprintf(script, sizeof script, "reset_timestep %" PRId64, step);
		ck_assert_int_eq(tsim_string(sim, script), 0);
		snprintf(got + strlen(got), sizeof got - strlen(got), "%s%.15g", *got ? " " : "",
			 value(function));
		at += n;
	}
	ck_assert_msg(strcmp(got, values) == 0, "%s at %s is %s, not %s", function, steps, got, values);
}

START_TEST(steps)
{
	ck_assert_int_eq(tsim_string(sim, turning), 0);
	sequence("stagger(100,10)", "0 9 10 99 100 110", "10 10 100 100 110 200");
	sequence("logfreq(10,4,10)", "0 10 39 40 99 100 400", "10 20 40 100 100 200 1000");
	sequence("logfreq2(10,7,3)", "0 10 11 30 56", "10 13 13 39 65");
	sequence("logfreq3(10,25,1000)", "0 10 11 55 99 400", "10 13 13 57 100 465");
	sequence("stride(100,1000,7)", "0 100 995 996", "100 107 996 9e+18");
	sequence("stride2(0,1000,100,140,180,7)", "100 140 174 175 200 1000", "140 147 175 200 300 9e+18");
	expect_error("print $(stagger(3,5))", 1, 9, 12, "x > y > 0");
	expect_error("print $(logfreq(10,10,10))", 1, 9, 17, "needs y < z");
	expect_error("print $(logfreq2(0,1,10))", 1, 9, 16, "needs x > 0");
	expect_error("print $(logfreq3(10,2000,1000))", 1, 9, 22, "1 < y");
	expect_error("print $(stride(5,1,1))", 1, 9, 13, "x <= y");
	expect_error("print $(stride2(0,10,1,5,20,1))", 1, 9, 22, "a <= b <= y");
	expect_error("print $(ramp(1,2))", 1, 9, 9, "only in a run");
}
END_TEST

START_TEST(names)
{
	ck_assert_int_eq(tsim_string(sim, turning), 0);
	expect_value("is_defined(group,light)*10+is_defined(region,up)", 11);
	expect_value("is_defined(variable,none)+is_defined(fix,none)+is_defined(molecule,x)", 0);
	expect_value("is_available(fix,gravity)+is_available(fix,none)", 1);
	expect_value("is_active(package,gpu)+is_active(fix,gravity)", 0);
	expect_output("fix g all gravity 9.81 vector 0 0 -1\n", "");
	expect_value("is_active(fix,gravity)+10*is_defined(fix,g)", 11);
	expect_value("is_active(pair,single)", 0);
	expect_output("pair_style spring/dashpot\npair_coeff * * stiffness 1 restitution 1\n", "");
	expect_value("is_active(pair,single)+10*is_active(pair,spring/dashpot)", 11);
	expect_value("is_active(pair,manybody)+is_active(pair,tail)+is_active(pair,lubricate)", 0);
	expect_error("print $(is_active(fix,gravitty))", 1, 23, 8, "did you mean 'gravity'");
	expect_value("is_file(/dev/null)*10+is_file(/nowhere/at/all)", 10);
	expect_value("is_os(^none)", 0);
	expect_value("extract_setting(dimension)*10+extract_setting(box_exist)", 31);
	expect_error("print $(extract_setting(dimensoin))", 1, 25, 9, "did you mean 'dimension'");
	expect_error("print $(is_defined(fxi,a))", 1, 20, 3, "did you mean 'fix'");
	expect_error("print $(is_defined(fix))", 1, 9, 15, "takes 2 arguments, found 1");
}
END_TEST

START_TEST(constants)
{
	expect_value("PI", 3.14159265358979323846);
	expect_value("yes+true+on+10*(no+false+off)", 3);
	expect_value("ternary(2>1,7,8)+ternary(0,1,2)", 9);
	expect_value("sign(-2.5)*10+sign(0)", -9);
	expect_value("round(2.5)+round(-2.5)*10+round(-2.6)*100", -317);
	expect_error("print $(ture)", 1, 9, 4, "did you mean 'true'");
}
END_TEST

/* As many brackets as the page says, whatever stands between them. */
START_TEST(brackets)
{
	static const struct {
		const char *open;
		double value;
	} in[] = { { "(", 1 }, { "-(", 1 }, { "0*1+(", 1 }, { "abs(", 1 } };
	char text[4096];

	for (size_t k = 0; k < sizeof in / sizeof *in; k++)
		for (int n = 500; n <= 501; n++) {
			double out;

			text[0] = '\0';
			for (int i = 0; i < n; i++)
				strcat(text, in[k].open);
			strcat(text, "1");
			for (int i = 0; i < n; i++)
				strcat(text, ")");
			ck_assert_int_eq(tsim_value(sim, text, &out) == 0, n == 500);
			if (n == 500)
				expect_value(text, in[k].value);
			else
				ck_assert_ptr_nonnull(strstr(tsim_error(sim), "more than 500"));
			tsim_error_clear(sim);
		}
}
END_TEST

/* Each variable is evaluated once: else this would take 2^63 additions. But what is drawn is drawn anew. */
START_TEST(once_each)
{
	char line[64];

	expect_output("variable a0 equal 1\nvariable r equal random(0,1,17)\nvariable s equal v_r", "");
	for (int k = 0; k < 63; k++) {
		snprintf(line, sizeof line, "variable a%d equal v_a%d+v_a%d", k + 1, k, k);
		expect_output(line, "");
	}
	expect_value("v_a63", 9223372036854775808.0);
	ck_assert(value("v_s-v_s") != 0);
	expect_output("variable a0 equal 3", "");
	expect_value("v_a2", 12);
}
END_TEST

static void add(TCase *all)
{
	tcase_add_test(all, groups);
	tcase_add_test(all, brackets);
	tcase_add_test(all, once_each);
	tcase_add_test(all, steps);
	tcase_add_test(all, names);
	tcase_add_test(all, constants);
}

int main(void)
{
	return case_main("formulas", add);
}
