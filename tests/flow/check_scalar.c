/* What the fluid carries: orders, bounds, and heat that is neither made nor lost. */
#include "deck.h"
#include "flow/flow.h"
#include "flow/fluid.h"

static const double PI = 3.14159265358979323846;

/* Rows of the array output of fix T: x y z T. */
static const struct ts_table *cells(struct tsim *sim)
{
	struct ts_instance *fix = ts_sim_find(sim, TS_KIND_FIX, "T");
	static struct ts_table table;

	ck_assert_int_eq(ts_value_eval(fix, sim, ts_value_find(fix, TS_ARRAY), &table), TS_OK);
	return &table;
}

static const char plane[] = "units si\ndimension 2\nboundary %s\n"
			    "region box block 0 1 0 1 -0.5 0.5 units box\ncreate_box 1 box\n";

/* Mean error of a wave that is carried obliquely and dies out. */
static double wave_error(int n, const char *scheme)
{
	const double nu = 0.003, k = 2 * PI, time = 0.25, decay = exp(-2 * k * k * nu * time);
	const struct ts_table *table;
	struct tsim *sim;
	double sum = 0;
	char box[512];

	snprintf(box, sizeof box, plane, "p p p");
	sim = deck_open("%svariable xx internal 0\nvariable yy internal 0\n"
			"variable T0 equal 2.385+sin(2*PI*v_xx)*cos(2*PI*v_yy)\n"
			"flow_style projection cells %d %d 1 viscosity 0 density 731 convection central time "
			"rk3\n"
			"flow_set velocity 0.7 0.3 0\n"
			"fix T all flow/scalar conductivity $(0.003*731*5) capacity 5 initial v_T0 set x xx "
			"set y yy convection %s\n"
			"timestep $(0.025/%d)\nrun %d",
			box, n, n, scheme, n, 10 * n);
	table = cells(sim);
	for (size_t i = 0; i < table->rows; i++) {
		const double *row = table->data + 4 * i;

		sum += fabs(row[3] - 2.385 -
			    decay * sin(k * (row[0] - 0.7 * time)) * cos(k * (row[1] - 0.3 * time)));
	}
	sum /= (double)table->rows;
	DECK_NEAR(deck_value(sim, "f_T[1]"), 731 * 5 * 2.385, 1e-9);
	tsim_close(sim);
	return sum;
}

START_TEST(orders)
{
	static const struct {
		const char *scheme;
		double order;
	} schemes[] = { { "central", 1.95 }, { "vanleer", 1.6 }, { "donor", 0.6 } };
	double coarse = wave_error(16, schemes[_i].scheme), fine = wave_error(32, schemes[_i].scheme);

	ck_assert_msg(log2(coarse / fine) > schemes[_i].order, "%s: %g, %g", schemes[_i].scheme, coarse,
		      fine);
	ck_assert(fine < (_i == 2 ? 0.2 : 0.02));
}
END_TEST

/* Through a plate of fluid at rest, and what a flux brings. */
START_TEST(conduction)
{
	const struct ts_table *table;
	struct tsim *sim;
	char box[512];

	snprintf(box, sizeof box, plane, "f p p");
	sim = deck_open("%sflow_style projection cells 10 2 1 viscosity 1e-3 density 731\n"
			"fix T all flow/scalar conductivity 7.31 capacity 0.5 initial 3 xlo value 2.385 xhi "
			"value 4.1\ntimestep 0.5\nrun 500",
			box);
	table = cells(sim);
	for (size_t i = 0; i < table->rows; i++)
		DECK_NEAR(table->data[4 * i + 3], 2.385 + (4.1 - 2.385) * table->data[4 * i], 1e-13);
	tsim_close(sim);
	sim = deck_open("%sflow_style projection cells 10 2 1 viscosity 1e-3 density 731\n"
			"variable q equal 3+step\n"
			"fix T all flow/scalar conductivity 7.31 capacity 0.5 initial 3 xlo flux 2.385 xhi "
			"flux v_q source 0.13\ntimestep 0.01\nrun 10",
			box);
	/* the mean flux of step n is 3 + n - 1/2 */
	DECK_NEAR(deck_value(sim, "f_T[1]"), 731 * 0.5 * 3 + 0.01 * (10 * 2.385 + 10 * 3 + 50 + 10 * 0.13),
		  1e-11);
	tsim_close(sim);
}
END_TEST

