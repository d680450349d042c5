/* Films on whose border no pressure is given: exact solutions but for a constant; parts; volumes that change. */
#include "films.h"

/* Gap 1 on one half of a period, 2 on the other, the upper surface slides with speed 1. The flow q is the same
 * everywhere and dp/dx = 12 (h/2 - q)/h^3 has the mean 0: q = 1/2 (1 + 1/4)/(1 + 1/8) = 5/9. */
START_TEST(steps_of_a_period)
{
	struct ts_film f = film_open(8, 3, 1, 1);
	double slope[2] = { 12 * (0.5 - 5.0 / 9), 12 * (1 - 5.0 / 9) / 8 };

	for (int k = 0; k < 4; k++)
		f.edge[k / 2][k % 2] = TS_FILM_PERIODIC;
	f.shape = TS_FILM_STEPPED;
	f.floating = true;
	f.ambient = 7;
	film_fill(&f, f.velocity[1][0], 1);
	for (int j = 0; j < 3; j++)
		for (int i = 4; i < 8; i++)
			f.gap[ts_film_at(&f, i, j)] = 2;
	for (int again = 0; again < 2; again++) {
		film_solve(&f);
		for (int j = 0; j < 3; j++)
			for (int i = 0; i < 8; i++) {
				double x = i < 4 ? i / 8.0 : 3.5 / 8, beyond = i < 4 ? 0 : (i - 3.5) / 8;

				DECK_NEAR(f.p[ts_film_at(&f, i, j)], 7 + slope[0] * x + slope[1] * beyond,
					  1e-12);
				DECK_NEAR(f.flow[0][ts_film_face(&f, 0, i, j)], 5.0 / 9 / 3, 1e-13);
			}
	}
	ts_film_release(&f);
}
END_TEST

/* Nothing flows: balances have no scale. */
static void solve(struct ts_film *f)
{
	struct ts_error error = { .status = TS_OK };

	ck_assert_msg(ts_film_solve(f, &error) == TS_OK, "%s", error.message);
}

/* A slider closed all around: no flow, p = 6/((K - 1) h) + constant for h = K - (K - 1) x. A wall in the middle makes
 * two of them. */
START_TEST(closed_slider)
{
	struct ts_film f = film_open(21, 1, 1, 1);

	f.edge[0][0] = f.edge[0][1] = TS_FILM_NO_FLOW;
	f.floating = true;
	film_fill(&f, f.velocity[0][0], 1);
	for (int i = 0; i < 21; i++)
		f.gap[i] = 2 - ts_film_centre(&f, 0, i);
	solve(&f);
	for (int i = 0; i < 21; i++)
		DECK_NEAR(f.p[i], 6 / f.gap[i] - 6 / f.gap[0], 1e-12);
	f.kind[10] = TS_FILM_SOLID;
	solve(&f);
	for (int i = 0; i < 10; i++) {
		DECK_NEAR(f.p[i], 6 / f.gap[i] - 6 / f.gap[0], 1e-12);
		DECK_NEAR(f.p[11 + i], 6 / f.gap[11 + i] - 6 / f.gap[11], 1e-12);
	}
	/* with a pressure given at one end of it, the first part has that one */
	f.edge[0][0] = TS_FILM_PRESSURE;
	f.edge_pressure[0][0] = 3;
	solve(&f);
	ck_assert(fabs(f.p[0]) > 1);
	DECK_NEAR(f.p[11], 0, 1e-15);
	ts_film_release(&f);
}
END_TEST

/* U = 1 on the lower surface, no flow: -h/2 dp/dx = -3/h, so that the stresses are -4/h and -2/h. */
static struct ts_film_measures closed_forces(int n, enum ts_film_shape shape, double slope)
{
	struct ts_film f = film_open(n, 1, 1, 1);
	struct ts_film_measures m;
	struct ts_film_point low, high;

	f.edge[0][0] = f.edge[0][1] = TS_FILM_NO_FLOW;
	f.floating = true;
	f.shape = shape;
	film_fill(&f, f.velocity[0][0], 1);
	for (int i = 0; i < n; i++)
		f.gap[i] = 1 + slope * (1 - ts_film_centre(&f, 0, i));
	solve(&f);
	ts_film_measure(&f, &m);
	ts_film_sample(&f, (double[]){ 0.013, 0.3 }, &low);
	ts_film_sample(&f, (double[]){ 0.987, 0.3 }, &high);
	if (slope == 0)
		DECK_NEAR(high.p - low.p, 6 * 0.974, 1e-12);
	ts_film_release(&f);
	return m;
}

