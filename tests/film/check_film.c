/* The Reynolds equation without cavitation: exact solutions, orders of convergence, conservation, wrong input. */
#include "films.h"

/* ---- plane slider: h from K to 1 on a length of 1, the lower surface slides with speed 1 */

static struct ts_film slider(int n, double ratio)
{
	struct ts_film f = film_open(n, 1, 1, 1);

	film_fill(&f, f.velocity[0][0], 1);
	for (int i = 0; i < n; i++)
		f.gap[i] = ratio - (ratio - 1) * ts_film_centre(&f, 0, i);
	return f;
}

/* p = 6 (K - h)(h - 1)/(h^2 (K^2 - 1)), W = 6/(K-1)^2 [ln K - 2(K-1)/(K+1)], F = [4 ln K - 6(K-1)/(K+1)]/(K-1),
 * p_max = 3/2 (K-1)/(K (K+1)) at h = 2K/(K+1). */
static void compare_slider(double ratio)
{
	double k = ratio, load = 6 / ((k - 1) * (k - 1)) * (log(k) - 2 * (k - 1) / (k + 1));
	double friction = (4 * log(k) - 6 * (k - 1) / (k + 1)) / (k - 1), step[3], error[3];

	for (int level = 0; level < 3; level++) {
		int n = 50 << (3 * level);
		struct ts_film f = slider(n, ratio);
		struct ts_film_measures m = film_solve(&f);

		for (int i = 0; i < n; i++) {
			double h = f.gap[i];

			DECK_NEAR(f.p[i], 6 * (k - h) * (h - 1) / (h * h * (k * k - 1)), 1e-13);
		}
		step[level] = 1.0 / n;
		error[level] = fabs(m.load - load);
		if (level == 2) {
			DECK_NEAR(m.load, load, 1e-6 * load);
			DECK_NEAR(m.shear[0][0], -friction, 1e-6 * friction);
			DECK_NEAR(m.p_max, 1.5 * (k - 1) / (k * (k + 1)), 1e-6 * m.p_max);
			DECK_NEAR(m.p_max_at[0], k / (k + 1), 1e-6);
			DECK_NEAR(m.outflow[0][1], k / (k + 1), 1e-13);
			DECK_NEAR(m.least_gap, 1, 2 / (double)n);
		}
		/* both surfaces and the edges are in equilibrium */
		DECK_NEAR(m.shear[0][0] + m.shear[1][0] + m.pressure_force[0], 0, 1e-12);
		ts_film_release(&f);
	}
	DECK_NEAR(deck_order(step, error, 3), 2, 0.02);
}

START_TEST(slider_is_exact)
{
	struct ts_film f = slider(3200, 2);
	struct ts_film_measures m = film_solve(&f);

	compare_slider(1.5);
	compare_slider(2);
	compare_slider(2.1887);
	compare_slider(3);
	DECK_NEAR(m.load, 0.158883, 1e-6);
	DECK_NEAR(m.centre[0], 0.568688, 1e-6);
	DECK_NEAR(m.centre[1], 0.5, 1e-14);
	film_fill(&f, f.velocity[0][0], -1);
	m = film_solve(&f);
	DECK_NEAR(m.load, -0.158883, 1e-6);
	ck_assert(f.report.driven && f.report.solves == 1 && f.report.cavitated == 0);
	ts_film_release(&f);
}
END_TEST

/* A slider that moves over a plane at rest: the gap at a fixed point changes by -U dh/dx; both the sliding of the
 * upper surface and this rate give the film of the slider at rest. */
START_TEST(moving_slider_is_the_same)
{
	struct ts_film f = slider(200, 2), moving = slider(200, 2);
	struct ts_film_measures rest = film_solve(&f), m;

	film_fill(&moving, moving.velocity[0][0], 0);
	film_fill(&moving, moving.velocity[1][0], -1);
	film_fill(&moving, moving.rate, -1); /* -U2 dh/dx = -(-1)(-1) */
	m = film_solve(&moving);
	DECK_NEAR(m.load, rest.load, 1e-4 * rest.load);
	DECK_NEAR(m.shear[0][0], rest.shear[0][0], 1e-4);
	ts_film_release(&f);
	ts_film_release(&moving);
}
END_TEST

