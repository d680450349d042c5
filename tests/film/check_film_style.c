/* Flow_style reynolds and compute film: exact films, the velocity that drag fixes feel, surfaces, refusals. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "deck.h"

/* A slider over a plane that moves with speed U: gap 2 h to h on the length 1000 h; all in units of h. */
static struct tsim *slider(double h, const char *words)
{
	return deck_open("units si\n"
			 "atom_style granular\n"
			 "atom_modify map array\n"
			 "boundary f f f\n"
			 "region box block 0 %.17g 0 %.17g 0 %.17g units box\n"
			 "create_box 1 box\n"
			 "variable cx internal 0\n"
			 "variable wedge equal %.17g*(2-v_cx/%.17g)\n"
			 "flow_style reynolds cells 200 3 lower 0 upper v_wedge set x cx lower_velocity "
			 "%.17g 0 0 viscosity 2.5 density 1000 closed ylo yhi %s\n"
			 "compute film all film\n"
			 "timestep 1e-9\n",
			 1000 * h, 500 * h, 3 * h, h, 1000 * h, h, words);
}

/* K = 2: W = 0.158883 eta U L^2/h^2 per width, F = 0.772589 eta U L/h, p_max = eta U L/(4 h^2), q = 2/3 U h; the same in
 * micrometres, metres and kilometres. */
START_TEST(slider_in_all_units)
{
	for (int k = 0; k < 3; k++) {
		double h = (const double[]){ 1e-9, 1e-3, 1e3 }[k], u = h;
		struct tsim *sim = slider(h, "");
		double force = 2.5 * u * 1000 * 500 * h;

		deck(sim, "run 0\n");
		DECK_NEAR(deck_value(sim, "c_film[1]") / (force * 1000), 0.158883, 4e-6);
		DECK_NEAR(deck_value(sim, "c_film[2]") / (1000 * h), 0.568688, 5e-6);
		DECK_NEAR(deck_value(sim, "c_film[3]") / (500 * h), 0.5, 1e-12);
		DECK_NEAR(deck_value(sim, "c_film[4]") / (2.5 * u * 1000 / h), 0.25, 1e-6);
		DECK_NEAR(deck_value(sim, "c_film[5]") / (1000 * h), 2.0 / 3, 3e-5);
		DECK_NEAR(deck_value(sim, "c_film[8]") / force, -0.772589, 1e-5);
		DECK_NEAR((deck_value(sim, "c_film[8]") + deck_value(sim, "c_film[10]") +
			   deck_value(sim, "c_film[12]")) /
				  force,
			  0, 1e-12);
		DECK_NEAR(deck_value(sim, "c_film[15]") / (u * h * 500 * h), 2.0 / 3, 1e-12);
		DECK_NEAR(deck_value(sim, "c_film[18]") / (1.5 * h * 1000 * h * 500 * h), 1, 1e-12);
		ck_assert(deck_value(sim, "c_film[19]") == 0 && deck_value(sim, "c_film[21]") == 0);
		DECK_NEAR(deck_value(sim, "c_film[1][4]"), 0, 1e-2 * deck_value(sim, "c_film[4]"));
		DECK_NEAR(deck_value(sim, "c_film[100][3]") / h, 1.5025, 1e-12);
		tsim_close(sim);
	}
}
END_TEST

