/* Kinetic theory of grains: constitutive functions in their limits; the shear flow between rough walls against a
 * tabulated solution, quadratures, homogeneous flow; order of convergence; balances; unknown gap, solid fraction, speed. */
#include <gsl/gsl_integration.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "kinetic/sheared_film.h"
#include "math/band.h"
#include "math/constants.h"
#include "math/rng.h"
#include "tests/deck.h"

/* ---- scenes ---- */

/* The reference case: nu 0.4, R 0.65. */
static struct ts_couette reference(void)
{
	struct ts_bumpy_wall wall = { asin(0.65), 0.65 };

	return (struct ts_couette){ .gas = { TS_GAS_LUN, TS_GAS_LUN_SAVAGE, 0.85, 0.65 },
				    .wall = { wall, wall },
				    .gap = 4 / 0.787,
				    .solids = 0.4 };
}

static struct ts_sheared_film film(void)
{
	struct ts_couette c = reference();

	return (struct ts_sheared_film){ .gas = c.gas,
					 .wall = { c.wall[0], c.wall[1] },
					 .diameter = 0.787e-3,
					 .density = 2550,
					 .gap = 4e-3,
					 .solids = 0.4,
					 .amount = NAN,
					 .speed = 2,
					 .load = NAN,
					 .points = 41,
					 .tolerance = 1e-10 };
}

static struct ts_couette_figures solved(struct ts_couette *c)
{
	struct ts_couette_figures figures;

	ck_assert(ts_couette_solve(c, ts_couette_intervals(c->gap, 41), 1e-10) == TS_OK);
	ts_couette_figures(c, &figures);
	return figures;
}

static void solve_film(struct ts_sheared_film *f)
{
	struct ts_error error = { .status = TS_OK };

	ck_assert_msg(ts_sheared_film_solve(f, NULL, &error) == TS_OK, "%s", error.message);
}

/* ---- linear equations ---- */

START_TEST(band_equations)
{
	enum { N = 23, LOW = 3, HIGH = 2 };
	struct ts_rng rng = ts_rng_start(5, 0);
	double *a = ts_alloc(ts_band_length(N, LOW, HIGH), sizeof *a), x[N], b[N] = { 0 };

	for (size_t i = 0; i < N; i++)
		x[i] = ts_rng_uniform(&rng) - 0.5;
	for (size_t i = 0; i < N; i++)
		for (size_t j = i > LOW ? i - LOW : 0; j < N && j <= i + HIGH; j++) {
			/* a main diagonal of 0 needs pivots; rows of unlike size */
			double value = i == j ? 0 : pow(10, (double)(i % 7)) * (ts_rng_uniform(&rng) - 0.5);

			*ts_band_at(a, LOW, HIGH, i, j) = value;
			b[i] += value * x[j];
		}
	ck_assert(ts_band_solve(N, LOW, HIGH, a, b));
	for (size_t i = 0; i < N; i++)
		DECK_NEAR(b[i], x[i], 1e-12);
	memset(a, 0, ts_band_length(N, LOW, HIGH) * sizeof *a);
	ck_assert(!ts_band_solve(N, LOW, HIGH, a, b));
	ts_free(a);
}
END_TEST

/* ---- constitutive functions ---- */

static const double fractions[] = { 1e-6, 0.013, 0.17, 0.385, 0.521, 0.617 };

