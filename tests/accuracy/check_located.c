/* Contacts that are located (pair_style ... located yes): what velocity Verlet then owes to the exact
 * solution.
 *
 * TS_TABLE=FILE appends the tables of doc/accuracy.md. */
#include "../cloud.h"

enum { PHASES = 16 };

static const double RADIUS = 0.0123, MASS = 0.0231, STIFFNESS = 2.385e5, SPEED = 0.7;
static const double PI = 3.14159265358979323846;

/* The step of a linear contact that lasts `steps` of them and a part. */
static double linear_step(double mass, double e, double steps)
{
	double ratio = -log(e) / sqrt(PI * PI + log(e) * log(e));

	return PI / sqrt(STIFFNESS / mass * (1 - ratio * ratio)) / (steps + 0.385);
}

/* One pair of spheres for each place at which the contact may begin within a step; the second is `ratio`
 * as heavy as the first, 0: held. Largest relative error of the velocity with which they part. */
static double pair_error(const char *pair, double out, double h, int steps, double ratio)
{
	static const double n[3] = { 2.0 / 7, 3.0 / 7, 6.0 / 7 };
	static const char *const names[] = { "vx", "vy", "vz" };
	struct tsim *sim = deck_open("units si\nboundary f f f\nnewton off\natom_style sphere\n"
				     "region box block -1 1 -1 1 -1 1 units box\n"
				     "create_box 2 box\nneighbor 0.003 bin\ntimestep %.17g\n%s",
				     h, pair);
	double v[3][2 * PHASES], worst = 0;

	for (int p = 0; p < PHASES; p++) {
		double x[3] = { -0.9 + 0.1 * p, 0.037, -0.011 };
		double gap = 2 * RADIUS + (1 + (p + 0.37) / PHASES) * SPEED * h;

		deck(sim, "create_atoms 1 single %.17g %.17g %.17g", x[0], x[1], x[2]);
		deck(sim, "create_atoms 2 single %.17g %.17g %.17g", x[0] + n[0] * gap, x[1] + n[1] * gap,
		     x[2] + n[2] * gap);
	}
	deck(sim,
	     "set group all diameter %.17g mass %.17g\nset type 1 mass %.17g\n"
	     "set type 2 vx %.17g vy %.17g vz %.17g\n"
	     "group first type 1\ngroup second type 2\nfix move %s nve\n%s",
	     2 * RADIUS, MASS, ratio > 0 ? MASS * ratio : MASS, -SPEED * n[0], -SPEED * n[1], -SPEED * n[2],
	     ratio > 0 ? "all" : "second", ratio > 0 ? "" : "fix hold first freeze");
	deck(sim, "run %d", steps + steps / 2 + 10);
	for (int k = 0; k < 3; k++)
		deck_column(sim, names[k], v[k], 2 * PHASES, 0);
	for (int p = 0; p < PHASES; p++) {
		double apart = 0;

		for (int k = 0; k < 3; k++)
			apart += (v[k][2 * p + 1] - v[k][2 * p]) * n[k] / SPEED;
		worst = fmax(worst, fabs(apart / out - 1));
	}
	tsim_close(sim);
	return worst;
}

static double linear_error(double e, int steps, double ratio, const char *located)
{
	double mass = ratio > 0 ? MASS * ratio / (1 + ratio) : MASS;
	char pair[200];

	snprintf(pair, sizeof pair,
		 "pair_style spring/dashpot located %s\n"
		 "pair_coeff * * stiffness %.17g restitution %.17g",
		 located, STIFFNESS, e);
	return pair_error(pair, e, linear_step(mass, e, steps), steps, ratio);
}

