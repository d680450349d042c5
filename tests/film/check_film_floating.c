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
	tcase_add_test(tcase, refusals);
	tcase_add_test(tcase, out_of_memory);
	suite_add_tcase(suite, tcase);
	return deck_main(suite);
}
