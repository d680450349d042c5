/* A grain of 25 um, 105 m/s, in a jet of air against a plane: speed and angle of its impact by the particle
 * program against an adaptive integration of the equation of motion, with each law of drag. */
#include <math.h>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

#include "deck.h"
#include "law/drag.h"

enum { SPEED_OF_SOUND = 343 };
static const double DIAMETER = 24.89e-6, DENSITY = 2900, VISCOSITY = 1.8e-5, AIR = 1.2, RATE = 105 / 0.01;

struct grain {
	double mass;
	double (*law)(const struct ts_slip *);
};

static double stokes(const struct ts_slip *s)
{
	return ts_drag_stokes(s);
}

static double schiller_naumann(const struct ts_slip *s)
{
	return ts_drag_schiller_naumann(s);
}

static double carlson_hoglund(const struct ts_slip *s)
{
	return ts_drag_carlson_hoglund(s, SPEED_OF_SOUND);
}

/* y: r, z and their velocities in axisymmetric potential flow */
static int motion(double t, const double y[], double d[], void *grain)
{
	const struct grain *g = grain;
	double w[2] = { RATE / 2 * y[0] - y[2], -RATE * y[1] - y[3] };
	struct ts_slip slip = { DIAMETER, hypot(w[0], w[1]), 1, AIR, VISCOSITY };
	double c = g->law(&slip) / g->mass;

	(void)t;
	d[0] = y[2];
	d[1] = y[3];
	d[2] = c * w[0];
	d[3] = c * w[1];
	return GSL_SUCCESS;
}

static void integrate(struct grain *g, double time, double y[4])
{
	gsl_odeiv2_system system = { motion, NULL, 4, g };
	gsl_odeiv2_driver *driver =
		gsl_odeiv2_driver_alloc_y_new(&system, gsl_odeiv2_step_rk8pd, 1e-8, 1e-16, 1e-13);
	double t = 0;

	ck_assert_int_eq(gsl_odeiv2_driver_apply(driver, &t, time, y), GSL_SUCCESS);
	gsl_odeiv2_driver_free(driver);
}

/* Time at which the grain touches the plane, by bisection. */
static double impact_time(struct grain *g, const double start[4])
{
	double lo = 0, hi = 2e-4;

	for (int k = 0; k < 50; k++) {
		double y[4] = { start[0], start[1], start[2], start[3] };

		integrate(g, (lo + hi) / 2, y);
		*(y[1] > DIAMETER / 2 ? &lo : &hi) = (lo + hi) / 2;
	}
	return (lo + hi) / 2;
}

enum { STEPS = 100000 };

/* A grain that leaves the nozzle at 10 mm with 30 degrees; the last step of the run ends at the impact. */
static double compare_impact(const char *name, double (*law)(const struct ts_slip *))
{
	const double start[4] = { -0.004, 0.01, 105 * 0.5, -105 * sqrt(0.75) };
	struct grain g = { .mass = DENSITY * TS_PI / 6 * pow(DIAMETER, 3), .law = law };
	double y[4] = { start[0], start[1], start[2], start[3] }, time = impact_time(&g, start), v[2];
	struct tsim *sim = deck_open("units si\n"
				     "atom_style granular\n"
				     "atom_modify map array\n"
				     "boundary f f f\n"
				     "region box block -0.02 0.02 -0.02 0.02 -0.001 0.02 units box\n"
				     "create_box 1 box\n"
				     "create_atoms 1 single %.17g 0 %.17g units box\n"
				     "set group all diameter %.17g density %.17g\n"
				     "velocity all set %.17g 0 %.17g\n"
				     "flow_style stagnation axisymmetric point 0 0 0 normal 0 0 1 speed 105 "
				     "distance 0.01 viscosity %.17g density %.17g\n"
				     "fix d all drag/%s\n"
				     "fix m all nve\n"
				     "timestep %.17g\n"
				     "run %d\n",
				     start[0], start[1], DIAMETER, DENSITY, start[2], start[3], VISCOSITY,
				     AIR, name, time / STEPS, STEPS);

	integrate(&g, time, y);
	v[0] = deck_value(sim, "vx[1]");
	v[1] = deck_value(sim, "vz[1]");
	DECK_NEAR(deck_value(sim, "z[1]"), DIAMETER / 2, 1e-8);
	DECK_NEAR(deck_value(sim, "x[1]"), y[0], 1e-8);
	DECK_NEAR(hypot(v[0], v[1]), hypot(y[2], y[3]), 1e-6 * 105);
	DECK_NEAR(atan2(-v[1], v[0]), atan2(-y[3], y[2]), 1e-6);
	tsim_close(sim);
	return hypot(v[0], v[1]);
}

/* The loss of speed is three to six times that by Stokes' drag; the correction for the gas is below 1 % of it. */
START_TEST(impacts_of_dust)
{
	double slow = 105 - compare_impact("stokes", stokes);
	double usual = 105 - compare_impact("schiller_naumann", schiller_naumann);
	double gas = 105 - compare_impact("carlson_hoglund sound 343", carlson_hoglund);

	ck_assert_msg(usual > 3 * slow && usual < 6.2 * slow, "%g %g", usual, slow);
	ck_assert_msg(gas < usual && gas > 0.985 * usual, "%.9g %.9g", usual, gas);
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("jet");
	TCase *tcase = tcase_create("jet");

	tcase_set_timeout(tcase, 100);
	tcase_add_test(tcase, impacts_of_dust);
	suite_add_tcase(suite, tcase);
	return deck_main(suite);
}
