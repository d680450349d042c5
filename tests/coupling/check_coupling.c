/* Particles in a fluid that is solved for: how they are laid down on its grid. */
#include <string.h>

#include "base/alloc.h"
#include "coupling/interpolation_weights.h"
#include "coupling/volume_distribution.h"
#include "deck.h"
#include "flow/flow.h"
#include "geom/ball_corner.h"
#include "particle/particles.h"

static const double PI = 3.14159265358979323846;

static struct ts_fluid *fluid_of(struct tsim *sim)
{
	struct ts_instance *flow = ts_sim_only(sim, TS_KIND_FLOW);

	return ts_flow_style_of(flow)->fluid(flow);
}

/* ---- how much of a ball lies beyond a corner */

/* Sum over thin slices. */
static double sliced(double a, double b, double c)
{
	double low = fmax(a, -1), sum = 0;
	int n = 20000;

	for (int i = 0; i < n && low < 1; i++) {
		double x = low + (i + 0.5) * (1 - low) / n, s = sqrt(1 - x * x);

		sum += s * s * ts_ball_corner_disc(b / s, c / s);
	}
	return low < 1 ? sum * (1 - low) / n : 0;
}

START_TEST(corners_of_a_ball)
{
	static const double corner[][3] = { { 0.1, 0.2, 0.3 },	 { -0.3, 0.2, 0.5 },   { -0.4, -0.2, -0.7 },
					    { 0.6, 0.5, -0.9 },	 { -0.9, 0.8, -0.1 },  { -2, 0.3, 0.1 },
					    { 0.7, 0.72, -1.5 }, { 0.57, 0.57, 0.57 }, { -1, -1, -1 } };

	DECK_NEAR(ts_ball_corner(0, 0, 0), PI / 6, 1e-15);
	DECK_NEAR(ts_ball_corner(-1, -1, -1), 4 * PI / 3, 1e-14);
	DECK_NEAR(ts_ball_corner(-3, 0.3, -7), PI / 3 * 0.7 * 0.7 * 2.3, 1e-14);
	DECK_NEAR(ts_ball_corner_disc(0.3, -1), acos(0.3) - 0.3 * sqrt(1 - 0.09), 1e-15);
	DECK_NEAR(ts_ball_corner_disc(-0.3, 0.2) + ts_ball_corner_disc(0.3, 0.2),
		  acos(0.2) - 0.2 * sqrt(0.96), 1e-15);
	for (size_t k = 0; k < DECK_LENGTH(corner); k++) {
		const double *c = corner[k];

		DECK_NEAR(ts_ball_corner(c[0], c[1], c[2]), sliced(c[0], c[1], c[2]), 1e-7);
		DECK_NEAR(ts_ball_corner(c[0], c[1], c[2]), ts_ball_corner(c[2], c[0], c[1]), 2e-15);
		/* the two sides of a plane make the whole */
		DECK_NEAR(ts_ball_corner(c[0], c[1], c[2]) + ts_ball_corner(-c[0], c[1], c[2]),
			  ts_ball_corner(-1, c[1], c[2]), 4e-15);
	}
}
END_TEST

/* All corners at once are bitwise the same, whatever planes cut the ball. */
START_TEST(corners_at_once)
{
	static const double cut[] = { -1, -0.99, -0.57, -0.2, -0., 0, 1e-9, 0.3, 0.57, 0.8, 0.999 };
	const size_t n = DECK_LENGTH(cut);

	for (size_t k = 0; k < n * n * n; k++) {
		const double a[3] = { cut[k % n], cut[k / n % n], cut[k / n / n] };

		for (int set = 0; set < 8; set++) {
			const bool cuts[3] = { set & 1, set & 2, set & 4 };
			double out[8];

			ts_ball_corners(a, cuts, out);
			for (int c = 0; c < 8; c++)
				if ((c & set) == c)
					ck_assert(out[c] == ts_ball_corner(c & 1 ? a[0] : -1.3,
									   c & 2 ? a[1] : -1,
									   c & 4 ? a[2] : -2));
		}
	}
}
END_TEST

/* ---- a grid by itself, graded along y, periodic along x, with outlets along z */