/* Of a sphere on a held one: what is promised for 50 steps per contact, and what is reached. */
START_TEST(restitution)
{
	static const struct {
		double e, most[3]; /* with 20, 50 and 200 steps */
	} rows[] = {
		{ 1, { 3e-3, 5e-4, 3e-5 } },	{ 0.8, { 1e-8, 1e-9, 1e-10 } },
		{ 0.6, { 1e-7, 3e-9, 1e-10 } }, { 0.4, { 5e-7, 1e-8, 3e-10 } },
		{ 0.2, { 2e-6, 3e-8, 1e-9 } },	{ 1e-6, { INFINITY, 5e-3, 1e-5 } },
	};
	static const int steps[3] = { 20, 50, 200 };
	FILE *out = deck_table("Restitution of a sphere on a held one, located contacts");

	if (out)
		fprintf(out, "relative error, largest over 16 phases of entry\n%6s %8s %8s %8s\n", "e", "20",
			"50", "200");
	for (size_t r = 0; r < DECK_LENGTH(rows); r++) {
		double error[3] = { 0 };

		/* 20 steps of the most damped contact: two free spheres would be unstable, the run is
		 * refused */
		for (int k = rows[r].e < 1e-3; k < 3; k++) {
			error[k] = linear_error(rows[r].e, steps[k], 0, "yes");
			ck_assert_msg(error[k] < rows[r].most[k], "e = %g, %d steps: error %g", rows[r].e,
				      steps[k], error[k]);
		}
		if (out)
			fprintf(out, "%6g %8.1e %8.1e %8.1e\n", rows[r].e, error[0], error[1], error[2]);
	}
	if (out)
		fclose(out);
}
END_TEST

/* A contact without a dashpot is left as it is, to the bit. */
START_TEST(undamped)
{
	DECK_NEAR(linear_error(1, 37, 0, "yes"), linear_error(1, 37, 0, "no"), 0);
}
END_TEST

/* Both free, of different masses. */
START_TEST(two_free)
{
	ck_assert_double_lt(linear_error(0.4, 50, 2.385, "yes"), 1e-7);
	ck_assert_double_lt(linear_error(0.2, 31, 0.117, "yes"), 1e-6);
	ck_assert_double_gt(linear_error(0.4, 50, 2.385, "no"), 1e-2);
}
END_TEST

static const char hertz[] = "fix a all property/global youngsModulus peratomtype 5e6 5e6\n"
			    "fix b all property/global poissonsRatio peratomtype 0.31 0.31\n"
			    "fix c all property/global coefficientRestitution peratomtypepair 2 %g %g %g %g\n"
			    "pair_style gran model hertz located %s\npair_coeff * *";

static double hertz_error(double e, int steps, const char *located)
{
	double young = 5e6 / (1 - 0.31 * 0.31) / 2, mass = MASS * 2.385 / 3.385, r = RADIUS / 2;
	double duration = 2.87 * pow(mass * mass / (r * young * young * SPEED), 0.2);
	char pair[500];

	snprintf(pair, sizeof pair, hertz, e, e, e, e, located);
	/* the dashpot of Tsuji et al. is made for e */
	return pair_error(pair, e, duration / (steps + 0.385), 2 * steps, 2.385);
}

/* Its dashpot begins with q^(1/4): order 5/4, and errors of a tenth of those without. */
START_TEST(hertzian)
{
	double error[4], h[4];

	for (int k = 0; k < 4; k++) {
		h[k] = 1.0 / (25 << k);
		error[k] = hertz_error(0.4, 25 << k, "yes");
	}
	DECK_NEAR(deck_order(h, error, 4), 1.25, 0.2);
	ck_assert_double_lt(error[1], 1.5e-3);
	ck_assert_double_lt(error[1], 0.15 * hertz_error(0.4, 50, "no"));
}
END_TEST

/* limitForce: the contact ends where the force does, at tan(w t) = -2 g w/(w^2 - g^2) (T. Schwager, T.
 * Poeschel, Granul. Matter 9 (2007) 465). */
START_TEST(without_tension)
{
	double gamma = 0.31, omega = sqrt(1 - gamma * gamma), error[2];
	double time = (PI - atan2(2 * gamma * omega, omega * omega - gamma * gamma)) / omega;
	double w0 = sqrt(STIFFNESS / MASS);
	char pair[700];

	for (int k = 0; k < 2; k++) {
		snprintf(pair, sizeof pair,
			 "fix a all property/global kn peratomtypepair 2 %.17g %.17g %.17g %.17g\n"
			 "fix b all property/global kt peratomtypepair 2 0 0 0 0\n"
			 "fix c all property/global gamman peratomtypepair 2 %.17g %.17g %.17g %.17g\n"
			 "fix d all property/global gammat peratomtypepair 2 0 0 0 0\n"
			 "pair_style gran model hooke/stiffness limitForce on located %s\npair_coeff * *",
			 STIFFNESS, STIFFNESS, STIFFNESS, STIFFNESS, 2 * gamma * w0, 2 * gamma * w0,
			 2 * gamma * w0, 2 * gamma * w0, k ? "no" : "yes");
		error[k] = pair_error(pair, exp(-gamma * time), PI / omega / w0 / 50.385, 50, 0);
	}
	ck_assert_double_lt(error[0], 1e-6);
	ck_assert_double_gt(error[1], 1e-3);
}
END_TEST

