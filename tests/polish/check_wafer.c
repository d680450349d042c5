/* A wafer on springs: closed forms of a flat pad, forces as derivatives of the energy, random pads. */
#include <stdlib.h>

#include "math/rng.h"
#include "polish/wafer.h"
#include "tests/deck.h"

/* A pad of n x m columns on the rectangle 2 x 1 around the joint. */
static struct ts_wafer_column *make_pad(int n, int m)
{
	struct ts_wafer_column *c = malloc((size_t)(n * m) * sizeof *c);

	for (int k = 0; k < n * m; k++)
		c[k] = (struct ts_wafer_column){ { 2 * ((k % n + 0.5) / n - 0.5),
						   (double)(k / n) / m + 0.5 / m - 0.5 },
						 2.0 / (n * m),
						 0.1 };
	return c;
}

/* All touch: z = h - P/k, s_d = P A friction_d/(k sum A x_d^2); sum A x^2 = A L^2/12 (1 - 1/n^2) for n columns. */
START_TEST(flat_pad)
{
	struct ts_wafer_column *pad = make_pad(20, 10);
	struct ts_wafer w = { pad, 200, 50, INFINITY, 4, { 0.1, -0.05 } };
	struct ts_wafer_pose pose = { 0, { 0, 0 } };
	struct ts_wafer_forces f;

	ck_assert(ts_wafer_settle(&w, &pose) == TS_OK);
	DECK_NEAR(pose.z, 0.1 - 4 / (2 * 50.0), 1e-12);
	DECK_NEAR(pose.slope[0], 4 * 0.1 / (50 * 2 * 4 / 12.0 * (1 - 1 / 400.0)), 1e-11);
	DECK_NEAR(pose.slope[1], -4 * 0.05 / (50 * 2 * 1 / 12.0 * (1 - 1 / 100.0)), 1e-11);
	ts_wafer_forces(&w, &pose, &f);
	DECK_NEAR(f.area, 2, 1e-14);
	DECK_NEAR(f.normal, 4, 1e-10);
	free(pad);
}
END_TEST

/* Friction so large that a part of the face lifts off: the load is a triangle over the length 3 (L/2 - e). */
START_TEST(lifted_edge)
{
	double step[3], error[3];

	for (int k = 0; k < 3; k++) {
		int n = 40 << k;
		struct ts_wafer_column *pad = make_pad(n, 1);
		struct ts_wafer w = { pad, (size_t)n, 50, INFINITY, 4, { 0.6, 0 } };
		struct ts_wafer_pose pose = { 0.3, { 0.2, 0 } };
		double length = 3 * (1 - 0.6), most = 2 * 4 / length; /* the leading edge carries most */

		ck_assert(ts_wafer_settle(&w, &pose) == TS_OK);
		step[k] = 1.0 / n;
		error[k] = fabs((0.1 - (pose.z - pose.slope[0])) * 50 - most);
		free(pad);
	}
	ck_assert_msg(error[2] < 2e-3 && deck_order(step, error, 3) > 1.5, "error %g, order %g", error[2],
		      deck_order(step, error, 3));
}
END_TEST

START_TEST(overloaded)
{
	struct ts_wafer_column *pad = make_pad(20, 10);
	struct ts_wafer w = { pad, 200, 50, 1.9, 4, { 0, 0 } };
	struct ts_wafer_pose pose = { 0, { 0, 0 } };

	ck_assert(ts_wafer_settle(&w, &pose) == TS_PHYSICS); /* 2 are needed, columns yield at 1.9 */
	w.hardness = INFINITY;
	w.friction[0] = 1.01; /* the load acts outside of the face */
	ck_assert(ts_wafer_settle(&w, &pose) == TS_PHYSICS);
	free(pad);
}
END_TEST

/* Random pads: forces are derivatives of the energy, the stiffness those of the forces; from far poses all settle. */
START_TEST(random_pads)
{
	struct ts_rng rng = ts_rng_start(41, 1);

	for (int trial = 0; trial < 40; trial++) {
		struct ts_wafer_column *pad = make_pad(15, 12);
		struct ts_wafer w = { pad, 180, 50, trial % 2 ? 3 : INFINITY, 0.3, { 0.1, 0.05 } };
		struct ts_wafer_pose pose = { 5 * ts_rng_uniform(&rng) - 2,
					      { ts_rng_uniform(&rng) - 0.5, 0 } };
		struct ts_wafer_forces f, g;
		double unit = 1e-7;

		for (int k = 0; k < 180; k++)
			pad[k].height = 0.1 * ts_rng_normal(&rng);
		ck_assert_msg(ts_wafer_settle(&w, &pose) == TS_OK, "pad %d", trial);
		ts_wafer_forces(&w, &pose, &f);
		DECK_NEAR(f.normal, 0.3, 1e-10);
		DECK_NEAR(f.moment[0], -0.03, 1e-10);
		DECK_NEAR(f.moment[1], -0.015, 1e-10);
		pose.z += unit;
		ts_wafer_forces(&w, &pose, &g);
		DECK_NEAR((g.energy - f.energy) / unit, -f.normal, 1e-4);
		DECK_NEAR((g.moment[0] - f.moment[0]) / unit, -f.stiffness[0][1], 1e-3);
		pose.z -= unit;
		pose.slope[1] += unit;
		ts_wafer_forces(&w, &pose, &g);
		DECK_NEAR((g.energy - f.energy) / unit, -f.moment[1], 1e-4);
		free(pad);
	}
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("wafer");
	TCase *tcase = tcase_create("springs");

	tcase_add_test(tcase, flat_pad);
	tcase_add_test(tcase, lifted_edge);
	tcase_add_test(tcase, overloaded);
	tcase_add_test(tcase, random_pads);
	suite_add_tcase(suite, tcase);
	return deck_main(suite);
}
