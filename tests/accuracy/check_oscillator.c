/* Two bonded spheres are a harmonic oscillator, omega^2 = K/m*. The exact solutions of the discrete
 * schemes are known (E. Hairer, C. Lubich, G. Wanner, Geometric Numerical Integration, I.1), so
 * every step can be checked, and the orders follow. */
#include "../deck.h"

#include <string.h>

static const double STIFFNESS = 1.7e4, LENGTH = 0.0305, AMPLITUDE = 1.3e-4;
static const double DIRECTION[3] = { 6.0 / 7, -2.0 / 7, 3.0 / 7 };

struct state {
	double extension, rate;
};

/* Spheres of different mass along an oblique line, then moved apart by AMPLITUDE about their centre
 * of mass; *omega gets the exact frequency. */
static struct tsim *bonded(const char *integrator, double *omega)
{
	static const char *const names[] = { "x", "y", "z" };
	struct tsim *sim = deck_open("units si\n"
				     "boundary f f f\n"
				     "region box block -1 1 -1 1 -1 1 units box\n"
				     "create_box 1 box\n"
				     "neighbor 0.001 bin\n"
				     "create_atoms 1 single 0.013 -0.027 0.041\n"
				     "create_atoms 1 single %.17g %.17g %.17g\n"
				     "set atom 1 diameter 0.021 density 2385\n"
				     "set atom 2 diameter 0.034 density 1711\n"
				     "bond_style contact\n"
				     "bond_coeff 1 stiffness %.17g ultimate 1e9\n"
				     "create_bonds single/bond 1 1 2\n"
				     "fix move all %s",
				     0.013 + LENGTH * DIRECTION[0], -0.027 + LENGTH * DIRECTION[1],
				     0.041 + LENGTH * DIRECTION[2], STIFFNESS, integrator);
	double m[2];

	deck_column(sim, "mass", m, 2, 0);
	for (int k = 0; k < 3; k++) {
		double x[2];

		deck_column(sim, names[k], x, 2, 0);
		x[0] -= AMPLITUDE * DIRECTION[k] * m[1] / (m[0] + m[1]);
		x[1] += AMPLITUDE * DIRECTION[k] * m[0] / (m[0] + m[1]);
		ck_assert(!tsim_column_write(sim, names[k], x, 2));
	}
	*omega = sqrt(STIFFNESS * (1 / m[0] + 1 / m[1]));
	return sim;
}

static struct state look(struct tsim *sim)
{
	static const char *const names[2][3] = { { "x", "y", "z" }, { "vx", "vy", "vz" } };
	struct state s = { -LENGTH, 0 };

	for (int k = 0; k < 3; k++) {
		double x[2], v[2];

		deck_column(sim, names[0][k], x, 2, 0);
		deck_column(sim, names[1][k], v, 2, 0);
		s.extension += (x[1] - x[0]) * DIRECTION[k];
		s.rate += (v[1] - v[0]) * DIRECTION[k];
	}
	return s;
}

/* 2 E/m*, in units of the exact initial value. */
static double energy(struct state s, double omega)
{
	double a = s.rate / omega / AMPLITUDE, b = s.extension / AMPLITUDE;

	return a * a + b * b;
}

/* x_n = A cos(n theta) with sin(theta/2) = omega h/2: the period is off by second order only. */
START_TEST(verlet_discrete_solution)
{
	double omega, h = 0.11, theta = 2 * asin(h / 2);
	struct tsim *sim = bonded("nve", &omega);

	deck(sim, "timestep %.17g\nrun 0", h / omega);
	for (int n = 1; n <= 400; n++) {
		deck(sim, "run 1 pre no post no");
		DECK_NEAR(look(sim).extension / AMPLITUDE, cos(n * theta), 1e-11);
	}
	tsim_close(sim);
}
END_TEST

