/* Uniform shear flow of a granular gas: integrals over collisions against closed forms, the limits of nearly elastic and of
 * dilute grains, quadrature, and a Monte Carlo solution of the Enskog equation. */
#include <math.h>

#include "base/alloc.h"
#include "kinetic/granular_shear.h"
#include "math/constants.h"
#include "math/rng.h"
#include "tests/deck.h"

static struct ts_gas gas_of(double restitution)
{
	return (struct ts_gas){ .radial = TS_GAS_CARNAHAN_STARLING,
				.restitution = restitution,
				.packing = 0.64 };
}

static struct ts_granular_shear flow(double restitution, double nu)
{
	struct ts_granular_shear s = { .gas = gas_of(restitution), .solids = nu };

	ck_assert_msg(ts_granular_shear_solve(&s) == TS_OK, "e %g, nu %g", restitution, nu);
	return s;
}

static const double restitutions[] = { 0.37, 0.8, 1 }, fractions[] = { 0.013, 0.217, 0.463 };

/* ---- collisions ---- */

/* An isotropic gas at rest: pressure, dissipation, collision rate. */
START_TEST(gas_at_rest)
{
	for (size_t k = 0; k < 9; k++) {
		struct ts_gas gas = gas_of(restitutions[k % 3]);
		double nu = fractions[k / 3], T = 2.385, moment[] = { T, T, T, 0 }, slope;
		struct ts_shear_collisions c;
		struct ts_gas_functions g;

		ts_shear_collisions(&gas, nu, 0, moment, 32, &c);
		ts_gas_functions(&gas, nu, &g);
		for (int i = 0; i < 3; i++) {
			DECK_NEAR((nu * T + c.stress[i]) / (g.pressure * T), 1, 1e-13);
			DECK_NEAR(nu * c.source[i] + 2.0 / 3 * g.dissipation * pow(T, 1.5), 0, 1e-12);
		}
		DECK_NEAR(c.dissipation - g.dissipation * pow(T, 1.5), 0, 1e-12);
		DECK_NEAR(c.rate / (24 * nu * ts_gas_radial(&gas, nu, &slope) * sqrt(T / TS_PI)), 1, 1e-13);
		DECK_NEAR(c.stress[TS_SHEAR_XY], 0, 1e-15);
	}
}
END_TEST

/* Small anisotropy and shear rate: the linear terms of Garzo and Dufty (1999) without the fourth cumulant. */
START_TEST(linear_terms)
{
	for (size_t k = 0; k < 9; k++) {
		struct ts_gas gas = gas_of(restitutions[k % 3]);
		double e = gas.restitution, nu = fractions[k / 3], T = 2.385, small = 1e-5, slope;
		double x = nu * ts_gas_radial(&gas, nu, &slope);
		double skew[] = { T, T, T, small }, even[] = { T, T, T, 0 };
		struct ts_shear_collisions c;

		/* relaxation of the kinetic stress, and the stress between colliding grains that comes with it */
		ts_shear_collisions(&gas, nu, 0, skew, 32, &c);
		DECK_NEAR(c.source[TS_SHEAR_XY] / (-16.0 / 5 * 6 / TS_PI * x * sqrt(TS_PI * T) *
						   (1 - (1 - e) * (1 - e) / 4) * small),
			  1, 1e-8);
		DECK_NEAR(c.stress[TS_SHEAR_XY] / (0.8 * nu * x * (1 + e) * small), 1, 1e-8);
		/* the velocity difference over a diameter: of the source, and the collisional viscosity */
		ts_shear_collisions(&gas, nu, small, even, 32, &c);
		DECK_NEAR(c.source[TS_SHEAR_XY] / (0.4 * (1 + e) * (1 - 3 * e) * x * small * T), 1, 1e-8);
		DECK_NEAR(c.stress[TS_SHEAR_XY] / (-5 * sqrt(TS_PI) / 96 * 0.6 * 128 / (5 * TS_PI) * nu * x *
						   (1 + e) * sqrt(T) * small),
			  1, 1e-8);
	}
}
END_TEST

