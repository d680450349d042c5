/* A sphere let go in a still fluid: v(t) = v_t (1 - exp(-t/tau)), tau = m/(6 pi eta r),
 * v_t = g tau. */
#include "../deck.h"

static const double RADIUS = 3.1e-4, DENSITY = 2385, VISCOSITY = 1.3, GRAVITY = 9.71;

static double relaxation(void)
{
	return 2.0 / 9 * RADIUS * RADIUS * DENSITY / VISCOSITY; /* of a sphere */
}

static struct tsim *settling(const char *integrator, const char *scheme, double h)
{
	return deck_open("units si\n"
			 "boundary p p p\n"
			 "region box block -1 1 -1 1 -1 1 units box\n"
			 "create_box 1 box\n"
			 "neighbor 0.001 bin\n"
			 "create_atoms 1 single 0.13 -0.27 0.71\n"
			 "set group all diameter %.17g density %.17g\n"
			 "flow_style uniform velocity 0 0 0 viscosity %.17g\n"
			 "fix move all %s\n"
			 "fix weight all gravity %.17g vector 0 0 -1\n"
			 "fix drag all drag/stokes scheme %s\n"
			 "timestep %.17g\n"
			 "run 0",
			 2 * RADIUS, DENSITY, VISCOSITY, integrator, GRAVITY, scheme, h * relaxation());
}

/* Velocity downwards in units of v_t, and that of half a step later. */
static double speed(struct tsim *sim, double *half)
{
	double v, f, m;

	deck_column(sim, "vz", &v, 1, 0);
	deck_column(sim, "fz", &f, 1, 0);
	deck_column(sim, "mass", &m, 1, 0);
	if (half)
		*half = -(v + 0.5 * deck_value(sim, "dt") * f / m) / (GRAVITY * relaxation());
	return -v / (GRAVITY * relaxation());
}

/* The drag is taken at the velocity known: first order, whatever the integrator. Their discrete
 * solutions are powers of 1 - h/tau. */
START_TEST(explicit_scheme)
{
	static const char *const integrators[] = { "nve", "nve/symplectic", "nve/euler" };
	double h[5], error[5];

	for (int k = 0; k < 5; k++) {
		int steps = 13 << k;
		struct tsim *sim = settling(integrators[_i], "explicit", 1.7 / steps);
		double v, start = _i ? 1 : (1 - 0.85 / steps) * (1 - 0.85 / steps);

		h[k] = 1.7 / steps;
		deck(sim, "run %d", steps);
		v = speed(sim, NULL);
		DECK_NEAR(1 - v, start * pow(1 - h[k], steps - !_i), 1e-12);
		error[k] = fabs(v - (1 - exp(-1.7)));
		tsim_close(sim);
	}
	DECK_NEAR(deck_order(h + 1, error + 1, 4), 1, 0.05);
	ck_assert_double_lt(error[4], 2e-3);
}
END_TEST

/* Scheme exact: with an integrator of one kick per step the velocity at the end of each is that of
 * the exponential. */
START_TEST(exact_velocity)
{
	static const double steps[] = { 0.03, 0.7, 3.1, 50 };
	static const char *const integrators[] = { "nve/symplectic", "nve/euler" };

	for (size_t k = 0; k < DECK_LENGTH(steps); k++) {
		struct tsim *sim = settling(integrators[_i], "exact", steps[k]);

		for (int n = 1; n <= 40; n++) {
			deck(sim, "run 1 post no");
			DECK_NEAR(speed(sim, NULL), -expm1(-n * steps[k]), 1e-13);
		}
		tsim_close(sim);
	}
}
END_TEST

/* With Verlet it is the velocity between the steps that relaxes by exp(-h/tau) each, even for
 * steps of 50 tau. The first of them comes from half the force of a whole step. */
START_TEST(exact_half_step)
{
	static const double steps[] = { 0.03, 0.7, 3.1, 50 };

	for (size_t k = 0; k < DECK_LENGTH(steps); k++) {
		double h = steps[k], half, first = 1 + 0.5 * expm1(-h);
		struct tsim *sim = settling("nve", "exact", h);

		for (int n = 0; n < 40; n++) {
			speed(sim, &half);
			DECK_NEAR(1 - half, first * exp(-n * h), 1e-13);
			deck(sim, "run 1 post no");
		}
		DECK_NEAR(speed(sim, NULL), 1, 40 * h > 30 ? 1e-12 : 1);
		tsim_close(sim);
	}
}
END_TEST

/* So the velocity at the steps is second order. */
START_TEST(exact_order)
{
	double h[5], error[5];

	for (int k = 0; k < 5; k++) {
		int steps = 5 << k;
		struct tsim *sim = settling("nve", "exact", 1.7 / steps);

		h[k] = 1.7 / steps;
		deck(sim, "run %d", steps);
		error[k] = fabs(speed(sim, NULL) + expm1(-1.7));
		tsim_close(sim);
	}
	DECK_NEAR(deck_order(h, error, 5), 2, 0.05);
	ck_assert_double_lt(error[4], 1e-3);
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("settling");
	TCase *tests = tcase_create("a sphere in a still fluid");

	tcase_set_timeout(tests, 30);
	tcase_add_loop_test(tests, explicit_scheme, 0, 3);
	tcase_add_loop_test(tests, exact_velocity, 0, 2);
	tcase_add_test(tests, exact_half_step);
	tcase_add_test(tests, exact_order);
	suite_add_tcase(suite, tests);
	return deck_main(suite);
}
