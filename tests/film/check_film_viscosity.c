/* Viscosity that depends on the pressure: Barus and Roelands. */
#include "films.h"

/* Plane slider: h from 2 to 1 on a length of 1, the lower surface slides with speed 1. */
static struct ts_film slider(int n)
{
	struct ts_film f = film_open(n, 1, 1, 1);

	film_fill(&f, f.velocity[0][0], 1);
	for (int i = 0; i < n; i++)
		f.gap[i] = 2 - ts_film_centre(&f, 0, i);
	return f;
}

/* With constant viscosity p = 2 (2 - h)(h - 1)/h^2, 0.25 at most, and W = 0.158883. */
static double slider_pressure(double h)
{
	return 2 * (2 - h) * (h - 1) / (h * h);
}

static struct ts_film_piezo barus(double alpha)
{
	return (struct ts_film_piezo){ .law = TS_FILM_BARUS, .alpha = alpha };
}

static struct ts_film_piezo roelands(double viscosity, double pressure, double exponent)
{
	return (struct ts_film_piezo){
		.law = TS_FILM_ROELANDS, .viscosity = viscosity, .pressure = pressure, .exponent = exponent
	};
}

/* p = -ln(1 - alpha q)/alpha, q the pressure with constant viscosity; the flow does not change. */
START_TEST(barus_slider_is_exact)
{
	for (int k = 0; k < 4; k++) {
		double alpha = (const double[]){ 0, 0.01, 1, 3.9 }[k], load = 0;
		struct ts_film f = slider(200);
		struct ts_film_measures m;

		f.piezo = barus(alpha);
		m = film_solve(&f);
		for (int i = 0; i < 200; i++) {
			double q = slider_pressure(f.gap[i]), p = alpha > 0 ? -log(1 - alpha * q) / alpha : q;

			DECK_NEAR(f.p[i], p, 1e-11);
			load += p / 200;
		}
		DECK_NEAR(m.load, load, 1e-11);
		DECK_NEAR(m.outflow[0][1], 2.0 / 3, 1e-13);
		DECK_NEAR(m.shear[0][0] + m.shear[1][0] + m.pressure_force[0], 0, 1e-12);
		ck_assert(f.report.solves == 1);
		ts_film_release(&f);
	}
}
END_TEST

/* Suction: the lower surface slides to the left, q < 0. */
START_TEST(barus_below_zero)
{
	struct ts_film f = slider(50);

	f.piezo = barus(2);
	film_fill(&f, f.velocity[0][0], -1);
	film_solve(&f);
	for (int i = 0; i < 50; i++)
		DECK_NEAR(f.p[i], -log(1 + 2 * slider_pressure(f.gap[i])) / 2, 1e-12);
	ts_film_release(&f);
}
END_TEST

/* Z = 1 is Barus' equation with alpha = ln(eta/eta_r)/p_r. */
START_TEST(roelands_with_unit_exponent)
{
	struct ts_film f = slider(100), g = slider(100);

	f.edge_pressure[0][0] = g.edge_pressure[0][0] = 0.3;
	f.edge_pressure[0][1] = g.edge_pressure[0][1] = -0.2;
	f.piezo = roelands(exp(-4), 2, 1);
	g.piezo = barus(2);
	film_solve(&f);
	film_solve(&g);
	for (int i = 0; i < 100; i++)
		DECK_NEAR(f.p[i], g.p[i], 1e-12);
	DECK_NEAR(f.flow[0][50], g.flow[0][50], 1e-12);
	ck_assert(g.flow[0][50] > 0.67);
	ts_film_release(&f);
	ts_film_release(&g);
}
END_TEST

