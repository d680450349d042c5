/* Films between surfaces that slip: closed solutions, the condition of Navier, forces, conservation. */
#include "films.h"

/* Flow of the surface 1 and h^3 with slip, for the tests that need only values. */
static double couette(double h, double b1, double b2)
{
	return h * (h / 2 + b2) / (h + b1 + b2);
}

static double poiseuille(double h, double b1, double b2)
{
	return h * h * (h * h + 4 * h * (b1 + b2) + 12 * b1 * b2) / (h + b1 + b2);
}

/* ---- plane slider: h from 2 to 1 on a length of 1, the lower surface slides with speed 1 */

static struct ts_film slider(int n, double b1, double b2)
{
	struct ts_film f = film_open(n, 1, 1, 1);

	f.slip[0] = b1;
	f.slip[1] = b2;
	film_fill(&f, f.velocity[0][0], 1);
	for (int i = 0; i < n; i++)
		f.gap[i] = 2 - ts_film_centre(&f, 0, i);
	return f;
}

/* Antiderivatives by h of couette/poiseuille and 1/poiseuille; dp/dx = 12 (couette - q)/poiseuille. Both surfaces slip
 * by b: 1/(2 h (h + 6 b)) and 1/(h^2 (h + 6 b)). The lower surface only: 1/(2 h (h + 4 b)) and (h + b)/(h^3 (h + 4 b)). */
static void integrals(double h, double b, bool both, double out[2])
{
	double a = both ? 6 * b : 4 * b, logarithm = log(h / (h + a));

	out[0] = logarithm / (2 * a);
	if (both)
		out[1] = -1 / (a * h) - logarithm / (a * a);
	else
		out[1] = -3 / (64 * b * b) * logarithm - 3 / (16 * b * h) - 1 / (8 * h * h);
}

static void compare_slider(double b, bool both)
{
	double low[2], high[2], now[2], q;
	struct ts_film f = slider(50, b, both ? b : 0);
	struct ts_film_measures m = film_solve(&f);

	integrals(1, b, both, low);
	integrals(2, b, both, high);
	q = (high[0] - low[0]) / (high[1] - low[1]);
	DECK_NEAR(m.outflow[0][1], q, 1e-12);
	for (int i = 0; i < 50; i++) {
		integrals(f.gap[i], b, both, now);
		DECK_NEAR(f.p[i], 12 * (high[0] - now[0] - q * (high[1] - now[1])), 1e-12);
	}
	DECK_NEAR(m.shear[0][0] + m.shear[1][0] + m.pressure_force[0], 0, 1e-12);
	ts_film_release(&f);
}

START_TEST(slider_is_exact)
{
	struct ts_film f = slider(3200, 1e-9, 1e-9);

	for (int k = 0; k < 3; k++) {
		double b = (const double[]){ 0.2, 1, 20 }[k];

		compare_slider(b, false);
		compare_slider(b, true);
	}
	DECK_NEAR(film_solve(&f).load, 0.158883, 1e-6); /* the limit without slip */
	ts_film_release(&f);
}
END_TEST

/* ---- steps: p at the step = 12 (couette(h1) - couette(h2))/(poiseuille(h1)/L1 + poiseuille(h2)/L2) */

START_TEST(rayleigh_step)
{
	enum { N = 10, STEP = 7 };
	const double b1 = 0.3, b2 = 0.7, length = STEP / (double)N, deep = 1.8;
	double top = 12 * (couette(deep, b1, b2) - couette(1, b1, b2)) /
		     (poiseuille(deep, b1, b2) / length + poiseuille(1, b1, b2) / (1 - length));
	struct ts_film f = slider(N, b1, b2);
	struct ts_film_measures m;

	f.shape = TS_FILM_STEPPED;
	for (int i = 0; i < N; i++)
		f.gap[i] = i < STEP ? deep : 1;
	m = film_solve(&f);
	for (int i = 0; i < N; i++) {
		double x = ts_film_centre(&f, 0, i);

		DECK_NEAR(f.p[i], x < length ? top * x / length : top * (1 - x) / (1 - length), 1e-13);
	}
	DECK_NEAR(m.load, top / 2, 1e-13);
	DECK_NEAR(m.pressure_force[0], top * (deep - 1), 1e-13);
	DECK_NEAR(m.shear[0][0],
		  -length / (deep + b1 + b2) - (1 - length) / (1 + b1 + b2) -
			  top * (couette(deep, b1, b2) - couette(1, b1, b2)),
		  1e-13);
	DECK_NEAR(m.shear[0][0] + m.shear[1][0] + m.pressure_force[0], 0, 1e-13);
	ts_film_release(&f);
}
END_TEST

