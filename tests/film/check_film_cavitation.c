/* Cavitation: journal bearings against exact limits and published tables, films of one dimension whose rupture and
 * reformation are known, conservation of volume. */
#include "films.h"

/* ---- long bearing, of one dimension */

static struct ts_film_measures long_bearing(int n, double e, enum ts_film_cavitation cavitation,
					    double *number, double *attitude)
{
	struct ts_film f = film_bearing(n, 1, e, 1, true, cavitation);
	struct ts_film_measures m;

	f.edge[1][1] = TS_FILM_NO_FLOW;
	m = film_solve(&f);
	film_sommerfeld(&f, number, attitude);
	m.volume = f.report.imbalance;
	ts_film_release(&f);
	return m;
}

/* A. Sommerfeld (1904): load perpendicular to the eccentricity, S = (2 + e^2) sqrt(1 - e^2)/(12 pi^2 e); friction of
 * the sliding surface 4 pi (1 + 2 e^2)/((2 + e^2) sqrt(1 - e^2)). Half of the film (L. Guembel 1914): with
 * W = 6 e sqrt(pi^2 - e^2 (pi^2 - 4))/((2 + e^2)(1 - e^2)), tan(attitude) = pi sqrt(1 - e^2)/(2 e). */
START_TEST(long_bearing_sommerfeld)
{
	for (double e = 0.1; e < 0.95; e += 0.2) {
		double s, angle, root = sqrt(1 - e * e), step[3], error[3];
		struct ts_film_measures m;

		for (int level = 0; level < 3; level++) {
			m = long_bearing(100 << (2 * level), e, TS_FILM_NONE, &s, &angle);
			step[level] = pow(0.25, level);
			error[level] =
				fabs(-m.shear[0][0] / (4 * PI * (1 + 2 * e * e) / ((2 + e * e) * root)) - 1);
		}
		DECK_NEAR(s * 12 * PI * PI * e / ((2 + e * e) * root), 1, 1e-5);
		DECK_NEAR(angle, 90, 1e-6);
		DECK_NEAR(-m.shear[0][0] / (4 * PI * (1 + 2 * e * e) / ((2 + e * e) * root)), 1, 1e-5);
		ck_assert(error[1] < 1e-9 || fabs(deck_order(step, error, 3) - 2) < 0.2);
		m = long_bearing(1600, e, TS_FILM_HALF, &s, &angle);
		DECK_NEAR(1 / (PI * s),
			  6 * e * sqrt(PI * PI - e * e * (PI * PI - 4)) / ((2 + e * e) * (1 - e * e)),
			  1e-4 / s);
		DECK_NEAR(tan(angle * PI / 180), PI * root / (2 * e), 1e-3 * PI * root / (2 * e));
		ck_assert(m.volume > 0); /* is not conserved, and says so */
	}
}
END_TEST

/* Integral of (h - hr)/h^3 from a to b by Gauss' rule of three points. */
typedef double gap_fn(double x, double parameter);

static double rise(gap_fn *gap, double parameter, double hr, double a, double b)
{
	enum { PARTS = 400 };
	double d = (b - a) / PARTS, sum = 0;

	for (int k = 0; k < PARTS; k++)
		for (int g = -1; g <= 1; g++) {
			double h = gap(a + (k + 0.5 + g * sqrt(0.15)) * d, parameter);

			sum += d * (g ? 5.0 : 8.0) / 18 * (h - hr) / (h * h * h);
		}
	return sum;
}

/* The point between a and b where the pressure that starts from `start` at x = from, with the flow of the gap at this
 * point, is 0: dp/dx = 6 (h - hr)/h^3. */
static double rupture(gap_fn *gap, double parameter, double from, double start, double a, double b)
{
	for (int k = 0; k < 100; k++) {
		double middle = (a + b) / 2;

		if (start + 6 * rise(gap, parameter, gap(middle, parameter), from, middle) > 0)
			a = middle;
		else
			b = middle;
	}
	return (a + b) / 2;
}

static double bearing_gap(double x, double e)
{
	return 1 + e * cos(x);
}

