/* Fix wafer on the film of flow_style reynolds: pivoted sliders, squeezed films, small oscillations, film and pad together. */
#include <math.h>
#include <string.h>

#include "deck.h"

/* int_0^1 f dx by Simpson's rule. */
static double integrate(double (*f)(double x, double k), double k)
{
	const int n = 20000;
	double sum = f(0, k) + f(1, k);

	for (int i = 1; i < n; i++)
		sum += (i % 2 ? 4 : 2) * f((double)i / n, k);
	return sum / (3 * n);
}

/* Pressure of the plane slider with the gaps k to 1 over eta U L/h0^2, and its moment. */
static double slider_pressure(double x, double k)
{
	double h = k - (k - 1) * x;

	return 6 * (k - h) * (h - 1) / (h * h * (k * k - 1));
}

static double slider_moment(double x, double k)
{
	return x * slider_pressure(x, k);
}

/* All in units of h: a slider of 1000 h x 500 h on a pad that moves with h/s, viscosity 2.5. The pad of columns is far below. */
static const char scene[] =
	"units si\nboundary f f f\nregion box block 0 %.17g 0 %.17g %.17g %.17g units box\ncreate_box 1 box\n"
	"fix pad all surface/voxel constant %.17g type 1 cells 4 4\n"
	"fix w all wafer pad %s stiffness 1e3 pressure %.17g joint_1 %.17g\n"
	"%stimestep %.17g\n";

static struct tsim *slider(double h, int cells, const char *motion, double pressure, double joint, double dt,
			   const char *more)
{
	char film[400];

	snprintf(film, sizeof film,
		 "flow_style reynolds cells %d 1 lower 0 lower_velocity %.17g 0 0 upper_wafer w viscosity "
		 "2.5 density 1 closed ylo yhi %s\n",
		 cells, h, more);
	return deck_open(scene, 1000 * h, 500 * h, -10 * h, 100 * h, -5 * h, motion, pressure,
			 joint * 1000 * h, film, dt);
}

/* The joint above the centre of pressure of K = 2, the load that of the gap h: K = 2 and the gap h are found, on all scales,
 * from far away. */
START_TEST(pivoted_slider)
{
	double load = integrate(slider_pressure, 2), centre = integrate(slider_moment, 2) / load, step[3],
	       error[3];

	DECK_NEAR(load, 0.158883, 1e-6);
	DECK_NEAR(centre, 0.568688, 1e-6);
	for (int k = 0; k < 4; k++) {
		double h = (const double[]){ 1e-6, 1e-9, 1e3, 1 }[k], slope, gap;
		int cells = (const int[]){ 100, 200, 400, 2400 }[k];
		struct tsim *sim = slider(h, cells, "settled", load * 2.5 * 1e3, centre - 0.5, 1, "");

		deck(sim, "run 0\n");
		slope = deck_value(sim, "f_w[2]") * 1000;
		gap = (deck_value(sim, "f_w[1]") / h + slope * (1 - centre));
		DECK_NEAR(deck_value(sim, "f_w[8]") / (load * 2.5 * 1e3 * 5e5 * h * h), 1, 1e-11);
		DECK_NEAR(deck_value(sim, "f_w[4]"), 0, 0);
		if (k == 3) {
			DECK_NEAR(gap, 1, 1e-6);
			DECK_NEAR(slope, -1, 3e-6);
			DECK_NEAR(deck_value(sim, "f_w[3]"), 0, 1e-12);
			/* shear and the pressure on the slope: the friction of the pad */
			DECK_NEAR(deck_value(sim, "f_w[11]") / (2.5 * 5e5), 0.772589, 2e-6);
		} else {
			step[k] = 1.0 / cells;
			error[k] = fabs(gap - 1);
		}
		tsim_close(sim);
	}
	DECK_NEAR(deck_order(step, error, 3), 2, 0.1);
}
END_TEST