/* Roelands: h/2 - h^3/(12 eta(p)) dp/dx = q at each centre, of second order; the drag is that of eta(p). */
START_TEST(roelands_satisfies_the_equation)
{
	double step[3], error[3];

	for (int level = 0; level < 3; level++) {
		int n = 100 << level;
		struct ts_film f = slider(n);
		struct ts_film_measures m;
		double shear = 0;

		f.piezo = roelands(1e-3, 1.2, 0.6);
		m = film_solve(&f);
		step[level] = 1.0 / n;
		error[level] = 0;
		for (int i = 0; i < n; i++) {
			double h = f.gap[i];
			double eta = pow(1e3, pow(1 + f.p[i] / 1.2, 0.6) - 1);

			shear += eta / h / n;
			if (i > 0 && i < n - 1)
				error[level] =
					fmax(error[level], fabs(h / 2 - 2.0 / 3 -
								h * h * h / (12 * eta) *
									(f.p[i + 1] - f.p[i - 1]) * n / 2));
		}
		/* the parts of the pressure on both surfaces are the same */
		DECK_NEAR(m.shear[1][0] - m.shear[0][0], 2 * shear, 1e-12);
		ck_assert(m.p_max > 0.3);
		ts_film_release(&f);
	}
	ck_assert(error[2] < 1e-3);
	DECK_NEAR(deck_order(step, error, 3), 2, 0.1);
}
END_TEST

/* Near the limit 0.2530 of the reduced pressure; p by quadrature: dq = eta(0)/eta dp. */
START_TEST(roelands_near_its_limit)
{
	struct ts_film f = slider(301);
	double q = 0, dp;
	int top = 0;

	f.piezo = roelands(1e-3, 0.96, 0.6);
	film_solve(&f);
	for (int i = 0; i < 301; i++)
		top = f.p[i] > f.p[top] ? i : top;
	dp = f.p[top] / 200000;
	for (int k = 0; k < 200000; k++)
		q += dp * pow(1e-3, pow(1 + (k + 0.5) * dp / 0.96, 0.6) - 1);
	DECK_NEAR(q, slider_pressure(f.gap[top]), 1e-9);
	ck_assert(f.p[top] > 1.2);
	ts_film_release(&f);
}
END_TEST

/* Rayleigh step: forces use the pressure at the step. */
START_TEST(step_with_barus)
{
	enum { N = 10, STEP = 7 };
	const double deep = 1.8, length = STEP / (double)N, alpha = 1.5;
	double top = 6 * (deep - 1) / (deep * deep * deep / length + 1 / (1 - length));
	struct ts_film f = slider(N);
	struct ts_film_measures m;

	f.shape = TS_FILM_STEPPED;
	f.piezo = barus(alpha);
	for (int i = 0; i < N; i++)
		f.gap[i] = i < STEP ? deep : 1;
	m = film_solve(&f);
	DECK_NEAR(m.pressure_force[0], -log(1 - alpha * top) / alpha * (deep - 1), 1e-13);
	DECK_NEAR(m.shear[0][0] + m.shear[1][0] + m.pressure_force[0], 0, 1e-13);
	ts_film_release(&f);
}
END_TEST

/* Cavitation: the reduced pressure, the cavity and the flows are those of constant viscosity; a cell with a pressure given
 * has it exactly. Slip does not depend on the viscosity. */
START_TEST(cavitation_is_the_same)
{
	const double alpha = 0.03;

	for (int k = 0; k < 3; k++) {
		enum ts_film_cavitation cavitation =
			(const enum ts_film_cavitation[]){ TS_FILM_HALF, TS_FILM_REYNOLDS, TS_FILM_JFO }[k];
		struct ts_film f = film_bearing(60, 20, 0.7, 1, true, cavitation);
		struct ts_film g = film_bearing(60, 20, 0.7, 1, true, cavitation);

		f.piezo = barus(alpha);
		f.cavity_pressure = -0.1;
		g.cavity_pressure = (1 - exp(0.1 * alpha)) / alpha;
		f.slip[1] = g.slip[1] = 0.2;
		f.kind[130] = g.kind[130] = TS_FILM_GIVEN;
		f.pressure_given[130] = 2;
		g.pressure_given[130] = (1 - exp(-2 * alpha)) / alpha;
		film_solve(&f);
		film_solve(&g);
		ck_assert(f.p[130] == 2);
		ck_assert(f.report.cavitated == g.report.cavitated && g.report.cavitated > 100);
		for (size_t c = 0; c < ts_film_cells(&f); c++) {
			DECK_NEAR((1 - exp(-alpha * f.p[c])) / alpha, g.p[c], 1e-11);
			DECK_NEAR(f.empty[c], g.empty[c], 1e-11);
			if (g.p[c] == g.cavity_pressure)
				ck_assert(f.p[c] == -0.1);
		}
		ts_film_release(&f);
		ts_film_release(&g);
	}
}
END_TEST

