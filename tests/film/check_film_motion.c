/* Shapes that move with their surfaces: the same film seen by observers that move, with steps and without; two height
 * fields. */
#include <math.h>
#include <string.h>

#include "deck.h"

static const char scene[] =
	"units si\nboundary f f f\nregion box block 0 2 0 1 0 2 units box\ncreate_box 1 box\n"
	"variable cx internal 0\nvariable cy internal 0\n"
	"variable low equal 0.2*sin(3*v_cx)+0.1*v_cy\nvariable high equal 1+0.2*cos(2*v_cx+v_cy)\n"
	"flow_style reynolds cells 24 12 lower v_low upper v_high set x cx y cy lower_velocity %g %g 0 "
	"upper_velocity %g %g 0 viscosity 1 density 1 %s\ncompute film all film\n"
	"timestep 1e-9\nrun 0\n";

static void near_film(struct tsim *a, struct tsim *b, double within)
{
	double most = fabs(deck_value(a, "c_film[4]")), shear = fabs(deck_value(a, "c_film[8]"));

	DECK_NEAR(deck_value(a, "c_film[8]"), deck_value(b, "c_film[8]"), 10 * within * shear);
	DECK_NEAR(deck_value(a, "c_film[10]"), deck_value(b, "c_film[10]"), 10 * within * shear);
	DECK_NEAR(deck_value(a, "c_film[12]"), deck_value(b, "c_film[12]"), 10 * within * shear);

	for (int c = 1; c <= 24 * 12; c += 7) {
		char name[40];

		snprintf(name, sizeof name, "c_film[%d][4]", c);
		DECK_NEAR(deck_value(a, name), deck_value(b, name), within * most);
	}
}

/* Both surfaces faster by the same velocity: pressure and forces are those before; all kinds of sections, edges, directions. */
START_TEST(moving_observers)
{
	static const char *const words[] = { "",
					     "gap stepped",
					     "lower_slip 0.2",
					     "gap stepped upper_slip 0.3",
					     "roughness 0.03 0.05 3",
					     "cavitation reynolds cavity_pressure -1",
					     "pressure_xhi 3",
					     "least_gap 0.3",
					     "gap stepped least_gap 0.3" };

	for (int k = 0; k < (int)(sizeof words / sizeof *words); k++) {
		struct tsim *a = deck_open(scene, 1.0, 0.5, -0.3, 0.0, words[k]);
		struct tsim *b = deck_open(scene, 0.0, 0.7, -1.3, 0.2, words[k]);
		struct tsim *c = deck_open(scene, 1.3, 0.5, 0.0, 0.0, words[k]);

		near_film(a, b, 1e-12);
		near_film(a, c, 1e-12);
		tsim_close(a);
		tsim_close(b);
		tsim_close(c);
	}
}
END_TEST

/* Load of a film with the gaps h on the lengths l, over a shape that slides to the right with speed 2, viscosity 0.5: in its
 * frame p' = 12 eta (-U h/2 - q)/h^3 with one flow q. */
static double stepped_load(const double l[3], const double h[3])
{
	double a = 0, b = 0, q, p = 0, load = 0;

	for (int k = 0; k < 3; k++) {
		a += l[k] / (h[k] * h[k]);
		b += l[k] / (h[k] * h[k] * h[k]);
	}
	q = -2 / 2.0 * a / b;
	for (int k = 0; k < 3; k++) {
		double rise = 12 * 0.5 * (-2 / 2.0 * h[k] - q) / (h[k] * h[k] * h[k]) * l[k];

		load += (p + rise / 2) * l[k];
		p += rise;
	}
	return load;
}