/* Elastic grains: Enskog's transport coefficients (S. Chapman, T. G. Cowling, chapter 16). */
START_TEST(elastic_grains_are_enskog)
{
	for (int theory = 0; theory < 2; theory++)
		for (int radial = 0; radial < 2; radial++)
			for (size_t k = 0; k < DECK_LENGTH(fractions); k++) {
				struct ts_gas gas = { (enum ts_gas_theory)theory, (enum ts_gas_radial)radial,
						      1, 0.65 };
				double nu = fractions[k], slope, g0 = ts_gas_radial(&gas, nu, &slope);
				double x = nu * g0, shear = 1 + 1.6 * x, heat = 1 + 2.4 * x;
				struct ts_gas_functions g;

				ts_gas_functions(&gas, nu, &g);
				DECK_NEAR(g.pressure / (nu * (1 + 4 * x)), 1, 1e-14);
				DECK_NEAR(g.viscosity / (5 * sqrt(TS_PI) / 96 / g0 *
							 (shear * shear + 768 / (25 * TS_PI) * x * x)),
					  1, 1e-14);
				DECK_NEAR(g.conductivity / (25 * sqrt(TS_PI) / 128 / g0 *
							    (heat * heat + 512 / (25 * TS_PI) * x * x)),
					  1, 1e-14);
				DECK_NEAR(g.dufour * nu, 0, 1e-14);
				DECK_NEAR(g.dissipation, 0, 0);
			}
}
END_TEST

START_TEST(slopes_are_derivatives)
{
	for (int radial = 0; radial < 3; radial++)
		for (size_t k = 1; k < DECK_LENGTH(fractions); k++) {
			struct ts_gas gas = { TS_GAS_LUN, (enum ts_gas_radial)radial, 0.7, 0.65 };
			double nu = fractions[k], step = 1e-5, slope, ignored;
			struct ts_gas_functions low, high, g;

			ts_gas_radial(&gas, nu, &slope);
			ts_gas_functions(&gas, nu, &g);
			ts_gas_functions(&gas, nu - step, &low);
			ts_gas_functions(&gas, nu + step, &high);
			DECK_NEAR((ts_gas_radial(&gas, nu + step, &ignored) -
				   ts_gas_radial(&gas, nu - step, &ignored)) /
					  (2 * step * slope),
				  1, 1e-5);
			DECK_NEAR((high.pressure - low.pressure) / (2 * step * g.pressure_slope), 1, 1e-5);
		}
}
END_TEST

/* Garzo & Dufty, Phys. Rev. E 59 (1999) 5895: the dilute limit is that of J. J. Brey, J. W. Dufty, C. S. Kim, A. Santos,
 * Phys. Rev. E 58 (1998) 4638: eta* = 1/(nu_eta - zeta/2), kappa* = 2/3 (1 + c)/(nu_kappa - 2 zeta),
 * mu* = 2 zeta/(2 nu_kappa - 3 zeta) (kappa* + c/(3 zeta)). */
START_TEST(dilute_inelastic_grains)
{
	struct ts_gas gas = { TS_GAS_GARZO_DUFTY, TS_GAS_CARNAHAN_STARLING, 0.7, 0.65 };
	double e = 0.7, nu = 1e-9, c = 32 * (1 - e) * (1 - 2 * e * e) / (81 - 17 * e + 30 * e * e * (1 - e));
	double zeta = 5.0 / 12 * (1 - e * e) * (1 + 3.0 / 32 * c);
	double rate = (1 + e) / 3 * (1 + 33.0 / 16 * (1 - e) + (19 - 3 * e) / 1024 * c);
	double kappa = 2.0 / 3 * (1 + c) / (rate - 2 * zeta);
	struct ts_gas_functions g;

	ts_gas_functions(&gas, nu, &g);
	DECK_NEAR(g.viscosity * 96 / (5 * sqrt(TS_PI)) *
			  ((1 - 0.25 * (1 - e) * (1 - e)) * (1 - c / 64) - zeta / 2),
		  1, 1e-7);
	DECK_NEAR(g.conductivity * 128 / (25 * sqrt(TS_PI)) / kappa, 1, 1e-7);
	DECK_NEAR(g.dufour * nu * 128 / (25 * sqrt(TS_PI)) * (2 * rate - 3 * zeta) /
			  (2 * zeta * kappa + 2 * c / 3),
		  1, 1e-7);
}
END_TEST

/* The same theory for dense grains: numbers of a separate program, after the formulas of MFIX for this theory (where the
 * derivative of g0 is to be that of its logarithm). */