START_TEST(shear_up_to_closed_edges)
{
	const int cells[] = { 1, 2, 9 };
	const enum ts_film_shape shape = _i ? TS_FILM_STEPPED : TS_FILM_LINEAR;
	double error[2];

	for (int k = 0; k < 3; k++) {
		struct ts_film_measures m = closed_forces(cells[k], shape, 0);

		DECK_NEAR(m.shear[0][0], -4, 1e-12);
		DECK_NEAR(m.shear[1][0], -2, 1e-12);
	}
	for (int k = 0; k < 2; k++)
		error[k] = closed_forces(10 << k, shape, 1).shear[0][0] + 4 * log(2);
	ck_assert_msg(fabs(error[1]) < 1e-3 && error[0] / error[1] > 3.5, "errors %g, %g", error[0],
		      error[1]);
}
END_TEST

/* 1000 before a block that fills the gap, 0 behind it, or the other way round. */
START_TEST(pressure_on_a_block)
{
	for (int side = 0; side < 2; side++) {
		struct ts_film f = film_open(10, 2, 1, 1);
		struct ts_film_point at;
		struct ts_film_measures m;

		f.shape = _i ? TS_FILM_STEPPED : TS_FILM_LINEAR;
		f.ambient = 0;
		f.edge_pressure[0][side] = 1000;
		for (int j = 0; j < 2; j++)
			for (int i = 4; i < 6; i++) {
				f.kind[ts_film_at(&f, i, j)] = TS_FILM_SOLID;
				f.gap[ts_film_at(&f, i, j)] = -0.1;
			}
		m = film_solve(&f);
		DECK_NEAR(m.pressure_force[0], side ? -1000 : 1000, 1e-9);
		DECK_NEAR(m.shear[0][0], 0, 1e-9);
		ts_film_release(&f);

		f = film_open(10, 2, 1, 1); /* without the block: linear up to the edges */
		f.shape = _i ? TS_FILM_STEPPED : TS_FILM_LINEAR;
		f.edge_pressure[0][side] = 1000;
		film_solve(&f);
		ts_film_sample(&f, (double[]){ 0.01, 0.9 }, &at);
		DECK_NEAR(at.p, side ? 10 : 990, 1e-9);
		ts_film_release(&f);
	}
}
END_TEST

static void refused(struct ts_film *f, enum ts_status status, const char *text)
{
	struct ts_error error = { .status = TS_OK };

	ck_assert_int_eq(ts_film_solve(f, &error), status);
	ck_assert_msg(strstr(error.message, text) != NULL, "%s", error.message);
}

START_TEST(refusals)
{
	struct ts_film f = film_open(6, 1, 1, 1);

	f.edge[0][0] = f.edge[0][1] = TS_FILM_NO_FLOW;
	f.floating = true;
	film_fill(&f, f.rate, -2);
	refused(&f, TS_PHYSICS, "that contains (0.0833333, 0.5) changes, by -2 per time");
	/* what one end takes up the other one gives */
	for (int i = 0; i < 6; i++)
		f.rate[i] = i < 3 ? -1 : 1;
	film_solve(&f);
	f.cavitation = TS_FILM_REYNOLDS;
	refused(&f, TS_STATE, "expected no cavitation");
	f.cavitation = TS_FILM_NONE;
	f.floating = false;
	refused(&f, TS_STATE, "see `floating`");
	ts_film_release(&f);
}
END_TEST

START_TEST(out_of_memory)
{
	struct ts_film f = film_open(6, 1, 1, 1);
	bool failed = true;

	f.edge[0][0] = f.edge[0][1] = TS_FILM_NO_FLOW;
	f.floating = true;
	film_fill(&f, f.velocity[0][0], 1);
	for (long k = 1; failed; k++) {
		struct ts_error error = { .status = TS_OK };

		ts_alloc_fail_at(k);
		failed = ts_film_solve(&f, &error) != TS_OK;
		ck_assert(!failed || error.status == TS_NOMEM);
		ts_alloc_fail_at(0);
		film_fill(&f, f.p, 0);
		for (size_t c = 0; c < ts_film_cells(&f); c++)
			f.kind[c] = TS_FILM_FLUID;
	}
	ts_film_release(&f);
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("film_floating");
	TCase *tcase = tcase_create("film_floating");

	tcase_add_test(tcase, steps_of_a_period);
	tcase_add_test(tcase, closed_slider);
	tcase_add_loop_test(tcase, shear_up_to_closed_edges, 0, 2);
	tcase_add_loop_test(tcase, pressure_on_a_block, 0, 2);
	tcase_add_test(tcase, refusals);
	tcase_add_test(tcase, out_of_memory);
	suite_add_tcase(suite, tcase);
	return deck_main(suite);
}
