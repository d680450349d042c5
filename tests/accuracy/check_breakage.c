/* A bond breaks when K |U| exceeds F_ult: not before, and within the step in which that happens. */
#include "../deck.h"

static const double STIFFNESS = 1.7e4, ULTIMATE = 2.385, LENGTH = 0.0305, MASS = 0.0127;

/* Sphere 1 is held; sphere 2 at distance LENGTH along x. */
static struct tsim *bonded(double h, const char *more)
{
	return deck_open("units si\n"
			 "boundary f f f\n"
			 "region box block -1 1 -1 1 -1 1 units box\n"
			 "create_box 2 box\n"
			 "neighbor 0.001 bin\n"
			 "create_atoms 1 single 0.0 0.0 0.0\n"
			 "create_atoms 2 single %.17g 0.0 0.0\n"
			 "set group all diameter 0.021 mass %.17g\n"
			 "group held type 1\n"
			 "group free type 2\n"
			 "bond_style contact\n"
			 "bond_coeff 1 stiffness %.17g ultimate %.17g\n"
			 "create_bonds single/bond 1 1 2\n"
			 "timestep %.17g\n"
			 "fix move free nve\n"
			 "fix crack all bond/breakage\n"
			 "%s",
			 LENGTH, MASS, STIFFNESS, ULTIMATE, h, more);
}

static double extension(struct tsim *sim)
{
	double x[2];

	deck_column(sim, "x", x, 2, 0);
	return x[1] - x[0] - LENGTH;
}

/* Sphere 2 is moved at a constant velocity, away (_i = 0) or nearer, in steps of different length.
 */
START_TEST(quasi_static)
{
	double speed = _i ? -1e-3 : 1e-3, h = 2.3e-5;
	struct tsim *sim = bonded(h, "fix still all setforce 0 0 0");
	int steps = 0;

	deck(sim, "set atom 2 vx %.17g\nrun 0", speed);
	while (deck_value(sim, "f_crack") == 0) {
		ck_assert_double_le(STIFFNESS * fabs(extension(sim)), ULTIMATE);
		ck_assert_int_lt(++steps, 10000);
		deck(sim, "run 1 post no");
	}
	ck_assert_double_gt(STIFFNESS * fabs(extension(sim)), ULTIMATE);
	DECK_NEAR(STIFFNESS * fabs(extension(sim)), ULTIMATE, STIFFNESS * 1e-3 * h);
	ck_assert_int_eq(steps, (int)ceil(ULTIMATE / STIFFNESS / (1e-3 * h)));
	deck(sim, "run 500");
	ck_assert_double_eq(deck_value(sim, "f_crack"), 1);
	tsim_close(sim);
}
END_TEST

/* Slowly loaded by a force that grows far more slowly than the bond swings. */
START_TEST(slow_force)
{
	struct tsim *sim = bonded(2e-5, "variable load equal 20.0*time\n"
					"fix pull free addforce v_load 0 0\n"
					"fix calm free viscous 5.0\n"
					"run 5000");

	ck_assert_double_eq(deck_value(sim, "f_crack"), 0); /* load 2.0 */
	deck(sim, "run 900");
	ck_assert_double_eq(deck_value(sim, "f_crack"), 0); /* 2.36, 1 % below */
	deck(sim, "run 200");
	ck_assert_double_eq(deck_value(sim, "f_crack"), 1); /* 2.44 */
	tsim_close(sim);
}
END_TEST

/* A force P put on suddenly swings the bond to 2 P/K: it breaks from P = F_ult/2 on. */
START_TEST(sudden_force)
{
	double direction = _i ? -1 : 1;

	for (int k = 0; k < 2; k++) {
		double load = direction * ULTIMATE / 2 * (k ? 1.0001 : 0.9999);
		/* 2 pi/omega is about 5.4e-3; the sampled maximum misses (omega h)^2/8 = 3e-7 */
		struct tsim *sim = bonded(1.37e-6, "");

		deck(sim, "fix push free addforce %.17g 0 0\nrun 9000", load);
		ck_assert_double_eq(deck_value(sim, "f_crack"), k);
		tsim_close(sim);
	}
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("breakage");
	TCase *tests = tcase_create("a bond at its ultimate force");

	tcase_set_timeout(tests, 30);
	tcase_add_loop_test(tests, quasi_static, 0, 2);
	tcase_add_test(tests, slow_force);
	tcase_add_loop_test(tests, sudden_force, 0, 2);
	suite_add_tcase(suite, tests);
	return deck_main(suite);
}
