/* Flow factors of rough surfaces. */
#include "films.h"

/* Flow between parallel surfaces of unit size, by a pressure at the lower edge and the sliding of the lower surface. */
static double flow_between(double h, double lower, double upper, enum ts_film_peklenik number, int axis,
			   double speed, double pressure)
{
	struct ts_film f = film_open(6, 6, 1, 1);
	struct ts_film_measures m;

	f.edge[axis][0] = f.edge[axis][1] = TS_FILM_PRESSURE;
	f.edge[1 - axis][0] = f.edge[1 - axis][1] = TS_FILM_NO_FLOW;
	f.edge_pressure[axis][0] = pressure;
	f.roughness[0] = lower;
	f.roughness[1] = upper;
	f.peklenik = number;
	film_fill(&f, f.gap, h);
	film_fill(&f, f.velocity[0][axis], speed);
	m = film_solve(&f);
	ck_assert(isnan(m.shear[0][axis]) == (lower + upper > 0));
	ts_film_release(&f);
	return m.outflow[axis][1];
}

/* phi_p h^3 at H = 4: along x and, by the inverse Peklenik number, along y. */
START_TEST(pressure_flow)
{
	const double factor[] = { 1 - 1.48 * exp(-1.68), 1 - 1.38 * exp(-1.68), 1 - 1.18 * exp(-1.68),
				  1 - 0.9 * exp(-2.24),	 1 + 0.225 * 0.125,	1 + 0.52 * 0.125,
				  1 + 0.87 * 0.125 };

	for (int k = 0; k < 7; k++) {
		double q = flow_between(2, 0.3, 0.4, (enum ts_film_peklenik)k, 0, 0, 12);

		DECK_NEAR(q, 8 * factor[k], 1e-13 * q);
		q = flow_between(2, 0.3, 0.4, (enum ts_film_peklenik)(6 - k), 1, 0, 12);
		DECK_NEAR(q, 8 * factor[k], 1e-13 * q);
	}
}
END_TEST

/* The two formulas of phi_s meet at H = 5 to the digits of their constants; rough lower surface: more flow than h/2 as it
 * slides, by sigma phi_s/2; rough upper one at rest: less by the same; equal ones: h/2. */
START_TEST(shear_flow)
{
	for (int k = 0; k < 7; k++) {
		enum ts_film_peklenik number = (enum ts_film_peklenik)k;
		double below = flow_between(5 - 1e-9, 1, 0, number, 0, 1, 0) - 2.5;
		double above = flow_between(5 + 1e-9, 1, 0, number, 0, 1, 0) - 2.5;

		DECK_NEAR(below / above, 1, 1e-3);
		ck_assert(below > 0.04);
		DECK_NEAR(flow_between(5 + 1e-9, 0, 1, number, 0, 1, 0) - 2.5, -above, 1e-8);
		DECK_NEAR(flow_between(5 + 1e-9, 1, 0, (enum ts_film_peklenik)(6 - k), 1, 1, 0) - 2.5, above,
			  1e-8);
		DECK_NEAR(flow_between(4, 0.7, 0.7, number, 0, 1, 0), 2, 1e-14);
	}
	/* isotropic */
	DECK_NEAR(flow_between(4, 1, 0, TS_FILM_PEKLENIK_1, 0, 1, 0) - 2,
		  1.899 * pow(4, 0.98) * exp(-0.92 * 4 + 0.05 * 16) / 2, 1e-13);
	DECK_NEAR(flow_between(8, 1, 0, TS_FILM_PEKLENIK_1, 0, 1, 0) - 4, 1.126 * exp(-2) / 2, 1e-13);
	DECK_NEAR(flow_between(8, 0.6, 0.8, TS_FILM_PEKLENIK_1, 0, 1, 0) - 4, -0.28 * 1.126 * exp(-2) / 2,
		  1e-13);
}
END_TEST

static struct ts_film slider(int n, double sigma, enum ts_film_peklenik number)
{
	struct ts_film f = film_open(n, 1, 1, 1);

	f.roughness[1] = sigma;
	f.peklenik = number;
	film_fill(&f, f.velocity[0][0], 1);
	for (int i = 0; i < n; i++)
		f.gap[i] = 2 - ts_film_centre(&f, 0, i);
	return f;
}

/* Second order, grooves across the flow carry more; the smooth limit; coarse grids of the cavity have the roughness. */
START_TEST(rough_slider)
{
	double step[3], load[4], error[3], across, along;
	struct ts_film f = slider(2000, 1e-6, TS_FILM_PEKLENIK_1);

	DECK_NEAR(film_solve(&f).load, 0.158883, 1e-6);
	ts_film_release(&f);
	f = slider(2000, 0.3, TS_FILM_PEKLENIK_1_9);
	across = film_solve(&f).load;
	f.cavitation = TS_FILM_REYNOLDS;
	DECK_NEAR(film_solve(&f).load, across, 1e-12);
	ts_film_release(&f);
	f = slider(2000, 0.3, TS_FILM_PEKLENIK_9);
	along = film_solve(&f).load;
	ts_film_release(&f);
	ck_assert(across > 1.1 * along);
	for (int level = 0; level < 4; level++) {
		int n = level == 3 ? 8000 : 50 << level;

		f = slider(n, 0.15, TS_FILM_PEKLENIK_1); /* H from 13.3 to 6.7 */
		load[level] = film_solve(&f).load;
		ts_film_release(&f);
	}
	for (int level = 0; level < 3; level++) {
		step[level] = 1.0 / (50 << level);
		error[level] = fabs(load[level] - load[3]);
	}
	DECK_NEAR(deck_order(step, error, 3), 2, 0.05);
}
END_TEST

#define REFUSED(place, value, code, text)                                                \
	do {                                                                             \
		struct ts_film film = slider(6, 0.3, TS_FILM_PEKLENIK_1);                \
		struct ts_error error = { .status = TS_OK };                             \
		film.place = (value);                                                    \
		ck_assert_int_eq(ts_film_solve(&film, &error), code);                    \
		ck_assert_msg(strstr(error.message, text) != NULL, "%s", error.message); \
		ts_film_release(&film);                                                  \
	} while (0)

START_TEST(refusals)
{
	REFUSED(roughness[0], -1, TS_RANGE, "roughness -1, expected >= 0");
	REFUSED(roughness[0], NAN, TS_RANGE, "roughness");
	REFUSED(gap[3], 0.89, TS_RANGE, "less than 3 standard deviations of the roughness, 0.3");
	REFUSED(cavitation, TS_FILM_JFO, TS_STATE, "not known for cavitation jfo");
	REFUSED(slip[0], 0.1, TS_STATE, "not known for slip");
	REFUSED(piezo.law, TS_FILM_BARUS, TS_STATE, "not known for a viscosity");
	REFUSED(polar, true, TS_STATE, "not known for a polar grid");
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("film_roughness");
	TCase *tcase = tcase_create("film_roughness");

	tcase_set_timeout(tcase, 100);
	tcase_add_test(tcase, pressure_flow);
	tcase_add_test(tcase, shear_flow);
	tcase_add_test(tcase, rough_slider);
	tcase_add_test(tcase, refusals);
	suite_add_tcase(suite, tcase);
	return deck_main(suite);
}
