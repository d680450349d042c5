/* Numbers out of the fields of a fluid: interpolation, energy, vorticity, fluxes, forces on faces; on a
 * graded grid with fields of which the answer is known. */
#include <math.h>
#include <stdlib.h>

#include "asserts.h"
#include "core/sim.h"
#include "flow/flow_measures.h"
#include "flow/flow_sampling.h"

enum { NX = 7, NY = 5, NZ = 6 };
static const int cells[3] = { NX, NY, NZ };
static struct ts_fluid fluid;

/* Polynomials of third degree in each coordinate; free of nothing. */
static double cubic(const double c[4], double x)
{
	return c[0] + x * (c[1] + x * (c[2] + x * c[3]));
}

static const double coefficient[4][3][4] = {
	{ { 0.7, 1.3, -0.4, 0.23 }, { 1.1, -0.3, 0.8, -0.17 }, { 0.9, 0.2, -0.6, 0.31 } },
	{ { -0.2, 0.5, 1.4, -0.6 }, { 0.6, 1.7, -0.9, 0.41 }, { 1.2, -0.8, 0.3, 0.19 } },
	{ { 0.4, -1.1, 0.3, 0.52 }, { 0.8, 0.7, 0.5, -0.29 }, { -0.5, 1.6, 0.2, -0.37 } },
	{ { 1.5, 0.6, -0.7, 0.33 }, { -0.9, 0.4, 1.2, 0.26 }, { 0.3, 1.9, -0.1, 0.44 } }, /* p */
};

/* Component k (3: the pressure) of degree 3, or of degree 1 along each axis. */
static double exact(int k, int degree, const double x[3])
{
	double value = 1;

	for (int d = 0; d < 3; d++) {
		const double *c = coefficient[k][d];

		value *= degree == 3 ? cubic(c, x[d]) : c[0] + c[1] * x[d];
	}
	return value;
}

static void place_of(int k, const int cell[3], double x[3])
{
	for (int d = 0; d < 3; d++)
		x[d] = d == k ? fluid.grid.face[d][cell[d]] : fluid.grid.centre[d][cell[d]];
}

/* Values in the grid; in ghosts what makes the value on the wall come out as it is there: 2 u_wall - u. */
static void set_field(int k, int degree, double *field)
{
	const struct ts_grid *grid = &fluid.grid;
	int cell[3];

	for (cell[2] = -1; cell[2] <= NZ; cell[2]++)
		for (cell[1] = -1; cell[1] <= NY; cell[1]++)
			for (cell[0] = -1; cell[0] <= NX; cell[0]++) {
				double x[3], value = 0;
				int axis[3], n = 0;

				place_of(k, cell, x);
				for (int d = 0; d < 3; d++)
					if (d != k && k < 3 && (cell[d] < 0 || cell[d] >= cells[d]))
						axis[n++] = d;
				/* product of (2 on the wall - mirrored) over the axes that are outside */
				for (int corner = 0; corner < 1 << n; corner++) {
					double y[3] = { x[0], x[1], x[2] }, factor = 1;

					for (int a = 0; a < n; a++) {
						int d = axis[a];
						double wall = grid->face[d][cell[d] < 0 ? 0 : cells[d]];

						y[d] = corner >> a & 1 ? wall : 2 * wall - x[d];
						factor *= corner >> a & 1 ? 2 : -1;
					}
					value += factor * exact(k, degree, y);
				}
				field[ts_at(grid, cell[0], cell[1], cell[2])] = value;
			}
}

static void set_fluid(int degree)
{
	for (int d = 0; d < 3; d++)
		set_field(d, degree, fluid.u[d]);
	set_field(3, degree, fluid.p);
}

static void start(void)
{
	static double x[NX + 1], y[NY + 1], z[NZ + 1];
	const double *const face[3] = { x, y, z };
	const bool periodic[3] = { false, false, false };

	for (int i = 0; i <= NX; i++)
		x[i] = -0.3 + 0.11 * i + 0.013 * i * i;
	for (int j = 0; j <= NY; j++)
		y[j] = 0.2 + 0.17 * j;
	for (int k = 0; k <= NZ; k++)
		z[k] = 0.1 + 0.21 * k - 0.009 * k * k;
	fluid = (struct ts_fluid){ .density = 2.385, .viscosity = 0.731 };
	ck_assert(ts_grid_make(&fluid.grid, 3, cells, face, periodic) == TS_OK);
	ck_assert(ts_fluid_make(&fluid) == TS_OK);
	for (int d = 0; d < 3; d++)
		for (int side = 0; side < 2; side++) {
			fluid.face[d][side] = TS_FLOW_WALL;
			fluid.ghost_weights[d][side][0] = 2;
			fluid.ghost_weights[d][side][1] = -1;
		}
}