/* The film begins at the widest gap and ends with p = dp/dx = 0 at PI + a, the same for reynolds and jfo. */
START_TEST(long_bearing_reynolds)
{
	for (double e = 0.1; e < 0.95; e += 0.2) {
		double end = rupture(bearing_gap, e, 0, 0, PI, 2 * PI), load[2], peak = 0;
		double hr = bearing_gap(end, e);

		for (int jfo = 0; jfo < 2; jfo++) {
			struct ts_film f =
				film_bearing(1000, 1, e, 1, true, jfo ? TS_FILM_JFO : TS_FILM_REYNOLDS);
			struct ts_film_measures m;

			f.edge[1][1] = TS_FILM_NO_FLOW;
			f.edge_void[0][0] = 0;
			m = film_solve(&f);
			load[jfo] = m.load;
			peak = m.p_max;
			DECK_NEAR(m.outflow[0][0], -hr / 2, 1e-4); /* entering flow is that at the rupture */
			for (int i = 0; i < 1000; i += 7) {
				double x = ts_film_centre(&f, 0, i);
				double p = x < end ? 6 * rise(bearing_gap, e, hr, 0, x) : 0;

				DECK_NEAR(f.p[i], p, 3e-4 * peak);
				if (jfo && x > end + 0.02 && x < 2 * PI - 0.02)
					DECK_NEAR(1 - f.empty[i], hr / f.gap[i], 0.01 * hr / f.gap[i]);
				if (jfo && x > end + 0.02 && x < 2 * PI - 0.02)
					ck_assert(f.p[i] == 0);
			}
			if (jfo)
				DECK_NEAR(film_outflow(&m), 0, 1e-12);
			ts_film_release(&f);
		}
		DECK_NEAR(load[0], load[1], 1e-4 * load[0]);
	}
}
END_TEST

/* ---- jfo of one dimension with rupture and reformation: two waves, higher pressure at the outlet */

static double waves(double x, double amplitude)
{
	return 1 + amplitude * cos(2 * PI * x);
}

/* Film from 0 to the rupture; cavity with (1 - theta) h = h_r; full film again from the reformation to the outlet at
 * x = 1.5, in which the same flow h_r/2 makes the pressure rise from 0 to that of the outlet. */
static double reformation(double amplitude, double hr, double outlet, double a, double b)
{
	for (int k = 0; k < 100; k++) {
		double middle = (a + b) / 2;

		if (6 * rise(waves, amplitude, hr, middle, 1.5) > outlet)
			a = middle;
		else
			b = middle;
	}
	return (a + b) / 2;
}

START_TEST(rupture_and_reformation)
{
	const double amplitude = 0.5, outlet = 0.25;
	double first = rupture(waves, amplitude, 0, 0.3, 0.5, 1), hr = waves(first, amplitude);
	double second = reformation(amplitude, hr, outlet, first, 1.3), step[3], error[3];

	ck_assert(first > 0.55 && first < 0.75 && second > 0.9 && second < 1);
	for (int level = 0; level < 3; level++) {
		int n = 150 << (2 * level);
		struct ts_film f = film_open(n, 1, 1.5, 1);
		struct ts_film_measures m;
		double width = 1.5 / n, void_error = 0;

		f.cavitation = TS_FILM_JFO;
		f.edge_pressure[0][0] = 0.3;
		f.edge_pressure[0][1] = outlet;
		film_fill(&f, f.velocity[0][0], 1);
		for (int i = 0; i < n; i++)
			f.gap[i] = waves(ts_film_centre(&f, 0, i), amplitude);
		m = film_solve(&f);
		step[level] = width;
		error[level] = 0;
		for (int i = 0; i < n; i++) {
			double x = ts_film_centre(&f, 0, i), p = 0;

			if (x < first)
				p = 0.3 + 6 * rise(waves, amplitude, hr, 0, x);
			else if (x > second)
				p = 6 * rise(waves, amplitude, hr, second, x);
			else if (x > first + 2 * width && x < second - 2 * width)
				void_error = fmax(void_error, fabs(1 - f.empty[i] - hr / f.gap[i]));
			error[level] += fabs(f.p[i] - p) * width;
		}
		ck_assert(f.report.cavitated > 0 && void_error < 3 * width);
		DECK_NEAR(m.outflow[0][1], hr / 2, 0.1 * width);
		DECK_NEAR(film_outflow(&m), 0, 1e-13);
		if (level == 2)
			DECK_NEAR((double)f.report.cavitated, (second - first) / width, 3);
		ts_film_release(&f);
	}
	ck_assert(error[2] < 1e-3 && deck_order(step, error, 3) > 0.9);
}
END_TEST

/* Fluid that fills the gap only partly enters a parallel gap: it stays so, at the pressure of the cavity. If it fills
 * 0.6 of a gap that narrows from 2 to 1, the film is full from h = 1.5 on: p = 6 (1/h - 0.6/h^2 - 0.4), which is 0
 * there and at the outlet. */
START_TEST(starved_inlet)
{
	struct ts_film f = film_open(400, 1, 1, 1);

	f.cavitation = TS_FILM_JFO;
	f.edge_void[0][0] = 0.4;
	film_fill(&f, f.velocity[0][0], 1);
	film_solve(&f);
	for (int i = 0; i < 400; i++) {
		DECK_NEAR(f.empty[i], 0.4, 1e-13);
		ck_assert(f.p[i] == 0);
	}
	for (int i = 0; i < 400; i++)
		f.gap[i] = 2 - ts_film_centre(&f, 0, i);
	film_solve(&f);
	for (int i = 0; i < 400; i++) {
		double h = f.gap[i];

		DECK_NEAR(f.p[i], h < 1.5 ? 6 * (1 / h - 0.6 / (h * h) - 0.4) : 0, 1e-3);
		if (h > 1.51)
			DECK_NEAR(1 - f.empty[i], 1.2 / h, 2e-3);
		ck_assert(h > 1.49 || f.empty[i] == 0);
	}
	ts_film_release(&f);
}
END_TEST

