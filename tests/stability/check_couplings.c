/* Steps of what acts on single particles and between their temperatures, found by bisection, beside
 * theory:
 *
 *   heat       dT/dt = A T, explicit Euler: stable for h |lambda| < 2, lambda the largest number of A; the plan advises
 *              the least m c/sum h, to which no temperature swings; both are the same in chains of equal grains
 *   drag       explicit: h < 2 tau; implicit and exact: all steps
 *   added mass with the acceleration of the step before it would be unstable for C rho_f > rho_p; tsim solves for the
 *              acceleration, which all ratios bear
 *
 * TS_TABLE=FILE appends what is measured. */
#include <stdlib.h>
#include <string.h>

#include "../deck.h"

#include "core/report.h"
#include "core/sim.h"

static double least_reported(struct tsim *sim)
{
	struct ts_plan_report report = { .advice = true, .enough = INFINITY };
	double least = INFINITY;

	ck_assert(ts_report_collect(&report, sim) == TS_OK);
	for (size_t k = 0; k < report.nlimits; k++)
		least = fmin(least, report.limit[k].dt);
	ts_report_release(&report);
	return least;
}

static void table(const char *name, double measured, double theory, double reported)
{
	FILE *file = getenv("TS_TABLE") ? fopen(getenv("TS_TABLE"), "a") : NULL;

	if (file) {
		fprintf(file, "%-44s %9.5g %9.5g %9.5g %9.4f\n", name, measured, theory, reported,
			measured / reported);
		fclose(file);
	}
}

/* ---- heat: h = 4 k k/(k + k) sqrt(A) = 1, m c = 1 unless the scene says otherwise ---- */

struct scene {
	const char *name, *grains;
	double theory;
};

#define CHAIN(n)                                                                           \
	"boundary p f f\nregion box block 0 " n " -1 1 -1 1 units box\ncreate_box 1 box\n" \
	"lattice sc 1.0\nregion line block 0 " n                                           \
	" -0.1 0.1 -0.1 0.1 units box\ncreate_atoms 1 region line\n"                       \
	"set group all diameter 1.01 mass 1\n"
#define TWO(mass)                                                                                            \
	"boundary f f f\nregion box block -2 2 -2 2 -2 2 units box\ncreate_box 1 box\n"                      \
	"create_atoms 1 single 0 0 0\ncreate_atoms 1 single 1 0 0\nset group all diameter 1.01 mass 1\nset " \
	"atom 2 mass " mass "\n"

static const struct scene heated[] = {
	{ "heat: two equal grains", TWO("1"), 1 },
	{ "heat: two grains, 1 and 9", TWO("9"), 1.8 },
	{ "heat: grain and a very heavy one", TWO("1e6"), 2 },
	{ "heat: chain", CHAIN("8"), 0.5 },
};

static struct tsim *open_heat(const struct scene *s, double h)
{
	return deck_open("units si\natom_style granular\nnewton off\ncommunicate single vel yes\nneighbor "
			 "0.01 bin\n%sfix k all property/global thermalConductivity peratomtype 0.5\n"
			 "fix c all property/global thermalCapacity peratomtype 1\n"
			 "pair_style spring/dashpot\npair_coeff * * stiffness 1 damping 0\n"
			 "fix heat all heat/gran initial_temperature 1 contact_area constant 1\n"
			 "set atom 1 property/atom Temp 1.001\n"
			 "compute hot all reduce max f_Temp\ncompute cold all reduce min f_Temp\ntimestep "
			 "%.17g",
			 s->grains, h);
}

static bool stable(const struct scene *s, double h)
{
	struct tsim *sim = open_heat(s, h);
	bool good = true;

	for (int chunk = 0; chunk < 20 && good; chunk++)
		good = deck_accepts(sim, "run 200 unsafe yes post no") &&
		       deck_value(sim, "c_hot") - deck_value(sim, "c_cold") < 0.01;
	tsim_close(sim);
	return good;
}