static void make_fluid(struct ts_fluid *fluid)
{
	static const int n[3] = { 5, 6, 4 };
	static const bool periodic[3] = { true, false, false };
	static const double x[6] = { -0.5, -0.3, -0.1, 0.1, 0.3, 0.5 };
	static const double y[7] = { 0, 0.1, 0.23, 0.4, 0.61, 0.8, 0.93 };
	static const double z[5] = { 1, 1.2, 1.4, 1.6, 1.8 };
	static const double *const face[3] = { x, y, z };

	*fluid = (struct ts_fluid){ .face = { { TS_FLOW_PERIODIC, TS_FLOW_PERIODIC },
					      { TS_FLOW_WALL, TS_FLOW_WALL },
					      { TS_FLOW_OUTLET, TS_FLOW_OUTLET } } };
	ck_assert_int_eq(ts_grid_make(&fluid->grid, 3, n, face, periodic), TS_OK);
}

static double control_volume(const struct ts_grid *grid, int c, const int i[3])
{
	double volume = 1;

	for (int d = 0; d < 3; d++)
		volume *= d == c ? grid->gap[d][i[d]] : grid->width[d][i[d]];
	return volume;
}

static struct ts_coupling_weights face_weights(const struct ts_fluid *fluid, int c, const double place[3],
					       const int cell[3], enum ts_coupling_interpolation how)
{
	struct ts_coupling_weights all[3];

	ts_coupling_weights_faces(fluid, place, cell, how, all);
	return all[c];
}

/* What a particle at x lays down is all of it, none of it on the boundary. */
static void lays_down_all(struct ts_fluid *fluid, const double x[3], int c,
			  enum ts_coupling_interpolation how)
{
	const struct ts_grid *grid = &fluid->grid;
	double *q = ts_grid_field(grid), *source = ts_grid_field(grid), *rate = ts_grid_field(grid);
	double place[3], sums[2] = { 0 }, mean;
	struct ts_coupling_weights share;
	int cell[3], i[3];

	for (size_t k = 0; k < grid->size; k++)
		q[k] = 0.3 + 0.01 * (double)(k % 17);
	ck_assert(ts_coupling_locate(fluid, x, place, cell));
	if (c < 0)
		ts_coupling_weights_centre(fluid, place, cell, how, &share);
	else
		share = face_weights(fluid, c, place, cell, how);
	mean = ts_coupling_distribute_force(grid, &share, c, q, 2.385, 0.73, source, rate);
	DECK_NEAR(mean, ts_coupling_interpolate(grid, &share, q), 1e-15);
	for (i[2] = 0; i[2] < grid->n[2]; i[2]++)
		for (i[1] = 0; i[1] < grid->n[1]; i[1]++)
			for (i[0] = 0; i[0] < grid->n[0]; i[0]++) {
				size_t at = ts_at(grid, i[0], i[1], i[2]);
				double volume = control_volume(grid, c, i);

				ck_assert(rate[at] >= 0);
				ck_assert(c < 1 || i[c] > 0 || rate[at] == 0);
				sums[0] += (source[at] - rate[at] * q[at]) * volume;
				sums[1] += rate[at] * volume;
			}
	DECK_NEAR(sums[0], -2.385, 1e-14);
	DECK_NEAR(sums[1], 0.73, 1e-14);
	ts_grid_field_free(q);
	ts_grid_field_free(source);
	ts_grid_field_free(rate);
}

START_TEST(what_is_laid_down_is_all_of_it)
{
	static const double places[][3] = { { 0.07, 0.33, 1.37 }, { -0.49, 0.02, 1.03 }, { 0.48, 0.92, 1.79 },
					    { 0.5, 0.93, 1.8 },	  { -0.5, 0, 1 },	 { 1.2, 0.5, 1.5 } };
	struct ts_fluid fluid;
	int cell[3];
	double place[3];

	make_fluid(&fluid);
	for (size_t k = 0; k < DECK_LENGTH(places); k++)
		for (int c = -1; c < 3; c++)
			for (int how = 0; how < 2; how++)
				lays_down_all(&fluid, places[k], c, (enum ts_coupling_interpolation)how);
	ck_assert(!ts_coupling_locate(&fluid, (const double[]){ 0, -0.01, 1.5 }, place, cell));
	ck_assert(!ts_coupling_locate(&fluid, (const double[]){ 0, 0.5, NAN }, place, cell));
	ts_grid_release(&fluid.grid);
}
END_TEST