/* The Stokes drag on a sphere at rest is 3 pi eta d u: inside the gap, below and above it. */
START_TEST(velocity_in_the_gap)
{
	struct tsim *sim = slider(1, "");
	const double c = 3 * 3.14159265358979324 * 2.5 * 1e-3;

	deck(sim, "create_atoms 1 single 250 250 0.5 units box\n"
		  "create_atoms 1 single 250 250 2.5 units box\n"
		  "create_atoms 1 single 750 3 1.1 units box\n"
		  "set group all diameter 1e-3 density 1000\n"
		  "fix d all drag/stokes\n"
		  "compute q all film/atom\n"
		  "run 0\n");
	for (int k = 0; k < 3; k += 2) {
		double x = k ? 0.75 : 0.25, z = k ? 1.1 : 0.5, h = 2 - x, s = z / h, mean = 2.0 / 3 / h;
		double u = 1 - s + 6 * s * (1 - s) * (mean - 0.5);
		DECK_NEAR(deck_value(sim, k ? "fx[3]" : "fx[1]") / c, u, 1e-9);
		/* w = s u dh/dx - (f1 - f3/2) dh/dx, f1 = s - s^2/2, f3 = 3 s^2 - 2 s^3 */
		DECK_NEAR(deck_value(sim, k ? "fz[3]" : "fz[1]") / c,
			  -1e-3 * (s * u - (s - s * s / 2 - s * s * (3 - 2 * s) / 2)), 1e-9);
	}
	DECK_NEAR(deck_value(sim, "c_q[1][1]"), 2500 * 6 * (2 - 1.75) * 0.75 / (1.75 * 1.75 * 3), 1e-2);
	DECK_NEAR(deck_value(sim, "c_q[3][2]"), 1.25, 1e-12);
	DECK_NEAR(deck_value(sim, "c_q[3][3]"), 0.88, 1e-12);
	DECK_NEAR(deck_value(sim, "c_q[2][3]"), 2.5 / 1.75, 1e-12);
	DECK_NEAR(deck_value(sim, "c_q[1][4]"), deck_value(sim, "fx[1]") / c, 1e-12);
	DECK_NEAR(deck_value(sim, "fx[2]"), 0, 1e-15); /* above: at rest as the upper surface */
	tsim_close(sim);
}
END_TEST

/* Slip at both surfaces, b = h/2: the flow is that of the closed solution in any units, and the fluid at the surfaces
 * moves as film/atom shows. */
START_TEST(slip_in_all_units)
{
	/* integrals of couette/poiseuille and of 1/poiseuille over the gap */
	const double q = (log(2 / 5.0) - log(1 / 4.0)) / 6 / (1 / 6.0 - (log(2 / 5.0) - log(1 / 4.0)) / 9);

	for (int k = 0; k < 3; k++) {
		double h = (const double[]){ 1e-9, 1e-3, 1e3 }[k], u = h, low, mean, high;
		char words[200];
		struct tsim *sim;

		snprintf(words, sizeof words, "upper_slip %.17g lower_slip %.17g", h / 2, h / 2);
		sim = slider(h, words);
		snprintf(words, sizeof words, "create_atoms 1 single %.17g %.17g %.17g units box\n", 505 * h,
			 250 * h, 1e-12 * h);
		deck(sim, words);
		snprintf(words, sizeof words, "create_atoms 1 single %.17g %.17g %.17g units box\n", 505 * h,
			 250 * h, 2 * h);
		deck(sim, words);
		deck(sim, "compute q all film/atom\nrun 0\n");
		DECK_NEAR(deck_value(sim, "c_film[15]") / (u * h * 500 * h), q, 1e-11);
		low = deck_value(sim, "c_q[1][4]") / u;
		high = deck_value(sim, "c_q[2][4]") / u;
		/* (h + 4 b) U1' + 2 b U2' = h U1 + 6 b q/h and the same for U2', h = 1.495 */
		mean = q / 1.495;
		DECK_NEAR((1.495 + 2) * low + high, 1.495 + 3 * mean, 1e-9);
		DECK_NEAR((1.495 + 2) * high + low, 3 * mean, 1e-9);
		DECK_NEAR((deck_value(sim, "c_film[8]") + deck_value(sim, "c_film[10]") +
			   deck_value(sim, "c_film[12]")) /
				  (2.5 * u * 1000 * 500 * h),
			  0, 1e-12);
		tsim_close(sim);
	}
}
END_TEST

/* Barus: the largest pressure is -ln(1 - alpha q)/alpha with that of constant viscosity, q = eta U L/(4 h^2), and the
 * same in all units; Roelands with Z = 1 is the same. */
