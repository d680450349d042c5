/* The fluid: steps, boundaries and operators of flow_style projection, with known answers. */
#include <stdlib.h>
#include <string.h>

#include "deck.h"

#include "base/alloc.h"
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
	deck(sim,
	     "flow_style projection cells 6 9 %d viscosity 0.2385 density 2 body_force 0.7 0 0 %s\n"
	     "pressure_style cg tolerance 1e-13\n"
	     "timestep 0.01\n"
	     "run 2000\n",
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
	run_channel(0, "", 1e-8);
	run_channel(1, "", 1e-8);
	run_channel(0, "convection quick", 1e-8);
	run_channel(0, "convection cubista time rk2", 1e-8);
	run_channel(1, "convection donor form fd", 1e-8);
	run_channel(1, "viscous implicit time ab2", 1e-8);
	run_channel(0, "viscous backward", 1e-8);
	run_channel(0, "wall linear time ab2", 0.7 / (0.2385 / 2) / 8 / 81 + 1e-9);
}
END_TEST

/* ---- orders: vortices of Taylor and Green, carried along by a mean flow */

/* Runs to a fixed time; velocities of component c to out, n x n. */
static void run_vortices(int n, double dt, int steps, const char *words, double *out)
{
	struct tsim *sim = deck_open("units si\nboundary p p p\ndimension 2\n"
				     "region box block 0 1 0 1 -0.5 0.5 units box\ncreate_box 1 box\n"
				     "neighbor 0.001 bin\n");
	struct ts_fluid *fluid;

	deck(sim,
	     "variable x internal 0\nvariable y internal 0\n"
	     "variable u equal 0.71+sin(2*PI*v_x)*cos(2*PI*v_y)\n"
	     "variable v equal 0.37-cos(2*PI*v_x)*sin(2*PI*v_y)\n"
	     "flow_style projection cells %d %d 1 viscosity 0.02 density 1 %s\n"
	     "flow_set velocity v_u v_v 0 set x x set y y\n"
	     "timestep %.17g\nrun %d\n",
	     n, n, words, dt, steps);
	fluid = fluid_of(sim);
	for (int j = 0; j < n; j++)
		memcpy(out + j * n, fluid->u[0] + ts_at(&fluid->grid, 0, j, 0), (size_t)n * sizeof *out);
	tsim_close(sim);
}

static double vortices_error(int n, double dt, int steps, const char *words)
{
	double *u = malloc((size_t)(n * n) * sizeof *u), t = dt * steps, sum = 0;

	ck_assert_ptr_nonnull(u);
	run_vortices(n, dt, steps, words, u);
	for (int j = 0; j < n; j++)
		for (int i = 0; i < n; i++) {
			double x = (double)i / n - 0.71 * t, y = (j + 0.5) / n - 0.37 * t;
			double exact =
				0.71 + sin(2 * PI * x) * cos(2 * PI * y) * exp(-8 * PI * PI * 0.02 * t);

			sum += pow(u[j * n + i] - exact, 2);
		}
	free(u);
	return sqrt(sum) / n;
}

START_TEST(order_in_space)
{
	static const struct {
		const char *words;
		double order;
	} cases[] = {
		{ "time rk3 convection central", 2 },	    { "time rk3 convection quick", 2 },
		{ "time rk3 convection cubista", 2 },	    { "time rk3 convection donor gamma 1", 1 },
		{ "time rk3 convection donor gamma 0", 2 }, { "time rk3 form fd convection central", 2 },
	};
	FILE *table = deck_table("Order in space");

	for (size_t k = 0; k < DECK_LENGTH(cases); k++) {
		double step[3], error[3], order;

		for (int m = 0; m < 3; m++) {
			step[m] = 1.0 / (12 << m);
			error[m] = vortices_error(12 << m, 0.004, 50, cases[k].words);
		}
		order = deck_order(step, error, 3);
		if (table)
			fprintf(table, "%s\t%g\t%g\t%g\t%.3f\n", cases[k].words, error[0], error[1], error[2],
				order);
		ck_assert_msg(order > cases[k].order - 0.25, "%s: order %g, errors %g %g %g", cases[k].words,
			      order, error[0], error[1], error[2]);
	}
}
END_TEST