START_TEST(dense_inelastic_grains)
{
	static const struct {
		double e, nu, viscosity, conductivity, dufour, dissipation;
	} cases[] = { { 0.7, 0.385, 0.566782681, 1.96143861, 1.27016533, 1.77713925 },
		      { 0.9, 0.521, 2.06861313, 7.37132689, 0.875315337, 2.34304008 } };

	for (size_t k = 0; k < DECK_LENGTH(cases); k++) {
		struct ts_gas gas = { TS_GAS_GARZO_DUFTY, TS_GAS_CARNAHAN_STARLING, cases[k].e, 0.65 };
		struct ts_gas_functions g;

		ts_gas_functions(&gas, cases[k].nu, &g);
		DECK_NEAR(g.viscosity / cases[k].viscosity, 1, 1e-8);
		DECK_NEAR(g.conductivity / cases[k].conductivity, 1, 1e-8);
		DECK_NEAR(g.dufour / cases[k].dufour, 1, 1e-7);
		DECK_NEAR(g.dissipation / cases[k].dissipation, 1, 1e-8);
	}
}
END_TEST

/* Small friction: e - pi mu/2 + 9 mu^2/2 + O(mu^3). */
START_TEST(friction_lowers_the_restitution)
{
	for (double tangential = -0.5; tangential < 1; tangential += 0.5)
		for (double mu = 1e-4; mu < 2e-3; mu *= 2) {
			double e = ts_gas_rough_restitution(0.93, mu, tangential);

			DECK_NEAR((e - (0.93 - TS_PI / 2 * mu + 4.5 * mu * mu)) / (mu * mu * mu), 0, 1000);
		}
	DECK_NEAR(ts_gas_rough_restitution(0.93, 0, 0), 0.93, 0);
	/* contacts that always stick: e - 2 k (1 - k) with k = 2/7 (1 + tangential)/(1 + e) */
	DECK_NEAR(ts_gas_rough_restitution(0.93, 1e7, 0), 0.93 - 4 / (7 * 1.93) * (1 - 2 / (7 * 1.93)), 1e-6);
}
END_TEST

/* ---- tabulated solution ---- */

static FILE *data(const char *name)
{
	char path[1024];
	FILE *file;

	snprintf(path, sizeof path, "%s/tests/data/%s", getenv("top_srcdir") ? getenv("top_srcdir") : ".",
		 name);
	file = fopen(path, "r");
	ck_assert_msg(file, "%s", path);
	return file;
}

/* Reads `n` numbers of the next line that begins with one. */
static bool next_row(FILE *file, double *out, int n)
{
	char line[512];

	while (fgets(line, sizeof line, file)) {
		char *at = line, *end;

		for (int k = 0; k < n; k++, at = *end ? end + 1 : end) {
			out[k] = strtod(at, &end);
			if (end == at)
				break;
			if (k == n - 1)
				return true;
		}
	}
	return false;
}

START_TEST(tabulated_solutions)
{
	FILE *file = data("granular_couette.csv");
	double row[12];
	int rows = 0;

	for (; next_row(file, row, 12); rows++) {
		struct ts_couette c = reference();
		struct ts_couette_figures g;
		double p[41][3], u;

		c.solids = row[0];
		c.wall[0].half_angle = c.wall[1].half_angle = asin(row[1]);
		g = solved(&c);
		u = g.speed;
		ts_couette_profile(&c, 41, p);
		DECK_NEAR(c.wall[0].half_angle * 180 / TS_PI, row[2], 6e-4);
		DECK_NEAR(p[0][0], row[3], 6e-6);
		DECK_NEAR(g.centre[0], row[4], 6e-6);
		DECK_NEAR(g.slip[0] / u, row[5], 6e-6);
		DECK_NEAR(g.traction, row[6], 6e-6);
		DECK_NEAR(1 / (u * u), row[7], 6e-7);
		DECK_NEAR(g.traction / (u * u), row[8], 6e-7);
		DECK_NEAR(p[0][2] / (u * u), row[9], 6e-7);
		DECK_NEAR(g.centre[1] / (u * u), row[10], 6e-7);
		DECK_NEAR(c.node[0][1] / (u * u * u), row[11], 6e-4 * fabs(row[11]));
		ck_assert_int_lt(c.iterations, 30); /* of Newton's method on all meshes and gaps */
		ts_couette_release(&c);
	}
	ck_assert_int_eq(rows, 9);
	fclose(file);
}
END_TEST