START_TEST(heat)
{
	const struct scene *s = &heated[_i];
	struct tsim *sim = open_heat(s, 1e-3);
	double lo = 0.5 * s->theory, hi = 1.5 * s->theory, reported;

	deck(sim, "run 1 post no");
	reported = least_reported(sim);
	tsim_close(sim);
	ck_assert(stable(s, lo) && !stable(s, hi));
	while (hi / lo > 1.0005) {
		double h = sqrt(lo * hi);

		*(stable(s, h) ? &lo : &hi) = h;
	}
	table(s->name, sqrt(lo * hi), s->theory, reported);
	ck_assert_msg(fabs(sqrt(lo * hi) / s->theory - 1) < 4e-3, "%s: stable up to %g, theory %g", s->name,
		      sqrt(lo * hi), s->theory);
	/* no swings: never beyond the limit, and within a factor of two */
	ck_assert(reported <= s->theory * 1.001 && reported >= 0.499 * s->theory);
}
END_TEST

/* ---- drag and added mass ---- */

static const double TAU = 0.0371, RADIUS = 0.0123, MASS = 0.0186;

/* A sphere of this mass that begins to sink; its velocity by the final one at the end. */
static double sink(const char *drag, double h, double mass, int steps)
{
	struct tsim *sim =
		deck_open("units si\nboundary p p p\nregion box block -1 1 -1 1 -1 1 units box\n"
			  "create_box 1 box\nneighbor 0.001 bin\ncreate_atoms 1 single 0 0 0\n"
			  "set group all diameter %.17g mass %.17g\nfix move all nve\n"
			  "flow_style uniform velocity 0 0 0 viscosity %.17g density 1000\n"
			  "fix weight all addforce 0 0 %.17g\n%s\ntimestep %.17g",
			  2 * RADIUS, mass, MASS / (6 * acos(-1) * RADIUS * TAU), -1e-9 * mass, drag, h);
	double v = INFINITY;

	if (deck_accepts(sim, "run %d unsafe yes post no", steps))
		deck_column(sim, "vz", &v, 1, 0);
	tsim_close(sim);
	return v;
}

START_TEST(drag_of_any_step)
{
	static const char *const scheme[] = { "implicit", "exact" };

	for (size_t k = 0; k < DECK_LENGTH(scheme); k++) {
		char line[64];
		double v;

		snprintf(line, sizeof line, "fix drag all drag/stokes scheme %s", scheme[k]);
		v = sink(line, 1e4 * TAU, MASS, 50);
		ck_assert_msg(fabs(v / (-1e-9 * TAU) - 1) < 0.01, "%s: %g tau", scheme[k], v / (-1e-9 * TAU));
		snprintf(line, sizeof line, "drag %s at 10000 tau: v/v_end", scheme[k]);
		table(line, v / (-1e-9 * TAU), 1, 1);
	}
	ck_assert(
		!(fabs(sink("fix drag all drag/stokes scheme explicit", 2.1 * TAU, MASS, 500)) < 1e-7 * TAU));
}
END_TEST

/* Of rho_p/rho_f: dv/dt = -g m/(m + C m_f), for any. */
START_TEST(added_mass_of_any_ratio)
{
	static const double ratio[] = { 2.385, 0.5, 0.1, 1e-3, 1e-6 };
	double fluid = 1000 * 4.0 / 3.0 * acos(-1) * pow(RADIUS, 3);

	for (size_t k = 0; k < DECK_LENGTH(ratio); k++) {
		double mass = ratio[k] * fluid, v = sink("fix added all added_mass", 1e-3, mass, 200);
		double theory = -1e-9 * mass / (mass + 0.5 * fluid) * 0.2;
		char line[64];

		ck_assert_msg(fabs(v / theory - 1) < 1e-6, "rho_p/rho_f = %g: %g, expected %g", ratio[k], v,
			      theory);
		snprintf(line, sizeof line, "added mass, rho_p/rho_f = %g: v/v_exact", ratio[k]);
		table(line, v / theory, 1, 1);
	}
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("stability of couplings");
	TCase *tests = tcase_create("bisection");

	tcase_set_timeout(tests, 120);
	tcase_add_loop_test(tests, heat, 0, (int)DECK_LENGTH(heated));
	tcase_add_test(tests, drag_of_any_step);
	tcase_add_test(tests, added_mass_of_any_ratio);
	suite_add_tcase(suite, tests);
	return deck_main(suite);
}