static void stop(void)
{
	ts_fluid_release(&fluid);
}

/* Places all over the grid, on its faces and corners too. */
static void random_place(uint64_t *state, double x[3])
{
	for (int d = 0; d < 3; d++) {
		double lo = fluid.grid.face[d][0], hi = fluid.grid.face[d][cells[d]], part;

		*state = *state * 6364136223846793005u + 1442695040888963407u;
		part = 1.4 * (double)(*state >> 11) / 9007199254740992.0 - 0.2;
		x[d] = part <= 0 ? lo : part >= 1 ? hi : lo + part * (hi - lo);
	}
}

static void check_samples(int degree, int interpolation)
{
	int items[] = { 4, 5, 6, 8 }; /* vx vy vz p */
	struct ts_flow_sampler sampler = { .interpolation = interpolation, .list = { 4, items } };
	uint64_t state = 17;
	double x[3], out[4];

	set_fluid(degree);
	for (int n = 0; n < 400; n++) {
		random_place(&state, x);
		ts_flow_sample(&sampler, &fluid, x, 0, out);
		for (int k = 0; k < 4; k++)
			ck_assert_double_eq_tol(out[k], exact(k, degree, x), 1e-13);
	}
}

START_TEST(linear_is_exact_for_lines)
{
	check_samples(1, 0);
}
END_TEST

START_TEST(cubic_is_exact_for_cubics)
{
	check_samples(3, 1);
	check_samples(1, 1);
}
END_TEST

/* As particles see it. */
START_TEST(linear_is_that_of_particles)
{
	int items[] = { 4, 5, 6 };
	struct ts_flow_sampler sampler = { .list = { 3, items } };
	uint64_t state = 29;
	double x[3], u[3], out[3];

	set_fluid(3);
	for (int n = 0; n < 400; n++) {
		random_place(&state, x);
		ts_flow_sample(&sampler, &fluid, x, 0, out);
		ts_fluid_velocity(&fluid, x, u);
		for (int k = 0; k < 3; k++)
			ck_assert_double_eq_tol(out[k], u[k], 1e-13);
	}
}
END_TEST

START_TEST(coordinates_and_speed)
{
	int items[] = { 0, 1, 2, 3, 7, 9 }; /* x y z s speed void */
	struct ts_flow_sampler sampler = { .list = { 6, items } };
	const double x[3] = { 0.05, 0.61, 0.47 };
	double out[6], u[3];

	set_fluid(1);
	ts_flow_sample(&sampler, &fluid, x, 0.385, out);
	for (int d = 0; d < 3; d++) {
		ck_assert_double_eq(out[d], x[d]);
		u[d] = exact(d, 1, x);
	}
	ck_assert_double_eq(out[3], 0.385);
	ck_assert_double_eq_tol(out[4], sqrt(u[0] * u[0] + u[1] * u[1] + u[2] * u[2]), 1e-14);
	ck_assert_double_eq(out[5], 1);
}
END_TEST

/* u = W x x: the vorticity is 2 W, in every cell, at every edge and place. */
START_TEST(solid_rotation)
{
	static const double turn[3] = { 0.7, -1.3, 0.45 };
	int items[] = { 10, 11, 12 };
	struct ts_flow_sampler sampler = { .list = { 3, items } };
	const struct ts_grid *grid = &fluid.grid;
	uint64_t state = 3;
	double x[3], w[3];
	int cell[3];

	for (int d = 0; d < 3; d++)
		for (cell[2] = -1; cell[2] <= NZ; cell[2]++)
			for (cell[1] = -1; cell[1] <= NY; cell[1]++)
				for (cell[0] = -1; cell[0] <= NX; cell[0]++) {
					int b = (d + 1) % 3, c = (d + 2) % 3;

					place_of(d, cell, x);
					fluid.u[d][ts_at(grid, cell[0], cell[1], cell[2])] =
						turn[b] * x[c] - turn[c] * x[b];
				}
	for (cell[2] = 0; cell[2] < NZ; cell[2]++)
		for (cell[1] = 0; cell[1] < NY; cell[1]++)
			for (cell[0] = 0; cell[0] < NX; cell[0]++) {
				ts_flow_centre_vorticity(&fluid, cell, w);
				for (int d = 0; d < 3; d++)
					ck_assert_double_eq_tol(w[d], 2 * turn[d], 1e-13);
			}
	for (int n = 0; n < 50; n++) {
		random_place(&state, x);
		ts_flow_sample(&sampler, &fluid, x, 0, w);
		for (int d = 0; d < 3; d++)
			ck_assert_double_eq_tol(w[d], 2 * turn[d], 1e-13);
	}
}
END_TEST

