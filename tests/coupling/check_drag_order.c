/* Drags that relax velocities need the force of all others, wherever these stand in the script. */
#include <string.h>

#include "deck.h"
#include "flow/flow.h"
#include "flow/fluid.h"
#include "particle/particles.h"

static const double PI = 3.14159265358979323846;

/* ---- every order of five force fixes */

enum { FIXES = 5, ORDERS = 120 };

/* The k-th order of the lines, between head and tail. */
static struct tsim *in_order(int k, const char *const lines[FIXES], const char *head, const char *tail)
{
	int left[FIXES] = { 0, 1, 2, 3, 4 };
	char text[2000] = "";
	size_t used = 0;

	for (int n = FIXES; n > 0; n--) {
		int pick = k % n;

		k /= n;
		used += (size_t)snprintf(text + used, sizeof text - used, "%s\n", lines[left[pick]]);
		memmove(&left[pick], &left[pick + 1], (size_t)(n - pick - 1) * sizeof *left);
	}
	ck_assert(used < sizeof text);
	return deck_open("%s%s%s", head, text, tail);
}

static const char alone[] = "units si\n"
			    "boundary f f f\n"
			    "region box block -1 1 -1 1 -1 1 units box\n"
			    "create_box 1 box\n"
			    "create_atoms 1 single 0.1 0.1 0.5 units box\n"
			    "set group all diameter 1e-3 density 2385\n"
			    "flow_style uniform velocity 0.01 0 0 viscosity 1e-2 density 1000\n"
			    "fix m all nve\n";

/* Two relaxation times are a step: the terminal velocity is where the drag balances all the others. */
START_TEST(terminal_velocity_in_every_order)
{
	static const char *const drags[] = { "drag/stokes scheme exact", "drag/stokes scheme implicit" };
	const double c = 3 * PI * 1e-2 * 1e-3, volume = PI / 6 * 1e-9, damping = 2e-6;
	const double push[3] = { 1e-7, 2e-7, -(2385 - 1000) * 0.5 * volume };
	const char *lines[FIXES] = { NULL, "fix g all gravity 0.5 vector 0 0 -1",
				     "fix b all buoyancy level 1 dim z density 1000",
				     "fix a all addforce 1e-7 2e-7 0", "fix v all viscous 2e-6" };
	char line[80];

	snprintf(line, sizeof line, "fix d all %s", drags[_i % 2]);
	lines[0] = line;
	for (int k = _i / 2; k < ORDERS; k += 4) {
		struct tsim *sim = in_order(k, lines, alone, "timestep 0.0265\nrun 40");
		const double *v = sim->particles->v[0];

		for (int d = 0; d < 3; d++) {
			double still = (push[d] + (d == 0 ? c * 0.01 : 0)) / (c + damping);

			DECK_NEAR(v[d], still, 1e-14 * fabs(still));
		}
		DECK_NEAR(deck_value(sim, "f_d[3]"), -push[2] + damping * v[2], 1e-14 * 3.6e-7);
		tsim_close(sim);
	}
}
END_TEST

/* Two drags relax the particle as one with the sum of their coefficients. */
START_TEST(drags_together)
{
	static const char *const schemes[][2] = { { "exact", "exact" },
						  { "implicit", "exact" },
						  { "exact axes z", "exact" } };
	const double c = 3 * PI * 1e-2 * 1e-3, weight = PI / 6 * 1e-9 * 2385 * 0.5;
	const char *lines[FIXES] = { NULL, "fix g all gravity 0.5 vector 0 0 -1", NULL,
				     "fix a all addforce 1e-7 0 0", "fix v all addforce 0 2e-7 0" };
	char line[2][80];
	double first[3];

	for (int k = 0; k < 2; k++) {
		snprintf(line[k], sizeof *line, "fix d%d all drag/stokes scheme %s", k, schemes[_i][k]);
		lines[2 * k] = line[k];
	}
	for (int k = 0; k < ORDERS; k += 7) {
		struct tsim *sim = in_order(k, lines, alone, "timestep 0.0265\nrun 3");
		const double *v = sim->particles->v[0];

		for (int d = 0; d < 3 && k; d++)
			DECK_NEAR(v[d], first[d], 1e-15 * fabs(first[d]));
		memcpy(first, v, sizeof first);
		deck(sim, "run 60");
		DECK_NEAR(v[2], -weight / (2 * c), 1e-14 * weight / (2 * c));
		DECK_NEAR(v[0], 0.01 + 1e-7 / (_i == 2 ? c : 2 * c), 1e-14 * 0.01);
		DECK_NEAR(deck_value(sim, "f_d0[3]") / deck_value(sim, "f_d1[3]"), 1, 1e-12);
		tsim_close(sim);
	}
}
END_TEST

