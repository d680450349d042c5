/* The largest stable time step, found by bisection, beside theory. With z the factor of one step,
 * omega^2 = k/m*, gamma = beta/(2 m*):
 *   velocity Verlet and symplectic Euler, which see the damping half a step late,
 *     z^2 - (2 - w^2 h^2 - 2 g h) z + 1 - 2 g h = 0:   h < 2 (sqrt(w^2 + g^2) - g)/w^2;
 *   explicit Euler, |1 - (g +- i sqrt(w^2 - g^2)) h| < 1:  h < 2 g/w^2 = beta/k;
 *   explicit drag, |1 - h/tau| < 1:                        h < 2 tau.
 *
 * TS_TABLE=FILE appends the table that doc/stability.txt shows. */
#include "../deck.h"

#include <string.h>

static const double RADIUS = 0.0123, MASS = 0.0186, STIFFNESS = 2.385e5, AMPLITUDE = 3e-9;
static const double SINK = 0.05; /* equilibrium overlap of the contact by the radius */
static const double TAU = 0.0371, GRAVITY = 3e-5;

static const char *const integrators[] = { "nve", "nve/symplectic", "nve/euler" };

enum system { BOND, CONTACT, DRAG };
static const char *const systems[] = { "bond", "contact", "drag" };

struct oscillator {
	enum system system;
	double damping; /* gamma/omega */
	double mass, omega;
};

static struct oscillator oscillator(enum system system, double damping)
{
	struct oscillator o = { .system = system, .damping = damping, .mass = MASS };

	if (system == BOND)
		o.mass = MASS * 2.3 / 3.3;
	o.omega = system == DRAG ? 1 / TAU : sqrt(STIFFNESS / o.mass);
	return o;
}

static double theory(struct oscillator o, const char *integrator)
{
	if (o.system == DRAG)
		return 2 * TAU;
	if (strcmp(integrator, "nve/euler") == 0)
		return 2 * o.damping / o.omega;
	return 2 * (sqrt(1 + o.damping * o.damping) - o.damping) / o.omega;
}

static double beta(struct oscillator o)
{
	return 2 * o.mass * o.damping * o.omega;
}

/* A little away from equilibrium: two bonded spheres of masses 1 : 2.3, a sphere that lies on a
 * wall, a sphere that begins to sink in a fluid. */
static struct tsim *displaced(struct oscillator o, const char *integrator, double h)
{
	struct tsim *sim = deck_open("units si\n"
				     "boundary p p f\n"
				     "region box block -1 1 -1 1 -1 1 units box\n"
				     "create_box 1 box\n"
				     "neighbor 0.001 bin\n"
				     "timestep %.17g\n"
				     "fix move all %s\n"
				     "create_atoms 1 single 0 0 %.17g\n"
				     "set group all diameter %.17g mass %.17g",
				     h, integrator, RADIUS * (1 - SINK), 2 * RADIUS, MASS);

	switch (o.system) {
	case BOND:
		deck(sim,
		     "create_atoms 1 single 0 0 %.17g\n"
		     "set atom 2 diameter %.17g mass %.17g\n"
		     "bond_style contact\n"
		     "bond_coeff 1 stiffness %.17g ultimate 1e9 damping %.17g\n"
		     "create_bonds single/bond 1 1 2",
		     RADIUS * (3 - SINK), 2 * RADIUS, 2.3 * MASS, STIFFNESS, beta(o));
		break;
	case CONTACT:
		deck(sim,
		     "pair_style spring/dashpot\n"
		     "pair_coeff * * stiffness %.17g damping %.17g\n"
		     "fix weight all gravity %.17g vector 0 0 -1\n"
		     "fix floor all wall/gran primitive type 1 zplane 0.0",
		     STIFFNESS, beta(o), SINK * RADIUS * STIFFNESS / MASS);
		break;
	case DRAG:
		deck(sim,
		     "flow_style uniform velocity 0 0 0 viscosity %.17g\n"
		     "fix weight all gravity %.17g vector 0 0 -1\n"
		     "fix drag all drag/stokes scheme explicit",
		     MASS / (6 * acos(-1) * RADIUS * TAU), GRAVITY);
		break;
	}
	if (o.system != DRAG)
		deck(sim, "set atom 1 z %.17g", RADIUS * (1 - SINK) - AMPLITUDE);
	return sim;
}

/* Deviation from equilibrium by the one at the start. */
static double deviation(struct tsim *sim, struct oscillator o)
{
	double z[2] = { 0 }, v[2] = { 0 };
	size_t n = o.system == BOND ? 2 : 1;

	deck_column(sim, "z", z, n, 0);
	deck_column(sim, "vz", v, n, 0);
	if (o.system == DRAG) {
		/* Verlet's velocity at the steps is a mean that hides what alternates: take the
		 * one between the steps */
		deck_column(sim, "fz", z, n, 0);
		v[0] += 0.5 * deck_value(sim, "dt") * z[0] / MASS;
		return fabs(v[0] / (GRAVITY * TAU) + 1);
	}
	if (o.system == BOND)
		return hypot(z[1] - z[0] - 2 * RADIUS, (v[1] - v[0]) / o.omega) / AMPLITUDE;
	return hypot(z[0] - RADIUS * (1 - SINK), v[0] / o.omega) / AMPLITUDE;
}