START_TEST(tabulated_profile)
{
	FILE *file = data("granular_couette_profile.csv");
	struct ts_couette c = reference();
	struct ts_couette_figures g;
	double row[4], p[81][3];

	c.n = 0;
	ck_assert(ts_couette_solve(&c, 80, 1e-10) == TS_OK);
	ts_couette_figures(&c, &g);
	ts_couette_profile(&c, 81, p);
	for (int k = 0; k <= 40; k++) {
		ck_assert(next_row(file, row, 4));
		DECK_NEAR(c.gap * k / 80, row[0], 6e-6);
		DECK_NEAR(p[k][0], row[1], 6e-7);
		DECK_NEAR(p[k][1] / g.speed, row[2], 6e-7);
		DECK_NEAR(p[k][2] / (g.speed * g.speed), row[3], 6e-8);
	}
	ts_couette_release(&c);
	fclose(file);
}
END_TEST

/* ---- exact results ---- */

/* Walls that dissipate just the work of the slip leave the flow uniform: T = g2/g5 (d u')^2. */
START_TEST(homogeneous_flow)
{
	for (int theory = 0; theory < 2; theory++)
		for (int radial = 0; radial < 3; radial++)
			for (size_t k = 1; k < DECK_LENGTH(fractions); k++) {
				struct ts_couette c = reference();
				struct ts_gas_functions g;
				struct ts_couette_figures f;
				double s, p[33][3], rate;

				c.gas = (struct ts_gas){ (enum ts_gas_theory)theory,
							 (enum ts_gas_radial)radial, 0.91, 0.65 };
				c.solids = fractions[k];
				c.gap = 7.3;
				ts_gas_functions(&c.gas, c.solids, &g);
				/* s^2 = g5 g2/g1^2; (1 - e_w) = s^2 slip/loss */
				s = sqrt(g.dissipation * g.viscosity) / g.pressure;
				c.wall[0].restitution = 0;
				c.wall[0].restitution = 1 - s * s * ts_bumpy_wall_slip(&c.wall[0]) /
								    ts_bumpy_wall_loss(&c.wall[0]);
				c.wall[1] = c.wall[0];
				ck_assert(ts_couette_solve(&c, 32, 1e-10) == TS_OK);
				ts_couette_figures(&c, &f);
				ts_couette_profile(&c, 33, p);
				rate = (f.speed - f.slip[0] - f.slip[1]) / c.gap;
				DECK_NEAR(f.traction / s, 1, 1e-12);
				DECK_NEAR(p[7][2] / (rate * rate) /
						  ts_gas_sheared_temperature(&c.gas, c.solids),
					  1, 1e-11);
				for (int i = 0; i <= 32; i++) {
					DECK_NEAR(p[i][0] / c.solids, 1, 1e-12);
					DECK_NEAR((p[i][1] - f.slip[1]) / (rate * c.gap), 1 - i / 32.0,
						  1e-12);
				}
				ts_couette_release(&c);
			}
}
END_TEST

/* With dPhi = h dnu the balance of energy is Phi'' = F(nu), so q^2/2 - integral of F h is constant: from nu at the centre
 * follow, by quadrature, q(nu) and y(nu). */
struct quadrature {
	const struct ts_gas *gas;
	double s, centre;
	gsl_integration_workspace *work;
};