/* ---- Rayleigh step: p at the step = 6 U (h1 - h2)/(h1^3/L1 + h2^3/L2), linear on both sides */

START_TEST(rayleigh_step)
{
	enum { N = 10, STEP = 7 };
	double low = STEP / (double)N, top = 6 * (1.8 - 1) / (1.8 * 1.8 * 1.8 / low + 1 / (1 - low));
	struct ts_film f = film_open(N, 1, 1, 1);
	struct ts_film_measures m;

	f.shape = TS_FILM_STEPPED;
	film_fill(&f, f.velocity[0][0], 1);
	for (int i = 0; i < STEP; i++)
		f.gap[i] = 1.8;
	f.face[0][2] = 0.25; /* not uniform */
	m = film_solve(&f);
	for (int i = 0; i < N; i++) {
		double x = ts_film_centre(&f, 0, i);

		DECK_NEAR(f.p[i], x < low ? top * x / low : top * (1 - x) / (1 - low), 1e-14);
	}
	DECK_NEAR(m.load, top / 2, 1e-14);
	DECK_NEAR(m.pressure_force[0], top * 0.8, 1e-14); /* on the face of the step */
	DECK_NEAR(m.shear[0][0], -(low / 1.8 + 1 - low) - (1.8 - 1) * top / 2, 1e-14);
	DECK_NEAR(m.shear[0][0] + m.shear[1][0] + m.pressure_force[0], 0, 1e-14);
	ts_film_release(&f);
}
END_TEST

/* ---- squeeze: V = -dh/dt */

static double rectangle_load(double a, double b)
{
	double sum = 0;

	for (int m = 1; m < 400; m += 2)
		for (int n = 1; n < 400; n += 2)
			sum += 1 / ((double)m * m * n * n * (m * m / (a * a) + n * n / (b * b)));
	return 12 * 64 * a * b / pow(PI, 6) * sum;
}

START_TEST(squeezed_strip_and_rectangle)
{
	double step[3], strip[3], rectangle[3], exact = rectangle_load(1, 0.7);

	for (int level = 0; level < 3; level++) {
		int n = 16 << level;
		struct ts_film f = film_open(n, n, 1, 0.7);

		film_fill(&f, f.rate, -1);
		step[level] = 1.0 / n;
		strip[level] = fabs(film_solve(&f).load / 0.7 - 1);
		f.edge[1][0] = f.edge[1][1] = TS_FILM_PRESSURE;
		rectangle[level] = fabs(film_solve(&f).load - exact);
		ts_film_release(&f);
	}
	ck_assert(strip[2] < 1e-3 && rectangle[2] < 1e-3 * exact);
	DECK_NEAR(deck_order(step, strip, 3), 2, 0.01);
	DECK_NEAR(deck_order(step, rectangle, 3), 2, 0.05);
}
END_TEST

static struct ts_film disc(int n, double gap)
{
	struct ts_film f = film_open(n, 1, 1, 2 * PI);

	f.polar = true;
	f.edge[0][0] = TS_FILM_NO_FLOW;
	film_fill(&f, f.rate, -1);
	film_fill(&f, f.gap, gap);
	return f;
}

/* p = 3 V (1 - r^2)/h^3, W = 3 pi V/(2 h^3) */
START_TEST(squeezed_disc)
{
	double step[3], error[3];

	for (int level = 0; level < 3; level++) {
		int n = 32 << (2 * level);
		struct ts_film f = disc(n, 0.5);
		struct ts_film_measures m = film_solve(&f);

		step[level] = 1.0 / n;
		error[level] = fabs(m.load - 12 * PI);
		DECK_NEAR(m.outflow[0][1], PI, 1e-13);
		ts_film_release(&f);
	}
	ck_assert(error[2] < 1e-5 * 12 * PI);
	DECK_NEAR(deck_order(step, error, 3), 2, 0.01);
}
END_TEST