/* Period from the zero crossings, which are interpolated with the local sine. */
static double period(const char *integrator, double h)
{
	double omega, first = 0, last = 0;
	struct tsim *sim = bonded(integrator, &omega);
	struct state before;
	int crossings = 0;

	deck(sim, "timestep %.17g\nrun 0", h / omega);
	before = look(sim);
	for (int n = 0; crossings < 21; n++) {
		struct state now;

		deck(sim, "run 1 pre no post no");
		now = look(sim);
		if (before.extension * now.extension <= 0) {
			double theta = 2 * asin(h / 2), a = before.extension, b = now.extension;
			/* a = C sin(-f theta), b = C sin((1 - f) theta) */
			double f = atan2(sin(theta), cos(theta) - b / a) / theta;

			last = n + f;
			if (!crossings++)
				first = last;
		}
		before = now;
	}
	tsim_close(sim);
	return (last - first) / 10 * h; /* in units of 1/omega */
}

START_TEST(verlet_period)
{
	const double pi = acos(-1);
	double h[4], error[4];

	for (int k = 0; k < 4; k++) {
		double exact;

		h[k] = 0.31 / (1 << k);
		exact = pi * h[k] / asin(h[k] / 2); /* of the discrete scheme */
		error[k] = 1 - period("nve", h[k]) / (2 * pi);
		DECK_NEAR(period("nve", h[k]), exact, 1e-13 * exact);
		ck_assert_double_gt(error[k], 0); /* too fast, by omega^2 h^2/24 */
		DECK_NEAR(error[k] / (h[k] * h[k] / 24), 1, 0.02);
	}
	DECK_NEAR(deck_order(h, error, 4), 2, 0.02);
}
END_TEST

/* Largest deviation of the energy in `steps` steps; checks the invariant of the scheme at each. */
static double energy_error(const char *integrator, double h, int steps)
{
	double omega, worst = 0;
	struct tsim *sim = bonded(integrator, &omega);
	bool verlet = strcmp(integrator, "nve") == 0;

	deck(sim, "timestep %.17g\nrun 0", h / omega);
	for (int n = 0; n < steps; n++) {
		struct state s;
		double e, x, invariant;

		deck(sim, "run %d post no", n % 50 ? 1 : 997);
		s = look(sim);
		e = energy(s, omega);
		x = s.extension / AMPLITUDE;
		/* v^2 + w^2 x^2 (1 - w^2 h^2/4), and v^2 + w^2 x^2 - h w^2 x v */
		invariant = verlet ? e - x * x * h * h / 4 : e - h * x * s.rate / omega / AMPLITUDE;
		DECK_NEAR(invariant, verlet ? 1 - h * h / 4 : 1, 1e-10);
		worst = fmax(worst, fabs(e - 1));
	}
	tsim_close(sim);
	return worst;
}

START_TEST(energy_bounded)
{
	const char *integrator = _i == 0 ? "nve" : "nve/symplectic";
	double h[4], error[4];

	for (int k = 0; k < 4; k++) {
		h[k] = 0.4 / (1 << k);
		error[k] = energy_error(integrator, h[k], 300);
		/* Verlet: e = 1 - (h^2/4)(1 - x^2); symplectic: |e - 1| <= (h/2) e */
		if (_i == 0)
			DECK_NEAR(error[k] / (h[k] * h[k] / 4), 1, 0.03);
		else
			ck_assert_double_le(error[k], h[k] / 2 / (1 - h[k] / 2) * (1 + 1e-8));
	}
	DECK_NEAR(deck_order(h, error, 4), 2 - _i, _i ? 0.15 : 0.02);
}
END_TEST

/* Explicit Euler: z = 1 + i w h, so the amplitude grows by sqrt(1 + w^2 h^2) in each step. */
START_TEST(euler_grows)
{
	double omega, h = 0.037, before = 1;
	struct tsim *sim = bonded("nve/euler", &omega);

	deck(sim, "timestep %.17g\nrun 0", h / omega);
	for (int n = 1; n <= 300; n++) {
		double now;

		deck(sim, "run 1 pre no post no");
		now = energy(look(sim), omega);
		DECK_NEAR(now / before, 1 + h * h, 1e-11);
		before = now;
	}
	tsim_close(sim);
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("oscillator");
	TCase *tests = tcase_create("two bonded spheres");

	tcase_set_timeout(tests, 30);
	tcase_add_test(tests, verlet_discrete_solution);
	tcase_add_test(tests, verlet_period);
	tcase_add_loop_test(tests, energy_bounded, 0, 2);
	tcase_add_test(tests, euler_grows);
	suite_add_tcase(suite, tests);
	return deck_main(suite);
}