START_TEST(viscosity_of_the_pressure)
{
	for (int k = 0; k < 6; k++) {
		double h = (const double[]){ 1e-9, 1e-3, 1e3 }[k / 2], q = 2.5 * 1000 / 4.0;
		char words[100];
		struct tsim *sim;

		if (k % 2)
			snprintf(words, sizeof words, "roelands %.17g 1000 1", 2.5 * exp(-0.8));
		else
			snprintf(words, sizeof words, "barus 8e-4");
		sim = slider(h, words);
		deck(sim, "run 0\n");
		DECK_NEAR(deck_value(sim, "c_film[4]") * 8e-4 / -log(1 - 8e-4 * q), 1, 1e-5);
		DECK_NEAR(deck_value(sim, "c_film[15]") / (h * h * 500 * h), 2.0 / 3, 1e-11);
		tsim_close(sim);
	}
}
END_TEST

/* A plate that slides over a rough one at rest, in all units: q = U (h - sigma phi_s)/2. */
START_TEST(rough_surfaces)
{
	for (int k = 0; k < 3; k++) {
		double h = (const double[]){ 1e-9, 1e-3, 1e3 }[k];
		struct tsim *sim =
			deck_open("units si\nboundary f f f\n"
				  "region box block 0 %.17g 0 %.17g 0 %.17g units box\n"
				  "create_box 1 box\n"
				  "flow_style reynolds roughness %.17g 0 1/3 cells 20 3 lower 0 upper %.17g "
				  "upper_velocity %.17g 0 0 viscosity 3 density 1 closed ylo yhi\n"
				  "compute film all film\ntimestep 1e-9\nrun 0\n",
				  100 * h, 10 * h, 9 * h, h, 8 * h, h);

		DECK_NEAR(deck_value(sim, "c_film[15]") / (h * h * 10 * h), 4 - 1.561 * exp(-2) / 2, 1e-12);
		DECK_NEAR(deck_value(sim, "c_film[8]/c_film[10]"), -1, 1e-12); /* 8 standard deviations */
		ck_assert(deck_value(sim, "c_film[22]") == 0);
		ck_assert(isfinite(deck_value(sim, "c_film[1]")));
		tsim_close(sim);
	}
}
END_TEST

/* A rigid slider that moves to the left over a plane at rest is the same film. If its shape stays while its material
 * slides, the gap does not change, and half of the film is due to each surface. */
START_TEST(moving_shapes)
{
	struct tsim *sim = slider(1, "");
	double load;

	deck(sim, "run 0\n");
	load = deck_value(sim, "c_film[1]");
	deck(sim, "flow_style none\n"
		  "flow_style reynolds cells 200 3 lower 0 upper v_wedge set x cx upper_velocity -1 0 0 "
		  "viscosity 2.5 density 1000 closed ylo yhi\nrun 0\n");
	DECK_NEAR(deck_value(sim, "c_film[1]") / load, 1, 1e-4);
	deck(sim, "flow_style none\n"
		  "flow_style reynolds cells 200 3 lower 0 upper v_wedge set x cx upper_velocity 1 0 0 "
		  "upper_stays viscosity 2.5 density 1000 closed ylo yhi\nrun 0\n");
	DECK_NEAR(deck_value(sim, "c_film[1]") / load, 1, 1e-12);
	deck(sim, "flow_style none\n"
		  "flow_style reynolds cells 200 3 lower 0 upper v_wedge set x cx upper_velocity 1 0 0 "
		  "upper_stays lower_velocity -1 0 0 viscosity 2.5 density 1000 closed ylo yhi\nrun 0\n");
	DECK_NEAR(deck_value(sim, "c_film[1]") / load, 0, 1e-12);
	tsim_close(sim);
}
END_TEST

/* A plate that sinks on a film: height by a formula in time, W = eta V B^3 L/h^3 follows it; with `update run` it does
 * not. */