/* Columns that slide below a plane, a channel 0.1 deep from 0 to 0.5, after the time in which they have moved by `shift`. */
static double moved_load(int cells, double shift, const char *upper)
{
	struct tsim *sim =
		deck_open("units si\nboundary p f f\nregion box block 0 1 0 1 -1 1 units box\ncreate_box 1 "
			  "box\n"
			  "variable cx internal 0\nvariable s equal 0.1*(v_cx>0.5)\n"
			  "fix pad all surface/voxel formula v_s x cx type 1 cells 10 1 move linear 2 0 0\n"
			  "flow_style reynolds cells %d 1 %s viscosity 0.5 density 1 gap stepped closed ylo "
			  "yhi open xlo xhi\n"
			  "compute film all film\ntimestep %.17g\nrun 1\n",
			  cells, upper, shift / 2);
	double load = deck_value(sim, "c_film[1]");

	tsim_close(sim);
	return load;
}

START_TEST(steps_that_move)
{
	static const char *const surfaces[] = { "lower_voxel pad upper 0.225",
						"upper_voxel pad upper 0.225 lower 0" };
	const double h[3] = { 0.125, 0.225, 0.125 };

	for (int side = 0; side < 2; side++) {
		double step[4], error[4];
		const double aligned[3] = { 0.1, 0.5, 0.4 }, between[3] = { 0.03, 0.5, 0.47 };

		DECK_NEAR(moved_load(20, 0.1, surfaces[side]) / stepped_load(aligned, h), 1, 1e-11);
		for (int k = 0; k < 4; k++) {
			int cells = 80 << k;

			step[k] = 1.0 / cells;
			error[k] = fabs(moved_load(cells, 0.03, surfaces[side]) - stepped_load(between, h));
		}
		ck_assert_msg(deck_order(step, error, 4) > 0.8 &&
				      error[3] < 0.01 * fabs(stepped_load(between, h)),
			      "errors %g %g %g %g of %g", error[0], error[1], error[2], error[3],
			      stepped_load(between, h));
	}
}
END_TEST

/* Two height fields that slide: the film is the same upside down. They are periodic, so that the volume of the gap stays and what
 * flows in flows out, where the columns at opposite edges are the same. */
static struct tsim *two_fields(const char *low, const char *high, double across, const char *cells,
			       const char *shape)
{
	return deck_open("units si\nboundary p p f\nregion box block 0 1 0 0.5 -1 1 units box\ncreate_box 1 "
			 "box\n"
			 "fix a all surface/voxel gaussian mean 0.1 deviation 0.02 correlation 0.1 seed 3 "
			 "type 1 cells 20 10 datum 0 move linear 1.0 %g 0\n"
			 "fix b all surface/voxel gaussian mean 0.1 deviation 0.02 correlation 0.1 seed 4 "
			 "type 1 cells 20 10 datum 0 move linear -0.5 %g 0\n"
			 "flow_style reynolds cells %s lower_voxel %s upper_voxel %s upper 0.5 viscosity 0.5 "
			 "density 1 gap %s open xlo xhi ylo yhi\n"
			 "compute film all film\ntimestep 0.0113\nrun 5\n",
			 across, -2 * across, cells, low, high, shape);
}

START_TEST(two_height_fields)
{
	struct tsim *sim;
	double through;

	for (int k = 0; k < 2; k++) {
		struct tsim *up = two_fields("a", "b", 0.1, "40 20", k ? "linear" : "stepped");
		struct tsim *down = two_fields("b", "a", 0.1, "40 20", k ? "linear" : "stepped");

		DECK_NEAR(deck_value(up, "c_film[1]") / deck_value(down, "c_film[1]"), 1, 1e-9);
		DECK_NEAR(deck_value(up, "c_film[4]") / deck_value(down, "c_film[4]"), 1, 1e-9);
		DECK_NEAR(deck_value(up, "c_film[8]") / deck_value(down, "c_film[10]"), 1, 1e-9);
		tsim_close(up);
		tsim_close(down);
	}
	sim = two_fields("a", "b", 0, "160 20", "stepped");
	through = fabs(deck_value(sim, "c_film[14]")) + fabs(deck_value(sim, "c_film[15]"));
	DECK_NEAR(deck_value(sim, "c_film[14]+c_film[15]+c_film[16]+c_film[17]"), 0, 1e-11 * through);
	tsim_close(sim);
}
END_TEST