static double heat_capacity(const struct quadrature *k, double nu, double *source)
{
	struct ts_gas_functions g;

	ts_gas_functions(k->gas, nu, &g);
	*source = k->s * k->s * sqrt(g.pressure) / g.viscosity - g.dissipation / pow(g.pressure, 1.5);
	return g.conductivity * g.pressure_slope / pow(g.pressure, 2.5) - g.dufour / pow(g.pressure, 1.5);
}

static double source_by_nu(double nu, void *data)
{
	double source, h = heat_capacity(data, nu, &source);

	return source * h;
}

static double flux(const struct quadrature *k, double nu)
{
	gsl_function f = { source_by_nu, (void *)(uintptr_t)k };
	double sum, error;

	gsl_integration_qag(&f, k->centre, nu, 0, 1e-13, 100, GSL_INTEG_GAUSS31, k->work, &sum, &error);
	return sqrt(2 * sum);
}

/* dy/dt with nu = centre - t^2, where the flux vanishes as t. */
static double width_by_root(double t, void *data)
{
	const struct quadrature *k = data;
	double source, nu = k->centre - t * t;

	return heat_capacity(k, nu, &source) * 2 * t / flux(k, nu);
}

/* torquato: through the step of its slope, at 0.49. */
START_TEST(quadratures)
{
	for (int theory = 0; theory < 4; theory++) {
		struct ts_couette c = reference();
		struct ts_couette_figures g;
		gsl_integration_workspace *outer = gsl_integration_workspace_alloc(100);
		struct quadrature k = { &c.gas, 0, 0, gsl_integration_workspace_alloc(100) };
		gsl_function f = { width_by_root, &k };
		double p[41][3], half, error;

		c.gas.theory = (enum ts_gas_theory)(theory % 2);
		c.gas.radial = theory < 2 ? TS_GAS_LUN_SAVAGE : TS_GAS_TORQUATO;
		c.solids = theory < 2 ? 0.4 : 0.485;
		g = solved(&c);
		ts_couette_profile(&c, 41, p);
		k.s = g.traction;
		k.centre = g.centre[0];
		DECK_NEAR(flux(&k, p[0][0]) / c.node[0][1], 1, 1e-8);
		gsl_integration_qag(&f, 0, sqrt(k.centre - p[0][0]), 0, 1e-11, 100, GSL_INTEG_GAUSS31, outer,
				    &half, &error);
		DECK_NEAR(half / (c.gap / 2), 1, 1e-8);
		gsl_integration_workspace_free(outer);
		gsl_integration_workspace_free(k.work);
		ts_couette_release(&c);
	}
}
END_TEST

/* Few grains in a narrow gap meet only the walls: s^2 = loss/slip of the walls, and each slips by half the speed. */
START_TEST(dilute_grains_meet_only_walls)
{
	struct ts_couette c = reference();
	struct ts_couette_figures g;

	c.solids = 1e-7;
	g = solved(&c);
	DECK_NEAR(g.traction * g.traction * ts_bumpy_wall_slip(&c.wall[0]) / ts_bumpy_wall_loss(&c.wall[0]),
		  1, 1e-5);
	DECK_NEAR(g.slip[0] / g.speed, 0.5, 1e-5);
	ts_couette_release(&c);
}
END_TEST

/* Towards closest packing stresses grow as g0, here the power -2.5 nu_max of the free part 1 - nu/nu_max; slip and
 * traction tend to a limit. */
START_TEST(packed_grains)
{
	struct ts_couette c = reference();
	struct ts_couette_figures g[2];

	for (int k = 0; k < 2; k++) {
		c.solids = 0.65 * (1 - (k ? 1e-6 : 1e-5));
		g[k] = solved(&c);
	}
	DECK_NEAR(pow(g[0].speed / g[1].speed, 2) / pow(10, 2.5 * 0.65), 1, 3e-5);
	DECK_NEAR(g[1].traction / g[0].traction, 1, 1e-6);
	DECK_NEAR(g[1].slip[0] / g[1].speed / (g[0].slip[0] / g[0].speed), 1, 1e-5);
	ts_couette_release(&c);
}
END_TEST