START_TEST(squeeze_in_time)
{
	for (int once = 0; once < 2; once++) {
		struct tsim *sim =
			deck_open("units si\nboundary f f f\nregion box block 0 1 0 2 0 1 units box\n"
				  "create_box 1 box\n"
				  "variable h equal 0.1-0.5*time\n"
				  "flow_style reynolds cells 100 3 lower 0 upper v_h upper_velocity 0 0 -0.5 "
				  "viscosity 3 density 1 closed ylo yhi update %s\n"
				  "compute film all film\ntimestep 0.01\nrun 10\n",
				  once ? "run" : "step");
		double h = once ? 0.1 : 0.05;

		DECK_NEAR(deck_value(sim, "c_film[1]") * h * h * h / (3 * 0.5 * 2), 1, 3e-4);
		DECK_NEAR(deck_value(sim, "c_film[14]+c_film[15]"), 1, 1e-10);
		if (!once) {
			ck_assert(!deck_accepts(sim, "run 10\n"));
			ck_assert_msg(strstr(tsim_error(sim),
					     "the surfaces touch or overlap; with `touching solid`"),
				      "%s", tsim_error(sim));
		}
		tsim_close(sim);
	}
}
END_TEST

/* A Rayleigh step of voxel columns that faces a plane which slides: p = 6 eta U (h1 - h2)/(h1^3/L1 + h2^3/L2). As deep as
 * the plane the columns are solid, or refused. */
START_TEST(voxel_step)
{
	const char scene[] =
		"units si\natom_style granular\nboundary f f f\nregion box block 0 1 0 0.5 0 1 units box\n"
		"create_box 1 box\n"
		"variable cx internal 0\nvariable s equal 0.1*(v_cx>%s)\n"
		"fix pad all surface/voxel formula v_s x cx type 1 cells 10 1\n"
		"flow_style reynolds cells 40 4 lower_voxel pad upper %s upper_velocity 2 0 0 viscosity 0.5 "
		"density 1 gap stepped closed ylo yhi touching solid\n"
		"compute film all film\nrun 0\n";
	struct tsim *sim = deck_open(scene, "0.7", "0.225");

	DECK_NEAR(deck_value(sim, "c_film[1]"),
		  0.25 * 6 * 0.5 * 2 * 0.1 / (pow(0.225, 3) / 0.7 + pow(0.125, 3) / 0.3), 1e-10);
	tsim_close(sim);
	sim = deck_open(scene, "0.7", "0.1"); /* a dam: at p = 6 eta U L/h^2 nothing flows */
	DECK_NEAR(deck_value(sim, "c_film[15]"), 0, 1e-15);
	DECK_NEAR(deck_value(sim, "c_film[14]"), 0, 1e-12);
	DECK_NEAR(deck_value(sim, "c_film[18]"), 0.1 * 0.7 * 0.5, 1e-12);
	tsim_close(sim);
	sim = deck_open(scene, "0", "0.1"); /* no fluid at all */
	DECK_NEAR(deck_value(sim, "c_film[1]"), 0, 0);
	for (int column = 4; column <= 7; column++) {
		char name[16];

		snprintf(name, sizeof name, "c_film[%d]", column);
		ck_assert_msg(isnan(deck_value(sim, name)), "%s", name);
	}
	tsim_close(sim);
}
END_TEST

/* Diverging gap: below ambient without cavitation, above the pressure of the cavity with it; jfo conserves volume. */
START_TEST(cavitation)
{
	static const char *const names[] = { "none", "half", "reynolds", "jfo" };

	for (int k = 0; k < 4; k++) {
		struct tsim *sim =
			deck_open("units si\nboundary f p f\nregion box block 0 2 0 1 0 2 units box\n"
				  "create_box 1 box\n"
				  "variable cx internal 0\nvariable h equal 1+0.5*cos(PI*v_cx)\n"
				  "flow_style reynolds cells 200 3 lower 0 lower_velocity 1 0 0 upper v_h "
				  "set x cx viscosity 1 density 1 cavitation %s ambient 5 cavity_pressure 5 "
				  "pressure_xhi 5.1\n"
				  "compute film all film\nrun 0\n",
				  names[k]);
		double net = deck_value(sim, "c_film[14]+c_film[15]");

		ck_assert((deck_value(sim, "c_film[1]") > 0.3) == (k > 0));
		ck_assert((deck_value(sim, "c_film[19]") > 0) == (k > 0));
		ck_assert((deck_value(sim, "c_film[21]") > 1e-3) == (k == 1 || k == 2));
		if (k != 1)
			DECK_NEAR(net, deck_value(sim, "c_film[21]"), 1e-12);
		ck_assert((deck_value(sim, "c_film[150][5]") > 0.1) == (k == 3));
		tsim_close(sim);
	}
}
END_TEST