/* A cavity whose lid swings and whose left wall blows what the right one takes. */
static void run_lid(int n, double dt, int steps, const char *words, double *out)
{
	struct tsim *sim = deck_open(box[0], "f f p");
	struct ts_fluid *fluid;

	deck(sim,
	     "variable lid equal 1.3*sin(7*time)\nvariable y internal 0\n"
	     "variable blow equal 0.3*sin(5*time)*v_y*(1-v_y)\n"
	     "flow_style projection cells %d %d 1 viscosity 0.02 density 1 %s\n"
	     "flow_boundary yhi wall velocity v_lid 0 0\n"
	     "flow_boundary xlo inlet velocity v_blow 0 0 set y y\n"
	     "flow_boundary xhi inlet velocity v_blow 0 0 set y y\n"
	     "timestep %.17g\nrun %d\n",
	     n, n, words, dt, steps);
	fluid = fluid_of(sim);
	for (int j = 0; j < n; j++)
		memcpy(out + j * n, fluid->u[0] + ts_at(&fluid->grid, 0, j, 0), (size_t)n * sizeof *out);
	tsim_close(sim);
}

/* Vortices between planes of symmetry, on cells that become finer towards them. */
static double graded_error(int n, const char *words)
{
	struct tsim *sim = deck_open("units si\nboundary f f p\ndimension 2\n"
				     "region box block 0 1 0 1 -0.5 0.5 units box\ncreate_box 1 box\n");
	struct ts_fluid *fluid;
	double sum = 0;

	deck(sim,
	     "variable x internal 0\nvariable y internal 0\n"
	     "variable u equal sin(PI*v_x)*cos(PI*v_y)\nvariable v equal -cos(PI*v_x)*sin(PI*v_y)\n"
	     "flow_style projection cells %d %d 1 viscosity 0.02 density 1 %s\n"
	     "flow_grid x tanh 1.1\nflow_grid y geometric 4 fine both\nflow_boundary all slip\n"
	     "flow_set velocity v_u v_v 0 set x x set y y\ntimestep 0.002\nrun 100\n",
	     n, n, words);
	fluid = fluid_of(sim);
	for (int j = 0; j < n; j++)
		for (int i = 0; i < n; i++) {
			double exact = sin(PI * fluid->grid.face[0][i]) * cos(PI * fluid->grid.centre[1][j]) *
				       exp(-2 * PI * PI * 0.02 * 0.2);

			sum += pow(fluid->u[0][ts_at(&fluid->grid, i, j, 0)] - exact, 2);
		}
	tsim_close(sim);
	return sqrt(sum) / n;
}

START_TEST(order_on_graded_cells)
{
	static const char *const cases[] = { "time rk2 convection central", "time rk2",
					     "time rk2 convection central form fd",
					     "time ab2 viscous implicit" };
	FILE *table = deck_table("Order in space, graded cells");

	for (size_t k = 0; k < DECK_LENGTH(cases); k++) {
		double step[3], error[3], order;

		for (int m = 0; m < 3; m++) {
			step[m] = 1.0 / (8 << m);
			error[m] = graded_error(8 << m, cases[k]);
		}
		order = deck_order(step, error, 3);
		if (table)
			fprintf(table, "%s\t%g\t%g\t%g\t%.3f\n", cases[k], error[0], error[1], error[2],
				order);
		ck_assert_msg(order > 1.8, "%s: order %g, errors %g %g %g", cases[k], order, error[0],
			      error[1], error[2]);
	}
}
END_TEST

/* ---- fields between their points */

START_TEST(sampling)
{
	struct tsim *sim = deck_open(box[1], "f f p");
	struct ts_fluid *fluid;
	double u[3], gradient[3], value;
	const double x[3] = { 1.385, 0.731, 0.217 };

	deck(sim, "neighbor 0.001 bin\n"
		  "flow_style projection cells 7 9 5 viscosity 0.05 density 1.7\n"
		  "flow_grid y tanh 1.3\nflow_boundary yhi wall velocity 0.7 0 0.3\n"
		  "flow_boundary xlo slip\ntimestep 0.005\nrun 7\n");
	fluid = fluid_of(sim);
	/* on walls what is given there, in them as beside them */
	ts_fluid_velocity(fluid, (const double[]){ 0.9, 1, 0.2 }, u);
	DECK_NEAR(u[0], 0.7, 1e-14);
	DECK_NEAR(u[1], 0, 1e-14);
	DECK_NEAR(u[2], 0.3, 1e-14);
	ts_fluid_velocity(fluid, (const double[]){ 0.9, -3, 0.2 }, u);
	DECK_NEAR(u[0] * u[0] + u[2] * u[2], 0, 1e-28);
	ts_fluid_velocity(fluid, (const double[]){ 0, 0.5, 0.2 }, u);
	DECK_NEAR(u[0], 0, 1e-14);
	/* at its own points the field itself, periodic images alike */
	value = fluid->u[2][ts_at(&fluid->grid, 4, 8, 3)];
	ck_assert(value > 0.01);
	for (int turn = -1; turn < 2; turn++) {
		ts_fluid_velocity(fluid,
				  (const double[]){ fluid->grid.centre[0][4], fluid->grid.centre[1][8],
						    fluid->grid.face[2][3] + 0.5 * turn },
				  u);
		DECK_NEAR(u[2], value, 1e-14);
	}
	/* a field that is linear */
	for (int k = -2; k < 7; k++)
		for (int j = -2; j < 11; j++)
			for (int i = -2; i < 9; i++)
				fluid->p[ts_at(&fluid->grid, i, j, k)] = 1.3 + 2 * fluid->grid.centre[0][i] -
									 3 * fluid->grid.centre[1][j] +
									 5 * fluid->grid.centre[2][k];
	value = ts_fluid_value(fluid, fluid->p, x, gradient);
	DECK_NEAR(value, 1.3 + 2 * x[0] - 3 * x[1] + 5 * x[2], 1e-13);
	DECK_NEAR(gradient[0], 2, 1e-12);
	DECK_NEAR(gradient[1], -3, 1e-12);
	DECK_NEAR(gradient[2], 5, 1e-12);
	tsim_close(sim);
}
END_TEST