/* A gap that opens and closes: a cavity forms, the fluid returns; volume is conserved at each step. */
START_TEST(squeeze_in_time)
{
	enum { N = 24, STEPS = 60 };
	struct ts_film f = film_open(N, N, 1, 1);
	double volume = 1;
	size_t most = 0;

	f.cavitation = TS_FILM_JFO;
	f.edge[1][0] = f.edge[1][1] = TS_FILM_PRESSURE;
	f.time_step = 2.0 / STEPS;
	film_fill(&f, f.content, 1);
	for (int k = 1; k <= STEPS; k++) {
		struct ts_film_measures m;

		film_fill(&f, f.gap, 1 + 0.8 * sin(2 * PI * k / STEPS));
		m = film_solve(&f);
		volume -= film_outflow(&m) * f.time_step;
		DECK_NEAR(m.volume, volume, 1e-12);
		ck_assert(m.load >= 0);
		most = f.report.cavitated > most ? f.report.cavitated : most;
		ts_film_keep_content(&f);
	}
	ck_assert(most == N * N);
	ck_assert(volume > 0.2 && volume < 0.99);
	ts_film_release(&f);
}
END_TEST

/* ---- bearings of finite length */

/* A. A. Raimondi & J. Boyd, Trans. ASLE 1 (1958) 194, table for bearings of 360 degrees: length/diameter, e,
 * Sommerfeld number, attitude. The numbers have errors of about 2 %. */
START_TEST(finite_bearings)
{
	static const double table[][4] = {
		{ 1, 0.2, 0.631, 74.02 },   { 1, 0.4, 0.264, 63.10 },	{ 1, 0.6, 0.121, 50.58 },
		{ 1, 0.8, 0.0446, 36.24 },  { 1, 0.9, 0.0188, 26.45 },	{ 0.5, 0.2, 2.03, 74.94 },
		{ 0.5, 0.4, 0.779, 61.45 }, { 0.5, 0.6, 0.319, 48.14 }, { 0.5, 0.8, 0.0923, 33.31 },
	};

	for (size_t k = 0; k < DECK_LENGTH(table); k++) {
		struct ts_film f = film_bearing(144, 24, table[k][1], table[k][0], true, TS_FILM_REYNOLDS);
		double s, angle;

		film_solve(&f);
		film_sommerfeld(&f, &s, &angle);
		DECK_NEAR(s, table[k][2], 0.03 * table[k][2]);
		DECK_NEAR(angle, table[k][3], 2);
		ts_film_release(&f);
	}
}
END_TEST

/* G. B. DuBois & F. W. Ocvirk, NACA report 1157 (1953), half of the film: S (L/D)^2 = (1 - e^2)^2/(pi e sqrt(pi^2 (1 -
 * e^2) + 16 e^2)) for L/D -> 0; the differences decrease as (L/D)^2. */
START_TEST(short_bearing)
{
	for (double e = 0.2; e < 0.7; e += 0.2) {
		double limit = pow(1 - e * e, 2) / (PI * e * sqrt(PI * PI * (1 - e * e) + 16 * e * e));
		double difference[2];

		for (int k = 0; k < 2; k++) {
			double s, angle, ratio = k ? 0.05 : 0.1;
			struct ts_film f = film_bearing(256, 48, e, ratio, false, TS_FILM_HALF);

			film_solve(&f);
			film_sommerfeld(&f, &s, &angle);
			difference[k] = s * ratio * ratio / limit - 1;
			DECK_NEAR(tan(angle * PI / 180) / (PI * sqrt(1 - e * e) / (4 * e)), 1, 0.02);
			ts_film_release(&f);
		}
		DECK_NEAR(difference[0], 0, 0.02);
		DECK_NEAR(difference[0] / difference[1], 4, 0.6);
	}
}
END_TEST

/* Reynolds: p >= pc, no flow into the cavity from nowhere but at its end; jfo conserves volume over all cells, and its
 * film is not longer. Pressures above pc everywhere: all conditions are the same film. */