/* The error of the quadrature falls exponentially, also where the shear is as large as the fluctuations. */
START_TEST(quadrature)
{
	struct ts_gas gas = gas_of(0.3);
	double moment[] = { 0.13, 0.08, 0.07, -0.05 }, error[3];
	struct ts_shear_collisions exact, c;

	ts_shear_collisions(&gas, 0.4, 1, moment, 128, &exact);
	for (int k = 0; k < 3; k++) {
		ts_shear_collisions(&gas, 0.4, 1, moment, 8 << k, &c);
		error[k] = fabs(c.source[TS_SHEAR_XY] / exact.source[TS_SHEAR_XY] - 1);
	}
	ck_assert_msg(error[1] < 1e-3 * error[0] && error[0] > 1e-7, "%g %g", error[0], error[1]);
	ck_assert(error[2] < 1e-13);
}
END_TEST

/* ---- steady flow ---- */

/* Nearly elastic grains: T = g2/g5 (d u')^2 of Navier-Stokes order, the difference falls as 1 - e. */
START_TEST(nearly_elastic_grains)
{
	for (size_t k = 0; k < 3; k++) {
		double off[2];

		for (int i = 0; i < 2; i++) {
			struct ts_granular_shear s = flow(1 - 1e-3 * (2 - i), fractions[k]);
			struct ts_gas_functions g;

			ts_gas_functions(&s.gas, s.solids, &g);
			off[i] = 1 - s.temperature / ts_gas_sheared_temperature(&s.gas, s.solids);
			DECK_NEAR(s.stress[TS_SHEAR_XY] / (g.viscosity * sqrt(s.temperature)), -1, 3e-3);
		}
		ck_assert(off[1] > 2e-4 && off[1] < 1.5e-3);
		DECK_NEAR(off[0] / off[1], 2, 0.02);
	}
}
END_TEST

/* Dilute grains, linear Grad theory: K_yy = K_zz = T (1 - zeta/nu_eta), K_xy^2 = (3/2) T^2 (zeta/nu_eta) (1 - zeta/nu_eta)
 * (A. Santos, V. Garzo, J. W. Dufty, Phys. Rev. E 69 (2004) 061303). K_xy^2 is of the order of zeta, too, by which K_yy and
 * K_zz differ. */
START_TEST(dilute_grains)
{
	for (double e = 0.999; e > 0.85; e = 1 - 10 * (1 - e)) {
		struct ts_granular_shear s = flow(e, 1e-5);
		double ratio = 5.0 / 12 * (1 - e * e) / (1 - (1 - e) * (1 - e) / 4), *k = s.moment;

		DECK_NEAR(1 - (k[TS_SHEAR_YY] + k[TS_SHEAR_ZZ]) / 2 / s.temperature, ratio, 0.05 * ratio);
		DECK_NEAR(k[TS_SHEAR_XY] * k[TS_SHEAR_XY] / (s.temperature * s.temperature),
			  1.5 * ratio * (1 - ratio), 4 * ratio * ratio);
		ck_assert(k[TS_SHEAR_ZZ] > k[TS_SHEAR_YY]);
	}
}
END_TEST

/* From dissipative to nearly elastic, dilute to dense: a solution is found, positive, and its energy is balanced. */
START_TEST(solutions_are_found)
{
	for (int radial = 0; radial < 3; radial++)
		for (double e = 0; e < 1; e = e < 0.9 ? e + 0.15 : 1 - (1 - e) / 10) {
			if (1 - e < 1e-7)
				break;
			for (double nu = 1e-6; nu < 0.63; nu = nu < 0.05 ? nu * 10 : nu + 0.1) {
				struct ts_granular_shear s = { .gas = gas_of(e), .solids = nu };

				s.gas.radial = (enum ts_gas_radial)radial;
				ck_assert_msg(ts_granular_shear_solve(&s) == TS_OK, "radial %d, e %g, nu %g",
					      radial, e, nu);
				ck_assert_msg(s.imbalance < 1e-6, "e %g, nu %g: %g", e, nu, s.imbalance);
				ck_assert(s.temperature > 0 && s.moment[TS_SHEAR_XY] < 0);
				ck_assert(s.moment[TS_SHEAR_XX] > s.moment[TS_SHEAR_YY]);
			}
		}
}
END_TEST

/* ---- Monte Carlo ---- */

enum { GRAINS = 4000 };

struct gas {
	double v[GRAINS][3];
	double restitution, often; /* n g0 d^3 */
	double fastest;		   /* bound of the relative velocity */
	double due;
	struct ts_rng rng;
};