/* A source that grows with time: the integral of 3 + 100 t. */
START_TEST(source_that_varies)
{
	static const char *const fluids[] = { "", "every 4", "substeps 3" };
	struct tsim *sim;
	char box[512];

	snprintf(box, sizeof box, plane, "p p p");
	sim = deck_open("%sflow_style projection cells 4 4 1 viscosity 1e-3 density 731 %s\n"
			"variable s equal 3+100*time\n"
			"fix T all flow/scalar initial 3 source v_s\ntimestep 0.01\nrun 8\nrun 0\nrun 4",
			box, fluids[_i]);
	DECK_NEAR(deck_value(sim, "f_T[1]"), 731 * 3 + 3 * 0.12 + 50 * 0.12 * 0.12, 1e-10);
	tsim_close(sim);
}
END_TEST

/* Mean error of 5 + exp(-y) cos(t - y), which a diffusivity 1/2 and its values on the faces give, at t = 1. */
static double error_of_varying_value(int steps)
{
	const struct ts_table *table;
	struct tsim *sim;
	double sum = 0;

	sim = deck_open("units si\nboundary p f p\nregion box block 0 1 0 1 0 1 units box\ncreate_box 1 box\n"
			"variable yy internal 0\nvariable T0 equal 5+exp(-v_yy)*cos(v_yy)\n"
			"variable lo equal 5+cos(time)\nvariable hi equal 5+exp(-1)*cos(time-1)\n"
			"flow_style projection cells 1 8 1 viscosity 1e-3 density 1\n"
			"fix T all flow/scalar conductivity 0.5 initial v_T0 set y yy ylo value v_lo yhi "
			"value v_hi\ntimestep $(1/%d)\nrun %d",
			steps, steps);
	table = cells(sim);
	for (size_t i = 0; i < table->rows; i++) {
		const double *row = table->data + 4 * i;

		sum += row[3] - 5 - exp(-row[1]) * cos(1 - row[1]);
	}
	tsim_close(sim);
	return sum / 8;
}

START_TEST(value_that_varies)
{
	double of_cells = error_of_varying_value(1600), error[2];

	for (int k = 0; k < 2; k++)
		error[k] = fabs(error_of_varying_value(100 << k) - of_cells);
	ck_assert(fabs(of_cells) < 2e-3);
	ck_assert_msg(log2(error[0] / error[1]) > 1.8, "%g, %g", error[0], error[1]);
}
END_TEST

/* What is given on a face is the value there, between the last centre and the face, and at periodic edges. */
START_TEST(values_on_faces)
{
	static const char *const ways[] = { "linear", "cubic" };
	struct tsim *sim;
	char box[512];

	snprintf(box, sizeof box, plane, "p f p");
	sim = deck_open("%sflow_style projection cells 4 8 1 viscosity 0.1 density 1\n"
			"fix T all flow/scalar conductivity 0.1 initial 300 ylo value 400\n"
			"compute p all flow/probe 0.5 0 0 0.5 0.03125 0 0 0.03125 0 0.5 1 0 values f_T "
			"interpolation %s\ntimestep 1e-3\nrun 0",
			box, ways[_i]);
	DECK_NEAR(deck_value(sim, "c_p[1][1]"), 400, 1e-10);
	/* by the values 400, 300, 300, 300 at 0, 1/2, 3/2, 5/2 cells */
	for (int k = 0; k < 2; k++)
		DECK_NEAR(deck_value(sim, k ? "c_p[3][1]" : "c_p[2][1]"),
			  _i ? 300 + 100 * 0.25 * 1.25 * 2.25 / 1.875 : 350, 1e-10);
	DECK_NEAR(deck_value(sim, "c_p[4][1]"), 300, 1e-10);
	deck(sim, "run 5");
	DECK_NEAR(deck_value(sim, "c_p[1][1]"), 400, 1e-10);
	tsim_close(sim);
}
END_TEST

