/* Bond styles bpm/spring and bpm/rotational, pair style bpm/spring: forces, energies and breakage by the formulas of
 * LAMMPS' manual; without smoothing bpm/rotational is bond_style parallel. */
#include "deck.h"

#include <math.h>
#include <string.h>

#include "bond/bond_moment.h"
#include "bond/bonds.h"
#include "core/sim.h"
#include "law/bpm_bond.h"
#include "math/constants.h"
#include "particle/particles.h"

static struct tsim *two(const char *special, const char *style, const char *coeff)
{
	return deck_open("units lj\n"
			 "atom_style bpm/sphere\n"
			 "boundary f f f\n"
			 "newton on off\n"
			 "region box block -2 2 -2 2 -2 2 units box\n"
			 "create_box 1 box bond/types 1 extra/bond/per/atom 4\n"
			 "create_atoms 1 single 0 0 0 units box\n"
			 "create_atoms 1 single 1.1 0 0 units box\n"
			 "create_bonds single/bond 1 1 2\n"
			 "%sbond_style %s\n"
			 "bond_coeff 1 %s\n"
			 "fix 1 all nve/bpm/sphere\n"
			 "review off integrator\n"
			 "timestep 1e-4\n"
			 "thermo 1000000\n"
			 "run 0\n",
			 special, style, coeff);
}

/* Force on the second particle at this distance, with a rate of extension of 0.3. */
START_TEST(spring)
{
	static const struct {
		const char *words;
		double smooth, stiffness;
	} law[] = { { "", 1, 7.3 }, { "smooth no", 0, 7.3 }, { "normalize yes", 1, 7.3 / 1.1 } };
	struct ts_bond_load load;

	for (int k = -3; k <= 3; k++) {
		char style[64];
		double x = 0.03 * k, strain = x / 1.1, w = 1 - law[_i].smooth * pow(strain / 0.1, 8);
		double expected = -(law[_i].stiffness * x * w + 0.9 * w * 0.3), energy[TS_BOND_MODES];
		struct tsim *sim;

		snprintf(style, sizeof style, "bpm/spring %s", law[_i].words);
		sim = two("", style, "7.3 0.1 0.9");
		deck(sim, "set atom 2 x %.17g\nset atom 2 vx 0.3\nrun 0", 1.1 + x);
		DECK_NEAR(deck_value(sim, "fx[2]"), expected, 1e-14);
		DECK_NEAR(deck_value(sim, "fx[1]"), -expected, 1e-14);
		/* the energy is the integral of the elastic force */
		ts_bond_energy(sim, 0, energy);
		DECK_NEAR(energy[TS_BOND_NORMAL],
			  law[_i].stiffness *
				  (x * x / 2 - law[_i].smooth * pow(strain / 0.1, 8) * x * x / 10),
			  1e-14);
		ts_bond_spring_load(sim, 0, &load);
		DECK_NEAR(load.force[0], law[_i].stiffness * x * w, 1e-14);
		tsim_close(sim);
	}
}
END_TEST

START_TEST(spring_breaks)
{
	for (int k = 0; k < 4; k++) {
		struct tsim *sim =
			two("", _i ? "bpm/spring smooth no break no" : "bpm/spring", "7.3 0.1 0.9");

		/* strains of 0.1 and -0.1 */
		deck(sim, "set atom 2 x %.17g\nrun 0",
		     1.1 + (k < 2 ? 0.11 : -0.11) * (k % 2 ? 1.0001 : 0.9999));
		ck_assert_int_eq(sim->bonds->broken, !_i && k % 2);
		tsim_close(sim);
	}
}
END_TEST

/* ---- bpm/rotational */

static const char network_text[] = "package omp %d grain 1\n"
				   "units lj\n"
				   "atom_style bpm/sphere\n"
				   "boundary f p f\n"
				   "region box block 0 1 0 1 0 1 units box\n"
				   "create_box 1 box bond/types 1\n"
				   "create_atoms 1 random 300 49979687 box overlap 0.08\n"
				   "set group all diameter 0.08 density 2000\n"
				   "velocity all create 0.1 15485863\n"
				   "bond_style %s\n"
				   "bond_coeff 1 %s\n"
				   "create_bonds many all all 1 0 0.13\n"
				   "fix move all nve/bpm/sphere\n"
				   "timestep 2e-4\n"
				   "thermo 100000\n";

