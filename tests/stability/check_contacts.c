/* The largest stable time step of granular contacts, found by bisection, beside law/granular_limit.h: two
 * uneven spheres pressed together swing along the line of centres; a sphere that lies on a plane slips and
 * turns.
 *
 * TS_TABLE=FILE appends what is measured. */
#include "../deck.h"

#include <string.h>

#include "law/granular_limit.h"

static const double RADIUS[2] = { 0.0123, 0.0171 }, MASS[2] = { 0.0186, 0.0431 };
static const double YOUNG = 7.3e6, NU = 0.31, SPEED = 1.37, FRICTION = 1e4;
static const double SINK = 2e-4; /* equilibrium overlap by R* */

struct contact {
	int law;
	bool slips;
	double restitution;
	struct ts_granular_model model;
	struct ts_granular_pair pair;
	double r_eff, m_eff, overlap;
};

static const char *name_of(const struct contact *c)
{
	return c->law == TS_NORMAL_HERTZ ? "hertz" : "hooke";
}

static struct contact contact(int law, bool slips, double restitution)
{
	double log_e = log(restitution);
	struct contact c = { .law = law, .slips = slips, .restitution = restitution };

	c.r_eff = slips ? RADIUS[0] : RADIUS[0] * RADIUS[1] / (RADIUS[0] + RADIUS[1]);
	c.m_eff = slips ? MASS[0] : MASS[0] * MASS[1] / (MASS[0] + MASS[1]);
	c.overlap = SINK * c.r_eff;
	c.model =
		(struct ts_granular_model){ .normal = law, .tangential = slips ? TS_TANGENTIAL_HISTORY : 0 };
	c.pair = (struct ts_granular_pair){ .young = YOUNG / (2 * (1 - NU * NU)),
					    .shear = YOUNG / (4 * (2 - NU) * (1 + NU)),
					    .log_restitution = log_e,
					    .damping = log_e / sqrt(log_e * log_e + TS_PI * TS_PI),
					    .velocity = SPEED,
					    .friction = FRICTION };
	return c;
}

static double theory(const struct contact *c)
{
	return c->slips ? ts_granular_slip_limit(&c->model, &c->pair, c->r_eff, c->m_eff, c->overlap, 0.4,
						 false)
			: ts_granular_limit(&c->model, &c->pair, c->r_eff, c->m_eff, c->overlap, false);
}

static double load(const struct contact *c)
{
	struct ts_touch t = { .r_eff = c->r_eff, .m_eff = c->m_eff, .overlap = c->overlap };
	struct ts_normal f;
	double deepest[TS_NORMAL_MEMORY] = { 0 };

	ts_normal_force(&c->model, &c->pair, &t, deepest, &f);
	return f.force;
}

static struct tsim *pressed(const struct contact *c, double h)
{
	struct tsim *sim =
		deck_open("units si\n"
			  "boundary f f f\n"
			  "newton off\n"
			  "communicate single vel yes\n"
			  "region box block -1 1 -1 1 -1 1 units box\n"
			  "create_box 1 box\n"
			  "neighbor 0.001 bin\n"
			  "timestep %.17g\n"
			  "create_atoms 1 single 0 0 0\n"
			  "set atom 1 diameter %.17g mass %.17g\n"
			  "group low id 1\n"
			  "fix y all property/global youngsModulus peratomtype %.17g\n"
			  "fix n all property/global poissonsRatio peratomtype %.17g\n"
			  "fix e all property/global coefficientRestitution peratomtypepair 1 %.17g\n"
			  "fix f all property/global coefficientFriction peratomtypepair 1 %.17g\n"
			  "fix v all property/global characteristicVelocity scalar %.17g\n"
			  "pair_style gran model %s tangential %s\n"
			  "pair_coeff * *\n"
			  "fix move all nve/sphere",
			  h, 2 * RADIUS[0], MASS[0], YOUNG, NU, c->restitution, FRICTION, SPEED, name_of(c),
			  c->slips ? "history" : "off");

	if (c->slips)
		deck(sim,
		     "fix floor all wall/gran primitive type 1 zplane %.17g\n"
		     "fix weight all addforce 0 0 %.17g\n"
		     "set atom 1 omegax 1e-7",
		     c->overlap - RADIUS[0], -load(c));
	else
		deck(sim,
		     "create_atoms 1 single 0 0 %.17g\n"
		     "set atom 2 diameter %.17g mass %.17g\n"
		     "group high id 2\n"
		     "fix up low addforce 0 0 %.17g\n"
		     "fix down high addforce 0 0 %.17g\n"
		     "set atom 1 vz 1e-9",
		     RADIUS[0] + RADIUS[1] - c->overlap, 2 * RADIUS[1], MASS[1], load(c), -load(c));
	return sim;
}