START_TEST(elastic_grains_between_walls_that_dissipate)
{
	struct ts_couette c = reference();
	struct ts_couette_figures elastic, nearly;

	c.gas.restitution = 1;
	elastic = solved(&c);
	DECK_NEAR(elastic.dissipation, 0, 0);
	DECK_NEAR((elastic.wall_loss[0] + elastic.wall_loss[1]) / (elastic.traction * elastic.speed), 1,
		  1e-13);
	ck_assert(elastic.centre[0] < 0.4); /* hot in the middle */
	c.gas.restitution = 1 - 1e-7;
	nearly = solved(&c);
	DECK_NEAR(nearly.speed / elastic.speed, 1, 1e-5);
	ck_assert(fabs(nearly.speed / elastic.speed - 1) > 1e-9);
	ts_couette_release(&c);
}
END_TEST

/* ---- numerics ---- */

START_TEST(order_is_four)
{
	struct ts_couette c = reference();
	struct ts_couette_figures exact, g;
	double width[3], error[3];

	c.wall[0].half_angle = c.wall[1].half_angle = asin(0.2);
	ck_assert(ts_couette_solve_mesh(&c, 1280, false) == TS_OK);
	ts_couette_figures(&c, &exact);
	for (int k = 0; k < 3; k++) {
		ck_assert(ts_couette_solve_mesh(&c, 20 << k, false) == TS_OK);
		ts_couette_figures(&c, &g);
		width[k] = 1.0 / (20 << k);
		error[k] = fabs(g.speed / exact.speed - 1);
	}
	DECK_NEAR(deck_order(width, error, 3), 4, 0.1);
	ck_assert(error[2] < 1e-7);
	/* the error that is told */
	ck_assert(ts_couette_solve(&c, 40, 1e-6) == TS_OK);
	ts_couette_figures(&c, &g);
	ck_assert(fabs(g.speed / exact.speed - 1) < 2 * c.error && c.error < 1e-6);
	ts_couette_release(&c);
}
END_TEST

/* All theories and walls: a solution is found, and balances hold to round-off on each mesh. */
START_TEST(solutions_are_found_and_balance)
{
	static const double solids[] = { 1e-3, 0.05, 0.2, 0.45, 0.6 }, restitution[] = { 0.6, 0.9, 1 },
			    roughness[] = { 0.05, 0.5, 1 }, gap[] = { 2, 8, 25 };
	int k = 0;

	for (; k < 5 * 3 * 3 * 3 * 2; k++) {
		struct ts_couette c = reference();
		struct ts_couette_figures g;
		double p[11][3];

		c.solids = solids[k % 5];
		c.gas.restitution = restitution[k / 5 % 3];
		c.wall[0].half_angle = c.wall[1].half_angle = asin(roughness[k / 15 % 3]);
		c.gap = gap[k / 45 % 3];
		c.gas.theory = (enum ts_gas_theory)(k / 135);
		ck_assert_msg(ts_couette_solve_mesh(&c, ts_couette_intervals(c.gap, 11), false) == TS_OK,
			      "case %d", k);
		ts_couette_figures(&c, &g);
		ts_couette_profile(&c, 11, p);
		ck_assert_msg(g.imbalance < 2e-12, "case %d: %g", k, g.imbalance);
		ck_assert(fabs(c.node[c.n][2] / (c.solids * c.gap) - 1) < 1e-12);
		ck_assert(fabs(p[0][1] + g.slip[0] - g.speed) < 1e-12 * g.speed);
		for (int i = 0; i <= 10; i++) { /* symmetric */
			ck_assert(fabs(p[i][0] / p[10 - i][0] - 1) < 1e-9);
			ck_assert(fabs(p[i][1] + p[10 - i][1] - g.speed) < 1e-9 * g.speed);
		}
		ts_couette_release(&c);
	}
}
END_TEST

