/* Drag that gives the fluid the force as it is (`lagged`): the largest stable step, found by bisection,
 * beside the one the plan of a run says. The slip between a fluid and particles spread evenly in it must
 * not grow.
 *
 * Its rates of relaxation are A = c/m for the particles and K = n c/rho for the fluid, n their number by
 * volume. Explicit drag is stable for h (A + K) < 2; exact for (1 - exp(-A h)) (1 + K/A) < 2, and always
 * where K < A.
 *
 * TS_TABLE=FILE appends what is measured. */
#include "../deck.h"

#include "core/sim.h"
#include "flow/fluid.h"
#include "flow/flow.h"
#include "particle/particles.h"

enum { N = 4, PER_CELL = 9, STEPS = 60 };
static const double PI = 3.14159265358979323846, WIDTH = 1, DIAMETER = 0.5, VISCOSITY = 0.1, DENSITY = 1.385;

struct scene {
	const char *drag;
	double mass; /* of the particles in a cell, by that of the fluid there */
	int every;
	bool fixed;
	double (*theory)(double a, double k);
	double most; /* of measured over what the plan says */
};

static double explicit_limit(double a, double k)
{
	return 2 / (a + k);
}

static double exact_limit(double a, double k)
{
	return -log(1 - 2 / (1 + k / a)) / a;
}

static struct tsim *open_scene(const struct scene *s)
{
	double cell = WIDTH * WIDTH; /* discs have their mass by unit of depth */

	return deck_open("units si\natom_style granular\nboundary p p p\ndimension 2\nneighbor 0.01 bin\n"
			 "region box block 0 4 0 4 -0.05 0.05 units box\ncreate_box 1 box\n"
			 "lattice sq %.17g\ncreate_atoms 1 box\npair_style none\n"
			 "set group all diameter %.17g mass %.17g\n"
			 "flow_style projection cells %d %d 1 viscosity %.17g density %.17g every %d\n"
			 "flow_set velocity 1e-3 0 0\n"
			 "fix drag all %s lagged yes\n%s\n",
			 WIDTH / 3, DIAMETER, s->mass * DENSITY * cell / PER_CELL, N, N, VISCOSITY, DENSITY,
			 s->every, s->drag, s->fixed ? "" : "fix move all nve/sphere");
}

static double slip(struct tsim *sim)
{
	const struct ts_fluid *fluid = ts_flow_fluid(sim);

	return fabs(fluid->u[0][ts_at(&fluid->grid, 1, 1, 0)] - sim->particles->v[0][0]);
}

static bool is_stable(const struct scene *s, double dt)
{
	struct tsim *sim = open_scene(s);
	double middle, end;
	bool stable;

	ck_assert_uint_eq(sim->particles->n, PER_CELL * N * N);
	stable = deck_accepts(sim, "timestep %.17g\nrun %d unsafe yes", dt, STEPS * s->every);
	middle = slip(sim);
	stable = stable && deck_accepts(sim, "run %d unsafe yes", STEPS * s->every);
	end = slip(sim);
	tsim_close(sim);
	return stable && end <= middle * 1.0001 + 1e-17;
}

/* Whether a run with this step is warned of. */
static bool is_warned(const struct scene *s, double dt)
{
	struct tsim *sim = open_scene(s);
	long before;
	bool warned;

	deck(sim, "timestep %.17g\nrun 0 unsafe yes", 0.01 * dt);
	before = (long)sim->log.warnings;
	deck(sim, "timestep %.17g\nrun 0 unsafe yes", dt);
	warned = (long)sim->log.warnings > before;
	tsim_close(sim);
	return warned;
}

static double bisect(const struct scene *s, bool (*fits)(const struct scene *s, double dt), double low,
		     double high)
{
	for (int k = 0; k < 9; k++) {
		double dt = sqrt(low * high);

		*(fits(s, dt) ? &low : &high) = dt;
	}
	return sqrt(low * high);
}

static const struct scene scenes[] = {
	{ "drag/stokes", 1e6, 1, true, explicit_limit, 1.01 },
	{ "drag/stokes", 2.385, 1, false, explicit_limit, 1.01 },
	{ "drag/stokes", 1e6, 3, true, explicit_limit, 1.01 },
	{ "drag/stokes scheme exact", 2.385, 1, false, exact_limit, 1.5 },
	{ "drag/stokes scheme exact", 1e6, 1, true, exact_limit, 1.01 },
};

START_TEST(limits)
{
	FILE *table = deck_table("Largest stable step of lagged drag: measured, theory");
	const struct scene *s = &scenes[_i];
	double spheres = 1.5 / DIAMETER; /* in a disc, per depth */
	double c = spheres * 3 * PI * VISCOSITY * DIAMETER, cell = WIDTH * WIDTH;
	double k = PER_CELL * c / (DENSITY * cell), a = k / s->mass;
	double said = 2 / (k * s->every + (s->theory == explicit_limit ? a : 0));
	double theory = s->theory(a, k * s->every);
	double measured = bisect(s, is_stable, 0.5 * said, 3 * said);

	if (table)
		fprintf(table, "%s, mass %g, every %d\t%g\t%g\t%.3f\n", s->drag, s->mass, s->every, measured,
			theory, measured / theory);
	ck_assert_msg(fabs(measured / theory - 1) < 0.01, "%s: stable up to %g, theory %g", s->drag, measured,
		      theory);
	ck_assert_msg(measured > 0.99 * said && measured < s->most * said,
		      "%s: stable up to %g, the plan says %g", s->drag, measured, said);
	ck_assert(!is_warned(s, 0.999 * said) && is_warned(s, 1.001 * said));
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("lagged drag");
	TCase *tcase = tcase_create("bisection");

	tcase_add_loop_test(tcase, limits, 0, (int)DECK_LENGTH(scenes));
	suite_add_tcase(suite, tcase);
	return deck_main(suite);
}