/* By its mass, with steps far longer than the times of the film: the same end. */
START_TEST(same_end)
{
	struct tsim *a = slider(1, 50, "settled", 0.15 * 2.5e3, 0.07, 1, "");
	struct tsim *b = slider(1, 50, "dynamic mass 1e6 inertia_1 1e11 inertia_2 1e11 start 5 start_1 -1e-3",
				0.15 * 2.5e3, 0.07, 1, "");

	deck(a, "run 0\n");
	deck(b, "run 200\ntimestep 1e4\nrun 400\n");
	for (int k = 1; k <= 3; k++) {
		char name[20];

		snprintf(name, sizeof name, "f_w[%d]", k);
		DECK_NEAR(deck_value(a, name), deck_value(b, name), 1e-8);
	}
	tsim_close(a);
	tsim_close(b);
}
END_TEST

/* A wafer of little mass sinks by a constant load: eta V B^2/h^3 = P; 1/h^2 = 1/h0^2 + 2 P t/(eta B^2). On n cells the
 * load is larger by 2/n^2. */
START_TEST(squeezed_strip)
{
	double step[4], error[4];

	for (int k = 0; k < 4; k++) {
		int steps = 80 << k;
		double pressure = 2.5 * 1e6, time = 2, end;
		struct tsim *sim = slider(1, 100, "dynamic mass 1e-3 inertia_1 1e3 inertia_2 1e3 start 3",
					  pressure, 0, time / steps, "");

		deck(sim,
		     "flow_style none\nflow_style reynolds cells 100 1 lower 0 upper_wafer w viscosity 2.5 "
		     "density 1 closed ylo yhi\nrun %d\n",
		     steps);
		end = 1 / sqrt(1 / 9.0 + 2 * pressure * time / (2.5 * 1e6 * (1 + 2e-4)));
		step[k] = 1.0 / steps;
		error[k] = fabs(deck_value(sim, "f_w[1]") - end);
		tsim_close(sim);
	}
	ck_assert_msg(fabs(deck_order(step + 2, error + 2, 2) - 2) < 0.25 && error[3] < 5e-6,
		      "order %g, errors %.9g %.9g %.9g %.9g", deck_order(step + 2, error + 2, 2), error[0],
		      error[1], error[2], error[3]);
}
END_TEST

/* Squeeze damping of the slider, over eta L^3 v/h0^3: h^3 p' = 12 (x - x0), x0 where int p' = 0. */
static double inverse_cube(double x, double k)
{
	return pow(k - (k - 1) * x, -3);
}

static double first_moment(double x, double k)
{
	return x * inverse_cube(x, k);
}

static double second_moment(double x, double k)
{
	return x * first_moment(x, k);
}

/* Heave of a slider whose slope is kept by its inertia: m z'' + c z' + k z = 0 for small z. */
START_TEST(small_oscillation)
{
	const double eta = 2.5, width = 500, length = 1000, part = 1e-5, ratio = 0.2, amplitude = 1e-4;
	double a = integrate(inverse_cube, 2), b = integrate(first_moment, 2),
	       c = integrate(second_moment, 2);
	/* with h0 and the rise fixed to h: K = (h + 1)/h; stiffness by differences of the closed form */
	double up = integrate(slider_pressure, (2 + part) / (1 + part)) / pow(1 + part, 2);
	double down = integrate(slider_pressure, (2 - part) / (1 - part)) / pow(1 - part, 2);
	double stiffness = (down - up) / (2 * part) * eta * length * length * width;
	double damping = 12 * (c - b * b / a) * eta * pow(length, 3) * width;
	double omega = 2 * ratio * stiffness / damping, mass = stiffness / (omega * omega), period;
	double damped = omega * sqrt(1 - ratio * ratio), time, expected, z[4], step[3], error[3];
	char motion[300];
	struct tsim *rest =
		slider(1, 100, "dynamic mass 1 inertia_1 1 inertia_2 1 start 1.5 start_1 -1e-3", 1, 0, 1, "");
	double load;

	deck(rest, "run 0\n");
	load = deck_value(rest, "f_w[8]") / 5e5;
	tsim_close(rest);
	period = 2 * 3.14159265358979324 / damped;
	time = 0.8 * period;
	expected = amplitude * exp(-ratio * omega * time) *
		   (cos(damped * time) + ratio * omega / damped * sin(damped * time));
	snprintf(motion, sizeof motion,
		 "dynamic mass %.17g inertia_1 1e28 inertia_2 1e28 start %.17g start_1 -1e-3", mass,
		 1.5 + amplitude);
	for (int k = 0; k < 4; k++) {
		int steps = (const int[]){ 100, 200, 400, 1600 }[k];
		struct tsim *sim = slider(1, 100, motion, load, 0, time / steps, "");

		deck(sim, "run %d\n", steps);
		z[k] = deck_value(sim, "f_w[1]") - 1.5;
		tsim_close(sim);
	}
	for (int k = 0; k < 3; k++) {
		step[k] = 1.0 / (100 << k);
		error[k] = fabs(z[k] - z[3]);
	}
	DECK_NEAR(deck_order(step, error, 3), 2, 0.15);
	DECK_NEAR(z[3] / amplitude, expected / amplitude, 2e-3);
}
END_TEST