START_TEST(walls_may_be_swapped)
{
	struct ts_couette c = reference();
	struct ts_couette_figures one, other;
	double p[41][3], q[41][3];

	c.wall[0] = (struct ts_bumpy_wall){ 0.3, 0.9 };
	one = solved(&c);
	ts_couette_profile(&c, 41, p);
	c.wall[0] = c.wall[1];
	c.wall[1] = (struct ts_bumpy_wall){ 0.3, 0.9 };
	other = solved(&c);
	ts_couette_profile(&c, 41, q);
	DECK_NEAR(one.traction / other.traction, 1, 1e-12);
	DECK_NEAR(one.speed / other.speed, 1, 1e-12);
	DECK_NEAR(one.slip[0] / other.slip[1], 1, 1e-12);
	ck_assert(one.slip[0] > 1.5 * one.slip[1]);
	for (int k = 0; k <= 40; k++) {
		DECK_NEAR(p[k][0] / q[40 - k][0], 1, 1e-11);
		DECK_NEAR(p[k][1] + q[40 - k][1], one.speed, 1e-11 * one.speed);
	}
	ts_couette_release(&c);
}
END_TEST

/* In a narrow gap there is one solution; in a wide one there are others, dense at one wall. */
START_TEST(solutions_are_counted)
{
	struct ts_couette c = reference();
	int count;

	ck_assert(ts_couette_count(&c, 64, &count) == TS_OK);
	ck_assert_int_eq(count, 1);
	c.gap = 20;
	ck_assert(ts_couette_count(&c, 128, &count) == TS_OK);
	ck_assert_int_eq(count, 3);
}
END_TEST

/* ---- films ---- */

/* There is no time but that of the walls: u/U, T/U^2 and load/U^2 do not depend on U, nor on units. */
START_TEST(films_scale_with_speed)
{
	struct ts_sheared_film one = film(), other = film();
	double p[41][4], q[41][4];

	other.speed = 17.3e3;
	other.gap *= 1e3;
	other.diameter *= 1e3;
	other.density *= 1e-6;
	solve_film(&one);
	solve_film(&other);
	DECK_NEAR(other.load / one.load / (8650.0 * 8650 * 1e-6), 1, 1e-13);
	ck_assert(ts_sheared_film_profile(&one, p) == TS_OK);
	ck_assert(ts_sheared_film_profile(&other, q) == TS_OK);
	for (int k = 0; k <= 40; k++) {
		DECK_NEAR(q[k][0] / 1e3, p[k][0], 1e-15);
		DECK_NEAR(q[k][1] / 8650, p[k][1], 1e-12);
		DECK_NEAR(q[k][2], p[k][2], 1e-13);
		DECK_NEAR(q[k][3] / (8650.0 * 8650), p[k][3], 1e-13);
	}
	DECK_NEAR((one.figures.dissipation + one.figures.wall_loss[0] + one.figures.wall_loss[1]) /
			  (one.figures.traction * one.load * one.speed),
		  1, 1e-12);
	ts_sheared_film_release(&one);
	ts_sheared_film_release(&other);
}
END_TEST

/* From the load of a film each of gap, solid fraction and speed is found again. */
START_TEST(unknowns_are_found)
{
	struct ts_sheared_film given = film(), f;

	solve_film(&given);
	for (int k = 0; k < 4; k++) {
		f = film();
		f.load = given.load;
		if (k == 0)
			f.speed = NAN;
		if (k == 1)
			f.solids = NAN;
		if (k >= 2)
			f.gap = NAN;
		if (k == 3) {
			f.solids = NAN;
			f.amount = given.amount;
		}
		solve_film(&f);
		DECK_NEAR(f.gap / given.gap, 1, 1e-9);
		DECK_NEAR(f.solids / given.solids, 1, 1e-9);
		DECK_NEAR(f.speed / given.speed, 1, 1e-9);
		DECK_NEAR(f.load / given.load, 1, 1e-15);
		DECK_NEAR(f.figures.slip[1] / given.figures.slip[1], 1, 1e-9);
		ts_sheared_film_release(&f);
	}
	ts_sheared_film_release(&given);
}
END_TEST