/* What is convected and does not conduct does not grow with central differences. */
START_TEST(central_waves_do_not_grow)
{
	struct tsim *sim;
	char box[512];

	snprintf(box, sizeof box, plane, "p p p");
	sim = deck_open("%svariable xx internal 0\nvariable T0 equal sin(16*PI*v_xx)\n"
			"flow_style projection cells 32 2 1 viscosity 0 density 1 convection central time "
			"rk3\n"
			"flow_set velocity 1 0 0\n"
			"fix T all flow/scalar initial v_T0 set x xx convection central\n"
			"timestep 0.015\nrun 400",
			box);
	ck_assert(deck_value(sim, "f_T[3]") > -1 && deck_value(sim, "f_T[4]") < 1);
	tsim_close(sim);
}
END_TEST

static const char closed_box[] = "units si\nboundary f f f\nregion box block 0 1 0 1 0 1 units box\n"
				 "create_box 1 box\n";

/* A cell with little fluid: its conduction limits the substeps. */
START_TEST(dense_cell_conducts)
{
	struct tsim *sim;

	sim = deck_open("%screate_atoms 1 single 0.55 0.55 0.55\nset group all diameter 0.105 density 2385\n"
			"variable xx internal 0\nvariable T0 equal v_xx>0.5\n"
			"flow_style projection cells 10 10 10 viscosity 0.001 density 1\n"
			"fix e all void_fraction\nfix still all freeze\n"
			"fix T all flow/scalar conductivity 0.1666 initial v_T0 set x xx\n"
			"timestep 0.01\nrun 200",
			closed_box);
	ck_assert(deck_value(sim, "f_e[2]") < 0.41);
	ck_assert(deck_value(sim, "f_T[3]") > 0.4 && deck_value(sim, "f_T[4]") < 0.6);
	tsim_close(sim);
}
END_TEST

/* A sphere that comes into a closed box, moves and goes changes the volume of the fluid, not its temperature. */
START_TEST(sphere_put_into_closed_box)
{
	static const char *const ways[] = { "time euler", "time rk3", "substeps 2", "every 2" };
	const double volume = PI / 6 * pow(0.1, 3);
	struct tsim *sim = deck_open("%sflow_style projection cells 6 6 6 viscosity 1 density 731 %s\n"
				     "fix e all void_fraction\n"
				     "fix T all flow/scalar initial 300 conductivity 0.1 capacity 17\n"
				     "fix move all nve/sphere\ntimestep 1e-4\nrun 2\n"
				     "create_atoms 1 single 0.5 0.5 0.5\n"
				     "set group all diameter 0.1 density 2385\nrun 4",
				     closed_box, ways[_i]);

	for (int k = 0; k < 3; k++) {
		if (k)
			deck(sim, k == 1 ? "displace_atoms all move 0.2 0.1 0\nrun 4"
					 : "delete_atoms group all\nrun 4");
		DECK_NEAR(deck_value(sim, "f_T[3]"), 300, 1e-7);
		DECK_NEAR(deck_value(sim, "f_T[4]"), 300, 1e-7);
		DECK_NEAR(deck_value(sim, "f_T[1]") / (731 * 17 * 300.0), k < 2 ? 1 - volume : 1, 1e-10);
	}
	tsim_close(sim);
}
END_TEST

/* A hot spot in a lid-driven cavity stays between cold and hot. */
START_TEST(bounds)
{
	struct tsim *sim;
	char box[512];

	snprintf(box, sizeof box, plane, "f f p");
	sim = deck_open("%svariable xx internal 0\nvariable T0 equal 2+(v_xx>0.6)\n"
			"flow_style projection cells 16 16 1 viscosity 0.01 density 1\n"
			"flow_boundary yhi wall velocity 1 0 0\n"
			"fix T all flow/scalar initial v_T0 set x xx\ntimestep 0.01\nrun 200",
			box);
	ck_assert(deck_value(sim, "f_T[3]") >= 2 && deck_value(sim, "f_T[4]") <= 3);
	DECK_NEAR(deck_value(sim, "f_T[1]"), 2 + 6.0 / 16, 1e-13);
	tsim_close(sim);
}
END_TEST