/* ---- volumes in cells */

static double part_of_cell(const struct ts_grid *grid, int i, int j, int k, const double x[3], double r)
{
	int n = 40, inside = 0;

	for (int c = 0; c < n * n * n; c++) {
		double dx = grid->face[0][i] + (c % n + 0.5) / n * grid->width[0][i] - x[0];
		double dy = grid->face[1][j] + (c / n % n + 0.5) / n * grid->width[1][j] - x[1];
		double dz = grid->face[2][k] + (c / n / n + 0.5) / n * grid->width[2][k] - x[2];

		dx -= round(dx); /* the box is 1 long and periodic */
		inside += dx * dx + dy * dy + dz * dz < r * r;
	}
	return (double)inside / (n * n * n);
}

START_TEST(divided_volumes)
{
	static const double x[3] = { 0.44, 0.37, 1.33 }, radius = 0.217;
	const struct ts_coupling_volume how = { TS_VOLUME_DIVIDED, false, 0 };
	struct ts_fluid fluid;
	const struct ts_grid *grid = &fluid.grid;
	double place[3], *part, sum = 0;
	int cell[3];

	make_fluid(&fluid);
	part = ts_grid_field(grid);
	ck_assert(ts_coupling_locate(&fluid, x, place, cell));
	ts_coupling_volume_add(grid, &how, place, cell, radius, part);
	for (int k = 0; k < grid->n[2]; k++)
		for (int j = 0; j < grid->n[1]; j++)
			for (int i = 0; i < grid->n[0]; i++) {
				double got = part[ts_at(grid, i, j, k)];

				DECK_NEAR(got, part_of_cell(grid, i, j, k, x, radius), 2e-3);
				sum += got * ts_grid_volume(grid, i, j, k);
			}
	DECK_NEAR(sum, 4 * PI / 3 * radius * radius * radius, 1e-16);
	ts_grid_field_free(part);
	ts_grid_release(&fluid.grid);
}
END_TEST

static const char bed[] = "units si\n"
			  "boundary p f p\n"
			  "newton off\n"
			  "communicate single vel yes\n"
			  "region box block 0 1 0 1.3 0 0.7 units box\n"
			  "region in block 0.05 0.95 0.1 1.2 0.05 0.65 units box\n"
			  "create_box 1 box\n"
			  "create_atoms 1 random 300 2385 in\n"
			  "set group all diameter 0.0731 density 2385\n"
			  "flow_style projection cells 9 12 9 viscosity 1.3e-3 density 731\n"
			  "pressure_style cg\n"
			  "timestep 1e-4\n";

START_TEST(void_fraction_keeps_the_volume)
{
	static const char *const methods[] = { "centre", "divided", "kernel reach 1.13" };
	struct tsim *sim =
		deck_open("%sfix e all void_fraction method %s least 0.001\nrun 0", bed, methods[_i]);
	double volume = 1.0 * 1.3 * 0.7, taken = 300 * PI / 6 * pow(0.0731, 3);

	DECK_NEAR(deck_value(sim, "f_e[1]"), 1 - taken / volume, 1e-14);
	ck_assert(deck_value(sim, "f_e[2]") < 1 - taken / volume);
	tsim_close(sim);
}
END_TEST

/* The fields do not depend on threads or on how particles lie in memory. */
START_TEST(fields_do_not_depend_on_order)
{
	static const char *const ways[] = { "", "package omp 3", "atom_modify sort 1 0.3" };
	struct ts_fluid *fluid[3];
	struct tsim *sim[3];

	for (int k = 0; k < 3; k++) {
		sim[k] = deck_open("%s", bed);
		sim[k]->grain = 1; /* threads, however little there is to do */
		deck(sim[k],
		     "%s\nvelocity all create 1e19 2385\nfix e all void_fraction method %s\n"
		     "fix d all drag/di_felice scheme implicit\nfix m all nve\nrun 2",
		     ways[k], _i ? "divided" : "kernel");
		fluid[k] = fluid_of(sim[k]);
		ck_assert_mem_eq(fluid[k]->void_fraction, fluid[0]->void_fraction,
				 fluid[0]->grid.size * sizeof(double));
		for (int c = 0; c < 3; c++)
			ck_assert_mem_eq(fluid[k]->u[c], fluid[0]->u[c],
					 fluid[0]->grid.size * sizeof(double));
	}
	for (int k = 0; k < 3; k++)
		tsim_close(sim[k]);
}
END_TEST

