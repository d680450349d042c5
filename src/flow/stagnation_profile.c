#include "flow/stagnation_profile.h"

#include <math.h>
#include <string.h>

#include "base/banned.h"

static const double STEP = 0.05; /* between the points of the table */
enum { SUBSTEPS = 40 };		 /* of the Runge-Kutta method: errors below 1e-12 */

static void derivative(int k, const double y[3], double d[3])
{
	d[0] = y[1];
	d[1] = y[2];
	d[2] = y[1] * y[1] - 1 - k * y[0] * y[2];
}

/* One step of the classical method of fourth order. */
static void runge_kutta(int k, double h, double y[3])
{
	static const double at[4] = { 0, 0.5, 0.5, 1 }, weight[4] = { 1, 2, 2, 1 };
	double sum[3] = { 0 }, d[3] = { 0 };

	for (int stage = 0; stage < 4; stage++) {
		double now[3];

		for (int i = 0; i < 3; i++)
			now[i] = y[i] + at[stage] * h * d[i];
		derivative(k, now, d);
		for (int i = 0; i < 3; i++)
			sum[i] += weight[stage] * d[i];
	}
	for (int i = 0; i < 3; i++)
		y[i] += h / 6 * sum[i];
}

/* Fills the table for this f''(0); returns f' - 1 at its end. */
static double integrate(struct ts_stagnation_profile *profile, int k, double curvature)
{
	double y[3] = { 0, 0, curvature };

	for (int n = 0; n < TS_STAGNATION_POINTS; n++) {
		memcpy(profile->f[n], y, sizeof y);
		for (int j = 0; j < SUBSTEPS; j++)
			runge_kutta(k, STEP / SUBSTEPS, y);
	}
	return profile->f[TS_STAGNATION_POINTS - 1][1] - 1;
}

/* Far from the plane errors of f''(0) only grow as s^2, so that the secant method finds it to round-off. */
void ts_stagnation_solve(struct ts_stagnation_profile *profile, int k)
{
	enum { MOST = 20 };
	double a = k == 1 ? 1.2326 : 1.3119, b = a + 1e-4, fa = integrate(profile, k, a);

	for (int n = 0; n < MOST; n++) {
		double fb = integrate(profile, k, b), next;

		if (fabs(fb) < 1e-14 || fabs(b - a) < 1e-16 || fabs(fb - fa) < 1e-16)
			return;
		next = b - fb * (b - a) / (fb - fa);
		a = b;
		fa = fb;
		b = next;
	}
}

/* Quintic Hermite interpolation of f from f, f' and f'' at both ends of an interval. */
void ts_stagnation_at(const struct ts_stagnation_profile *profile, double s, double *f, double *slope)
{
	int n = (int)fmin(s / STEP, TS_STAGNATION_POINTS - 1);
	const double *p = profile->f[n], *q = p + 3;
	double t = s / STEP - n, c[6], rise, tilt, bend;

	if (n == TS_STAGNATION_POINTS - 1) {
		*f = p[0] + (s - n * STEP);
		*slope = 1;
		return;
	}
	c[0] = p[0];
	c[1] = p[1] * STEP;
	c[2] = p[2] * STEP * STEP / 2;
	rise = q[0] - c[0] - c[1] - c[2];
	tilt = q[1] * STEP - c[1] - 2 * c[2];
	bend = q[2] * STEP * STEP - 2 * c[2];
	c[3] = 10 * rise - 4 * tilt + bend / 2;
	c[4] = -15 * rise + 7 * tilt - bend;
	c[5] = 6 * rise - 3 * tilt + bend / 2;
	*f = c[0] + t * (c[1] + t * (c[2] + t * (c[3] + t * (c[4] + t * c[5]))));
	*slope = (c[1] + t * (2 * c[2] + t * (3 * c[3] + t * (4 * c[4] + t * 5 * c[5])))) / STEP;
}
