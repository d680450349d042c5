/* `cohesion bond` of pair_style gran: without damping its forces are those of bond_style parallel; local damping and
 * breakage by known answers; bits do not depend on threads. */
#include "deck.h"

#include <math.h>
#include <string.h>

#include "bond/bonds.h"
#include "core/sim.h"
#include "math/constants.h"
#include "particle/particles.h"

static const char properties[] =
	"fix m1 all property/global youngsModulus peratomtype 5e6 5e6\n"
	"fix m2 all property/global poissonsRatio peratomtype 0.3 0.3\n"
	"fix m3 all property/global coefficientRestitution peratomtypepair 2 0.9 0.9 0.9 0.9\n"
	"fix m4 all property/global coefficientFriction peratomtypepair 2 0.5 0.5 0.5 0.5\n"
	"fix b1 all property/global normalBondStiffnessPerUnitArea peratomtypepair 2 2e7 3e7 3e7 4e7\n"
	"fix b2 all property/global tangentialBondStiffnessPerUnitArea peratomtypepair 2 8e6 9e6 9e6 1e7\n"
	"fix b3 all property/global radiusMultiplierBond peratomtypepair 2 0.9 0.8 0.8 1.1\n"
	"fix b4 all property/global createDistanceBond peratomtypepair 2 0.12 0.11 0.11 0.13\n"
	"fix b5 all property/global tsCreateBond scalar 0\n";
static const char by_distance[] =
	"fix c1 all property/global maxDistanceBond peratomtypepair 2 0.3 0.3 0.3 0.3\n";
static const char by_stress[] =
	"fix c2 all property/global maxSigmaBond peratomtypepair 2 9e4 9e4 9e4 9e4\n"
	"fix c3 all property/global maxTauBond peratomtypepair 2 7e4 7e4 7e4 7e4\n"
	"fix c4 all property/global ratioTensionCompression peratomtypepair 2 0.5 0.5 0.5 0.5\n";

/* A random network of two types. `law`: the lines that choose pair style and bonds. */
static struct tsim *network(int threads, int sorts, const char *law)
{
	return deck_open("package omp %d grain 1\n"
			 "units si\n"
			 "atom_style granular\n"
			 "atom_modify map array sort %d 0.1\n"
			 "boundary f p f\n"
			 "newton off\n"
			 "communicate single vel yes\n"
			 "region box block 0 1 0 1 0 1 units box\n"
			 "create_box 2 box\n"
			 "neighbor 0.01 bin\n"
			 "create_atoms 1 random 300 49979687 box overlap 0.09\n"
			 "set group all diameter 0.08 density 2000\n"
			 "set group all type/fraction 2 0.4 86028121\n"
			 "set type 2 diameter 0.09 density 2385\n"
			 "group a type 1\n"
			 "group b type 2\n"
			 "variable r atom random(-1,1,4711)\n"
			 "velocity all set v_r v_r v_r\n"
			 "%s%s%s%sfix move all nve/sphere\n"
			 "timestep 2e-5\n"
			 "thermo 100000\n",
			 threads, sorts, properties, by_distance, by_stress, law);
}

static const char parallel[] = "pair_style gran model hertz tangential history\npair_coeff * *\n"
			       "bond_style parallel\n"
			       "bond_coeff 1 kn 2e7 ks 8e6 lambda 0.9%s\n"
			       "bond_coeff 2 kn 3e7 ks 9e6 lambda 0.8%s\n"
			       "bond_coeff 3 kn 4e7 ks 1e7 lambda 1.1%s\n"
			       "create_bonds many a a 1 0 0.12\n"
			       "create_bonds many a b 2 0 0.11\n"
			       "create_bonds many b b 3 0 0.13\n";
static const char cohesion[] =
	"pair_style gran model hertz tangential history cohesion bond %s\npair_coeff * *\n";

/* Positions after many steps; the loops differ in the order of operations only. */
START_TEST(as_parallel)
{
	const char *strength = _i ? " sigma_c 9e4 sigma_compression 9e4 tau_c 7e4" : "";
	char lines[2][2048];
	struct tsim *sim[2];

	snprintf(lines[0], sizeof lines[0], parallel, strength, strength, strength);
	snprintf(lines[1], sizeof lines[1], cohesion,
		 _i ? "stressBreak on dampingBond off" : "createBondAlways off dampingBond off");
	for (int k = 0; k < 2; k++) {
		sim[k] = network(1, 0, lines[k]);
		deck(sim[k], "run 300");
	}
	ck_assert_uint_gt(sim[0]->bonds->n, 100);
	ck_assert_uint_eq(sim[0]->bonds->n, sim[1]->bonds->n);
	ck_assert_int_eq(sim[0]->bonds->broken, sim[1]->bonds->broken);
	ck_assert(_i == (sim[0]->bonds->broken > 5));
	for (size_t b = 0; b < sim[0]->bonds->n; b++)
		ck_assert_int_eq(sim[0]->bonds->type[b], sim[1]->bonds->type[b]);
	for (size_t i = 0; i < sim[0]->particles->n; i++)
		for (int c = 0; c < 3; c++) {
			DECK_NEAR(sim[1]->particles->x[i][c], sim[0]->particles->x[i][c], 1e-12);
			DECK_NEAR(sim[1]->particles->f[i][c], sim[0]->particles->f[i][c], 1e-5); /* of 1e3 */
		}
	for (int k = 0; k < 2; k++)
		tsim_close(sim[k]);
}
END_TEST

