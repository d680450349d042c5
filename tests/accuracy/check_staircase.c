/* A ramp made of columns converges to the inclined plane. Its edges lie on a plane: at a distance d from it the
 * nearest edge is at most at half of their spacing l from the foot of the perpendicular, so that the distance of the
 * staircase is at most sqrt(d^2 + l^2/4) - d = l^2/(8 d) larger, of second order in the width of the columns, and
 * its normal turned by at most l/(2 d), of first order. The velocity of a sphere that rebounds from it converges
 * faster as soon as several edges within the contact area sqrt(2 R overlap) share the force, with `merge no`. */
#include "../deck.h"

#include <math.h>

#include "voxel/voxel_touch.h"

enum { PHASES = 16, WIDTHS = 5 };

static const double RADIUS = 0.1, SPEED = 1.3;

/* The largest difference of distance and of direction between staircase and plane, at a distance of RADIUS. */
static void geometry_error(int columns, double *distance, double *direction)
{
	const double slope = tan(20 * acos(-1) / 180), c = cos(atan(slope)), n[2] = { -slope * c, c };
	struct ts_voxel_field f = { .axis = { 0, 1, 2 },
				    .n = { columns, 1 },
				    .origin = { -0.5, 0 },
				    .width = { 1.0 / columns, 1 },
				    .base = -INFINITY };

	ck_assert(ts_voxel_field_make(&f) == TS_OK);
	for (int i = 0; i < columns; i++) /* the edges are at the left border of the columns */
		ts_voxel_heights(&f)[i] = slope * ts_voxel_border(&f, 0, i);
	ts_voxel_field_update(&f);
	*distance = *direction = 0;
	for (int k = 0; k < 1000; k++) {
		double foot = k / 1000.0 * f.width[0];
		double x[3] = { foot + RADIUS * n[0], 0.5, slope * foot + RADIUS * n[1] }, least = INFINITY;
		struct ts_voxel_contact contact[100];
		size_t found = ts_voxel_contacts(&f, x, 1.2 * RADIUS, contact, 100), nearest = 0;

		ck_assert(found > 0 && found <= 100);
		for (size_t m = 0; m < found; m++) {
			nearest = contact[m].distance < least ? m : nearest;
			least = fmin(least, contact[m].distance);
		}
		*distance = fmax(*distance, least - RADIUS);
		*direction =
			fmax(*direction, hypot(contact[nearest].n[0] - n[0], contact[nearest].n[2] - n[1]));
	}
	ts_voxel_field_release(&f);
}

START_TEST(distance_and_direction)
{
	double width[WIDTHS], distance[WIDTHS], direction[WIDTHS];

	for (int k = 0; k < WIDTHS; k++) {
		double l;

		width[k] = 0.2 * RADIUS / (1 << k);
		l = width[k] / cos(20 * acos(-1) / 180);
		geometry_error((int)rint(1 / width[k]), &distance[k], &direction[k]);
		printf("width %g R: distance %g R, direction %g\n", width[k] / RADIUS, distance[k] / RADIUS,
		       direction[k]);
		/* bounds, which are reached but for the positions that are tried */
		ck_assert_double_le(distance[k], l * l / (8 * RADIUS) * (1 + 1e-9));
		ck_assert_double_ge(distance[k], l * l / (8 * RADIUS) * 0.99);
		ck_assert_double_le(direction[k], l / (2 * RADIUS) * (1 + 1e-9));
		ck_assert_double_ge(direction[k], l / (2 * RADIUS) * 0.98);
	}
	DECK_NEAR(deck_order(width, distance, WIDTHS), 2, 0.01);
	DECK_NEAR(deck_order(width, direction, WIDTHS), 1, 0.01);
}
END_TEST

/* Velocities of frictionless, elastic spheres after they have hit a ramp of 20 degrees at PHASES places of a
 * column: root mean square of the difference to the reflection at the plane, as a part of the speed. */
