/* The fluid: steps, boundaries and operators of flow_style projection, with known answers. */
#include <stdlib.h>
#include <string.h>

#include "deck.h"

#include "core/sim.h"
#include "flow/flow.h"
#include "flow/fluid.h"

static const double PI = 3.14159265358979323846;

static struct ts_fluid *fluid_of(struct tsim *sim)
{
	struct ts_instance *flow = ts_sim_only(sim, TS_KIND_FLOW);

	return ts_flow_style_of(flow)->fluid(flow);
}

static const char *const box[] = {
	"units si\nboundary %s\ndimension 2\nregion box block 0 2 0 1 -0.5 0.5 units box\n"
	"create_box 1 box\n",
	"units si\nboundary %s\nregion box block 0 2 0 1 0 0.5 units box\ncreate_box 1 box\n",
};

/* ---- channel flow: the parabola is exact on any grid */

static void run_channel(int solid, const char *words, double tolerance)
{
	struct tsim *sim = deck_open(box[solid], solid ? "p f p" : "p f p");
	struct ts_fluid *fluid;
	double worst = 0;

	/* u = G/(2 nu) y (1 - y) */
	deck(sim, "flow_style projection cells 6 9 %d viscosity 0.2385 density 2 body_force 0.7 0 0 %s\n"
		  "pressure_style cg tolerance 1e-13\n"
		  "timestep 0.02\n"
		  "run 1500\n",
	     solid ? 4 : 1, words);
	fluid = fluid_of(sim);
	for (int j = 0; j < 9; j++) {
		double y = fluid->grid.centre[1][j], exact = 0.7 / (0.2385 / 2) / 2 * y * (1 - y);
		double u[3];

		worst = fmax(worst, fabs(fluid->u[0][ts_at(&fluid->grid, 3, j, 0)] - exact));
		ts_fluid_velocity(fluid, (const double[]){ 0.3, 0.1 * y / 2, 0.1 }, u);
		ck_assert(fabs(u[1]) < 1e-12 && fabs(u[2]) < 1e-12);
	}
	DECK_NEAR(worst, 0, tolerance);
	tsim_close(sim);
}

START_TEST(channel)
{
	for (int solid = 0; solid < 2; solid++) {
		run_channel(solid, "", 1e-10);
		run_channel(solid, "convection quick", 1e-10);
		run_channel(solid, "convection cubista time rk2", 1e-10);
		run_channel(solid, "convection donor form fd time ab2", 1e-10);
		run_channel(solid, "wall linear", 0.7 / (0.2385 / 2) / 8 / 81 + 1e-9);
	}
}
END_TEST

/* ---- particles take room, and hold the fluid */

static void set_room(struct ts_fluid *fluid, double mean, double wave)
{
	const struct ts_grid *grid = &fluid->grid;

	for (int k = 0; k < grid->n[2]; k++)
		for (int j = 0; j < grid->n[1]; j++)
			for (int i = 0; i < grid->n[0]; i++)
				fluid->empty[ts_at(grid, i, j, k)] =
					mean + wave * cos(PI * grid->centre[0][i]) *
						       cos(3 * PI * grid->centre[1][j]);
}

static const char cavity[] = "flow_style projection cells 12 9 %d viscosity 0.05 density 1.7 %s\n"
			     "flow_boundary yhi wall velocity 1 0 0\n"
			     "pressure_style cg tolerance 1e-13\n"
			     "timestep 0.01\n";

/* The same void fraction everywhere changes nothing. */
START_TEST(even_room)
{
	for (int solid = 0; solid < 2; solid++) {
		struct tsim *sim[2];
		struct ts_fluid *fluid[2];
		double worst = 0;

		for (int k = 0; k < 2; k++) {
			sim[k] = deck_open(box[solid], solid ? "f f f" : "f f p");
			deck(sim[k], cavity, solid ? 4 : 1, "convection quick time rk3");
			fluid[k] = fluid_of(sim[k]);
			if (k == 1) {
				ck_assert_int_eq(ts_fluid_want(fluid[k], sim[k], TS_FLUID_VOID), TS_OK);
				set_room(fluid[k], 0.385, 0);
			}
			deck(sim[k], "run 20");
		}
		for (size_t at = 0; at < fluid[0]->grid.size; at++)
			worst = fmax(worst, fabs(fluid[0]->u[0][at] - fluid[1]->u[0][at]));
		DECK_NEAR(worst, 0, 1e-11);
		tsim_close(sim[0]);
		tsim_close(sim[1]);
	}
}
END_TEST

/* An uneven one: div(e u) = 0 all the same. */
START_TEST(uneven_room)
{
	for (int solid = 0; solid < 2; solid++) {
		struct tsim *sim = deck_open(box[solid], solid ? "f f f" : "f f p");
		struct ts_fluid *fluid;

		deck(sim, cavity, solid ? 4 : 1, "convection donor time rk2");
		fluid = fluid_of(sim);
		ck_assert_int_eq(ts_fluid_want(fluid, sim, TS_FLUID_VOID), TS_OK);
		set_room(fluid, 0.6, 0.3);
		deck(sim, "run 20");
		DECK_NEAR(fluid->divergence, 0, 1e-9);
		ck_assert(fluid->courant > 0.01);
		tsim_close(sim);
	}
}
END_TEST

static void set_exchange(struct ts_fluid *fluid, double k)
{
	for (int d = 0; d < fluid->grid.dimensions; d++)
		for (size_t at = 0; at < fluid->grid.size; at++)
			fluid->exchange[d][at] = k;
}

/* A bed that holds the fluid with k: dp/dx = - k u/e, however large k dt is. */
START_TEST(bed)
{
	static const char *const times[] = { "euler", "ab2", "rk2", "rk3" };
	const double u0 = 0.31, k = 2.385e4, e = 0.43;

	for (size_t s = 0; s < DECK_LENGTH(times); s++) {
		struct tsim *sim = deck_open(box[0], "f f p");
		struct ts_fluid *fluid;
		double slope;

		deck(sim, "flow_style projection cells 10 4 1 viscosity 0.05 density 1.7 time %s\n"
			  "flow_boundary xlo inlet velocity %g 0 0\nflow_boundary xhi outlet\n"
			  "flow_boundary ylo slip\nflow_boundary yhi slip\n"
			  "pressure_style cg tolerance 1e-13\ntimestep 0.01\n",
		     times[s], u0);
		fluid = fluid_of(sim);
		ck_assert_int_eq(ts_fluid_want(fluid, sim, TS_FLUID_VOID | TS_FLUID_EXCHANGE), TS_OK);
		set_room(fluid, e, 0);
		for (int step = 0; step < 5; step++) {
			set_exchange(fluid, k);
			deck(sim, "run 1");
		}
		slope = (fluid->p[ts_at(&fluid->grid, 7, 2, 0)] - fluid->p[ts_at(&fluid->grid, 2, 2, 0)]) /
			(5 * 0.2);
		DECK_NEAR(slope, -k * u0 / e, 1e-8 * k);
		DECK_NEAR(fluid->used[0][ts_at(&fluid->grid, 5, 2, 0)], u0, 1e-9);
		tsim_close(sim);
	}
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("flow");
	TCase *tcase = tcase_create("projection");

	tcase_add_test(tcase, channel);
	tcase_add_test(tcase, even_room);
	tcase_add_test(tcase, uneven_room);
	tcase_add_test(tcase, bed);
	suite_add_tcase(suite, tcase);
	return deck_main(suite);
}