/* dh/dt for a load, by Runge's method: t = 3 pi R^4/(4 W) (1/h2^2 - 1/h1^2) */
static double closing_speed(struct ts_film *f, double gap, double load)
{
	film_fill(f, f->gap, gap);
	return load / film_solve(f).load;
}

START_TEST(closing_time_of_a_disc)
{
	struct ts_film f = disc(400, 1);
	double gap = 1, load = 2.5, time = 3 * PI / (4 * load) * (1 / 0.09 - 1), dt = time / 2000;

	for (int k = 0; k < 2000; k++)
		gap -= dt * closing_speed(&f, gap - dt / 2 * closing_speed(&f, gap, load), load);
	DECK_NEAR(gap, 0.3, 1e-5);
	ts_film_release(&f);
}
END_TEST

/* A disc cut out of a Cartesian grid by cells with a given pressure; of first order, because of the stairs. */
START_TEST(disc_of_square_cells)
{
	for (int n = 50; n <= 200; n *= 2) {
		struct ts_film f = film_open(n, n, 2.1, 2.1);

		film_fill(&f, f.rate, -1);
		for (int j = 0; j < n; j++)
			for (int i = 0; i < n; i++)
				if (hypot(ts_film_centre(&f, 0, i) - 1.05, ts_film_centre(&f, 1, j) - 1.05) >
				    1)
					f.kind[ts_film_at(&f, i, j)] = TS_FILM_GIVEN;
		DECK_NEAR(film_solve(&f).load, 1.5 * PI, 4.0 / n * 1.5 * PI);
		ts_film_release(&f);
	}
}
END_TEST

/* ---- flow in a film with parallel surfaces */

START_TEST(parallel_surfaces)
{
	struct ts_film f = film_open(7, 4, 2, 3);
	struct ts_film_measures m;

	film_fill(&f, f.gap, 0.5);
	m = film_solve(&f);
	ck_assert(!f.report.driven && m.load == 0 && isnan(m.centre[0]));
	f.edge_pressure[0][0] = f.edge_pressure[0][1] = 5; /* at rest under pressure */
	m = film_solve(&f);
	ck_assert(!f.report.driven);
	DECK_NEAR(m.load, 30, 1e-12);
	DECK_NEAR(m.outflow[0][0], 0, 1e-15);
	f.edge_pressure[0][0] = f.ambient = 5; /* Poiseuille: h^3/12 dp/L */
	f.edge_pressure[0][1] = 1;
	m = film_solve(&f);
	DECK_NEAR(m.outflow[0][1], 3 * 0.125 / 12 * 2, 1e-15);
	DECK_NEAR(m.outflow[0][0], -m.outflow[0][1], 1e-15);
	DECK_NEAR(m.load, -12, 1e-13);
	DECK_NEAR(m.shear[0][0], 0.25 * 4 * 3, 1e-13);
	DECK_NEAR(m.shear[1][0], 0.25 * 4 * 3, 1e-13);
	film_fill(&f, f.velocity[1][0], 2); /* and Couette */
	m = film_solve(&f);
	DECK_NEAR(m.outflow[0][1], 3 * 0.125 / 12 * 2 + 3 * 0.5, 1e-14);
	DECK_NEAR(m.shear[1][0], 3 - 24, 1e-13);
	DECK_NEAR(m.shear[0][0], 3 + 24, 1e-13);
	DECK_NEAR(m.torque[0], -1.5 * 27, 1e-12);
	DECK_NEAR(m.volume, 3, 1e-15);
	ts_film_release(&f);
}
END_TEST