/* Squeezed strip: W = eta V B^3 L/poiseuille. */
START_TEST(squeezed_strip)
{
	double step[3], error[3];

	for (int level = 0; level < 3; level++) {
		int n = 16 << level;
		struct ts_film f = film_open(n, 1, 1, 0.7);

		film_fill(&f, f.rate, -1);
		f.slip[0] = 0.1;
		f.slip[1] = 0.4;
		step[level] = 1.0 / n;
		error[level] = fabs(film_solve(&f).load * poiseuille(1, 0.1, 0.4) / 0.7 - 1);
		ts_film_release(&f);
	}
	ck_assert(error[2] < 1e-3);
	DECK_NEAR(deck_order(step, error, 3), 2, 0.01);
}
END_TEST

/* ---- velocity */

static double profile_at(const struct ts_film_point *point, double s, int axis)
{
	double u[3];

	ts_film_profile(point, s, (const double[]){ 0, 0 }, 0, u);
	return u[axis];
}

/* du/dz at s = 0 or 1, exact for a parabola. */
static double shear_at(const struct ts_film_point *point, bool upper, int axis)
{
	double a = profile_at(point, upper, axis), b = profile_at(point, 0.5, axis),
	       c = profile_at(point, !upper, axis);

	return (upper ? 1 : -1) * (3 * a - 4 * b + c) / point->gap;
}

/* U1 + b1 du/dz and U2 - b2 du/dz at the surfaces, d2u/dz2 = grad p, the mean is q/h, and the shear forces are those of
 * the profile. */
START_TEST(slip_at_the_surfaces)
{
	enum { N = 400 };
	const double b1 = 0.3, b2 = 0.8;
	struct ts_film f = slider(N, b1, b2);
	struct ts_film_measures m;
	double forces[2] = { 0, 0 };

	film_fill(&f, f.velocity[1][0], -0.25);
	m = film_solve(&f);
	for (int i = 0; i < N; i++) {
		struct ts_film_point point;
		double h, slope, q = m.outflow[0][1];

		ts_film_sample(&f, (const double[]){ (i + 0.5) / N, 0.5 }, &point);
		h = point.gap;
		slope = 12 * (couette(h, b1, b2) - 0.25 * couette(h, b2, b1) - q) / poiseuille(h, b1, b2);
		DECK_NEAR(point.mean[0] * h, q, 1e-12);
		DECK_NEAR(profile_at(&point, 0, 0), 1 + b1 * shear_at(&point, false, 0), 1e-12);
		DECK_NEAR(profile_at(&point, 1, 0), -0.25 - b2 * shear_at(&point, true, 0), 1e-12);
		DECK_NEAR((shear_at(&point, true, 0) - shear_at(&point, false, 0)) / h, slope, 1e-11);
		forces[0] += shear_at(&point, false, 0) / N;
		forces[1] -= shear_at(&point, true, 0) / N;
	}
	DECK_NEAR(m.shear[0][0], forces[0], 1e-5);
	DECK_NEAR(m.shear[1][0], forces[1], 1e-5);
	ck_assert(fabs(forces[0]) > 0.1);
	ts_film_release(&f);
}
END_TEST