/* In a gap of 20 diameters the load has a maximum at nu = 0.04 and a minimum at 0.12: three solid fractions carry what is
 * between. */
START_TEST(several_solid_fractions_carry_a_load)
{
	double solids[2];

	for (int branch = 0; branch < 2; branch++) {
		struct ts_sheared_film f = film(), again;

		f.gap = 20 * f.diameter;
		f.solids = NAN;
		f.load = 0.00102 * f.density * f.speed * f.speed;
		f.branch = (enum ts_sheared_branch)branch;
		solve_film(&f);
		ck_assert_int_eq(f.solutions, 3);
		solids[branch] = f.solids;
		again = film();
		again.gap = f.gap;
		again.solids = f.solids;
		solve_film(&again);
		DECK_NEAR(again.load / f.load, 1, 1e-9);
		ts_sheared_film_release(&again);
		ts_sheared_film_release(&f);
	}
	ck_assert(solids[TS_SHEARED_DENSE] > 0.15 && solids[TS_SHEARED_DILUTE] < 0.04);
}
END_TEST

START_TEST(memory_may_run_out)
{
	long before = ts_alloc_balance();

	for (int unknown = 0; unknown < 3; unknown++)
		for (long k = 1;; k++) {
			struct ts_sheared_film f = film();
			struct ts_error error = { .status = TS_OK };
			enum ts_status status;

			f.tolerance = 1e-4;
			f.count = true;
			f.load = unknown ? 372 : NAN;
			if (unknown == 1)
				f.gap = NAN;
			if (unknown == 2)
				f.solids = NAN;
			ts_alloc_fail_at(k);
			status = ts_sheared_film_solve(&f, NULL, &error);
			ts_alloc_fail_at(0);
			ts_sheared_film_release(&f);
			ck_assert_int_eq(ts_alloc_balance(), before);
			if (status == TS_OK)
				break;
			ck_assert_int_eq(status, TS_NOMEM);
			if (k > 20) /* continuations allocate each time: some of them are enough */
				k += k / 3;
		}
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("granular couette");
	TCase *gas = tcase_create("gas"), *flow = tcase_create("flow"), *films = tcase_create("film");

	tcase_add_test(gas, band_equations);
	tcase_add_test(gas, elastic_grains_are_enskog);
	tcase_add_test(gas, slopes_are_derivatives);
	tcase_add_test(gas, dilute_inelastic_grains);
	tcase_add_test(gas, dense_inelastic_grains);
	tcase_add_test(gas, friction_lowers_the_restitution);
	suite_add_tcase(suite, gas);
	tcase_set_timeout(flow, 60);
	tcase_add_test(flow, tabulated_solutions);
	tcase_add_test(flow, tabulated_profile);
	tcase_add_test(flow, homogeneous_flow);
	tcase_add_test(flow, quadratures);
	tcase_add_test(flow, dilute_grains_meet_only_walls);
	tcase_add_test(flow, packed_grains);
	tcase_add_test(flow, elastic_grains_between_walls_that_dissipate);
	tcase_add_test(flow, order_is_four);
	tcase_add_test(flow, solutions_are_found_and_balance);
	tcase_add_test(flow, walls_may_be_swapped);
	tcase_add_test(flow, solutions_are_counted);
	suite_add_tcase(suite, flow);
	tcase_set_timeout(films, 60);
	tcase_add_test(films, films_scale_with_speed);
	tcase_add_test(films, unknowns_are_found);
	tcase_add_test(films, several_solid_fractions_carry_a_load);
	tcase_add_test(films, memory_may_run_out);
	suite_add_tcase(suite, films);
	return deck_main(suite);
}