/* What swings: the distance and the velocity along the line of centres (Verlet's velocity at the steps is a
 * mean that may hide what alternates), or the slip. */
static double swing(struct tsim *sim, const struct contact *c)
{
	double v[2] = { 0 }, z[2], omega = 0;

	if (!c->slips) {
		deck_column(sim, "vz", v, 2, 0);
		deck_column(sim, "z", z, 2, 0);
		z[0] -= z[1] - (RADIUS[0] + RADIUS[1] - c->overlap);
		return hypot(v[0] - v[1], z[0] / theory(c));
	}
	deck_column(sim, "vy", v, 1, 0);
	deck_column(sim, "omegax", &omega, 1, 0);
	return fabs(v[0] + omega * RADIUS[0]);
}

static bool stable(const struct contact *c, double h)
{
	struct tsim *sim = pressed(c, h);
	double first = 0, now = 1;
	bool good = true;

	for (int chunk = 0; chunk < 40 && good; chunk++) {
		good = deck_accepts(sim, "run 100 unsafe yes post no");
		now = good ? swing(sim, c) : INFINITY;
		first = chunk ? first : now;
		good = now < 1e3 * (1e-9 + first) && now < 1e-6;
	}
	tsim_close(sim);
	return good;
}

static void measure(FILE *out, const struct contact *c)
{
	double expected = theory(c), lo = 0.5 * expected, hi = 1.7 * expected;

	ck_assert_msg(stable(c, lo), "%s: unstable at half the limit", name_of(c));
	ck_assert_msg(!stable(c, hi), "%s: stable at 1.7 times the limit", name_of(c));
	while (hi / lo > 1.0005) {
		double h = 0.5 * (lo + hi);

		if (stable(c, h))
			lo = h;
		else
			hi = h;
	}
	if (out)
		fprintf(out, "%-6s %-7s %11g %12.5g %12.5g %9.5f\n", name_of(c), c->slips ? "slip" : "normal",
			c->restitution, sqrt(lo * hi), expected, sqrt(lo * hi) / expected);
	ck_assert_msg(fabs(sqrt(lo * hi) / expected - 1) < 4e-3,
		      "%s, %s, e = %g: stable up to %g, theory says %g", name_of(c),
		      c->slips ? "slip" : "normal", c->restitution, sqrt(lo * hi), expected);
}

START_TEST(limits)
{
	static const int laws[] = { TS_NORMAL_HOOKE, TS_NORMAL_HERTZ };
	static const double restitution[] = { 1, 0.7, 0.2 };
	FILE *out = deck_table("Largest stable time step of granular contacts, by bisection");

	if (out)
		fprintf(out, "%-6s %-7s %11s %12s %12s %9s\n", "law", "motion", "restitution", "measured",
			"theory", "ratio");
	for (size_t l = 0; l < DECK_LENGTH(laws); l++) {
		for (size_t e = 0; e < DECK_LENGTH(restitution); e++) {
			for (int slips = 0; slips < 2; slips++) {
				struct contact c = contact(laws[l], slips, restitution[e]);

				measure(out, &c);
			}
		}
	}
	if (out)
		fclose(out);
}
END_TEST

/* Linear laws are refused beyond their limit, with that number. */
START_TEST(refused_beyond)
{
	struct contact c = contact(TS_NORMAL_HOOKE, false, 0.7);
	double limit = theory(&c);
	struct tsim *sim = pressed(&c, limit * (1 - 1e-9));
	char number[32];

	deck(sim, "run 1");
	ck_assert(!deck_accepts(sim, "timestep %.17g\nrun 1", 1.001 * limit));
	snprintf(number, sizeof number, "%g", limit);
	ck_assert_ptr_nonnull(strstr(tsim_error(sim), number));
	tsim_error_clear(sim);
	deck(sim, "run 1 unsafe yes");
	tsim_close(sim);
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("stability of granular contacts");
	TCase *tests = tcase_create("largest stable step");

	tcase_set_timeout(tests, 120);
	tcase_add_test(tests, limits);
	tcase_add_test(tests, refused_beyond);
	suite_add_tcase(suite, tests);
	return deck_main(suite);
}