static const char suspension[] =
	"units si\nboundary f p f\nnewton off\ncommunicate single vel yes\n"
	"region box block 0 1 0 1.3 0 0.7 units box\n"
	"region in block 0.05 0.95 0.1 1.2 0.05 0.65 units box\n"
	"create_box 1 box\ncreate_atoms 1 random 150 2385 in\n"
	"set group all diameter 0.0731 density 2385\n"
	"fix k all property/global thermalConductivity peratomtype 0\n"
	"fix c all property/global thermalCapacity peratomtype 31\n"
	"fix heat all heat/gran initial_temperature 300\n"
	"flow_style projection cells 7 8 6 viscosity 1.3 density 731 %s\n"
	"flow_boundary zhi wall velocity 0 1.5 0\n"
	"fix e all void_fraction method %s\n"
	"fix d all drag/di_felice scheme implicit\n"
	"fix T all flow/scalar conductivity 23.85 capacity 17 initial 400 exchange ranz_marshall\n"
	"fix m all nve\ntimestep 1e-3\n";

/* Heat of particles that move, and of the fluid between them. */
START_TEST(heat_is_kept)
{
	static const char *const fluids[] = { "", "every 3", "substeps 2" };
	struct tsim *sim = deck_open(suspension, fluids[_i], "divided");
	double before, drop;

	deck(sim, "run 3");
	before = deck_value(sim, "f_heat+f_T[1]");
	drop = deck_value(sim, "f_T[1]");
	deck(sim, "run 30");
	DECK_NEAR(deck_value(sim, "f_heat+f_T[1]") / before, 1, 1e-14);
	/* the particles have become warmer, by about what they got a step */
	drop -= deck_value(sim, "f_T[1]");
	ck_assert(drop > 0);
	DECK_NEAR(deck_value(sim, "f_T[2]*0.03") / drop, 1, 0.1);
	tsim_close(sim);
}
END_TEST

/* A run in two parts is the same, also where the value of a wall varies and the fluid waits between them. */
START_TEST(heat_in_two_runs)
{
	double heat[2];

	for (int k = 0; k < 2; k++) {
		struct tsim *sim = deck_open(suspension, "every 3", "divided");

		deck(sim, "unfix T\nvariable w equal 400+1e4*time\n"
			  "fix T all flow/scalar conductivity 23.85 capacity 17 initial 400 exchange "
			  "ranz_marshall "
			  "xlo value v_w");
		deck(sim, k ? "run 10" : "run 4\nrun 6");
		heat[k] = deck_value(sim, "f_heat");
		tsim_close(sim);
	}
	DECK_NEAR(heat[0], heat[1], 0);
}
END_TEST

/* Where all have the same temperature nothing happens, whatever moves. */
START_TEST(even_temperatures_stay)
{
	struct tsim *sim = deck_open(suspension, "", "kernel");

	deck(sim, "set group all property/atom Temp 400\nrun 30");
	DECK_NEAR(deck_value(sim, "f_T[3]"), 400, 1e-10);
	DECK_NEAR(deck_value(sim, "f_T[4]"), 400, 1e-10);
	tsim_close(sim);
}
END_TEST

/* One hot sphere in much cold fluid at rest: T - T_f dies by exp(-pi d^2 h t/(m c)), Nu = 2. A disc has the volume and the exchange
 * of a row of spheres. */