static bool stable(struct oscillator o, const char *integrator, double h)
{
	struct tsim *sim = displaced(o, integrator, h);
	double now = 1, first = 0;
	bool damped = o.damping > 0 || o.system == DRAG, good = true;

	/* undamped and stable, it swings up to 1/sqrt(1 - (h/limit)^2) times the start */
	for (int chunk = 0; chunk < 60 && good && (now > 1e-4 || !chunk); chunk++) {
		good = deck_accepts(sim, "run 500 unsafe yes post no");
		now = good ? deviation(sim, o) : INFINITY;
		good = now < 200;
		first = chunk ? first : now;
	}
	tsim_close(sim);
	return good && !(damped && now > 1.2 * first);
}

static double largest_stable(struct oscillator o, const char *integrator)
{
	double lo = 0.5 * theory(o, integrator), hi = 1.7 * theory(o, integrator);

	ck_assert_msg(stable(o, integrator, lo), "unstable at half the limit");
	ck_assert_msg(!stable(o, integrator, hi), "stable at 1.7 times the limit");
	while (hi / lo > 1.0002) {
		double h = 0.5 * (lo + hi);

		if (stable(o, integrator, h))
			lo = h;
		else
			hi = h;
	}
	return sqrt(lo * hi);
}

static void row(FILE *out, struct oscillator o, const char *integrator)
{
	double measured = largest_stable(o, integrator), expected = theory(o, integrator);

	if (out)
		fprintf(out, "%-8s %-14s %11g %12.5f %12.5f %9.5f\n", systems[o.system], integrator,
			o.damping, measured * o.omega, expected * o.omega, measured / expected);
	ck_assert_msg(fabs(measured / expected - 1) < 2e-3,
		      "%s, fix %s, gamma/omega = %g: stable up to %g, theory says %g", systems[o.system],
		      integrator, o.damping, measured, expected);
}

START_TEST(limits)
{
	static const double damping[] = { 0, 0.11, 0.37, 0.83 };
	FILE *out = deck_table("Largest stable time step h, by bisection");

	if (out)
		fprintf(out, "%-8s %-14s %11s %12s %12s %9s\n", "system", "fix", "gamma/omega", "omega h",
			"theory", "ratio");
	for (enum system s = BOND; s <= CONTACT; s++)
		for (size_t k = 0; k < DECK_LENGTH(integrators); k++)
			for (size_t d = k == 2; d < DECK_LENGTH(damping); d++)
				row(out, oscillator(s, damping[d]), integrators[k]);
	for (size_t k = 0; k < DECK_LENGTH(integrators); k++)
		row(out, oscillator(DRAG, 0), integrators[k]);
	if (out)
		fprintf(out, "(omega = 1/tau for drag; undamped explicit Euler has no stable step)\n");
	if (out)
		fclose(out);
}
END_TEST

/* Undamped explicit Euler grows at every step, however short: by sqrt(1 + w^2 h^2). */
START_TEST(euler_never_stable)
{
	static const double steps[] = { 0.01, 0.03, 0.1 };

	for (enum system s = BOND; s <= CONTACT; s++) {
		for (size_t k = 0; k < DECK_LENGTH(steps); k++) {
			struct oscillator o = oscillator(s, 0);
			double h = steps[k];
			struct tsim *sim = displaced(o, "nve/euler", h / o.omega);

			deck(sim, "run 1000");
			DECK_NEAR(log(deviation(sim, o)), 500 * log1p(h * h), 1e-5);
			ck_assert_double_gt(deviation(sim, o), 1.04);
			tsim_close(sim);
		}
	}
}
END_TEST

/* What -explain and the refusal call the limit is the one measured here. */
START_TEST(refused_beyond)
{
	static const double damping[] = { 0, 0.37 };

	for (enum system s = BOND; s <= DRAG; s++) {
		for (size_t d = 0; d < (s == DRAG ? 1 : DECK_LENGTH(damping)); d++) {
			struct oscillator o = oscillator(s, damping[d]);
			double limit = theory(o, "nve");
			struct tsim *sim = displaced(o, "nve", limit * (1 - 1e-9));
			char number[32];

			deck(sim, "run 1");
			snprintf(number, sizeof number, "%g", 1.001 * limit);
			ck_assert(!deck_accepts(sim, "timestep %.17g\nrun 1", 1.001 * limit));
			ck_assert_ptr_nonnull(strstr(tsim_error(sim), number));
			snprintf(number, sizeof number, "%g", limit);
			ck_assert_ptr_nonnull(strstr(tsim_error(sim), number));
			tsim_error_clear(sim);
			deck(sim, "run 1 unsafe yes");
			ck_assert(!deck_accepts(sim, "run 1"));
			tsim_close(sim);
		}
	}
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("stability");
	TCase *tests = tcase_create("largest stable step");

	tcase_set_timeout(tests, 120);
	tcase_add_test(tests, limits);
	tcase_add_test(tests, euler_never_stable);
	tcase_add_test(tests, refused_beyond);
	suite_add_tcase(suite, tests);
	return deck_main(suite);
}