static const char damping[] =
	"fix d1 all property/global dampingNormalForceBond peratomtypepair 2 0.2 0.2 0.2 0.2\n"
	"fix d2 all property/global dampingTangentialForceBond peratomtypepair 2 0.3 0.3 0.3 0.3\n"
	"fix d3 all property/global dampingNormalTorqueBond peratomtypepair 2 0.4 0.4 0.4 0.4\n"
	"fix d4 all property/global dampingTangentialTorqueBond peratomtypepair 2 0.5 0.5 0.5 0.5\n";

/* Threads and sorting change nothing; bonds are created, damped, and break. */
START_TEST(same_bits)
{
	char lines[2048], first[512];
	struct tsim *one, *other;

	snprintf(first, sizeof first, cohesion, "stressBreak on createBondAlways on");
	snprintf(lines, sizeof lines, "%s%s", damping, first);
	one = network(1, 0, lines);
	other = network(3, 0, lines);
	deck(one, "run 300");
	deck(other, "compute c all pair/gran/local/bond\ncompute n all bond/counter\nrun 100\nrun 200");
	ck_assert_int_gt(one->bonds->broken, 5);
	ck_assert_int_gt(one->bonds->created, one->bonds->broken + (int64_t)one->bonds->n - 1);
	ck_assert_uint_eq(one->bonds->n, other->bonds->n);
	for (size_t i = 0; i < one->particles->n; i++) {
		ck_assert(!memcmp(one->particles->x[i], other->particles->x[i], sizeof one->particles->x[i]));
		ck_assert(!memcmp(one->particles->omega[i], other->particles->omega[i],
				  sizeof one->particles->omega[i]));
	}
	tsim_close(one);
	tsim_close(other);
}
END_TEST

/* ---- two spheres */

static struct tsim *pair(const char *words, const char *more)
{
	return deck_open("units si\n"
			 "atom_style granular\n"
			 "boundary f f f\n"
			 "newton off\n"
			 "communicate single vel yes\n"
			 "region box block -1 1 -1 1 -1 1 units box\n"
			 "create_box 2 box\n"
			 "neighbor 0.01 bin\n"
			 "create_atoms 1 single 0 0 0 units box\n"
			 "create_atoms 1 single 0.11 0 0 units box\n"
			 "set group all diameter 0.1 density 2000\n"
			 "%s%s%s%spair_style gran model hertz tangential history cohesion bond %s\n"
			 "pair_coeff * *\n"
			 "fix move all nve/sphere\n"
			 "timestep 1e-6\n"
			 "thermo 100000000\n"
			 "run 0\n%s\n",
			 properties, by_distance, by_stress, damping, words, more);
}

/* A free vibration of either sort: each half ends sqrt((1 - alpha)/(1 + alpha)) times as far as it began. */
START_TEST(local_damping)
{
	static const struct {
		const char *begin, *reading;
		double alpha;
	} motion[] = {
		{ "set atom 1 x -1e-6\nset atom 2 x 0.110001", "x[2]-x[1]-0.11", 0.2 },
		{ "set atom 1 omegax -0.01\nset atom 2 omegax 0.01", "omegax[2]-omegax[1]", 0.4 },
		{ "set atom 1 omegaz -0.01\nset atom 2 omegaz 0.01", "omegaz[2]-omegaz[1]", 0.5 },
	};
	struct tsim *sim = pair("", motion[_i].begin);
	double before = 0, most[3] = { 0 }, ratio = sqrt((1 - motion[_i].alpha) / (1 + motion[_i].alpha));
	int half = 0;

	/* extremes of the reading between its zeros, after the first */
	for (int step = 0; half < 4 && step < 40000; step++) {
		double now;

		deck(sim, "run 1 pre no post no");
		now = deck_value(sim, motion[_i].reading);
		if (now * before < 0)
			half++;
		before = now;
		if (half && half < 4)
			most[half - 1] = fmax(most[half - 1], fabs(now));
	}
	ck_assert_int_eq(half, 4);
	DECK_NEAR(most[1] / most[0], ratio, 0.01);
	DECK_NEAR(most[2] / most[1], ratio, 0.01);
	tsim_close(sim);
}
END_TEST