typedef void scene_fn(int n, double dt, int steps, const char *words, double *out);
enum { N = 12, FIRST = 25, FINE = 800 };

static void check_order(scene_fn *run, const char *words, const double *fine, double expected)
{
	double u[N * N], step[3], error[3] = { 0 }, order;
	FILE *table = deck_table("Order in time");

	for (int m = 0; m < 3; m++) {
		step[m] = 0.2 / (FIRST << m);
		run(N, step[m], FIRST << m, words, u);
		for (int i = 0; i < N * N; i++)
			error[m] = fmax(error[m], fabs(u[i] - fine[i]));
	}
	order = deck_order(step, error, 3);
	if (table)
		fprintf(table, "%s\t%g\t%g\t%g\t%.3f\n", words, error[0], error[1], error[2], order);
	ck_assert_msg(order > expected - 0.2, "%s: order %g, errors %g %g %g", words, order, error[0],
		      error[1], error[2]);
}

static const struct {
	const char *words;
	double vortices, lid;
} schemes[] = {
	{ "time euler", 1, 1 },
	{ "time ab2", 2, 2 },
	{ "time rk2", 2, 2 },
	{ "time rk3", 3, 2 }, /* faces are linear in time within a step */
	{ "time euler viscous backward", 1, 1 },
	{ "time ab2 viscous implicit", 2, 2 },
};

START_TEST(order_in_time)
{
	double fine[N * N];

	run_vortices(N, 0.2 / FINE, FINE, "time rk3", fine);
	for (size_t k = 0; k < DECK_LENGTH(schemes); k++)
		check_order(run_vortices, schemes[k].words, fine, schemes[k].vortices);
}
END_TEST

START_TEST(order_with_walls)
{
	double fine[N * N];

	run_lid(N, 0.2 / FINE, FINE, "time rk3", fine);
	for (size_t k = 0; k < DECK_LENGTH(schemes); k++)
		check_order(run_lid, schemes[k].words, fine, schemes[k].lid);
}
END_TEST

/* ---- particles take room, and hold the fluid */

static void set_room(struct ts_fluid *fluid, double mean, double wave)
{
	const struct ts_grid *grid = &fluid->grid;

	for (int k = 0; k < grid->n[2]; k++)
		for (int j = 0; j < grid->n[1]; j++)
			for (int i = 0; i < grid->n[0]; i++)
				fluid->void_fraction[ts_at(grid, i, j, k)] =
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
				ck_assert_int_eq(ts_fluid_require_fields(fluid[k], sim[k], TS_FLUID_VOID),
						 TS_OK);
				set_room(fluid[k], 0.385, 0);
			}
			deck(sim[k], "run 20");
		}
		for (size_t at = 0; at < fluid[0]->grid.size; at++)
			worst = fmax(worst, fabs(fluid[0]->u[0][at] - fluid[1]->u[0][at]));
		DECK_NEAR(worst, 0, 1e-13);
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
		ck_assert_int_eq(ts_fluid_require_fields(fluid, sim, TS_FLUID_VOID), TS_OK);
		set_room(fluid, 0.6, 0.3);
		deck(sim, "run 20");
		DECK_NEAR(fluid->divergence, 0, 1e-13);
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

		deck(sim,
		     "flow_style projection cells 10 4 1 viscosity 0.05 density 1.7 time %s\n"
		     "flow_boundary xlo inlet velocity %g 0 0\nflow_boundary xhi outlet\n"
		     "flow_boundary ylo slip\nflow_boundary yhi slip\n"
		     "pressure_style cg tolerance 1e-13\ntimestep 0.01\n",
		     times[s], u0);
		fluid = fluid_of(sim);
		ck_assert_int_eq(ts_fluid_require_fields(fluid, sim, TS_FLUID_VOID | TS_FLUID_EXCHANGE),
				 TS_OK);
		set_room(fluid, e, 0);
		for (int step = 0; step < 5; step++) {
			set_exchange(fluid, k);
			deck(sim, "run 1");
		}
		slope = (fluid->p[ts_at(&fluid->grid, 7, 2, 0)] - fluid->p[ts_at(&fluid->grid, 2, 2, 0)]) /
			(5 * 0.2);
		DECK_NEAR(slope, -k * u0 / e, 1e-12 * k * u0 / e);
		DECK_NEAR(fluid->exchange_velocity[0][ts_at(&fluid->grid, 5, 2, 0)], u0, 1e-14);
		tsim_close(sim);
	}
}
END_TEST