/* One relaxation under a constant force is exact at half steps, added mass and drags' order whatever they
 * are. */
START_TEST(added_mass_in_every_order)
{
	const double volume = PI / 6 * 1e-9, mass = 2385 * volume, inert = mass + 500 * volume;
	const double c = 3 * PI * 1e-2 * 1e-3, force = 2e-7, h = 0.01;
	const char *lines[FIXES] = { "fix d all drag/stokes scheme exact", "fix h all added_mass",
				     "fix g all gravity 0.5 vector 0 0 -1", "fix a all addforce 0 2e-7 0",
				     "fix b all buoyancy level 1 dim z density 1000" };
	double rate = c / inert, far = force / c;

	for (int k = 0; k < ORDERS; k += 5) {
		struct tsim *sim = in_order(k, lines, alone, "timestep 0.01\nrun 0");
		const struct ts_particles *p = sim->particles;
		double half, before;

		deck(sim, "run 1");
		before = 0.5 * far * -expm1(-h * rate); /* F(0) h/(2 m) with F = m/h (1 - exp(-h rate)) f/c */
		half = p->v[0][1] + 0.5 * h * p->f[0][1] / p->mass[0];
		DECK_NEAR(half, before + (far - before) * -expm1(-h * rate), 1e-14 * far);
		tsim_close(sim);
	}
}
END_TEST

/* ---- a suspension */

static const char suspension[] =
	"units si\n"
	"boundary p p p\n"
	"newton off\n"
	"communicate single vel yes\n"
	"region box block 0 0.004 0 0.004 0 0.004 units box\n"
	"create_box 1 box\n"
	"lattice sc 0.0005 origin 0.5 0.5 0.5\n"
	"create_atoms 1 box\n"
	"set group all diameter 0.0003 density 2385\n"
	"flow_style projection cells 4 4 4 viscosity 1e-2 density 1000 body_force 0 0 0.1\n"
	"pressure_style cg\n"
	"fix e all void_fraction\n"
	"fix m all nve\n";

/* The slip of a suspension is that of the law of its void fraction, in every order. */
START_TEST(suspension_in_every_order)
{
	const char *lines[FIXES] = { "fix d all drag/di_felice scheme exact",
				     "fix p all flow/pressure_gradient",
				     "fix g all gravity 2.0 vector 0 0 -1", "fix b all addforce 0 0 1e-8",
				     "fix l all lift/saffman" };
	double first = 0;

	for (int k = 0; k < ORDERS; k += 17) {
		struct tsim *sim = in_order(k, lines, suspension, "timestep 0.002\nrun 12");
		const double v = sim->particles->v[0][2];

		if (k)
			DECK_NEAR(v, first, 1e-12 * fabs(v));
		first = v;
		ck_assert(v < 0);
		tsim_close(sim);
	}
}
END_TEST

/* ---- forces that are taken away, motion that is given */

static const char beads[] = "units si\n"
			    "boundary p p p\n"
			    "newton off\n"
			    "communicate single vel yes\n"
			    "region box block 0 1 0 1 0 1 units box\n"
			    "create_box 1 box\n"
			    "lattice sc 0.25 origin 0.5 0.5 0.5\n"
			    "create_atoms 1 box\n"
			    "set group all diameter 0.01 density 2385\n"
			    "velocity all set 0.1 0.2 0.3\n"
			    "flow_style projection cells 4 4 4 viscosity 1.3 density 131\n";

/* What is held takes nothing, the fluid feels the drag at its velocity and is slowed by the same as by
 * explicit drag. */