static double rebound_error(double width)
{
	const double slope = tan(20 * acos(-1) / 180), c = cos(atan(slope)), n[2] = { -slope * c, c };
	double vx[PHASES], vz[PHASES], sum = 0;
	struct tsim *sim =
		deck_open("units si\n"
			  "boundary f p f\n"
			  "newton off\n"
			  "communicate single vel yes\n"
			  "neighbor 0.01 bin\n"
			  "region box block -0.5 0.5 0 4 -1 1 units box\n"
			  "create_box 1 box\n"
			  "timestep 1e-5\n"
			  "fix kn all property/global kn peratomtypepair 1 1e6\n"
			  "fix kt all property/global kt peratomtypepair 1 1e-13\n"
			  "fix gn all property/global gamman peratomtypepair 1 1e-13\n"
			  "fix gt all property/global gammat peratomtypepair 1 1e-13\n"
			  "fix mu all property/global coefficientFriction peratomtypepair 1 0\n"
			  "variable cx internal 0\n"
			  "variable h equal %.17g*v_cx\n"
			  "fix ramp all surface/voxel formula v_h x cx type 1 cells %d 1 merge no\n"
			  "fix wall all wall/gran model hooke/stiffness tangential no_history voxels ramp\n"
			  "fix move all nve",
			  slope, (int)rint(1 / width));

	for (int k = 0; k < PHASES; k++) {
		/* the first contact is near x = 0 */
		double x = (k + 0.5) / PHASES * width - 0.1 * slope;

		deck(sim, "create_atoms 1 single %.17g %.17g %.17g units box", x, 0.125 + 0.25 * k,
		     slope * (x + 0.5 * width) + 1.01 * RADIUS / c);
	}
	deck(sim,
	     "set group all diameter %.17g density 1000\n"
	     "velocity all set 0 0 %.17g\n"
	     "run 3000",
	     2 * RADIUS, -SPEED);
	deck_column(sim, "vx", vx, PHASES, 0);
	deck_column(sim, "vz", vz, PHASES, 0);
	for (int k = 0; k < PHASES; k++) {
		double normal = -SPEED * n[1]; /* v.n before; after it -v.n */
		double ex = vx[k] + 2 * normal * n[0], ez = vz[k] + SPEED + 2 * normal * n[1];

		ck_assert(vz[k] > -0.9 * SPEED); /* it has rebounded */
		sum += (ex * ex + ez * ez) / (SPEED * SPEED);
	}
	tsim_close(sim);
	return sqrt(sum / PHASES);
}

START_TEST(rebound_from_a_staircase)
{
	double width[WIDTHS], error[WIDTHS];

	for (int k = 0; k < WIDTHS; k++) {
		width[k] = 0.5 * RADIUS / (1 << k);
		error[k] = rebound_error(width[k]);
		printf("width %g R: rebound velocity %g\n", width[k] / RADIUS, error[k]);
		ck_assert(!k || error[k] < error[k - 1]);
	}
	printf("order %g\n", deck_order(width, error, WIDTHS));
	ck_assert_double_gt(deck_order(width, error, WIDTHS), 2);
}
END_TEST

/* The force on a sphere pressed by 0.05 R into a ramp with `merge yes`, relative to that of the plane: the largest
 * difference for PHASES places. */
static double force_error(int columns)
{
	const double slope = tan(20 * acos(-1) / 180), c = cos(atan(slope)), n[2] = { -slope * c, c };
	double fx[PHASES], fz[PHASES], most = 0;
	struct tsim *sim =
		deck_open("units si\n"
			  "boundary f p f\n"
			  "newton off\n"
			  "communicate single vel yes\n"
			  "neighbor 0.01 bin\n"
			  "region box block -0.5 0.5 0 4 -1 1 units box\n"
			  "create_box 1 box\n"
			  "timestep 1e-7\n"
			  "fix kn all property/global kn peratomtypepair 1 1000\n"
			  "fix kt all property/global kt peratomtypepair 1 1e-13\n"
			  "fix gn all property/global gamman peratomtypepair 1 1e-13\n"
			  "fix gt all property/global gammat peratomtypepair 1 1e-13\n"
			  "fix mu all property/global coefficientFriction peratomtypepair 1 0\n"
			  "variable cx internal 0\n"
			  "variable h equal %.17g*(v_cx-%.17g)\n"
			  "fix ramp all surface/voxel formula v_h x cx type 1 cells %d 1 merge yes\n"
			  "fix wall all wall/gran model hooke/stiffness tangential no_history voxels ramp",
			  slope, 0.5 / columns, columns);

	for (int k = 0; k < PHASES; k++) {
		double foot = (k + 0.5) / PHASES / columns;

		deck(sim, "create_atoms 1 single %.17g %.17g %.17g units box", foot + 0.95 * RADIUS * n[0],
		     0.125 + 0.25 * k, slope * foot + 0.95 * RADIUS * n[1]);
	}
	deck(sim, "set group all diameter %.17g density 1000\nrun 0", 2 * RADIUS);
	deck_column(sim, "fx", fx, PHASES, 0);
	deck_column(sim, "fz", fz, PHASES, 0);
	for (int k = 0; k < PHASES; k++) {
		double plane = 1000 * 0.05 * RADIUS;

		most = fmax(most, hypot(fx[k] / plane - n[0], fz[k] / plane - n[1]));
	}
	tsim_close(sim);
	return most;
}

START_TEST(force_of_merged_contacts)
{
	double width[WIDTHS], error[WIDTHS];

	for (int k = 0; k < WIDTHS; k++) {
		int columns = 200 << k;

		width[k] = 1.0 / columns;
		error[k] = force_error(columns);
		printf("width %g R: force %g\n", width[k] / RADIUS, error[k]);
	}
	DECK_NEAR(deck_order(width, error, WIDTHS), 1, 0.05);
	ck_assert_double_lt(error[WIDTHS - 1], 0.6 * width[WIDTHS - 1] / RADIUS);
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("staircase");
	TCase *tests = tcase_create("staircase");

	tcase_add_test(tests, distance_and_direction);
	tcase_add_test(tests, rebound_from_a_staircase);
	tcase_add_test(tests, force_of_merged_contacts);
	suite_add_tcase(suite, tests);
	return deck_main(suite);
}