/* ---- what particles gain the fluid loses */

/* Momentum of particles, between steps where velocity Verlet has half of the kick to come, and of the
 * fluid. */
static void momentum(struct tsim *sim, double out[3])
{
	const struct ts_particles *p = sim->particles;
	const struct ts_fluid *fluid = fluid_of(sim);
	const struct ts_grid *grid = &fluid->grid;

	for (int c = 0; c < 3; c++) {
		out[c] = 0;
		for (size_t i = 0; i < p->n; i++)
			out[c] += p->mass[i] * p->v[i][c] + 0.5 * sim->clock.dt * p->f[i][c];
		for (int k = 0; k < grid->n[2]; k++)
			for (int j = 0; j < grid->n[1]; j++)
				for (int i = 0; i < grid->n[0]; i++)
					out[c] += fluid->density * ts_grid_volume(grid, i, j, k) *
						  fluid->u[c][ts_at(grid, i, j, k)];
	}
}

/* Alone, and a thick crowd that would hold the fluid within a part of a step and be held by it. */
START_TEST(momentum_is_kept)
{
	static const struct {
		const char *fluid, *drag;
		double diameter, viscosity, density;
		int cells;
	} ways[] = {
		{ "", "drag/schiller_naumann", 0.02, 0.13, 1.31, 8 },
		{ "every 3", "drag/stokes scheme exact", 0.02, 0.13, 1.31, 8 },
		{ "", "drag/stokes scheme exact", 0.05, 2236, 238.5, 4 },
		{ "", "drag/schiller_naumann scheme implicit interpolation cell", 0.05, 2236, 238.5, 4 },
		{ "time rk3", "drag/stokes scheme implicit", 0.002, 0.13, 1.31, 8 },
		{ "", "drag/schiller_naumann scheme exact axes xz", 0.02, 0.13, 1.31, 7 },
		{ "every 3", "drag/schiller_naumann scheme exact lagged yes", 0.01, 0.13, 1.31, 7 },
		{ "substeps 3 time ab2", "drag/stokes scheme exact", 0.01, 0.13, 1.31, 7 },
	};
	double before[3], after[3], size = 2385 * 2000 * PI / 6 * pow(ways[_i].diameter, 3) * 0.5;
	struct tsim *sim =
		deck_open("units si\n"
			  "boundary p p p\n"
			  "newton off\n"
			  "communicate single vel yes\n"
			  "region box block 0 1 0 1.3 0 0.7 units box\n"
			  "create_box 1 box\n"
			  "create_atoms 1 random 2000 2385 box\n"
			  "set group all diameter %g density 2385\n"
			  "flow_style projection cells %d 5 3 viscosity %g density %g %s\n"
			  "pressure_style %s\n"
			  "velocity all create 1 2385\n"
			  "velocity all set 0.5 -0.3 0.2 sum yes\n"
			  "fix d all %s\n"
			  "fix m all nve\n"
			  "timestep 0.001\n"
			  "run 0",
			  ways[_i].diameter, ways[_i].cells, ways[_i].viscosity, ways[_i].density,
			  ways[_i].fluid, strstr(ways[_i].drag, "lagged") ? "direct" : "cg", ways[_i].drag);

	deck(sim, "run 3");
	momentum(sim, before);
	deck(sim, "run 24");
	momentum(sim, after);
	for (int c = 0; c < 3; c++)
		DECK_NEAR(after[c], before[c], 1e-12 * size);
	/* and it has moved something */
	ck_assert(fabs(fluid_of(sim)->u[0][ts_at(&fluid_of(sim)->grid, 1, 2, 1)]) > 1e-5);
	tsim_close(sim);
}
END_TEST