/* kn A, ks A, ks J, kn I of a disc of radius 0.04 with kn = 1e6, ks = 4e5 */
#define AREA (TS_PI * 0.0016)
START_TEST(as_parallel)
{
	char coeff[256];
	struct tsim *sim[2];

	snprintf(coeff, sizeof coeff, "%.17g %.17g %.17g %.17g 1e9 1e9 1e9 1e9 0 0 0 0", 1e6 * AREA,
		 4e5 * AREA, 4e5 * AREA * 0.0016 / 2, 1e6 * AREA * 0.0016 / 4);
	sim[0] = deck_open(network_text, 1, "parallel", "kn 1e6 ks 4e5");
	sim[1] = deck_open(network_text, 1, "bpm/rotational overlay/pair yes smooth no", coeff);
	for (int k = 0; k < 2; k++)
		deck(sim[k], "run 300");
	ck_assert_uint_gt(sim[0]->bonds->n, 200);
	for (size_t i = 0; i < sim[0]->particles->n; i++)
		for (int c = 0; c < 3; c++) {
			DECK_NEAR(sim[1]->particles->x[i][c], sim[0]->particles->x[i][c], 1e-12);
			DECK_NEAR(sim[1]->particles->omega[i][c], sim[0]->particles->omega[i][c], 1e-9);
		}
	for (int k = 0; k < 2; k++)
		tsim_close(sim[k]);
}
END_TEST

START_TEST(same_bits)
{
	static const char coeff[] = "5000 2000 1.5 2 60 50 0.6 0.6 1 1 1e-4 1e-4";
	struct tsim *one = deck_open(network_text, 1, "bpm/rotational overlay/pair yes", coeff);
	struct tsim *other = deck_open(network_text, 3, "bpm/rotational overlay/pair yes", coeff);

	deck(one, "run 200");
	deck(other, "compute c all bond/local dist force\nrun 80\nrun 120");
	ck_assert_int_gt(one->bonds->broken, 20);
	ck_assert_uint_gt(one->bonds->n, 20);
	ck_assert_uint_eq(one->bonds->n, other->bonds->n);
	for (size_t i = 0; i < one->particles->n; i++)
		ck_assert(!memcmp(one->particles->x[i], other->particles->x[i], sizeof one->particles->x[i]));
	tsim_close(one);
	tsim_close(other);
}
END_TEST

/* Stretched, and twisted or bent by an angular velocity for one step: B is the sum of the parts, and forces and moments
 * are multiplied by 1 - B^4. */
START_TEST(damage)
{
	static const double angle = 0.1, critical[2] = { 0.4, 0.5 }; /* bending; twist */
	double moment = (_i ? 2.5 : 1.7) * angle, pull, w;
	char coeff[160];
	struct tsim *sim;

	snprintf(coeff, sizeof coeff, "7.3 0 2.5 1.7 0.6 1 %.17g %.17g 0 0 0 0", critical[0], critical[1]);
	sim = two("", "bpm/rotational", coeff);
	deck(sim, "set atom 2 x 1.12\nset atom 2 omega%s %.17g\ntimestep 0.1\nrun 1 unsafe yes",
	     _i ? "x" : "z", angle / 0.1);
	pull = 7.3 * (deck_value(sim, "x[2]-x[1]") - 1.1);
	w = 1 - pow(pull / 0.6 + moment / critical[_i], 4);
	ck_assert_double_gt(pull, 0.05);
	DECK_NEAR(sim->bonds->load[0].torque[1][_i ? 0 : 2], -moment * w, 1e-12);
	DECK_NEAR(sim->bonds->load[0].force[0], pull * w, 1e-12);
	tsim_close(sim);
}
END_TEST

/* Breaks where B = 1: in tension, not in compression of the same size. */
START_TEST(rotational_breaks)
{
	for (int k = 0; k < 3; k++) {
		const double x[3] = { 0.0999, 0.1001, -0.2 };
		struct tsim *sim = two("", _i ? "bpm/rotational break no smooth no" : "bpm/rotational",
				       "7 0 0 0 0.7 1 1 1 0 0 0 0");

		deck(sim, "set atom 2 x %.17g\nrun 0", 1.1 + x[k]);
		ck_assert_int_eq(sim->bonds->broken, !_i && k == 1);
		tsim_close(sim);
	}
}
END_TEST