START_TEST(conditions_compared)
{
	double load[4];

	for (int c = TS_FILM_NONE; c <= TS_FILM_JFO; c++) {
		struct ts_film f = film_bearing(96, 16, 0.6, 1, true, (enum ts_film_cavitation)c);
		struct ts_film_measures m = film_solve(&f);

		load[c] = m.load;
		ck_assert((f.report.cavitated > 0) == (c != TS_FILM_NONE));
		for (size_t k = 0; k < ts_film_cells(&f); k++)
			ck_assert(c == TS_FILM_NONE || f.p[k] >= -1e-12);
		if (c != TS_FILM_HALF) /* what leaves is what the cavity makes */
			DECK_NEAR(film_outflow(&m), f.report.imbalance, 1e-12);
		ck_assert((f.report.imbalance > 0.01) == (c == TS_FILM_HALF || c == TS_FILM_REYNOLDS));
		f.edge_pressure[0][0] = f.edge_pressure[0][1] = f.edge_pressure[1][1] = 10;
		m = film_solve(&f);
		ck_assert(f.report.cavitated == 0 && f.report.imbalance < 1e-11);
		DECK_NEAR(m.load - 10 * 2 * PI, 0, 1e-9);
		ts_film_release(&f);
	}
	DECK_NEAR(load[TS_FILM_NONE], 0, 1e-10);
	ck_assert(load[TS_FILM_HALF] > 1 && load[TS_FILM_REYNOLDS] > load[TS_FILM_HALF]);
	DECK_NEAR(load[TS_FILM_JFO], load[TS_FILM_REYNOLDS], 0.01 * load[TS_FILM_REYNOLDS]);
}
END_TEST

/* Gaps that vary by a factor of 55 or 3000 from cell to cell: Newton's method converges, volume is conserved. */
START_TEST(rough_gap)
{
	for (int variant = 0; variant < 4; variant++) {
		struct ts_film f = film_open(40, 40, 1, 1);
		struct ts_error error = { .status = TS_OK };
		struct ts_film_measures m;

		f.cavitation = TS_FILM_JFO;
		f.shape = variant & 1 ? TS_FILM_STEPPED : TS_FILM_LINEAR;
		f.edge[1][0] = f.edge[1][1] = TS_FILM_PERIODIC;
		film_fill(&f, f.velocity[0][0], 1);
		film_fill(&f, f.velocity[0][1], 0.3);
		for (int c = 0; c < 1600; c++)
			f.gap[c] =
				exp((variant & 2 ? 8 : 4) * fmod(fabs(sin(c * 12.9898) * 43758.5453), 1) - 2);
		ck_assert_msg(ts_film_solve(&f, &error) == TS_OK, "%s", error.message);
		ts_film_measure(&f, &m);
		ck_assert(f.report.balance < 1e-9 * f.report.throughput);
		DECK_NEAR(film_outflow(&m), 0, 1e-8 * f.report.throughput * 40);
		for (int c = 0; c < 1600; c++) {
			ck_assert(f.p[c] >= 0 && f.empty[c] >= 0 && f.empty[c] < 1);
			ck_assert(f.p[c] == 0 || f.empty[c] == 0);
		}
		ts_film_release(&f);
	}
}
END_TEST

START_TEST(refusals)
{
	struct ts_film f = film_bearing(12, 2, 0.6, 1, true, TS_FILM_JFO);
	struct ts_error error = { .status = TS_OK };

	film_fill(&f, f.rate, 1);
	ck_assert_int_eq(ts_film_solve(&f, &error), TS_STATE);
	ck_assert_msg(strstr(error.message, "cavitation jfo then needs a time step"), "%s", error.message);
	ts_error_clear(&error);
	film_fill(&f, f.rate, 0);
	f.edge_void[0][0] = 1;
	ck_assert_int_eq(ts_film_solve(&f, &error), TS_RANGE);
	ck_assert_msg(strstr(error.message, "void fraction given at the lower edge of axis 1"), "%s",
		      error.message);
	ts_error_clear(&error);
	f.edge_void[0][0] = 0;
	f.time_step = 0.1;
	film_fill(&f, f.content, -1);
	ck_assert_int_eq(ts_film_solve(&f, &error), TS_RANGE);
	ck_assert_msg(strstr(error.message, "the content is -1"), "%s", error.message);
	ts_film_release(&f);
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("film_cavitation");
	TCase *tcase = tcase_create("film_cavitation");

	tcase_set_timeout(tcase, 100);
	tcase_add_test(tcase, long_bearing_sommerfeld);
	tcase_add_test(tcase, long_bearing_reynolds);
	tcase_add_test(tcase, rupture_and_reformation);
	tcase_add_test(tcase, starved_inlet);
	tcase_add_test(tcase, squeeze_in_time);
	tcase_add_test(tcase, finite_bearings);
	tcase_add_test(tcase, short_bearing);
	tcase_add_test(tcase, conditions_compared);
	tcase_add_test(tcase, rough_gap);
	tcase_add_test(tcase, refusals);
	suite_add_tcase(suite, tcase);
	return deck_main(suite);
}