/* The gap of two planes is closed by a block of one of them that reaches `into` the other; one of them slides and drags
 * fluid along, or pushes it: pressure rises by 6 eta U/h^2 from the open end to the block. */
static struct tsim *closed_gap(double into, int upside_down, int pushes)
{
	const char *planes = upside_down ? "lower v_low upper 0" : "lower 0 upper v_high";
	const char *slides = upside_down != pushes ? "upper_velocity" : "lower_velocity";

	return deck_open("units si\nboundary f f f\nregion box block 0 0.01 0 0.01 -0.001 0.001 units box\n"
			 "create_box 1 box\nvariable cx internal 0\n"
			 "variable high equal 1e-5-(v_cx>0.004)*(v_cx<0.006)*(1e-5+%g)\n"
			 "variable low equal -v_high\n"
			 "flow_style reynolds cells 100 3 %s set x cx viscosity 0.01 density 1000 %s 1 0 0 "
			 "touching solid closed ylo yhi\ncompute film all film\ntimestep 1e-5\nrun 0\n",
			 into, planes, slides);
}

START_TEST(blocks_that_close_the_gap)
{
	const double into[] = { 0, 1e-6, 1e-4 }, rise = 6 * 0.01 * (0.004 - 0.00005) / 1e-10;

	for (int k = 0; k < 12; k++) {
		struct tsim *sim = closed_gap(into[k % 3], k / 3 % 2, k / 6);
		double flow = k / 6 ? 1e-7 : 0; /* a block that moves pushes the fluid out */

		DECK_NEAR(deck_value(sim, "c_film[4]") / rise, 1, 1e-12);
		DECK_NEAR(deck_value(sim, "c_film[14]"), -flow, 1e-20);
		DECK_NEAR(deck_value(sim, "c_film[15]"), flow, 1e-20);
		tsim_close(sim);
	}
}
END_TEST

/* A wavy pad that slides, where it touches the other surface the gap is that of its roughness: the mirror image has the mirror
 * image of all forces, to round-off. */
START_TEST(mirror_images)
{
	struct tsim *sim[2];

	for (int k = 0; k < 2; k++)
		sim[k] = deck_open("units si\nboundary p p f\nregion box block -0.5 0.5 0 0.5 -0.5 1 units "
				   "box\n"
				   "create_box 1 box\nvariable cx internal 0\nvariable s equal %d\n"
				   "variable h equal 0.05*sin(2*PI*v_s*v_cx)+0.02*cos(4*PI*v_s*v_cx+1)\n"
				   "fix pad all surface/voxel formula v_h x cx type 1 cells 24 4 move linear "
				   "$(0.1*v_s) 0 0\n"
				   "flow_style reynolds cells 24 4 lower_voxel pad upper 0.05 viscosity 2 "
				   "density 1000 "
				   "gap stepped least_gap 0.01 open xlo xhi\n"
				   "compute film all film\ntimestep 1e-3\nrun 0\n",
				   1 - 2 * k);
	for (int side = 8; side <= 12; side += 2) {
		double force[2];
		char name[40];

		snprintf(name, sizeof name, "c_film[%d]", side);
		for (int k = 0; k < 2; k++)
			force[k] = deck_value(sim[k], name);
		DECK_NEAR(force[0], -force[1], 1e-12 * fabs(force[0]));
	}
	DECK_NEAR(deck_value(sim[0], "c_film[1]"), deck_value(sim[1], "c_film[1]"), 1e-10);
	tsim_close(sim[0]);
	tsim_close(sim[1]);
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("film_motion");
	TCase *tcase = tcase_create("film_motion");

	tcase_set_timeout(tcase, 100);
	tcase_add_test(tcase, moving_observers);
	tcase_add_test(tcase, steps_that_move);
	tcase_add_test(tcase, two_height_fields);
	tcase_add_test(tcase, blocks_that_close_the_gap);
	tcase_add_test(tcase, mirror_images);
	suite_add_tcase(suite, tcase);
	return deck_main(suite);
}