/* Between inclined planes: no flow out of small boxes in the fluid; none through the surfaces. */
START_TEST(velocity_has_no_divergence)
{
	struct ts_film f = film_open(20, 12, 1, 1);
	const double d = 1e-5;

	f.slip[0] = 0.2;
	f.slip[1] = 0.05;
	f.edge[1][0] = f.edge[1][1] = TS_FILM_PRESSURE;
	film_fill(&f, f.velocity[0][0], 1);
	film_fill(&f, f.velocity[1][0], -0.3);
	film_fill(&f, f.velocity[1][1], 0.4);
	film_fill(&f, f.rate, -0.2);
	for (int j = 0; j < 12; j++)
		for (int i = 0; i < 20; i++)
			f.gap[ts_film_at(&f, i, j)] =
				0.3 - 0.2 * ts_film_centre(&f, 0, i) + 0.1 * ts_film_centre(&f, 1, j);
	film_solve(&f);
	for (int k = 0; k < 50; k++) { /* inside of a cell, and of the rectangle of four centres */
		double x = (k % 18 + 1 + 0.2) / 20, y = (k % 10 + 1 + 0.3) / 12, h = 0.3 - 0.2 * x + 0.1 * y;
		double z = film_lower_surface(x, y) + h * (k + 0.5) / 50, divergence = 0, u[3];

		for (int axis = 0; axis < 3; axis++) {
			double low[3], high[3];

			film_velocity_at(&f, x - (axis == 0) * d, y - (axis == 1) * d, z - (axis == 2) * d,
					 low);
			film_velocity_at(&f, x + (axis == 0) * d, y + (axis == 1) * d, z + (axis == 2) * d,
					 high);
			divergence += (high[axis] - low[axis]) / (2 * d);
		}
		DECK_NEAR(divergence, 0, 1e-6);
		film_velocity_at(&f, x, y, film_lower_surface(x, y), u);
		DECK_NEAR(u[2], 0.05 + 0.2 * u[0] - 0.1 * u[1], 1e-12);
		film_velocity_at(&f, x, y, film_lower_surface(x, y) + h, u);
		DECK_NEAR(u[2], 0.05 - 0.2 + (0.2 - 0.2) * u[0] + (-0.1 + 0.1) * u[1], 1e-12);
	}
	ts_film_release(&f);
}
END_TEST

/* ---- cavitation: the fluid is conserved also over cavities, and coarse grids have the slip lengths */

START_TEST(slip_in_a_bearing)
{
	double number[2], attitude;

	for (int k = 0; k < 2; k++) {
		struct ts_film f = film_bearing(96, 24, 0.6, 1, true, TS_FILM_JFO);
		struct ts_film_measures m;

		f.slip[0] = f.slip[1] = k ? 0.1 : 0;
		m = film_solve(&f);
		ck_assert(f.report.cavitated > 100 && f.report.solves < 40);
		DECK_NEAR(film_outflow(&m), 0, 1e-12);
		film_sommerfeld(&f, &number[k], &attitude);
		ts_film_release(&f);
	}
	ck_assert(number[1] > 1.2 * number[0]); /* less load */
}
END_TEST

/* ---- wrong input */

static void refused(double b1, double b2, bool polar, const char *text)
{
	struct ts_film f = slider(6, b1, b2);
	struct ts_error error = { .status = TS_OK };

	f.polar = polar;
	ck_assert_int_eq(ts_film_solve(&f, &error), TS_RANGE);
	ck_assert_msg(strstr(error.message, text) != NULL, "%s", error.message);
	ts_film_release(&f);
}

START_TEST(refusals)
{
	refused(-1, 0, false, "slip length -1, expected >= 0");
	refused(0, NAN, false, "slip length");
	refused(INFINITY, 0, false, "slip length inf");
	refused(0, 0.1, true, "slip on a polar grid is not supported");
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("film_slip");
	TCase *tcase = tcase_create("film_slip");

	tcase_set_timeout(tcase, 100);
	tcase_add_test(tcase, slider_is_exact);
	tcase_add_test(tcase, rayleigh_step);
	tcase_add_test(tcase, squeezed_strip);
	tcase_add_test(tcase, slip_at_the_surfaces);
	tcase_add_test(tcase, velocity_has_no_divergence);
	tcase_add_test(tcase, slip_in_a_bearing);
	tcase_add_test(tcase, refusals);
	suite_add_tcase(suite, tcase);
	return deck_main(suite);
}