/* A rough pad that slides: springs and film share the load, whatever the pad does, in any of both motions. */
START_TEST(film_and_pad)
{
	static const char *const motions[] = { "settled",
					       "dynamic mass 1e-9 inertia_1 2e-19 inertia_2 2e-19" };
	static const char *const films[] = { "", "cavitation reynolds cavity_pressure -3e4" };

	for (int k = 0; k < 4; k++) {
		struct tsim *sim =
			deck_open("units si\nboundary p p f\nregion box block 0 50e-6 0 40e-6 -20e-6 60e-6 "
				  "units box\n"
				  "create_box 1 box\n"
				  "fix pad all surface/voxel gaussian mean 5e-6 deviation 3e-6 correlation "
				  "4e-6 seed 2 type 1 cells 25 20 datum 0 move linear 0.7 0.2 0\n"
				  "fix w all wafer pad %s stiffness 1e12 pressure 1e5 friction 0.3 arm 3e-6\n"
				  "flow_style reynolds cells 25 20 lower_voxel pad upper_wafer w viscosity "
				  "0.5 density 1000 gap stepped least_gap 4e-7 open xlo xhi ylo yhi %s\n"
				  "compute film all film\ntimestep 1e-7\nrun 0\n",
				  motions[k / 2], films[k % 2]);
		double most = 0;

		for (int i = 0; i < 12; i++) {
			double load = 1e5 * 2e-9, pad = deck_value(sim, "f_w[4]"),
			       film = deck_value(sim, "f_w[8]");

			if (k < 2)
				DECK_NEAR((pad + film) / load, 1, 1e-11);
			DECK_NEAR(film, deck_value(sim, "c_film[1]"), 1e-12 * load);
			most = fmax(most, fabs(film / load));
			ck_assert(pad > 0 && deck_value(sim, "f_w[5]") > 0);
			deck(sim, "run 1\n");
		}
		ck_assert_msg(most > 0.1 && most < 3, "part of the film %g", most);
		tsim_close(sim);
	}
}
END_TEST

/* A wafer of little mass that sinks, tilts and is lifted again, in a film that breaks and heals: what leaves through the edges
 * is missing in the gap. */
START_TEST(volume_is_kept)
{
	struct tsim *sim = deck_open(
		"units si\nboundary f f f\nregion box block 0 1 0 1 -1 1 units box\ncreate_box 1 box\n"
		"variable p equal 300*(1+0.5*sin(9*time))\n"
		"fix pad all surface/voxel constant -0.5 type 1 cells 4 4\n"
		"fix w all wafer pad dynamic mass 0.1 inertia_1 0.01 inertia_2 0.01 joint_1 0.02 arm 0.1 "
		"stiffness 1e3 pressure v_p start 0.05 start_1 -0.01\n"
		"variable cx internal 0\nvariable wave equal 0.01*sin(20*v_cx)\n"
		"flow_style reynolds cells 20 20 lower v_wave set x cx lower_stays upper_wafer w "
		"lower_velocity 6 0 0 viscosity 1 density 1 cavitation jfo transient yes\n"
		"compute film all film\ntimestep 0.02\nrun 0\n");
	double volume = deck_value(sim, "c_film[18]"), cavity = 0;

	for (int k = 1; k <= 40; k++) {
		deck(sim, "run 1 pre no post no\n");
		volume -= 0.02 * deck_value(sim, "c_film[14]+c_film[15]+c_film[16]+c_film[17]");
		DECK_NEAR(deck_value(sim, "c_film[18]"), volume, 1e-12);
		cavity = fmax(cavity, deck_value(sim, "c_film[19]"));
	}
	ck_assert_msg(cavity > 0, "no cavity");
	tsim_close(sim);
}
END_TEST

