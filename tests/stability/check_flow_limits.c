/* Steps of the fluid: the largest stable one, found by bisection, beside von Neumann's. A small
 * disturbance of a uniform flow, or of a fluid at rest, must not grow.
 *
 * TS_TABLE=FILE appends what is measured. */
#include <stdlib.h>

#include "../deck.h"

#include "core/sim.h"
#include "flow/flow_limits.h"

enum { N = 12, STEPS = 300 };

struct scene {
	const char *words;
	double nu, u, v;
	bool walls;
	double least, most; /* of measured over theory */
};

static struct ts_projection *projection_of(struct tsim *sim)
{
	return ts_sim_only(sim, TS_KIND_FLOW)->state;
}

static struct tsim *open_scene(const struct scene *s)
{
	return deck_open("units si\nboundary p %s p\ndimension 2\n"
			 "region box block 0 1 0 1 -0.5 0.5 units box\ncreate_box 1 box\n"
			 "neighbor 0.001 bin\n"
			 "variable u equal %.17g+random(-1e-7,1e-7,2385)\n"
			 "variable v equal %.17g+random(-1e-7,1e-7,2389)\n"
			 "flow_style projection cells %d %d 1 viscosity %.17g density 1 %s\n"
			 "flow_set velocity v_u v_v 0\n",
			 s->walls ? "f" : "p", s->u, s->v, N, N, s->nu, s->words);
}

/* Energy of what is not the mean flow. */
static double disturbance(const struct scene *s, const struct ts_fluid *fluid)
{
	double sum = 0;

	for (int j = 0; j < N; j++)
		for (int i = 0; i < N; i++) {
			size_t at = ts_at(&fluid->grid, i, j, 0);

			sum += pow(fluid->u[0][at] - s->u, 2) + pow(fluid->u[1][at] - s->v, 2);
		}
	return sum;
}

static bool is_stable(const struct scene *s, double dt)
{
	struct tsim *sim = open_scene(s);
	double middle, end;
	bool stable;

	stable = deck_accepts(sim, "timestep %.17g\nrun %d unsafe yes", dt, STEPS);
	middle = disturbance(s, &projection_of(sim)->fluid);
	stable = stable && deck_accepts(sim, "run %d unsafe yes", STEPS);
	end = disturbance(s, &projection_of(sim)->fluid);
	tsim_close(sim);
	return stable && end <= middle * 1.0001;
}

static double theory(const struct scene *s)
{
	struct tsim *sim = open_scene(s);
	double limit = ts_flow_limit(projection_of(sim));

	tsim_close(sim);
	return limit;
}

static double measure(const struct scene *s, double limit)
{
	double stable = 0.5 * limit, unstable = 3 * limit;

	ck_assert(is_stable(s, stable));
	for (int k = 0; k < 9; k++) {
		double dt = sqrt(stable * unstable);

		*(is_stable(s, dt) ? &stable : &unstable) = dt;
	}
	return sqrt(stable * unstable);
}

static const struct scene scenes[] = {
	{ "time euler", 0.1, 0, 0, false, 0.99, 1.01 },
	{ "time ab2", 0.1, 0, 0, false, 0.99, 1.01 },
	{ "time rk2", 0.1, 0, 0, false, 0.99, 1.01 },
	{ "time rk3", 0.1, 0, 0, false, 0.99, 1.01 },
	{ "time euler wall linear", 0.1, 0, 0, true, 0.99, 1.03 },
	/* what is without divergence feels less of the walls than a component alone */
	{ "time euler", 0.1, 0, 0, true, 0.99, 1.1 },
	/* the waves that grow first are longer than this box */
	{ "time euler convection central", 0.005, 0.71, 0.37, false, 0.97, 1.3 },
	{ "time euler convection donor gamma 1", 0.001, 0.71, 0.37, false, 0.97, 1.1 },
	{ "time euler convection donor gamma 0.5", 0.005, 0.71, 0.37, false, 0.97, 1.1 },
	{ "time rk3 convection quick", 0.001, 0.71, 0.37, false, 0.97, 1.3 },
	{ "time ab2 convection quick", 0, 0.71, 0.37, false, 0.97, 1.3 },
	{ "time rk2 convection quick", 0, 0.71, 0.37, false, 0.97, 1.3 },
	{ "time ab2 convection central", 0.003, 0.71, 0.37, false, 0.97, 1.3 },
	{ "time rk2 convection central", 0.003, 0.71, 0.37, false, 0.97, 1.4 },
	{ "time rk3 convection central", 0.001, 0.71, 0.37, false, 0.97, 1.1 },
	{ "time ab2 convection donor gamma 1", 0.001, 0.71, 0.37, false, 0.97, 1.3 },
	{ "time rk2 convection donor gamma 1", 0.001, 0.71, 0.37, false, 0.97, 1.3 },
	{ "time rk3 convection donor gamma 1", 0.001, 0.71, 0.37, false, 0.97, 1.3 },
	{ "time euler convection quick", 0.005, 0.71, 0.37, false, 0.97, 1.5 },
	/* its limiter damps what is central otherwise */
	{ "time euler convection cubista", 0.005, 0.71, 0.37, false, 0.97, 3.2 },
	{ "time ab2 convection cubista", 0, 0.71, 0.37, false, 0.97, 1.5 },
	{ "time rk2 convection cubista", 0, 0.71, 0.37, false, 0.97, 1.5 },
	{ "time rk3 convection cubista", 0.001, 0.71, 0.37, false, 0.97, 1.5 },
};

START_TEST(limits)
{
	FILE *table = deck_table("Largest stable step of the fluid: measured, theory");
	const struct scene *s = &scenes[_i];
	double limit = theory(s), measured = measure(s, limit);

	if (table)
		fprintf(table, "%s, nu %g, u %g %g\t%g\t%g\t%.3f\n", s->words, s->nu, s->u, s->v, measured,
			limit, measured / limit);
	ck_assert_msg(measured >= s->least * limit && measured <= s->most * limit,
		      "%s: stable up to %g, theory %g, ratio %g", s->words, measured, limit,
		      measured / limit);
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("flow limits");
	TCase *tcase = tcase_create("bisection");

	tcase_add_loop_test(tcase, limits, 0, (int)DECK_LENGTH(scenes));
	suite_add_tcase(suite, tcase);
	return deck_main(suite);
}