static void refused(struct ts_film_piezo piezo, double edge, enum ts_status status, const char *text)
{
	struct ts_film f = slider(20);
	struct ts_error error = { .status = TS_OK };

	f.piezo = piezo;
	f.edge_pressure[0][1] = edge;
	ck_assert_int_eq(ts_film_solve(&f, &error), status);
	ck_assert_msg(strstr(error.message, text) != NULL, "%s", error.message);
	ts_film_release(&f);
}

START_TEST(refusals)
{
	refused(barus(-1), 0, TS_RANGE, "coefficient of Barus -1, expected >= 0");
	refused(barus(NAN), 0, TS_RANGE, "coefficient of Barus");
	refused(barus(4.1), 0, TS_PHYSICS, "no pressure satisfies the equation");
	refused(barus(1), -1e4, TS_RANGE, "is out of the range");
	refused(roelands(0, 1, 0.5), 0, TS_RANGE, "viscosity of Roelands is 0");
	refused(roelands(1, 1, 0.5), 0, TS_RANGE, "less than that at pressure 0, 1");
	refused(roelands(0.1, 0, 0.5), 0, TS_RANGE, "pressure of Roelands is 0");
	refused(roelands(0.1, 1, 0), 0, TS_RANGE, "exponent of Roelands is 0");
	refused(roelands(0.1, 1, 1.5), 0, TS_RANGE, "expected > 0 and at most 1");
	refused(roelands(0.1, 1, 0.5), -0.6, TS_RANGE, "is out of the range");
	/* the limit of the reduced pressure is 0.2372, the film needs 0.25 */
	refused(roelands(1e-3, 0.9, 0.6), 0, TS_PHYSICS, "no pressure satisfies the equation");
	refused(roelands(1e-9, 1, 0.9), 0, TS_PHYSICS, "no pressure satisfies the equation");
}
END_TEST

/* Each allocation fails once: an error, and nothing is left allocated. */
START_TEST(out_of_memory)
{
	long balance = ts_alloc_balance();
	enum ts_status status = TS_NOMEM;

	for (long k = 1; status != TS_OK; k++) {
		struct ts_film f = slider(30);
		struct ts_error error = { .status = TS_OK };

		ck_assert(k < 200);
		f.cavitation = TS_FILM_JFO;
		f.piezo = barus(1);
		ts_alloc_fail_at(k);
		status = ts_film_solve(&f, &error);
		ts_alloc_fail_at(0);
		ck_assert(status == TS_OK || status == TS_NOMEM);
		ts_film_release(&f);
		ck_assert(ts_alloc_balance() == balance);
	}
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("film_viscosity");
	TCase *tcase = tcase_create("film_viscosity");

	tcase_set_timeout(tcase, 100);
	tcase_add_test(tcase, barus_slider_is_exact);
	tcase_add_test(tcase, barus_below_zero);
	tcase_add_test(tcase, roelands_with_unit_exponent);
	tcase_add_test(tcase, roelands_satisfies_the_equation);
	tcase_add_test(tcase, roelands_near_its_limit);
	tcase_add_test(tcase, step_with_barus);
	tcase_add_test(tcase, cavitation_is_the_same);
	tcase_add_test(tcase, refusals);
	tcase_add_test(tcase, out_of_memory);
	suite_add_tcase(suite, tcase);
	return deck_main(suite);
}