/* A rough wafer at rest stands on its asperities, h = sigma where P = 16 sqrt(2) pi/15 (n b sigma)^2 E' sqrt(sigma/b) F_5/2(1);
 * the faster the pad, the more the film carries and the smaller is the friction. */
START_TEST(rough_wafer)
{
	const double crowd = 0.05, pressure = 16 * sqrt(2) * 3.14159265358979324 / 15 * crowd * crowd * 1e9 *
					      sqrt(0.1) * 0.0805623;
	double film[4], friction[4];

	for (int k = 0; k < 4; k++) {
		struct tsim *sim =
			deck_open("units si\nboundary f f f\nregion box block 0 1e-3 0 5e-4 -1e-4 1e-3 units "
				  "box\n"
				  "create_box 1 box\nfix pad all surface/voxel constant -5e-5 type 1 cells 4 "
				  "4\n"
				  "fix w all wafer pad settled stiffness 1e3 pressure %.17g joint_1 %g\n"
				  "flow_style reynolds cells 20 8 lower 0 lower_velocity %g 0 0 upper_wafer "
				  "w viscosity 1e-2 density 1000 roughness 1e-6 0 1 asperities 5e9 1e-5 1e9 "
				  "0.1 closed ylo yhi\ncompute film all film\nrun 0\n",
				  pressure, k ? 7e-5 : 0, k ? 1e-4 * pow(70, k - 1) : 0);
		double load = pressure * 5e-7, asperities = deck_value(sim, "f_w[13]");

		DECK_NEAR(deck_value(sim, "f_w[8]") / load, 1, 1e-11);
		DECK_NEAR(deck_value(sim, "c_film[1]+c_film[22]") / load, 1, 1e-11);
		DECK_NEAR(asperities, deck_value(sim, "c_film[22]"), 1e-12 * load);
		film[k] = 1 - asperities / load;
		friction[k] = deck_value(sim, "-c_film[8]+c_film[24]") / load;
		if (k == 0) {
			DECK_NEAR(deck_value(sim, "f_w[1]") / 1e-6, 1, 1e-6);
			DECK_NEAR(film[0], 0, 1e-11);
			DECK_NEAR(friction[0], 0, 1e-12);
		} else {
			ck_assert(film[k] > film[k - 1]);
		}
		tsim_close(sim);
	}
	ck_assert_msg(film[3] > 0.9 && friction[1] > 0.09 && friction[2] < friction[1], "%g %g %g %g %g",
		      film[1], film[2], film[3], friction[1], friction[2]);
}
END_TEST

static void refuses(const char *wafer, const char *film, const char *text)
{
	struct tsim *sim =
		deck_open("units si\nboundary p f f\nregion box block 0 1 0 1 -1 1 units box\n"
			  "create_box 1 box\nvariable zero equal 0*time\nvariable cx internal 0\n"
			  "variable hill equal 0.1*(v_cx>0.5)\n"
			  "fix pad all surface/voxel constant 0 type 1 cells 4 4\n"
			  "fix hills all surface/voxel formula v_hill x cx type 1 cells 4 4\n"
			  "fix half all surface/voxel constant 0 type 1 cells 4 4 size 0.5 0.5\n"
			  "fix belt all surface/voxel constant 0 type 1 cells 4 4 move linear 0 1 0\n");

	ck_assert_msg(!deck_accepts(sim,
				    "fix w all wafer %s\nflow_style reynolds cells 8 8 upper_wafer w "
				    "viscosity 1 density 1 %s\nrun 2\n",
				    wafer, film),
		      "accepted: %s; %s", wafer, film);
	ck_assert_msg(strstr(tsim_error(sim), text) != NULL, "%s; %s: %s", wafer, film, tsim_error(sim));
	tsim_close(sim);
}