/* A disc that turns over another at rest: viscous torque pi R^4/(2h), no pressure. */
START_TEST(turning_disc)
{
	struct ts_film f = film_open(100, 8, 1, 2 * PI);
	struct ts_film_measures m;

	f.polar = true;
	f.edge[0][0] = TS_FILM_NO_FLOW;
	f.edge[1][0] = f.edge[1][1] = TS_FILM_PERIODIC;
	film_fill(&f, f.gap, 0.25);
	for (int j = 0; j < 8; j++)
		for (int i = 0; i < 100; i++)
			f.velocity[1][1][ts_film_at(&f, i, j)] = ts_film_centre(&f, 0, i);
	m = film_solve(&f);
	DECK_NEAR(m.torque[1], -PI / 2 * 4, 1e-3);
	DECK_NEAR(m.torque[0] + m.torque[1], 0, 1e-13);
	DECK_NEAR(m.load, 0, 1e-13);
	DECK_NEAR(m.shear[0][0], 0, 1e-13);
	ts_film_release(&f);
}
END_TEST

/* A pressure difference between the ends of a sector: p is linear in the angle, the flow h^3/12 dp/angle ln(r2/r1). */
START_TEST(flow_along_the_angle)
{
	struct ts_film f = film_open(40, 9, 1, 0.7);
	struct ts_film_measures m;

	for (int i = 0; i <= 40; i++)
		f.face[0][i] = 1 + i / 40.;
	f.polar = true;
	f.edge[0][0] = f.edge[0][1] = TS_FILM_NO_FLOW;
	f.edge[1][0] = f.edge[1][1] = TS_FILM_PRESSURE;
	f.edge_pressure[1][0] = 3;
	film_fill(&f, f.gap, 0.5);
	m = film_solve(&f);
	for (int j = 0; j < 9; j++)
		DECK_NEAR(f.p[ts_film_at(&f, 17, j)], 3 * (1 - (j + 0.5) / 9), 1e-12);
	DECK_NEAR(m.outflow[1][1], 0.125 / 12 * 3 / 0.7 * log(2), 1e-5);
	DECK_NEAR(m.outflow[1][0], -m.outflow[1][1], 1e-14);
	DECK_NEAR(m.load, 1.5 * 0.7 * 1.5, 1e-12); /* area 0.7 (4 - 1)/2 */
	ts_film_release(&f);
}
END_TEST

/* ---- gaps that vary by 100 from cell to cell, h^3 by 1e6: the balance stays at round-off */

static double noise(int k)
{
	return fmod(fabs(sin(k * 12.9898) * 43758.5453), 1);
}

START_TEST(rough_gap_conserves)
{
	for (int variant = 0; variant < 8; variant++) {
		struct ts_film f = film_open(33, 20, 1, 1);
		struct ts_film_measures m;
		double made = 0;

		f.shape = variant & 1 ? TS_FILM_STEPPED : TS_FILM_LINEAR;
		if (variant & 2)
			f.edge[1][0] = f.edge[1][1] = TS_FILM_PERIODIC;
		if (variant & 4) {
			f.edge[0][0] = f.edge[0][1] = TS_FILM_PERIODIC;
			f.kind[200] = TS_FILM_GIVEN;
		}
		film_fill(&f, f.velocity[0][0], 1);
		film_fill(&f, f.velocity[1][1], -0.3);
		for (int c = 0; c < 33 * 20; c++) {
			f.gap[c] = pow(100, noise(c));
			f.rate[c] = noise(c + 1000) - 0.4;
			made -= f.kind[c] == TS_FILM_FLUID ? f.rate[c] / (33 * 20) : 0;
			if (c % 37 == 5)
				f.kind[c] = TS_FILM_SOLID, made += f.rate[c] / (33 * 20);
		}
		m = film_solve(&f);
		if (!(variant & 4))
			DECK_NEAR(film_outflow(&m), made, 1e-11);
		ck_assert(isfinite(m.load) && f.report.driven);
		ts_film_release(&f);
	}
}
END_TEST

/* ---- velocity inside the film */

/* Between curved surfaces h1 = lower(x, y), h2 = h1 + h. Velocities at s = 0 and 1 are those of the surfaces, the mean
 * is that of the flow, and the flow out of a small box in the fluid vanishes. */