/* A plate that rises and sinks again: a cavity opens and closes; what leaves through the edges is missing in the gap, in
 * each step. A film that stays full is that without cavitation. */
/* A plane, at any height, slides along both axes below a shape at rest: the gap stays, up to round-off, as jfo without
 * `transient` needs. */
START_TEST(plane_below_a_shape)
{
	static const double heights[] = { 0, -1e-7, 3.3e-8 };
	static const double speeds[][2] = { { 0.1, 0 }, { 0.1, 0.03 }, { 7, 0.7 } };

	for (int h = 0; h < 3; h++)
		for (int u = 0; u < 3; u++) {
			struct tsim *sim =
				deck_open("units si\n"
					  "boundary f f f\n"
					  "region box block 0 1e-3 0 0.4e-3 0 1e-5 units box\n"
					  "create_box 1 box\n"
					  "variable x internal 0\n"
					  "variable y internal 0\n"
					  "variable h equal 2e-6-1e-3*v_x+1e-7*cos(PI*v_y/0.2e-3)\n"
					  "flow_style reynolds cells 30 12 lower %g lower_velocity %g %g 0 "
					  "upper v_h "
					  "set x x y y viscosity 1e-3 density 1000 cavitation jfo\n"
					  "compute f all film\n",
					  heights[h], speeds[u][0], speeds[u][1]);

			deck(sim, "run 0\n");
			ck_assert(deck_value(sim, "c_f[1]") > 0);
			tsim_close(sim);
		}
}
END_TEST

START_TEST(transient)
{
	struct tsim *sim =
		deck_open("units si\nboundary f f f\nregion box block 0 1 0 1 0 1 units box\n"
			  "create_box 1 box\n"
			  "variable h equal 0.1+0.04*sin(2*PI*time)\n"
			  "flow_style reynolds cells 20 20 lower 0 upper v_h upper_velocity 0 0 0.25 "
			  "lower_velocity 0.1 0 0 viscosity 1 density 1 cavitation jfo transient yes\n"
			  "compute film all film\ntimestep 0.02\nrun 0\n");
	double volume = deck_value(sim, "c_film[18]"), most = 0;

	for (int k = 1; k <= 50; k++) {
		deck(sim, "run 1 pre no post no\n");
		volume -= 0.02 * deck_value(sim, "c_film[14]+c_film[15]+c_film[16]+c_film[17]");
		DECK_NEAR(deck_value(sim, "c_film[18]"), volume, 1e-13);
		ck_assert(deck_value(sim, "c_film[21]") == 0 && deck_value(sim, "c_film[1]") >= 0);
		most = fmax(most, deck_value(sim, "c_film[19]"));
	}
	ck_assert(most == 400 && volume < 0.1);
	deck(sim, "run 0\n"); /* the same time again: the same film */
	DECK_NEAR(deck_value(sim, "c_film[18]"), volume, 1e-13);
	tsim_close(sim);
}
END_TEST

static void refuses(const char *boundary, const char *words, const char *text)
{
	struct tsim *sim =
		deck_open("units si\natom_style granular\nboundary %s\n"
			  "region box block 0 1 0 1 0 1 units box\ncreate_box 1 box\n"
			  "variable cx internal 0\n"
			  "fix pad all surface/voxel constant 0.1 type 1 cells 4 4 normal x base 0\n"
			  "fix half all surface/voxel constant 0.1 type 1 cells 4 4 size 0.5 0.5\n"
			  "variable step equal 0.1*(v_cx>0.5)\n"
			  "fix block all surface/voxel formula v_step x cx type 1 cells 4 4\n",
			  boundary);

	ck_assert_msg(!deck_accepts(sim, "flow_style reynolds %s\nrun 0\n", words), "accepted: %s", words);
	ck_assert_msg(strstr(tsim_error(sim), text) != NULL, "%s", tsim_error(sim));
	tsim_close(sim);
}