/* What flows in by an uneven void fraction does not balance, though the velocities do. */
START_TEST(uneven_inflow)
{
	struct tsim *sim = deck_open(box[0], "f f p");
	struct ts_fluid *fluid;

	deck(sim, "flow_style projection cells 8 6 1 viscosity 0.05 density 1.7\n"
		  "flow_boundary xlo inlet velocity 0.31 0 0\nflow_boundary xhi inlet velocity 0.31 0 0\n"
		  "timestep 0.01\nrun 2\n");
	fluid = fluid_of(sim);
	ck_assert_int_eq(ts_fluid_require_fields(fluid, sim, TS_FLUID_VOID), TS_OK);
	set_room(fluid, 0.6, 0);
	deck(sim, "run 2");
	for (int j = 0; j < 6; j++)
		fluid->void_fraction[ts_at(&fluid->grid, 7, j, 0)] = 0.5;
	ck_assert(!deck_accepts(sim, "run 1"));
	ck_assert_ptr_nonnull(strstr(tsim_error(sim), "incompressible"));
	tsim_close(sim);
}
END_TEST

/* ---- the k-th allocation fails, for all k: a clean error, and nothing stays behind */

static int use_all(struct tsim *sim)
{
	struct ts_instance *flow;
	int code;

	code = tsim_string(sim, "units si\nboundary f f p\ndimension 2\n"
				"region box block 0 2 0 1 -0.5 0.5 units box\ncreate_box 1 box\n"
				"variable y internal 0\nvariable u equal v_y*(1-v_y)\n"
				"flow_style projection cells 4 3 1 viscosity 0.05 density 1.7 time ab2 "
				"viscous implicit\n"
				"flow_grid y tanh 1.1\n"
				"flow_boundary xlo inlet velocity v_u 0 0 set y y\nflow_boundary xhi outlet\n"
				"flow_set velocity v_u 0 0 set y y\ntimestep 0.01\nrun 1\n"
				"flow_style none\nflow_style projection cells 4 3 1 viscosity 0.05 density "
				"1.7 time rk3\n");
	if (code)
		return code;
	flow = ts_sim_only(sim, TS_KIND_FLOW);
	if (ts_fluid_require_fields(ts_flow_style_of(flow)->fluid(flow), sim,
				    TS_FLUID_VOID | TS_FLUID_EXCHANGE) != TS_OK)
		return TSIM_NOMEM;
	return tsim_string(sim, "run 1");
}

START_TEST(out_of_memory)
{
	long before = ts_alloc_balance();
	int code = TSIM_NOMEM;
	long k = 0;

	while (code) {
		struct tsim *sim;

		ts_alloc_fail_at(++k);
		sim = tsim_open();
		code = sim ? use_all(sim) : TSIM_NOMEM;
		ts_alloc_fail_at(0);
		ck_assert_msg(code == 0 || code == TSIM_NOMEM, "allocation %ld: %s", k, tsim_error(sim));
		tsim_close(sim);
		ck_assert_int_eq(ts_alloc_balance(), before);
	}
	ck_assert_int_gt(k, 100);
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("flow");
	TCase *tcase = tcase_create("projection");

	tcase_add_test(tcase, channel);
	tcase_add_test(tcase, order_in_space);
	tcase_add_test(tcase, order_in_time);
	tcase_add_test(tcase, order_with_walls);
	tcase_add_test(tcase, order_on_graded_cells);
	tcase_add_test(tcase, sampling);
	tcase_add_test(tcase, even_room);
	tcase_add_test(tcase, uneven_room);
	tcase_add_test(tcase, bed);
	tcase_add_test(tcase, uneven_inflow);
	tcase_add_test(tcase, out_of_memory);
	suite_add_tcase(suite, tcase);
	return deck_main(suite);
}