START_TEST(velocity_has_no_divergence)
{
	struct ts_film f = film_open(20, 12, 1, 1);
	struct ts_film_point point;
	const double d = 1e-5, slope[2] = { 0.2, -0.1 };
	double u[3], sum = 0;

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
		double x = (k % 18 + 1 + 0.2) / 20, y = (k % 10 + 1 + 0.3) / 12;
		double z = film_lower_surface(x, y) + (0.3 - 0.2 * x + 0.1 * y) * noise(k), divergence = 0;

		for (int axis = 0; axis < 3; axis++) {
			double low[3], high[3];

			film_velocity_at(&f, x - (axis == 0) * d, y - (axis == 1) * d, z - (axis == 2) * d,
					 low);
			film_velocity_at(&f, x + (axis == 0) * d, y + (axis == 1) * d, z + (axis == 2) * d,
					 high);
			divergence += (high[axis] - low[axis]) / (2 * d);
		}
		DECK_NEAR(divergence, 0, 1e-6);
	}
	ts_film_sample(&f, (const double[]){ 0.01, 0.99 }, &point); /* near a corner: h is linear up to it */
	DECK_NEAR(point.gap, 0.3 - 0.002 + 0.099, 1e-15);
	DECK_NEAR(point.slope[0], -0.2, 1e-13);
	DECK_NEAR(point.slope[1], 0.1, 1e-13);
	ts_film_profile(&point, 0, slope, 0.05, u);
	ck_assert(u[0] == 1 && u[1] == 0);
	DECK_NEAR(u[2], 0.05 + 0.2, 1e-14); /* dh1/dt + U1.grad h1 */
	ts_film_profile(&point, 1, slope, 0.05, u);
	ck_assert(u[0] == -0.3 && u[1] == 0.4);
	DECK_NEAR(u[2], 0.05 - 0.2 - 0.3 * (0.2 - 0.2) + 0.4 * (-0.1 + 0.1), 1e-14);
	for (int k = 0; k < 100; k++) {
		ts_film_profile(&point, (k + 0.5) / 100, slope, 0, u);
		sum += u[1] / 100;
	}
	DECK_NEAR(sum, point.mean[1], 1e-4 * fabs(point.mean[1]));
	ts_film_release(&f);
}
END_TEST

/* Radial outflow under a squeezed disc: q = V r/2 between the surfaces, at any radius; outside as at the rim. */
START_TEST(velocity_under_a_disc)
{
	struct ts_film f = disc(10, 0.5);
	struct ts_film_point point;

	film_solve(&f);
	for (double r = 0.03; r < 1.3; r += 0.1) {
		ts_film_sample(&f, (const double[]){ r, 1 }, &point);
		DECK_NEAR(point.mean[0] * point.gap, fmin(r, 1) / 2, 1e-13);
		ck_assert(point.gap == 0.5 && point.slope[0] == 0 && point.mean[1] == 0);
	}
	ts_film_release(&f);
}
END_TEST

/* ---- wrong input */

static void refused(struct ts_film *f, enum ts_status status, const char *text)
{
	struct ts_error error = { .status = TS_OK };

	ck_assert_int_eq(ts_film_solve(f, &error), status);
	ck_assert_msg(strstr(error.message, text) != NULL, "%s", error.message);
}

#define REFUSED(place, value, status, text)         \
	do {                                        \
		struct ts_film film = slider(6, 2); \
		film.place = (value);               \
		refused(&film, status, text);       \
		ts_film_release(&film);             \
	} while (0)