#define FILM "cells 8 8 viscosity 1 density 1 "

START_TEST(refusals)
{
	refuses("f f f", FILM "lower 0", "where is the upper surface?");
	refuses("f f f", FILM "upper 1", "where is the lower surface?");
	refuses("f f f", FILM "upper 1 lower 0 lower_voxel half", "is given twice");
	refuses("f f f", FILM "upper 1 lower_voxel none", "there is no height field 'none'");
	refuses("f f f", FILM "upper 1 lower_voxel pad", "the normal of fix 'pad' is not z");
	refuses("f f f", FILM "upper 1 lower_voxel half", "has no column at (0.5625, 0.0625)");
	refuses("f f f", FILM "lower 0 upper_voxel block",
		"from which height do the columns of 'block' hang?");
	refuses("f f f", FILM "lower 0 upper 1 upper_voxel pad", "the normal of fix 'pad' is not z");
	refuses("f f f", FILM "lower 0 upper 1 upper_voxel half", "has no column at (0.5625, 0.0625)");
	refuses("f f f", FILM "lower 0 upper 0.05 upper_voxel block", "the gap is -0.05 at");
	refuses("f f f", FILM "lower 0 upper_wafer w", "there is no fix 'w'; expected the ID of a fix wafer");
	refuses("f f f", FILM "lower 0 upper_wafer pad", "is of style surface/voxel, expected wafer");
	refuses("f f f", FILM "lower 0 upper 1 upper_wafer w", "is given twice");
	refuses("f f f", FILM "lower 0 upper 1 least_gap -1", "least_gap");
	refuses("f f f", FILM "upper 1 lower 0 open xlo xhi", "the box is not periodic there");
	refuses("p f f", FILM "upper 1 lower 0 open xlo",
		"the edge xhi is not open, but the opposite one is");
	refuses("f f f", FILM "upper 1 lower 1", "the gap is 0 at (0.0625, 0.0625), the surfaces touch");
	refuses("f f f", FILM "upper 1 lower 2", "the gap is -1 at");
	refuses("f f f", FILM "upper 1 lower 0\nfix d all deform 1 y erate 1",
		"does not change with the box");
}
END_TEST