/* Breaks just above the strength, in the mode given, not just below; R = 0.045, A = pi R^2. */
START_TEST(breakage)
{
	static const struct {
		const char *words, *set;
		double at; /* value of the coordinate at which the bond breaks */
		int mode;
	} load[] = {
		/* 9e4/2e7 = 4.5 mm; compression the same */
		{ "stressBreak on dampingBond off", "set atom 2 x %.17g", 0.1145, TS_BOND_TENSION },
		{ "stressBreak on dampingBond off compressionStress off", "set atom 2 x %.17g", 0.1145,
		  TS_BOND_TENSION },
		/* tension: half the strength */
		{ "stressBreak on dampingBond off ratioTensionCompression on", "set atom 2 x %.17g", 0.11225,
		  TS_BOND_TENSION },
		/* by distance */
		{ "dampingBond off", "set atom 2 x %.17g", 0.3, TS_BOND_TENSION },
		{ "dampingBond off tensionStress off", "set atom 2 x %.17g", 0.3, TS_BOND_TENSION },
	};
	char words[256];

	for (int k = 0; k < 2; k++) {
		struct tsim *sim;

		snprintf(words, sizeof words, load[_i].set, load[_i].at + (k ? 1e-7 : -1e-7));
		sim = pair(load[_i].words, words);
		deck(sim, "run 0");
		ck_assert_int_eq(sim->bonds->broken, k);
		ck_assert_uint_eq(sim->bonds->n, (size_t)!k);
		if (k)
			ck_assert_int_eq(sim->bonds->event[0].mode, load[_i].mode);
		tsim_close(sim);
	}
}
END_TEST

/* With tensionStress off a stretched bond exerts no force, a compressed one does; and the other way round. */
START_TEST(one_sided)
{
	static const char *const words[] = { "dampingBond off tensionStress off",
					     "dampingBond off compressionStress off" };

	for (int stretched = 0; stretched < 2; stretched++) {
		struct tsim *sim = pair(words[_i], stretched ? "set atom 2 x 0.111" : "set atom 2 x 0.109");
		double force = 2e7 * TS_PI * 0.045 * 0.045 * 0.001;

		deck(sim, "run 0");
		DECK_NEAR(fabs(deck_value(sim, "fx[1]")), stretched == _i ? force : 0, 1e-9 * force);
		tsim_close(sim);
	}
}
END_TEST

/* Bonds are created in one step, or in each; those near enough at that time. */
START_TEST(creation)
{
	struct tsim *sim =
		deck_open("units si\natom_style granular\nboundary p f f\nnewton off\ncommunicate single vel "
			  "yes\n"
			  "region box block 0 1 -1 1 -1 1 units box\ncreate_box 2 box\nneighbor 0.01 bin\n"
			  "create_atoms 1 single 0.03 0 0 units box\ncreate_atoms 1 single 0.92 0 0 units "
			  "box\n"
			  "create_atoms 2 single 0.15 0 0 units box\ncreate_atoms 2 single 0.3 0 0 units "
			  "box\n"
			  "set group all diameter 0.1 density 2000\n%s%s%sfix b5 all property/global "
			  "tsCreateBond scalar 3\n"
			  "pair_style gran model hertz tangential history cohesion bond dampingBond off "
			  "createBondAlways %s\n"
			  "pair_coeff * *\nfix move all nve/sphere\ntimestep 1e-3\nset atom 3 vx -10\nrun 2",
			  properties, by_distance, by_stress, _i ? "on" : "off");

	/* 1 and 2 across the face, 0.11 apart: created at once with `on`; 3 comes near 1 in step 1: 0.11 */
	ck_assert_uint_eq(sim->bonds->n, _i ? 2 : 0);
	deck(sim, "set atom 3 vx 0\nrun 1");
	ck_assert_uint_eq(sim->bonds->n, 2);
	ck_assert_int_eq(sim->bonds->type[0], 1); /* particles 1, 2 */
	ck_assert_int_eq(sim->bonds->type[1], 2); /* particles 1, 3 of types 1, 2 */
	DECK_NEAR(sim->bonds->rest[0], 0.11, _i ? 1e-12 : 1e-3);
	deck(sim, "set atom 4 x 0.24\nrun 1");
	ck_assert_uint_eq(sim->bonds->n, _i ? 3 : 2);
	tsim_close(sim);
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("cohesive bonds");
	TCase *all = tcase_create("all");

	tcase_set_timeout(all, 120);
	tcase_add_loop_test(all, as_parallel, 0, 2);
	tcase_add_test(all, same_bits);
	tcase_add_loop_test(all, local_damping, 0, 3);
	tcase_add_loop_test(all, breakage, 0, 5);
	tcase_add_loop_test(all, one_sided, 0, 2);
	tcase_add_loop_test(all, creation, 0, 2);
	suite_add_tcase(suite, all);
	return deck_main(suite);
}
