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
	ck_assert(isfinite(m.shear[0][axis]) && isfinite(m.shear[1][axis]));
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

/* Density of the heights, sigma = 1, and means over it of powers of an open gap h + d. */
static double mean_power(double h, int power)
{
	const int n = 60000;
	double sum = 0;

	for (int i = 0; i < n; i++) {
		double d = -3 + 6 * (i + 0.5) / n, y = 1 - d * d / 9;

		if (h + d > 0.01)
			sum += 35 / 96.0 * y * y * y * pow(h + d, power) * 6 / n;
	}
	return sum;
}

/* Surfaces that touch: unit size, the lower one rough (sigma 1) and sliding with speed 1, viscosity 1. */
static struct ts_film_measures touching(double h, double lower, double upper, enum ts_film_peklenik number,
					double pressure, double rate)
{
	struct ts_film f = film_open(6, 6, 1, 1);
	struct ts_film_measures m;

	f.roughness[0] = lower;
	f.roughness[1] = upper;
	f.peklenik = number;
	f.asperity = (struct ts_film_asperity){ 0.1, 0.5, 1e6, 0.2 };
	f.edge_pressure[0][0] = pressure;
	film_fill(&f, f.gap, h);
	film_fill(&f, f.rate, rate);
	film_fill(&f, f.velocity[0][0], rate != 0 || pressure != 0 ? 0 : 1);
	m = film_solve(&f);
	ts_film_release(&f);
	return m;
}

/* Equal surfaces: the mean of the open gap is dragged and squeezed; phi_f is the mean of h over the gap. */
START_TEST(mixed_film)
{
	for (int k = 0; k < 8; k++) {
		double h = (const double[]){ 0.5, 0.8, 1.5, 2.9, 3, 5, 29.9, 30.1 }[k], s = sqrt(0.5),
		       step = 1e-3;
		struct ts_film_measures m = touching(h, s, s, TS_FILM_PEKLENIK_1, 0, 0);
		double more = mean_power(h + step, 1), less = mean_power(h - step, 1);

		DECK_NEAR(m.volume, mean_power(h, 1), 1e-4);
		DECK_NEAR(m.outflow[0][1], m.volume / 2, 1e-12);
		DECK_NEAR(m.shear[1][0] * h, h * mean_power(h, -1), k < 4 ? 1.5e-2 : 1e-6);
		DECK_NEAR(m.shear[0][0], -m.shear[1][0], 1e-12);
		if (h > 1) {
			m = touching(h, s, s, TS_FILM_PEKLENIK_1, 0, -1);
			DECK_NEAR(film_outflow(&m), (more - less) / (2 * step), 1e-3);
		}
	}
}
END_TEST

/* Shear stress factors of a rough lower surface: between those of smooth surfaces and of infinitely long ridges across, for which
 * the film is exact in one dimension; in the order of the Peklenik numbers; the rough surface is sheared less. */
START_TEST(shear_stress_factors)
{
	for (int n = 3; n <= 6; n++) {
		double h = n, i1 = mean_power(h, -1), i2 = mean_power(h, -2), i3 = mean_power(h, -3);
		double difference = h * (3 * i1 - 3 * i2 * i2 / i3), last = difference, flow = i2 / i3 / h,
		       next;

		for (int k = 0; k < 7; k++) {
			enum ts_film_peklenik number = (enum ts_film_peklenik)k;
			struct ts_film_measures m = touching(h, 1, 0, number, 0, 0);

			DECK_NEAR((m.shear[1][0] - m.shear[0][0]) / 2 * h, h * i1, 1e-3);
			next = (m.shear[1][0] + m.shear[0][0]) / 2 * h;
			ck_assert_msg(next > 0 && next < last, "phi_fs %g, then %g", last, next);
			last = next;
			m = touching(h, 1, 0, number, 1, 0);
			next = m.shear[0][0] / (h / 2);
			ck_assert_msg(next > flow && next < 1, "phi_fp %g, then %g", flow, next);
			DECK_NEAR(m.shear[1][0], m.shear[0][0], 1e-12);
			flow = next;
		}
	}
}
END_TEST

/* F_5/2 and F_2 as Greenwood and Tripp tabulated them; the slope is the derivative. */
START_TEST(asperities)
{
	static const double table[][3] = { { 0, 0.61664, 0.5 },	    { 0.5, 0.24040, 0.20964 },
					   { 1, 0.08056, 0.07534 }, { 1.5, 0.02286, 0.02285 },
					   { 2, 0.00542, 0.00577 }, { 3, 0.00017, 0.00020 } };
	const struct ts_film f = { .roughness = { 0.3, 0.4 }, .asperity = { 3, 0.2, 7, 0 } };
	const double crowd = 3 * 0.2 * 0.5, scale = 16 * sqrt(2) * PI / 15 * crowd * crowd * 7 * sqrt(2.5);

	for (size_t k = 0; k < DECK_LENGTH(table); k++) {
		double h = table[k][0] * 0.5, step = 1e-5;
		struct ts_film_touch t = ts_film_touch(&f, h);

		DECK_NEAR(t.pressure / scale, table[k][1], 2e-5);
		DECK_NEAR(t.area / (PI * PI * crowd * crowd), table[k][2], 1e-5);
		DECK_NEAR(t.slope / scale,
			  (ts_film_touch(&f, h + step).pressure - ts_film_touch(&f, h - step).pressure) /
				  (2 * step) / scale,
			  1e-7);
	}
	struct ts_film_measures m = touching(1, 0.6, 0.8, TS_FILM_PEKLENIK_1, 0, 0);
	struct ts_film plates = { .roughness = { 0.6, 0.8 }, .asperity = { 0.1, 0.5, 1e6, 0.2 } };

	DECK_NEAR(m.touch_load, ts_film_touch(&plates, 1).pressure, 1e-9 * m.touch_load);
	DECK_NEAR(m.touch_friction[0], 0.2 * m.touch_load, 1e-9 * m.touch_load);
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
	REFUSED(gap[3], 0.89, TS_RANGE, "below 3 the surfaces touch; expected `asperities`");
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
	tcase_add_test(tcase, mixed_film);
	tcase_add_test(tcase, shear_stress_factors);
	tcase_add_test(tcase, asperities);
	tcase_add_test(tcase, rough_slider);
	tcase_add_test(tcase, refusals);
	suite_add_tcase(suite, tcase);
	return deck_main(suite);
}