/* Spheres fall on a floor; `laws`: of pair and wall. */
static double wall_error(const char *laws, double e, double h, int steps)
{
	double worst = 0, v[PHASES];
	struct tsim *sim = deck_open("units si\nboundary f f f\nnewton off\natom_style sphere\n"
				     "region box block -1 1 -1 1 -1 1 units box\n"
				     "create_box 1 box\nneighbor 0.003 bin\ntimestep %.17g\n"
				     "%s primitive type 1 zplane -0.011\nfix move all nve",
				     h, laws);

	for (int p = 0; p < PHASES; p++)
		deck(sim, "create_atoms 1 single %.17g 0 %.17g", -0.9 + 0.1 * p,
		     -0.011 + RADIUS + (1 + (p + 0.37) / PHASES) * SPEED * h);
	deck(sim, "set group all diameter %.17g mass %.17g vz %.17g\nrun %d", 2 * RADIUS, MASS, -SPEED,
	     steps + steps / 2 + 10);
	deck_column(sim, "vz", v, PHASES, 0);
	for (int p = 0; p < PHASES; p++)
		worst = fmax(worst, fabs(v[p] / SPEED / e - 1));
	tsim_close(sim);
	return worst;
}

static double pair_wall_error(const char *located)
{
	char laws[300];

	snprintf(laws, sizeof laws,
		 "pair_style spring/dashpot located %s\n"
		 "pair_coeff * * stiffness %.17g restitution 0.4\nfix floor all wall/gran",
		 located, STIFFNESS);
	return wall_error(laws, 0.4, linear_step(MASS, 0.4, 50), 50);
}

/* Walls of their own model, which has a loop of its own where contacts are not located. */
static double own_wall_error(const char *located)
{
	double a = sqrt(RADIUS) * 5e6 / (1 - 0.31 * 0.31);
	double k = 16.0 / 15 * a * pow(15.0 / 16 * MASS * 0.385 * 0.385 / a, 0.2);
	double step = linear_step(MASS, 0.4, 50) * sqrt(STIFFNESS / k);
	char laws[700];

	snprintf(laws, sizeof laws,
		 "fix a all property/global youngsModulus peratomtype 5e6\n"
		 "fix b all property/global poissonsRatio peratomtype 0.31\n"
		 "fix c all property/global coefficientRestitution peratomtypepair 1 0.4\n"
		 "fix d all property/global coefficientFriction peratomtypepair 1 0.3\n"
		 "fix e all property/global characteristicVelocity scalar 0.385\n"
		 "pair_style gran model hooke tangential history\npair_coeff * *\n"
		 "fix floor all wall/gran model hooke tangential history located %s",
		 located);
	return wall_error(laws, 0.4, step, 50);
}

START_TEST(wall)
{
	ck_assert_double_lt(pair_wall_error("yes"), 1e-7);
	ck_assert_double_gt(pair_wall_error("no"), 1e-2);
	ck_assert_double_lt(own_wall_error("yes"), 1e-7);
	ck_assert_double_gt(own_wall_error("no"), 1e-2);
}
END_TEST

/* A pile of spheres comes to rest: overlaps are weights over k to rounding, whatever the dashpot and the
 * step. */