START_TEST(one_sphere_cools)
{
	static const char *const box[][2] = { { "", "0 1" }, { "dimension 2\n", "-0.5 0.5" } };
	struct tsim *sim = deck_open("units si\n%sboundary p p p\nnewton off\ncommunicate single vel yes\n"
				     "region box block 0 1 0 1 %s units box\ncreate_box 1 box\n"
				     "create_atoms 1 single 0.43 0.57 0 units box\n"
				     "set group all diameter 0.01 density 2385\n"
				     "fix k all property/global thermalConductivity peratomtype 0\n"
				     "fix c all property/global thermalCapacity peratomtype 31\n"
				     "fix heat all heat/gran initial_temperature 500\n"
				     "flow_style projection cells 4 4 %d viscosity 1.3 density 731\n"
				     "fix T all flow/scalar conductivity 0.73 capacity 4e9 initial 300 "
				     "exchange ranz_marshall\ntimestep 1e-3\nrun 2000",
				     box[_i][0], box[_i][1], _i ? 1 : 4);
	double rate = 12 * 0.73 / (2385 * 31 * 0.01 * 0.01), temperature;

	temperature = deck_value(sim, "f_heat/(31*mass(all))");
	DECK_NEAR(temperature, 300 + 200 * pow(1 - rate * 1e-3, 2000), 1e-8);
	DECK_NEAR(temperature, 300 + 200 * exp(-rate * 2), 0.2);
	tsim_close(sim);
}
END_TEST

/* Hot gas through a bed whose spheres keep their temperature: T - T_p dies by exp(-z a h/(rho c U)), a h the
 * exchange by volume. */
START_TEST(gas_through_a_bed)
{
	const double d = 0.001, u = 3.1, rho = 1.21, mu = 1.85e-5, k = 0.026, c = 1005;
	const double by_volume = 1 / pow(0.0015, 3); /* spheres */
	struct tsim *sim = deck_open("units si\nboundary p p f\nnewton off\ncommunicate single vel yes\n"
				     "region box block 0 0.003 0 0.003 0 0.06 units box\n"
				     "region bed block 0 0.003 0 0.003 0.015 0.045 units box\n"
				     "create_box 1 box\nlattice sc 0.0015 origin 0.5 0.5 0.5\n"
				     "create_atoms 1 region bed\nset group all diameter 0.001 density 2385\n"
				     "group none empty\nfix hold all freeze\n"
				     "fix k all property/global thermalConductivity peratomtype 0\n"
				     "fix c all property/global thermalCapacity peratomtype 31\n"
				     "fix heat none heat/gran initial_temperature 300\n"
				     "flow_style projection cells 1 1 160 viscosity 1.85e-5 density 1.21\n"
				     "flow_boundary zlo inlet velocity 0 0 3.1\nflow_boundary zhi outlet\n"
				     "fix e all void_fraction method kernel reach 1.5\n"
				     "fix d all drag/ergun scheme exact\n"
				     "fix T all flow/scalar conductivity 0.026 capacity 1005 initial 300 zlo "
				     "value 400 exchange ranz_marshall\n"
				     "timestep 2e-5\nrun 2500");
	double re = rho * u * d / mu, nu = 2 + 0.6 * sqrt(re) * cbrt(mu * c / k);
	double rate = PI * d * nu * k * by_volume / (rho * c * u), here[2];
	const struct ts_table *table = cells(sim);

	for (int j = 0; j < 2; j++) /* well inside the bed */
		here[j] = table->data[4 * (j ? 100 : 60) + 3] - 300;
	DECK_NEAR(log(here[0] / here[1]) / (40 * 0.06 / 160), rate, 0.02 * rate);
	tsim_close(sim);
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("scalar");
	TCase *c = tcase_create("scalar");

	tcase_add_loop_test(c, orders, 0, 3);
	tcase_add_test(c, conduction);
	tcase_add_loop_test(c, source_that_varies, 0, 3);
	tcase_add_test(c, value_that_varies);
	tcase_add_loop_test(c, values_on_faces, 0, 2);
	tcase_add_test(c, central_waves_do_not_grow);
	tcase_add_test(c, dense_cell_conducts);
	tcase_add_loop_test(c, sphere_put_into_closed_box, 0, 4);
	tcase_add_test(c, bounds);
	tcase_add_loop_test(c, heat_is_kept, 0, 3);
	tcase_add_test(c, heat_in_two_runs);
	tcase_add_test(c, even_temperatures_stay);
	tcase_add_loop_test(c, one_sphere_cools, 0, 2);
	tcase_add_test(c, gas_through_a_bed);
	suite_add_tcase(suite, c);
	return deck_main(suite);
}