static double volume(void)
{
	double v = 1;

	for (int d = 0; d < 3; d++)
		v *= fluid.grid.face[d][cells[d]] - fluid.grid.face[d][0];
	return v;
}

START_TEST(energy_of_uniform_flow)
{
	static const double u[3] = { 1.3, -0.4, 0.85 };

	for (int d = 0; d < 3; d++)
		for (size_t k = 0; k < fluid.grid.size; k++)
			fluid.u[d][k] = u[d];
	ck_assert_double_eq_tol(ts_flow_kinetic_energy(&fluid),
				0.5 * 2.385 * volume() * (1.69 + 0.16 + 0.7225), 1e-13);
	fluid.void_fraction = ts_grid_field(&fluid.grid);
	for (size_t k = 0; k < fluid.grid.size; k++)
		fluid.void_fraction[k] = 0.6;
	ck_assert_double_eq_tol(ts_flow_kinetic_energy(&fluid),
				0.6 * 0.5 * 2.385 * volume() * (1.69 + 0.16 + 0.7225), 1e-13);
}
END_TEST

/* u across x is linear in x, and in y and z, where cell middles give the mean exactly. */
START_TEST(flux)
{
	const struct ts_grid *grid = &fluid.grid;
	double at = 0.5 * (grid->face[0][2] + 3 * grid->face[0][3]) / 2, area = 1;
	double middle[3] = { at, 0, 0 };
	struct ts_flow_flux_sums through;

	set_fluid(1);
	for (int d = 1; d < 3; d++) {
		middle[d] = 0.5 * (grid->face[d][0] + grid->face[d][cells[d]]);
		area *= grid->face[d][cells[d]] - grid->face[d][0];
	}
	ts_flow_flux(&fluid, NULL, 0, at, NULL, &through);
	ck_assert_double_eq_tol(through.area, area, 1e-13);
	ck_assert_double_eq_tol(through.flux, area * exact(0, 1, middle), 1e-13);
	middle[0] = grid->face[0][NX];
	ts_flow_flux(&fluid, NULL, 0, middle[0], NULL, &through);
	ck_assert_double_eq_tol(through.flux, area * exact(0, 1, middle), 1e-13);
}
END_TEST

/* Shear flow u = g y along x over walls across y, pressure linear: forces are area times mu g and p. */
START_TEST(forces)
{
	const double g = 1.7;
	const struct ts_grid *grid = &fluid.grid;
	struct ts_flow_face_load push;
	double area = 1, middle[3];
	int cell[3];

	set_field(3, 1, fluid.p);
	for (int d = 0; d < 3; d++) {
		middle[d] = 0.5 * (grid->face[d][0] + grid->face[d][cells[d]]);
		area *= d == 1 ? 1 : grid->face[d][cells[d]] - grid->face[d][0];
	}
	for (cell[2] = 0; cell[2] < NZ; cell[2]++)
		for (cell[1] = -1; cell[1] <= NY; cell[1]++)
			for (cell[0] = 0; cell[0] <= NX; cell[0]++)
				fluid.u[0][ts_at(grid, cell[0], cell[1], cell[2])] =
					g * grid->centre[1][cell[1]];
	for (int side = 0; side < 2; side++) {
		double sign = side ? 1 : -1;

		ts_flow_face_force(&fluid, NULL, 1, (enum ts_grid_side)side, NULL, &push);
		middle[1] = grid->face[1][side ? NY : 0];
		ck_assert_double_eq_tol(push.area, area, 1e-13);
		ck_assert_double_eq_tol(push.pressure[1], sign * area * exact(3, 1, middle), 1e-13);
		ck_assert_double_eq_tol(push.shear[0], -sign * area * 0.731 * g, 1e-13);
		ck_assert_double_eq(push.shear[1], 0);
		ck_assert_double_eq(push.shear[2], 0);
	}
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("numbers out of a flow");
	TCase *all = tcase_create("all");
	SRunner *runner;
	int failed;

	tcase_add_checked_fixture(all, start, stop);
	tcase_add_test(all, linear_is_exact_for_lines);
	tcase_add_test(all, cubic_is_exact_for_cubics);
	tcase_add_test(all, linear_is_that_of_particles);
	tcase_add_test(all, coordinates_and_speed);
	tcase_add_test(all, solid_rotation);
	tcase_add_test(all, energy_of_uniform_flow);
	tcase_add_test(all, flux);
	tcase_add_test(all, forces);
	suite_add_tcase(suite, all);
	runner = srunner_create(suite);
	srunner_run_all(runner, CK_NORMAL);
	failed = srunner_ntests_failed(runner);
	srunner_free(runner);
	return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