START_TEST(at_rest)
{
	enum { HIGH = 4 };
	double h = linear_step(MASS / 2, 0.3, 17), z[HIGH], below = 0.011;
	struct tsim *sim = deck_open("units si\nboundary f f f\n"
				     "region box block -1 1 -1 1 -1 1 units box\n"
				     "create_box 1 box\nneighbor 0.003 bin\ntimestep %.17g\n"
				     "pair_style spring/dashpot located yes\n"
				     "pair_coeff * * stiffness %.17g restitution 0.3\n"
				     "fix move all nve\nfix g all gravity 9.81 vector 0 0 -1\n"
				     "fix floor all wall/gran primitive type 1 zplane 0.011",
				     h, STIFFNESS);

	for (int p = 0; p < HIGH; p++)
		deck(sim, "create_atoms 1 single 0 0 %.17g", 0.011 + RADIUS * (2 * p + 1.0));
	deck(sim, "set group all diameter %.17g mass %.17g\nrun 20000", 2 * RADIUS, MASS);
	deck_column(sim, "z", z, HIGH, 0);
	for (int p = 0; p < HIGH; p++) {
		double overlap = (p ? 2 : 1) * RADIUS - (z[p] - below);

		DECK_NEAR(overlap / (9.81 * MASS * (HIGH - p) / STIFFNESS), 1, 1e-9);
		below = z[p];
	}
	tsim_close(sim);
}
END_TEST

/* A row of spheres in collision with each other: largest error of a velocity beside a run with very small
 * steps. */
static void row_velocities(const char *located, int steps, double *v)
{
	enum { N = 5 };
	static const double speed[N] = { 0.3, 0.05, -0.2, -0.11, -0.4 };
	double time = 3 * linear_step(MASS / 2, 0.5, 1);
	struct tsim *sim = deck_open("units si\nboundary f f f\n"
				     "region box block -1 1 -1 1 -1 1 units box\n"
				     "create_box 1 box\nneighbor 0.003 bin\ntimestep %.17g\n"
				     "pair_style spring/dashpot located %s\n"
				     "pair_coeff * * stiffness %.17g restitution 0.5\n"
				     "fix move all nve",
				     time / steps, located, STIFFNESS);

	for (int p = 0; p < N; p++)
		deck(sim, "create_atoms 1 single %.17g 0 0", 2 * RADIUS * p + 1e-5 * (p + 0.3 * sin(7 * p)));
	deck(sim, "set group all diameter %.17g mass %.17g", 2 * RADIUS, MASS);
	for (int p = 0; p < N; p++)
		deck(sim, "set atom %d vx %.17g", p + 1, speed[p]);
	deck(sim, "run %d", steps);
	deck_column(sim, "vx", v, N, 0);
	tsim_close(sim);
}

START_TEST(second_order)
{
	double exact[5], v[5], h[5], error[2][5];

	row_velocities("yes", 32000, exact);
	for (int l = 0; l < 2; l++) {
		for (int k = 0; k < 5; k++) {
			h[k] = 1.0 / (100 << k);
			row_velocities(l ? "yes" : "no", 100 << k, v);
			error[l][k] = 0;
			for (int p = 0; p < 5; p++)
				error[l][k] = fmax(error[l][k], fabs(v[p] - exact[p]));
		}
	}
	DECK_NEAR(deck_order(h, error[1], 5), 2, 0.15);
	ck_assert_double_lt(error[1][4], 0.02 * error[0][4]);
}
END_TEST

/* Forces are opposite. */
START_TEST(momentum)
{
	struct tsim *sim = cloud_open("p p p", "located yes", "nve", cloud_start());
	struct cloud before = cloud_read(sim, 0), after;

	deck(sim, "run 2000");
	after = cloud_read(sim, 0);
	for (int k = 0; k < 3; k++) {
		double change = 0, scale = 0;

		for (int i = 0; i < CLOUD; i++) {
			change += after.m[i] * (after.v[k][i] - before.v[k][i]);
			scale += fabs(after.m[i] * before.v[k][i]);
		}
		DECK_NEAR(change, 0, 1e-14 * scale);
	}
	tsim_close(sim);
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("located");
	TCase *tests = tcase_create("located contacts");

	tcase_set_timeout(tests, 60);
	tcase_add_test(tests, restitution);
	tcase_add_test(tests, undamped);
	tcase_add_test(tests, two_free);
	tcase_add_test(tests, hertzian);
	tcase_add_test(tests, without_tension);
	tcase_add_test(tests, wall);
	tcase_add_test(tests, at_rest);
	tcase_add_test(tests, second_order);
	tcase_add_test(tests, momentum);
	suite_add_tcase(suite, tests);
	return deck_main(suite);
}
