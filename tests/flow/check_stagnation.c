/* Flow_style stagnation: the profile against an adaptive integration and published numbers, fluxes through
 * closed surfaces, streamlines, grains that follow it or hit the plane. */
#include <math.h>
#include <string.h>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

#include "flow/stagnation_profile.h"
#include "deck.h"

static int similarity(double s, const double y[], double d[], void *k)
{
	(void)s;
	d[0] = y[1];
	d[1] = y[2];
	d[2] = y[1] * y[1] - 1 - *(const int *)k * y[0] * y[2];
	return GSL_SUCCESS;
}

/* f''(0), and s - f far away (displacement thickness): 1.2325877 and 0.6479 (K. Hiemenz; L. Howarth 1934),
 * 1.3119377 and 0.5689 (F. Homann; N. Froessling 1940). */
START_TEST(profile_is_the_solution)
{
	const double wall[3] = { 0, 1.232587656820, 1.311937693880 }, away[3] = { 0, 0.6479004, 0.5689 };

	for (int k = 1; k <= 2; k++) {
		struct ts_stagnation_profile profile;
		gsl_odeiv2_system system = { similarity, NULL, 3, &k };
		gsl_odeiv2_driver *driver =
			gsl_odeiv2_driver_alloc_y_new(&system, gsl_odeiv2_step_rk8pd, 1e-3, 1e-14, 1e-14);
		double s = 0, y[3] = { 0 }, f, slope;

		ts_stagnation_solve(&profile, k);
		y[2] = profile.f[0][2];
		DECK_NEAR(y[2], wall[k], 2e-12);
		for (int n = 1; n < 600; n++) { /* also between the points of the table */
			ck_assert_int_eq(gsl_odeiv2_driver_apply(driver, &s, n * 0.0131, y), GSL_SUCCESS);
			ts_stagnation_at(&profile, s, &f, &slope);
			DECK_NEAR(f, y[0], 1e-10);
			DECK_NEAR(slope, y[1], 1e-10);
		}
		ts_stagnation_at(&profile, 23.85, &f, &slope);
		DECK_NEAR(23.85 - f, away[k], 5e-5);
		ck_assert(slope == 1);
		gsl_odeiv2_driver_free(driver);
	}
}
END_TEST

/* Integral of f' over an interval of the table, exact for the interpolating polynomial by Gauss' rule of
 * three points, is the difference of f: the flux through any cylinder about the axis vanishes. */
START_TEST(profile_has_no_divergence)
{
	const double at[3] = { -0.7745966692414834, 0, 0.7745966692414834 },
		     w[3] = { 5. / 18, 8. / 18, 5. / 18 };

	for (int k = 1; k <= 2; k++) {
		struct ts_stagnation_profile profile;

		ts_stagnation_solve(&profile, k);
		for (int n = 0; n < TS_STAGNATION_POINTS + 5; n++) {
			double lo = n * 0.05, hi = lo + 0.05, flux = 0, f[2], slope;

			for (int j = 0; j < 3; j++) {
				ts_stagnation_at(&profile, (lo + hi) / 2 + at[j] * (hi - lo) / 2, f, &slope);
				flux += w[j] * (hi - lo) * slope;
			}
			ts_stagnation_at(&profile, lo, &f[0], &slope);
			ts_stagnation_at(&profile, hi, &f[1], &slope);
			DECK_NEAR(flux, f[1] - f[0], 4e-15);
		}
	}
}
END_TEST

static const char scene[] = "units si\n"
			    "atom_style granular\n"
			    "atom_modify map array\n"
			    "boundary f f f\n"
			    "region box block -0.1 0.1 -0.1 0.1 -0.01 0.1 units box\n"
			    "create_box 1 box\n";

/* Velocity of the fluid at a point: the Stokes drag on a small sphere that moves with (-1, 0, 0). */
static void velocity_at(const char *flow, const double x[3], double u[3])
{
	struct tsim *sim = deck_open("%screate_atoms 1 single %.17g %.17g %.17g units box\n"
				     "set group all diameter 1e-4 density 1000\n"
				     "velocity all set -1 0 0\n"
				     "flow_style stagnation %s viscosity 1e-3 density 500\n"
				     "fix d all drag/stokes\n"
				     "timestep 1e-9\n"
				     "run 0\n",
				     scene, x[0], x[1], x[2], flow);
	double c = 3 * 3.14159265358979324 * 1e-3 * 1e-4;
	const char *names[3] = { "fx[1]", "fy[1]", "fz[1]" };

	for (int k = 0; k < 3; k++)
		u[k] = deck_value(sim, names[k]) / c - (k == 0);
	tsim_close(sim);
}