/* Evenly spread spheres and their fluid come to one velocity: the slip dies by exp(-(1 + M) t/tau), M the
 * mass of the spheres by that of the fluid. The error falls with the step. */
static double slip_error(const char *scheme, int steps)
{
	const double tau = 2385 * 0.05 * 0.05 / (18 * 2.236),
		     load = 512 * 2385 * PI / 6 * pow(0.05, 3) / 238.5;
	const double time = 0.1;
	struct tsim *sim =
		deck_open("units si\nboundary p p p\nnewton off\ncommunicate single vel yes\n"
			  "region box block 0 1 0 1 0 1 units box\ncreate_box 1 box\n"
			  "lattice sc 0.125 origin 0.5 0.5 0.5\ncreate_atoms 1 box\n"
			  "set group all diameter 0.05 density 2385\n"
			  "flow_style projection cells 4 4 4 viscosity 2.236 density 238.5\n"
			  "velocity all set 0.3 0 0\nfix d all drag/stokes scheme %s\nfix m all nve\n"
			  "timestep %.17g\nrun %d",
			  scheme, time / steps, steps);
	double v[512], slip;

	deck_column(sim, "vx", v, 512, 0);
	slip = (v[0] - fluid_of(sim)->u[0][ts_at(&fluid_of(sim)->grid, 1, 1, 1)]) / 0.3;
	DECK_NEAR(v[7], v[0], 1e-12);
	tsim_close(sim);
	return fabs(slip / exp(-(1 + load) * time / tau) - 1);
}

START_TEST(slip_dies_out)
{
	static const char *const schemes[] = { "explicit", "exact", "implicit", "exact lagged yes" };
	double coarse = slip_error(schemes[_i], 20), fine = slip_error(schemes[_i], 80);

	ck_assert_msg(fine < 0.03 && fine < 0.4 * coarse, "%s: %g, %g", schemes[_i], coarse, fine);
}
END_TEST

/* The pressure drop of a bed that is held, by the step. */
static double bed_drop(double step)
{
	struct tsim *sim = deck_open("units si\nboundary p p f\nnewton off\ncommunicate single vel yes\n"
				     "region box block 0 0.01 0 0.01 0 0.06 units box\n"
				     "region bed block 0 0.01 0 0.01 0.02 0.04 units box\n"
				     "create_box 1 box\nlattice sc 0.0011\ncreate_atoms 1 region bed\n"
				     "set group all diameter 0.001 density 2385\nfix hold all freeze\n"
				     "flow_style projection cells 1 1 15 viscosity 1e-3 density 1000\n"
				     "flow_boundary zlo inlet velocity 0 0 0.013\nflow_boundary zhi outlet\n"
				     "fix e all void_fraction\nfix d all drag/koch_hill interpolation cell\n"
				     "compute p all flow/probe 0.005 0.005 0.01 0.005 0.005 0.05 values p\n"
				     "timestep %g\nrun 1000",
				     step);
	double drop = deck_value(sim, "c_p[1][1]-c_p[2][1]");

	tsim_close(sim);
	return drop;
}

START_TEST(drop_does_not_depend_on_the_step)
{
	double drop = bed_drop(1e-3);

	ck_assert(drop > 10);
	DECK_NEAR(bed_drop(0.08) / drop, 1, 1e-6);
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("coupling");
	TCase *c = tcase_create("grid");

	tcase_add_test(c, corners_of_a_ball);
	tcase_add_test(c, corners_at_once);
	tcase_add_test(c, what_is_laid_down_is_all_of_it);
	tcase_add_test(c, divided_volumes);
	tcase_add_loop_test(c, void_fraction_keeps_the_volume, 0, 3);
	tcase_add_loop_test(c, fields_do_not_depend_on_order, 0, 2);
	tcase_add_loop_test(c, momentum_is_kept, 0, 8);
	tcase_add_loop_test(c, slip_dies_out, 0, 4);
	tcase_add_test(c, drop_does_not_depend_on_the_step);
	suite_add_tcase(suite, c);
	return deck_main(suite);
}