START_TEST(where_motion_is_given)
{
	static const struct {
		const char *before, *after;
		bool free[3];
	} ways[] = {
		{ "", "fix s all setforce 0 0 0\nfix m all nve", { false, false, false } },
		{ "", "fix s all setforce NULL 0 NULL\nfix m all nve", { true, false, true } },
		{ "fix s all setforce NULL 0 NULL", "fix m all nve", { true, true, true } },
		{ "", "fix s all planeforce 0 0 2\nfix m all nve", { true, true, false } },
		{ "", "fix s all lineforce 0 1 0\nfix m all nve", { false, true, false } },
		{ "", "fix m all nve/noforce", { false, false, false } },
		{ "fix m all nve/noforce", "", { false, false, false } },
		{ "", "fix m all move linear 0.1 NULL 0.3", { false, true, false } },
	};
	struct tsim *sim[2];

	for (int k = 0; k < 2; k++)
		sim[k] = deck_open("%s%s\nfix d all drag/stokes scheme %s\n%s\ntimestep 1e-3\nrun 3", beads,
				   ways[_i].before, k ? "exact" : "explicit", ways[_i].after);
	for (int d = 0; d < 3; d++) {
		double change = fabs(sim[1]->particles->v[0][d] - 0.1 * (d + 1)), u[2];

		for (int k = 0; k < 2; k++) {
			const struct ts_fluid *fluid = ts_flow_fluid(sim[k]);

			u[k] = fluid->u[d][ts_at(&fluid->grid, 1, 2, 1)];
		}
		ck_assert(ways[_i].free[d] ? change > 1e-9 : change < 1e-15);
		if (!ways[_i].free[d])
			DECK_NEAR(u[1], u[0], 1e-14 * fabs(u[0]));
	}
	tsim_close(sim[0]);
	tsim_close(sim[1]);
}
END_TEST

/* The sum that setforce takes away has the drag in it. */
START_TEST(what_was_taken_away_counts)
{
	struct tsim *sim = deck_open("%sfix d all drag/stokes scheme exact\nfix s all setforce 0 NULL NULL\n"
				     "fix g all addforce 1e-3 0 0\nfix m all nve\ntimestep 1e-3\nrun 0",
				     alone);
	const double c = 3 * PI * 1e-2 * 1e-3;

	DECK_NEAR(deck_value(sim, "f_s[1]"), c * 0.01, 1e-14 * c * 0.01);
	DECK_NEAR(deck_value(sim, "f_d[1]"), c * 0.01, 1e-14 * c * 0.01);
	DECK_NEAR(sim->particles->f[0][0], 1e-3, 1e-18);
	tsim_close(sim);
}
END_TEST

START_TEST(a_common_force_is_refused)
{
	struct tsim *sim =
		deck_open("%sfix d all drag/stokes scheme exact\nfix s all aveforce 0 0 0\ntimestep 1e-3",
			  alone);

	ck_assert(!deck_accepts(sim, "run 1"));
	ck_assert(strstr(tsim_error(sim),
			 "gives particles of this group a common force: put fix aveforce before"));
	tsim_close(sim);
	sim = deck_open("%sfix s all aveforce 0 0 0\nfix d all drag/stokes scheme exact\ntimestep 1e-3\nrun "
			"1",
			alone);
	tsim_close(sim);
}
END_TEST

/* ---- functions of another program add forces, too */

static int push(struct tsim *sim, void *data)
{
	(void)data;
	sim->particles->f[0][2] -= 1e-7;
	return 0;
}

START_TEST(forces_of_another_program)
{
	struct tsim *sim = deck_open("%sfix d all drag/stokes scheme exact\ntimestep 0.0265", alone);

	ck_assert_int_eq(tsim_on_step(sim, TSIM_AFTER_FORCE, push, NULL), 0);
	deck(sim, "run 60");
	DECK_NEAR(sim->particles->v[0][2], -1e-7 / (3 * PI * 1e-2 * 1e-3), 1e-15);
	tsim_close(sim);
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("drag among forces");
	TCase *c = tcase_create("order");

	tcase_add_loop_test(c, terminal_velocity_in_every_order, 0, 8);
	tcase_add_loop_test(c, drags_together, 0, 3);
	tcase_add_test(c, added_mass_in_every_order);
	tcase_add_test(c, suspension_in_every_order);
	tcase_add_loop_test(c, where_motion_is_given, 0, 8);
	tcase_add_test(c, what_was_taken_away_counts);
	tcase_add_test(c, a_common_force_is_refused);
	tcase_add_test(c, forces_of_another_program);
	suite_add_tcase(suite, c);
	return deck_main(suite);
}