/* Closed forms, with a tilted plane; the potential flow shifted by the displacement thickness far away. */
START_TEST(velocities)
{
	const double x[3] = { 0.02, -0.03, 0.05 };
	double u[3], length = sqrt(1e-3 / 500 / 10);

	velocity_at("axisymmetric point 0.01 0 0.02 normal 0 0 2.385 rate 20", x, u);
	DECK_NEAR(u[0], 10 * 0.01, 1e-14);
	DECK_NEAR(u[1], 10 * -0.03, 1e-14);
	DECK_NEAR(u[2], -20 * 0.03, 1e-14);
	velocity_at("plane point 0.01 0 0.02 normal 0 0 1 span 0 2 0 speed 2 distance 0.1", x, u);
	DECK_NEAR(u[0], 20 * 0.01, 1e-14);
	DECK_NEAR(u[1], 0, 1e-14);
	DECK_NEAR(u[2], -20 * 0.03, 1e-14);
	/* normal (3, 0, 4)/5: z = 0.6*0.01 + 0.8*0.03 = 0.03, r = (0.01, -0.03, 0.03) - z n */
	velocity_at("axisymmetric point 0.01 0 0.02 normal 3 0 4 rate 20", x, u);
	DECK_NEAR(u[0], 10 * (0.01 - 0.6 * 0.03) - 20 * 0.03 * 0.6, 1e-14);
	DECK_NEAR(u[1], 10 * -0.03, 1e-14);
	DECK_NEAR(u[2], 10 * (0.03 - 0.8 * 0.03) - 20 * 0.03 * 0.8, 1e-14);
	velocity_at("axisymmetric point 0.01 0 0.02 normal 0 0 1 rate 20 profile viscous", x, u);
	DECK_NEAR(u[0], 10 * 0.01, 1e-12);
	DECK_NEAR(u[2], -20 * (0.03 - 0.5689 * length), 20 * length * 1e-4);
	velocity_at("plane point 0.01 0 0.02 normal 0 0 1 span 0 1 0 rate 10 profile viscous", x, u);
	DECK_NEAR(u[2], -10 * (0.03 - 0.6479 * length), 10 * length * 1e-4);
	velocity_at("axisymmetric point 0.01 0 0.06 normal 0 0 1 rate 20 profile viscous", x, u);
	DECK_NEAR(fabs(u[0]) + fabs(u[1]) + fabs(u[2]), 0, 1e-14);
}
END_TEST

/* A grain with a small relaxation time tau has the velocity u - tau u.grad u, so that r^2 z (r z) decreases as
 * exp(-tau (2 A^2 + a^2) t) (plane: A^2 + a^2); tau = 4.994e-6. */
static double streamline_drift(const char *shape, int power)
{
	struct tsim *sim =
		deck_open("%screate_atoms 1 single 0.001 0 0.05 units box\n"
			  "set group all diameter 4.24e-5 density 1000\n"
			  "velocity all set %g 0 -1\n"
			  "flow_style stagnation %s point 0 0 0 normal 0 0 1 rate 20 viscosity 2e-2\n"
			  "fix d all drag/stokes scheme exact\n"
			  "fix m all nve\n"
			  "timestep 1e-6\n"
			  "run 100000\n",
			  scene, power == 2 ? 0.01 : 0.02, shape);
	double x = deck_value(sim, "x[1]"), z = deck_value(sim, "z[1]");

	ck_assert(x > 0.002 && z < 0.01); /* 2 time constants of the flow */
	tsim_close(sim);
	return pow(x / 0.001, power) * z / 0.05 - 1;
}

START_TEST(light_grains_follow_streamlines)
{
	DECK_NEAR(streamline_drift("axisymmetric", 2), -3e-4, 2e-6);
	DECK_NEAR(streamline_drift("plane span 0 1 0", 1), -4e-4, 2e-6);
}
END_TEST