static void direction(struct ts_rng *rng, double k[3])
{
	double z = 2 * ts_rng_uniform(rng) - 1, angle = 2 * TS_PI * ts_rng_uniform(rng), s = sqrt(1 - z * z);

	k[0] = s * cos(angle);
	k[1] = s * sin(angle);
	k[2] = z;
}

/* Collisions of pairs at random, with the mean velocity difference of their places, as often as the Enskog equation has
 * them (J. M. Montanero, A. Santos, Phys. Fluids 9 (1997) 2057). */
static void collide(struct gas *g, double step)
{
	g->due += GRAINS / 2.0 * g->often * 4 * TS_PI * g->fastest * step;
	for (; g->due >= 1; g->due--) {
		double *a = g->v[(int)(GRAINS * ts_rng_uniform(&g->rng))], k[3];
		double *b = g->v[(int)(GRAINS * ts_rng_uniform(&g->rng))], s;

		direction(&g->rng, k);
		s = (a[0] - b[0]) * k[0] + (a[1] - b[1]) * k[1] + (a[2] - b[2]) * k[2] - k[0] * k[1];
		if (a == b || s <= g->fastest * ts_rng_uniform(&g->rng))
			continue;
		for (int i = 0; i < 3; i++) {
			a[i] -= (1 + g->restitution) / 2 * s * k[i];
			b[i] += (1 + g->restitution) / 2 * s * k[i];
		}
	}
}

static void start_gas(struct gas *g, const struct ts_granular_shear *s)
{
	double mean[3] = { 0 }, slope;

	g->restitution = s->gas.restitution;
	g->often = 6 / TS_PI * s->solids * ts_gas_radial(&s->gas, s->solids, &slope);
	g->fastest = 5 * sqrt(2 * s->temperature);
	g->due = 0;
	g->rng = ts_rng_start(7, 0);
	for (int n = 0; n < 2; n++) /* a mean velocity would grow */
		for (int j = 0; j < GRAINS; j++)
			for (int i = 0; i < 3; i++) {
				double u = n ? 0 : 1 - ts_rng_uniform(&g->rng);

				if (!n)
					g->v[j][i] = sqrt(-2 * log(u) * s->temperature) *
						     cos(2 * TS_PI * ts_rng_uniform(&g->rng));
				else
					g->v[j][i] -= mean[i];
				mean[i] += n ? 0 : g->v[j][i] / GRAINS;
			}
}

/* The Gaussian closure against the equation itself: T within 2 %, its noise is 0.7 % in the first case, its anisotropy within 0.02. */
START_TEST(monte_carlo)
{
	static const double cases[][2] = { { 0.8, 0.1 }, { 0.9, 0.2 }, { 0.8, 0.4 } };
	struct gas *g = ts_alloc(1, sizeof *g);

	for (size_t n = 0; n < DECK_LENGTH(cases); n++) {
		struct ts_granular_shear s = flow(cases[n][0], cases[n][1]);
		double step = 0.1 / s.collisions.rate, sum[4] = { 0 }, T;
		int steps = (int)(300 / s.collisions.rate / step), counted = 0;

		start_gas(g, &s);
		for (int k = 0; k < steps; k++) {
			for (int j = 0; j < GRAINS; j++)
				g->v[j][0] -= step * g->v[j][1];
			collide(g, step);
			for (int j = 0; k > steps / 8 && j < GRAINS; j++, counted++) {
				const double *v = g->v[j];

				for (int i = 0; i < 3; i++)
					sum[i] += v[i] * v[i];
				sum[3] += v[0] * v[1];
			}
		}
		T = (sum[0] + sum[1] + sum[2]) / 3 / counted;
		DECK_NEAR(T / s.temperature, 1, 0.02);
		for (int i = 0; i < 4; i++)
			DECK_NEAR(sum[i] / counted / T, s.moment[i] / s.temperature, 0.02);
	}
	ts_free(g);
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("granular shear");
	TCase *tests = tcase_create("shear");

	tcase_set_timeout(tests, 200);
	tcase_add_test(tests, gas_at_rest);
	tcase_add_test(tests, linear_terms);
	tcase_add_test(tests, quadrature);
	tcase_add_test(tests, nearly_elastic_grains);
	tcase_add_test(tests, dilute_grains);
	tcase_add_test(tests, solutions_are_found);
	tcase_add_test(tests, monte_carlo);
	suite_add_tcase(suite, tests);
	return deck_main(suite);
}