#define SPRINGS " stiffness 1e3 pressure 10 "
#define SLIDES "lower 0 lower_velocity 1 0 0 open xlo xhi"

START_TEST(refusals)
{
	/* surfaces that overlap at the beginning, and touch */
	refuses("pad settled" SPRINGS "start -0.1", SLIDES,
		"the gap is -0.1 at (0.0625, 0.0625), the surfaces touch");
	refuses("pad settled" SPRINGS "start 0", SLIDES, "the gap is 0 at");
	refuses("pad settled" SPRINGS "start 0.1 start_1 0.3", SLIDES, "the surfaces touch or overlap");
	/* a film that cannot carry: a flat wafer held at its middle; nothing slides */
	refuses("pad settled" SPRINGS, "lower 0 open xlo xhi",
		"no place above the film where forces balance");
	/* the pad yields everywhere */
	refuses("hills settled hardness 5" SPRINGS,
		"lower_voxel hills least_gap 1e-3 gap stepped open xlo xhi", "the pad carries at most 5");
	refuses("hills settled" SPRINGS, "lower_voxel hills gap stepped open xlo xhi",
		"columns of a pad reach the wafer only if the flow style has a `least_gap`");
	refuses("hills settled" SPRINGS, "lower_voxel hills gap stepped open xlo xhi touching solid",
		"its forces jump; expected `least_gap`");
	refuses("pad settled joint_1 0.07" SPRINGS, SLIDES "\nfix grow all deform 1 x final 0 1.1",
		"the grid of the fluid (flow_style");
	refuses("pad settled joint_1 0.07" SPRINGS, SLIDES "\nrun 0\nchange_box all y final 0 1.1",
		"the film below it covers the box, the wafer the pad pad");
	refuses("half settled" SPRINGS, SLIDES,
		"expected a pad with normal z of the size of the box, from 0 to 1 along x");
	refuses("belt settled" SPRINGS, SLIDES, "it would leave the wafer");
	refuses("pad dynamic mass 0 inertia_1 1 inertia_2 1" SPRINGS, SLIDES, "mass");
	refuses("pad dynamic mass 1 inertia_1 -1 inertia_2 1" SPRINGS, SLIDES, "inertia_1");
	refuses("pad settled joint_1 0.6" SPRINGS, SLIDES, "the joint is 0.6 from the middle of the wafer");
	refuses("pad settled stiffness 1e3 pressure 0", SLIDES, "pressure is 0, expected a number > 0");
	refuses("pad settled stiffness 1e3 pressure v_zero", SLIDES, "the back pressure is 0, must be > 0");
	refuses("pad settled" SPRINGS, "lower 0 cavitation half open xlo xhi",
		"not possible with cavitation half");
	refuses("pad settled" SPRINGS, "lower 0 update run open xlo xhi", "not possible with `update run`");
	refuses("pad settled" SPRINGS, "lower 0 barus 1e-9 open xlo xhi",
		"a viscosity that depends on the pressure");
	refuses("pad settled" SPRINGS, "lower 0 upper_velocity 0 0 1 open xlo xhi", "the wafer has its own");
	refuses("pad settled" SPRINGS, "lower 0 upper_wafer w open xlo xhi", "upper_wafer");
	refuses("pad settled" SPRINGS, "lower 0 cavitation jfo transient yes open xlo xhi",
		"give `start` and a height");
	refuses("pad dynamic mass 1 inertia_1 1 inertia_2 1" SPRINGS, "lower 0 cavitation jfo open xlo xhi",
		"then needs `transient yes`");
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("floating");
	TCase *tcase = tcase_create("floating");

	tcase_set_timeout(tcase, 100);
	tcase_add_test(tcase, pivoted_slider);
	tcase_add_test(tcase, same_end);
	tcase_add_test(tcase, squeezed_strip);
	tcase_add_test(tcase, small_oscillation);
	tcase_add_test(tcase, film_and_pad);
	tcase_add_test(tcase, volume_is_kept);
	tcase_add_test(tcase, rough_wafer);
	tcase_add_test(tcase, refusals);
	suite_add_tcase(suite, tcase);
	return deck_main(suite);
}