/* On the axis z'' = -(a z + z')/tau: with St = a tau < 1/4 a grain that follows the flow never reaches the
 * plane; above it the motion oscillates and the grain crosses z = 0. The time of the crossing is known. */
static double height_in_steps(double stokes, double time, int steps)
{
	struct tsim *sim = deck_open("%screate_atoms 1 single 0 0 0.05 units box\n"
				     "set group all diameter 1e-4 density %.17g\n"
				     "velocity all set 0 0 -1\n"
				     "flow_style stagnation axisymmetric point 0 0 0 normal 0 0 1 rate 20 "
				     "viscosity 1e-3\n"
				     "fix d all drag/stokes\n"
				     "fix m all nve\n"
				     "timestep %.17g\n"
				     "run %d\n",
				     scene, stokes / 20 * 18 * 1e-3 / 1e-8, time / steps, steps);
	double z = deck_value(sim, "z[1]");

	tsim_close(sim);
	return z;
}

/* The explicit drag is of first order in the step: its error is extrapolated to zero. */
static double height_after(double stokes, double time)
{
	return 2 * height_in_steps(stokes, time, 20000) - height_in_steps(stokes, time, 10000);
}

START_TEST(heavy_grains_hit)
{
	double tau = 0.5 / 20, omega = sqrt(20 / tau - 1 / (4 * tau * tau)), slow, fast, b;

	/* z = exp(-t/(2 tau)) (z0 cos omega t + b sin omega t), b = (v0 + z0/(2 tau))/omega */
	b = (-1 + 0.05 / (2 * tau)) / omega;
	DECK_NEAR(height_after(0.5, 0.05),
		  exp(-0.05 / (2 * tau)) * (0.05 * cos(omega * 0.05) + b * sin(omega * 0.05)), 1e-9);
	/* St = 0.16: roots -5 and -1.25 of p^2 + p/St + 1/St = 0 in units of a */
	slow = -20 * 1.25;
	fast = -20 * 5;
	b = (-1 - slow * 0.05) / (fast - slow);
	DECK_NEAR(height_after(0.16, 0.2), (0.05 - b) * exp(slow * 0.2) + b * exp(fast * 0.2), 1e-9);
	ck_assert(height_after(0.16, 0.2) > 0 && height_after(0.5, 0.15) < 0);
}
END_TEST

static void refuses(const char *flow, const char *text)
{
	struct tsim *sim = deck_open("%s", scene);

	ck_assert(!deck_accepts(sim, "flow_style stagnation %s\nfix d all drag/stokes\nrun 0\n", flow));
	ck_assert_msg(strstr(tsim_error(sim), text) != NULL, "%s", tsim_error(sim));
	tsim_close(sim);
}

START_TEST(refusals)
{
	refuses("axisymmetric point 0 0 0 normal 0 0 1 viscosity 1",
		"expected either rate, or speed and distance");
	refuses("axisymmetric point 0 0 0 normal 0 0 1 rate 1 speed 1 viscosity 1", "expected either rate");
	refuses("axisymmetric point 0 0 0 normal 0 0 1 speed 1 viscosity 1", "expected either rate");
	refuses("axisymmetric point 0 0 0 normal 0 0 0 rate 1 viscosity 1", "normal is 0 0 0");
	refuses("plane point 0 0 0 normal 0 0 1 rate 1 viscosity 1", "not perpendicular");
	refuses("axisymmetric point 0 0 0 normal 0 0 1 rate 1 viscosity 1 profile viscous",
		"needs viscosity and density > 0");
	refuses("round point 0 0 0 normal 0 0 1 rate 1 viscosity 1", "'round'");
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("stagnation");
	TCase *tcase = tcase_create("stagnation");

	tcase_set_timeout(tcase, 100);
	tcase_add_test(tcase, profile_is_the_solution);
	tcase_add_test(tcase, profile_has_no_divergence);
	tcase_add_test(tcase, velocities);
	tcase_add_test(tcase, light_grains_follow_streamlines);
	tcase_add_test(tcase, heavy_grains_hit);
	tcase_add_test(tcase, refusals);
	suite_add_tcase(suite, tcase);
	return deck_main(suite);
}