START_TEST(refused_fluids)
{
	refuses("f f f", "cells 8 8 viscosity 0 density 1 upper 1 lower 0", "viscosity");
	refuses("f f f", "cells 8 8 viscosity -1 density 1 upper 1 lower 0", "viscosity");
	refuses("f f f", "cells 8 8 viscosity 1 density 0 upper 1 lower 0", "density");
	refuses("f f f", FILM "upper 1 lower 0 lower_slip -1", "lower_slip");
	refuses("f f f", FILM "upper 1 lower 0 roughness 0.1 0.1", "GAMMA");
	refuses("f f f", FILM "upper 1 lower 0 roughness 0.1 0.1 2", "'2'");
	refuses("f f f", FILM "upper 1 lower 0 roughness -0.1 0.1 3", "SIGMA_LOWER");
	refuses("f f f", FILM "upper 1 lower 0 roughness 0.3 0.3 3",
		"below 3 the surfaces touch; expected `asperities`");
	refuses("f f f", FILM "upper 1 lower 0 roughness 0.1 0.1 3 cavitation jfo",
		"not known for cavitation jfo");
	refuses("f f f", FILM "upper 1 lower 0 roughness 0.1 0.1 3 upper_slip 1", "not known for slip");
	refuses("f f f", FILM "upper 1 lower 0 asperities 1 1 1 0", "expected `roughness`, too");
	refuses("f f f", FILM "upper 1 lower 0 roughness 1 1 3 asperities 1 1 0 0", "MODULUS");
	refuses("f f f", FILM "upper 1 lower 0 roughness 1 1 3 asperities 1 1 1 -1", "FRICTION");
	refuses("f f f", FILM "upper 1 lower 0 roughness 1 1 1 asperities 1 1 1", "FRICTION");
	refuses("f f f", FILM "upper 1 lower 0 roughness 1.8 1.8 1 asperities 1 1 1 0",
		"0.392837 standard deviations of the roughness: flow factors are not known");
	refuses("f f f", FILM "upper 1 lower 0 barus -1", "barus");
	refuses("f f f", FILM "upper 1 lower 0 barus 1 roelands 0.1 1 0.6", "found both");
	refuses("f f f", FILM "upper 1 lower 0 roelands 0.1 1", "Z");
	refuses("f f f", FILM "upper 1 lower 0 roelands 2 1 0.6", "less than that at pressure 0, 1");
	refuses("f f f", FILM "upper 1 lower 0 barus 1\nfix d all drag/stokes",
		"takes one viscosity from the flow style");
	refuses("f f f", "cells 8 viscosity 1 density 1 upper 1 lower 0", "NY");
	refuses("f f f", "cells 0 8 viscosity 1 density 1 upper 1 lower 0", "NX");
	refuses("f f f", "cells 9000 9000 viscosity 1 density 1 upper 1 lower 0",
		"too many: at most 4000000");
	refuses("f f f", FILM "upper 1 lower 0 closed xlo pressure_xlo 1",
		"the edge xlo is closed, and a pressure");
	refuses("f f f", FILM "upper 1 lower 0 closed xlo xhi ylo yhi", "no pressure is given at any border");
	refuses("f f f", FILM "upper 1 lower 0 closed zlo", "'zlo'");
	refuses("p f f", FILM "upper 1 lower 0 closed xlo", "is closed, but the box is periodic there");
	refuses("p f f", FILM "upper 1 lower 0 pressure_xhi 1", "has a pressure, but the box is periodic");
	refuses("p f f", "cells 2 8 viscosity 1 density 1 upper 1 lower 0", "expected at least 3");
	refuses("s f f", FILM "upper 1 lower 0", "xlo follows the particles");
	refuses("f f f", FILM "upper 1 lower 0 set z cx", "not of z");
	refuses("f f f", FILM "upper 1 lower 0 lower_velocity 0 0 1 cavitation jfo",
		"the gap changes at (0.0625, 0.0625) by -1 per time");
	refuses("f f f", FILM "upper 1 lower 0 transient yes", "is for cavitation jfo only");
	refuses("f f f", FILM "upper 1 lower 0 cavitation jfo transient yes update run",
		"needs `update step`");
	refuses("f f f", FILM "upper 1 lower 0 cavitation jfo transient yes touching solid",
		"conserves the fluid");
	refuses("f f f", FILM "upper 1 lower 0 cavitation reynolds cavity_pressure 1",
		"is below that in the cavity, 1");
	refuses("f f f", FILM "upper 1 lower 0 cavity_pressure -1", "has no effect without `cavitation`");
	refuses("f f f", FILM "upper 1 lower 0\nfix d all immersed/boundary region box", "solved for");
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("film_style");
	TCase *tcase = tcase_create("film_style");

	tcase_set_timeout(tcase, 100);
	tcase_add_test(tcase, slider_in_all_units);
	tcase_add_test(tcase, velocity_in_the_gap);
	tcase_add_test(tcase, slip_in_all_units);
	tcase_add_test(tcase, rough_surfaces);
	tcase_add_test(tcase, viscosity_of_the_pressure);
	tcase_add_test(tcase, moving_shapes);
	tcase_add_test(tcase, squeeze_in_time);
	tcase_add_test(tcase, voxel_step);
	tcase_add_test(tcase, cavitation);
	tcase_add_test(tcase, plane_below_a_shape);
	tcase_add_test(tcase, transient);
	tcase_add_test(tcase, refusals);
	tcase_add_test(tcase, refused_fluids);
	suite_add_tcase(suite, tcase);
	return deck_main(suite);
}