START_TEST(refusals)
{
	struct ts_film f = slider(6, 2);

	REFUSED(viscosity, 0, TS_RANGE, "viscosity 0, expected > 0");
	REFUSED(viscosity, -1, TS_RANGE, "viscosity -1");
	REFUSED(viscosity, NAN, TS_RANGE, "viscosity");
	REFUSED(density, 0, TS_RANGE, "density 0");
	REFUSED(gap[3], 0, TS_RANGE, "the gap is 0 at (0.583333, 0.5), expected > 0");
	REFUSED(gap[3], -0.1, TS_RANGE, "touch or overlap");
	REFUSED(gap[3], NAN, TS_RANGE, "the gap is");
	REFUSED(rate[2], INFINITY, TS_RANGE, "not a finite number");
	REFUSED(velocity[1][0][2], NAN, TS_RANGE, "not a finite number");
	REFUSED(face[0][3], 0.2, TS_RANGE, "do not increase");
	REFUSED(edge_pressure[0][1], NAN, TS_RANGE, "at the upper edge of axis 1");
	REFUSED(time_step, -1, TS_RANGE, "time step -1");
	REFUSED(edge[0][1], TS_FILM_PERIODIC, TS_RANGE, "only one edge of axis 1 is periodic");
	f.edge[0][0] = f.edge[0][1] = TS_FILM_NO_FLOW;
	refused(&f, TS_STATE, "no pressure is given at any border of the part of the film that contains");
	f.edge[0][0] = TS_FILM_PRESSURE;
	f.kind[2] = TS_FILM_SOLID; /* cuts the film */
	refused(&f, TS_STATE, "contains (0.583333, 0.5)");
	f.kind[2] = TS_FILM_FLUID;
	f.edge[1][0] = f.edge[1][1] = TS_FILM_PERIODIC;
	refused(&f, TS_RANGE, "1 cells along the periodic axis 2, expected at least 3");
	f.edge[1][0] = f.edge[1][1] = TS_FILM_NO_FLOW;
	f.polar = true;
	refused(&f, TS_RANGE, "is the centre, expected no flow");
	f.face[0][0] = -1;
	refused(&f, TS_RANGE, "radius begins at -1");
	f.polar = false;
	f.cavitation = TS_FILM_REYNOLDS;
	f.cavity_pressure = 0.5;
	refused(&f, TS_RANGE, "is below that in the cavity, 0.5");
	ts_film_release(&f);
}
END_TEST

/* Each allocation fails once: an error, and nothing is left allocated. */
START_TEST(out_of_memory)
{
	long balance = ts_alloc_balance();
	bool failed = true;

	for (long k = 1; failed; k++) {
		struct ts_film f = {
			.n = { 30, 4 }, .viscosity = 1, .density = 1, .cavitation = TS_FILM_JFO
		};
		struct ts_error error = { .status = TS_OK };

		ck_assert(k < 200);
		ts_alloc_fail_at(k);
		failed = ts_film_make(&f) != TS_OK;
		if (!failed) {
			for (int d = 0; d < 2; d++)
				for (int i = 0; i <= f.n[d]; i++)
					f.face[d][i] = i;
			film_fill(&f, f.gap, 1);
			failed = ts_film_solve(&f, &error) != TS_OK;
			ck_assert(!failed || error.status == TS_NOMEM);
		}
		ts_alloc_fail_at(0);
		ts_film_release(&f);
		ck_assert(ts_alloc_balance() == balance);
	}
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("film");
	TCase *tcase = tcase_create("film");

	tcase_set_timeout(tcase, 100);
	tcase_add_test(tcase, slider_is_exact);
	tcase_add_test(tcase, moving_slider_is_the_same);
	tcase_add_test(tcase, rayleigh_step);
	tcase_add_test(tcase, squeezed_strip_and_rectangle);
	tcase_add_test(tcase, squeezed_disc);
	tcase_add_test(tcase, closing_time_of_a_disc);
	tcase_add_test(tcase, disc_of_square_cells);
	tcase_add_test(tcase, parallel_surfaces);
	tcase_add_test(tcase, turning_disc);
	tcase_add_test(tcase, flow_along_the_angle);
	tcase_add_test(tcase, rough_gap_conserves);
	tcase_add_test(tcase, velocity_has_no_divergence);
	tcase_add_test(tcase, velocity_under_a_disc);
	tcase_add_test(tcase, refusals);
	tcase_add_test(tcase, out_of_memory);
	suite_add_tcase(suite, tcase);
	return deck_main(suite);
}