static const double critical[TS_BOND_MODES] = { 3.1, 2.3, 1.9, 1.3 };

static double smoothed_energy(const struct ts_bond_element *e, const struct ts_bond_ends *s,
			      struct ts_bond_answer *out)
{
	double energy[TS_BOND_MODES];

	ts_bond_elastic(e, s, out);
	ts_bpm_damage(critical, out);
	out->smoothed = ts_bpm_smoothing(out) / 3;
	ts_bond_energies(e, out, energy);
	return energy[0] + energy[1] + energy[2] + energy[3];
}

/* The part of the forces that has a potential: the derivatives of the energy, in tension and in compression. */
START_TEST(derivatives)
{
	const struct ts_bond_element e = { .length = 1.1, .fraction = 0.5, .k = { 7, 5, 3, 2 } };
	const struct ts_bond_ends s = { .d = { _i ? 1.05 : 1.2, 0.13, -0.08 },
					.q = { ts_wxyz_of_vector((struct ts_xyz){ 0.05, 0.1, -0.07 }),
					       ts_wxyz_of_vector((struct ts_xyz){ -0.11, 0.02, 0.15 }) } };
	const double h = 1e-5;
	struct ts_bond_answer a, ignored;

	(void)smoothed_energy(&e, &s, &a);
	ck_assert_double_gt(a.smoothed, 0.005);
	ts_bpm_derive(critical, &e, &s, &a);
	for (int c = 0; c < 3; c++) {
		const struct ts_xyz axis = { c == 0, c == 1, c == 2 };
		double moved[2], turned[2];

		for (int k = 0; k < 2; k++) {
			const double step = k ? h : -h;
			struct ts_bond_ends there = s;

			there.d = ts_xyz_add(s.d, step, axis);
			moved[k] = smoothed_energy(&e, &there, &ignored);
			there = s;
			there.q[1] = ts_wxyz_product(ts_wxyz_of_vector(ts_xyz_scale(step, axis)), s.q[1]);
			turned[k] = smoothed_energy(&e, &there, &ignored);
		}
		DECK_NEAR(ts_xyz_dot(a.force, axis), -(moved[1] - moved[0]) / (2 * h), 1e-7);
		DECK_NEAR(ts_xyz_dot(a.torque[1], axis), -(turned[1] - turned[0]) / (2 * h), 1e-7);
	}
}
END_TEST

/* ---- pair bpm/spring: particles of the atom style bond get the radius r_c/2 */

START_TEST(pair)
{
	struct tsim *sim = deck_open("units lj\natom_style bond\nboundary f f f\n"
				     "region box block -2 2 -2 2 -2 2 units box\ncreate_box 1 box\n"
				     "create_atoms 1 single 0 0 0 units box\n"
				     "create_atoms 1 single 1.1 0 0 units box\nmass 1 1.7\n"
				     "pair_style bpm/spring\npair_coeff 1 1 3.1 1.3 0.7\n"
				     "velocity all set 0 0 0\nset atom 2 vx 0.2\nfix 1 all nve\n"
				     "timestep 1e-6\nrun 0");
	double r = deck_value(sim, "x[2]-x[1]"), w = 1 - pow(r / 1.3, 8);

	DECK_NEAR(deck_value(sim, "fx[2]"), 3.1 * (1.3 - r) - 0.7 * w * 0.2, 1e-14);
	DECK_NEAR(deck_value(sim, "mass(all)"), 3.4, 1e-14);
	tsim_close(sim);
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("bonds of BPM");
	TCase *all = tcase_create("all");

	tcase_set_timeout(all, 60);
	tcase_add_loop_test(all, spring, 0, 3);
	tcase_add_loop_test(all, spring_breaks, 0, 2);
	tcase_add_test(all, as_parallel);
	tcase_add_test(all, same_bits);
	tcase_add_loop_test(all, damage, 0, 2);
	tcase_add_loop_test(all, rotational_breaks, 0, 2);
	tcase_add_loop_test(all, derivatives, 0, 2);
	tcase_add_test(all, pair);
	suite_add_tcase(suite, all);
	return deck_main(suite);
}
