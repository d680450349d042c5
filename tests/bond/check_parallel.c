/* bond_style parallel: the loop over bonds is the law of law/bond_element.h bit for bit, whatever the threads and the
 * order of particles; cantilevers, vibrations, breaking loads, energy and order of the time integration. */
#include "deck.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bond/bond_moment.h"
#include "core/sim.h"
#include "math/constants.h"
#include "math/quaternion.h"
#include "math/vec3.h"
#include "particle/identity.h"
#include "particle/orientation.h"
#include "particle/particles.h"

static const char strong[] = "bond_coeff 1 kn 5e4 ks 2e4\nbond_coeff 2 kn 8e4 ratio 3 lambda 0.8\n"
			     "bond_coeff 3 E 4e3 ratio 2.5 lambda 1.2\n";
static const char weak[] =
	"bond_coeff 1 kn 5e4 ks 2e4 sigma_c 40 tau_c 60 scatter normal deviation 0.3 seed 5\n"
	"bond_coeff 2 kn 8e4 ratio 3 lambda 0.8 sigma_c 40 scatter weibull shape 3\n"
	"bond_coeff 3 E 4e3 ratio 2.5 lambda 1.2 sigma_c 40 tau_c 60 sigma_compression 90 beta 0.5 damping "
	"0.1 damping_twist 0.2\n";

static const char soft[] =
	"bond_coeff 1 kn 5e4 ks 2e4 sigma_c 20 soften 0.01 scatter normal deviation 0.3 seed 5\n"
	"bond_coeff 2 kn 8e4 ratio 3 lambda 0.8 sigma_c 40 soften 0.02\n"
	"bond_coeff 3 E 4e3 ratio 2.5 lambda 1.2 sigma_c 2e3\n";

/* Shear that grows with the pressure, of brittle bonds and of some that soften by shear. */
static const char rubbing[] =
	"bond_coeff 1 kn 5e4 ks 2e4 sigma_c 40 tau_c 30 friction_angle 40 scatter normal deviation 0.3 seed "
	"5\n"
	"bond_coeff 2 kn 8e4 ratio 3 lambda 0.8 sigma_c 40 tau_c 15 soften 0.02 soften_by both\n"
	"bond_coeff 3 E 4e3 ratio 2.5 lambda 1.2 sigma_c 50 tau_c 20 soften 0.02 soften_by both "
	"friction_angle 30\n";

/* A random network, periodic in y, that vibrates. */
static struct tsim *network(int threads, int sorts, const char *coefficients)
{
	return deck_open("package omp %d grain 1\n"
			 "units lj\n"
			 "atom_style sphere\n"
			 "atom_modify sort %d 0.1\n"
			 "boundary f p f\n"
			 "region box block 0 1 0 1 0 1 units box\n"
			 "create_box 2 box\n"
			 "create_atoms 1 random 500 49979687 box overlap 0.05\n"
			 "set type 1 diameter 0.05 density 2000\n"
			 "set group all type/fraction 2 0.4 86028121\n"
			 "set type 2 diameter 0.06 density 2385\n"
			 "velocity all create 1 15485863\n"
			 "group a type 1\n"
			 "group b type 2\n"
			 "bond_style parallel\n%screate_bonds many a a 1 0 0.17\n"
			 "create_bonds many b b 2 0 0.2\n"
			 "create_bonds many a b 3 0 0.12\n"
			 "fix move all nve/sphere\n"
			 "timestep 2e-5\n"
			 "thermo 100000\n",
			 threads, sorts, coefficients);
}

/* The sums over the bonds of particle i of the law itself, in the order of the identities of the partners. */
static void plain_sums(const struct tsim *sim, size_t i, double force[3], double torque[3])
{
	const struct ts_bonds *b = sim->bonds;

	for (int c = 0; c < 3; c++)
		force[c] = torque[c] = 0;
	for (size_t k = b->gather.first[i]; k < b->gather.first[i + 1]; k++) {
		size_t bond = b->gather.entry[k] >> 1, side = b->gather.entry[k] & 1;
		struct ts_bond_load load;

		ts_bond_spring_load(sim, bond, &load);
		for (int c = 0; c < 3; c++) {
			force[c] += side ? -load.force[c] : load.force[c];
			torque[c] += load.torque[side][c];
			ck_assert(load.force[c] == b->load[bond].force[c]);
			ck_assert(load.torque[side][c] == b->load[bond].torque[side][c]);
		}
	}
}

START_TEST(plain_loop)
{
	struct tsim *sim = network(1 + _i % 2, 1000, _i < 2 ? strong : _i < 4 ? soft : rubbing);
	const struct ts_particles *p = sim->particles;
	double force[3], torque[3], most = 0;

	deck(sim, "run 200");
	ck_assert_uint_gt(sim->bonds->n, 1000);
	for (size_t i = 0; i < p->n; i++) {
		plain_sums(sim, i, force, torque);
		for (int c = 0; c < 3; c++) {
			ck_assert(p->f[i][c] == force[c]);
			ck_assert(p->torque[i][c] == torque[c]);
			most = fmax(most, fabs(torque[c]));
		}
	}
	ck_assert_double_gt(most, 0);
	tsim_close(sim);
}
END_TEST

/* Threads, sorting, and outputs that read loads change nothing; bonds break. */
START_TEST(same_bits)
{
	const char *coefficients = _i == 2 ? rubbing : _i ? soft : weak;
	struct tsim *one = network(1, 0, coefficients), *other = network(2, 13, coefficients);
	struct ts_identities map;
	double(*q[2])[4];
	int cracked = 0;

	deck(one, "run 200");
	deck(other, "compute c all bond/local dist force\nrun 80\nrun 120");
	ck_assert_int_gt(one->bonds->broken, 20);
	ck_assert_uint_gt(one->bonds->n, 100);
	ck_assert_uint_eq(one->bonds->n, other->bonds->n);
	for (size_t k = 0; k < one->bonds->n; k++)
		ck_assert(!memcmp(&one->bonds->load[k], &other->bonds->load[k], sizeof *one->bonds->load));
	for (size_t k = 0; _i && k < one->bonds->n; k++) {
		cracked += one->bonds->damage[k].reached > 1;
		ck_assert(one->bonds->damage[k].reached == other->bonds->damage[k].reached);
	}
	ck_assert(!_i || cracked > 50);
	q[0] = ts_orientation(one);
	q[1] = ts_orientation(other);
	ck_assert(ts_identities(other, false, &map) == TS_OK);
	for (size_t i = 0; i < one->particles->n; i++) {
		size_t j = (size_t)ts_identity_row(&map, one->particles->tag[i]);

		ck_assert(!memcmp(one->particles->x[i], other->particles->x[j], 3 * sizeof(double)));
		ck_assert(!memcmp(one->particles->omega[i], other->particles->omega[j], 3 * sizeof(double)));
		ck_assert(!memcmp(q[0][i], q[1][j], 4 * sizeof(double)));
	}
	tsim_close(one);
	tsim_close(other);
}
END_TEST

/* Of all particles of an unbounded network. */
static void momenta(const struct tsim *sim, double linear[3], double angular[3])
{
	const struct ts_particles *p = sim->particles;
	double arm[3];

	for (int c = 0; c < 3; c++)
		linear[c] = angular[c] = 0;
	for (size_t i = 0; i < p->n; i++) {
		ts_axpy(p->mass[i], p->v[i], linear);
		ts_cross(p->x[i], p->v[i], arm);
		ts_axpy(p->mass[i], arm, angular);
		ts_axpy(0.4 * p->mass[i] * p->radius[i] * p->radius[i], p->omega[i], angular);
	}
}

/* A block of particles on a lattice in free space, 3 x 3 x 3 unless said otherwise, k = 1 for all. */
static struct tsim *block(const char *size, const char *coefficients, double dt)
{
	return deck_open("units si\n"
			 "boundary f f f\n"
			 "region box block -50 50 -50 50 -50 50 units box\n"
			 "create_box 1 box\n"
			 "lattice sc 1.0\n"
			 "region some block %s units box\n"
			 "create_atoms 1 region some\n"
			 "set group all diameter 1 density 1000\n"
			 "bond_style parallel\n"
			 "bond_coeff 1 %s\n"
			 "create_bonds many all all 1 0 1.45\n"
			 "fix move all nve/sphere\n"
			 "timestep %.17g\n"
			 "thermo 100000000\n",
			 size, coefficients, dt);
}

START_TEST(momentum)
{
	struct tsim *sim = block("-1.1 1.1 -1.1 1.1 -1.1 1.1",
				 _i ? "kn 1e6 ratio 2 damping 0.1" : "kn 1e6 ratio 2", 1e-3);
	double p[2][3], l[2][3];

	deck(sim, "variable r atom random(-1,1,4711)\nvelocity all set v_r v_r v_r\n"
		  "set group all omegax 0.3 omegay -0.2");
	momenta(sim, p[0], l[0]);
	deck(sim, "run 3000");
	momenta(sim, p[1], l[1]);
	ck_assert_double_gt(ts_norm(l[0]), 1);
	for (int c = 0; c < 3; c++) {
		DECK_NEAR(p[1][c], p[0][c], 1e-8); /* of 1e4 */
		DECK_NEAR(l[1][c], l[0][c], 1e-8);
	}
	tsim_close(sim);
}
END_TEST

static double largest_force(const struct tsim *sim)
{
	double most = 0;

	for (size_t i = 0; i < sim->particles->n; i++)
		most = fmax(most, fmax(ts_norm(sim->particles->f[i]), ts_norm(sim->particles->torque[i])));
	return most;
}

/* A block turned by 2 radians about an oblique axis and shifted: no force beyond rounding, nor on the move. */
START_TEST(rigid_motion)
{
	const double k = 1e6, turn[4] = { cos(1), sin(1) * 0.6, 0, sin(1) * 0.8 };
	struct tsim *sim = block("-1.1 1.1 -1.1 1.1 -1.1 1.1", "kn 1e6 ratio 2", 1e-3);
	double m[3][3], x[3], q[4], (*all)[4];

	deck(sim, "run 0");
	ts_quaternion_matrix(turn, m);
	all = ts_orientation(sim);
	for (size_t i = 0; i < sim->particles->n; i++) {
		ts_rotate(m, sim->particles->x[i], x);
		memcpy(sim->particles->x[i], x, sizeof x);
		ts_quaternion_multiply(turn, all[i], q);
		memcpy(all[i], q, sizeof q);
	}
	deck(sim, "run 0");
	ck_assert_double_lt(largest_force(sim), 1e-12 * k);
	deck(sim, "velocity all set 2.3 -1.9 0.7\nrun 1000");
	ck_assert_double_lt(largest_force(sim), 2e-11 * k); /* of positions up to 4 */
	tsim_close(sim);
}
END_TEST

/* The same by a prescribed rotation: orientations follow the angular velocity. */
START_TEST(prescribed_rotation)
{
	struct tsim *sim = block("-1.1 1.1 -1.1 1.1 -1.1 1.1", "kn 1e6 ratio 2", 1e-3);

	deck(sim, "unfix move\nfix turn all move rotate 0 0 0 0.6 0 0.8 1.7\nrun 1000");
	ck_assert_double_lt(largest_force(sim), 1e-13 * 1e6); /* rounding of a thousand steps */
	deck(sim, "run 700");
	for (size_t i = 0; i < sim->particles->n; i++)
		DECK_NEAR(fabs(ts_orientation(sim)[i][0]), 1, 1e-12);
	tsim_close(sim);
}
END_TEST

/* ---- a cantilever along x of 11 spheres of radius 0.5, the first one held */

static const double KN = 1e9, KS = 4e8;
#define BEAM_I (TS_PI / 64)
#define BEAM_A (TS_PI / 4)
#define BEAM_M (1000 * TS_PI / 6)

static struct tsim *cantilever(int n, const char *more, double dt)
{
	struct tsim *sim = deck_open("units si\n"
				     "boundary f f f\n"
				     "region box block -20 80 -20 20 -20 20 units box\n"
				     "create_box 1 box\n"
				     "lattice sc 1.0\n"
				     "region line block 0 %g -0.1 0.1 -0.1 0.1 units box\n"
				     "create_atoms 1 region line\n"
				     "set group all diameter 1 density 1000\n"
				     "bond_style parallel\n"
				     "bond_coeff 1 kn %g ks %g %s\n"
				     "create_bonds many all all 1 0 1.05\n"
				     "group first id 1\n"
				     "group tip id %d\n"
				     "group free subtract all first\n"
				     "fix move free nve/sphere\n"
				     "review off integrator\n"
				     "thermo 100000000\n"
				     "timestep %.17g\n",
				     n + 0.1, KN, KS, more, n + 1, dt);

	ck_assert_uint_eq(sim->bonds->n, (size_t)n);
	return sim;
}

/* Critical damping of the lowest bending mode. */
static void calm(struct tsim *sim, int n)
{
	double w = 1.8751 * 1.8751 / (n * n) * sqrt(KN * BEAM_I / BEAM_M);

	deck(sim, "fix calm free viscous %.17g\nfix still free viscous/sphere %.17g", 2 * BEAM_M * w,
	     0.2 * BEAM_M * w);
}

START_TEST(deflections)
{
	enum { N = 10 };
	const double exact[2] = { N / (KN * BEAM_A),
				  pow(N, 3) / (3 * KN * BEAM_I) * (1 - 0.25 / (N * N)) + N / (KS * BEAM_A) };
	struct tsim *sim = cantilever(N, "", 3e-4);

	calm(sim, N);
	deck(sim, "fix load tip addforce %s\nrun 16000", _i ? "0 0 1" : "1000 0 0");
	if (_i)
		DECK_NEAR(deck_value(sim, "z[11]") / exact[1], 1, 1e-9);
	else
		DECK_NEAR((deck_value(sim, "x[11]") - N) / (1000 * exact[0]), 1, 1e-9);
	tsim_close(sim);
}
END_TEST

/* Lowest angular frequency: half a turn between zeros of the tip after its load is taken off. */
static double frequency(int n)
{
	struct tsim *sim = cantilever(n, "", 6e-4);
	double before = 0, first = 0, last = 0, y = 1;
	int zeros = 0;

	calm(sim, n);
	deck(sim, "fix load tip addforce 0 1 0\nrun %d\nunfix load\nunfix calm\nunfix still", 60 * n * n);
	for (int step = 0; zeros < 5; step++) {
		before = y;
		deck(sim, "run 1 pre no post no");
		y = deck_value(sim, "xcm(tip,y)");
		if (!(before * y < 0))
			continue;
		last = step + before / (before - y);
		if (!zeros++)
			first = last;
	}
	tsim_close(sim);
	return (zeros - 1) / (last - first) / 6e-4 * TS_PI;
}

START_TEST(vibration)
{
	enum { N = 16 };
	/* A beam of Euler and Bernoulli with the mass of the spheres, one of which is at the very end: length N +
	 * 1/2. Shear and rotary inertia lower it by some thousandths. */
	const double euler = pow(1.875104 / (N + 0.5), 2) * sqrt(KN * BEAM_I / BEAM_M);

	DECK_NEAR(frequency(N) / euler, 0.996, 0.004);
}
END_TEST

/* At P (L - l/2) R/I = sigma_c the first bond breaks by tension; at 0.999 of that none. */
START_TEST(breaking_load)
{
	enum { N = 10 };
	const double sigma = 40, load = sigma * BEAM_I / (0.5 * (N - 0.5));
	struct tsim *sim = cantilever(N, "sigma_c 40 tau_c 1e9", 3e-4);
	const struct ts_bonds *b = sim->bonds;

	calm(sim, N);
	deck(sim, "variable p equal %.17g*(1-exp(-step/1500))\nfix load tip addforce 0 v_p 0\nrun 16000",
	     0.9995 * load);
	ck_assert_int_eq(b->broken, 0);
	deck(sim, "variable p equal %.17g+%.17g*(step-16000)/8000\nrun 8000", 0.9995 * load, 0.0015 * load);
	ck_assert_int_eq(b->broken, 1);
	ck_assert_int_eq(b->event[0].tag[0], 1);
	ck_assert_int_eq(b->event[0].mode, TS_BOND_TENSION);
	tsim_close(sim);
}
END_TEST

/* Beams: the deflection of the continuum with 3 bonds, and the first one breaks at P L R/I = sigma_c. */
START_TEST(beam)
{
	enum { N = 3 };
	const double sigma = 40, load = sigma * BEAM_I / (0.5 * N), g = KN / 2.6, kappa = 7.8 / 8.8;
	struct tsim *sim = cantilever(N, "\nbond_style beam\nbond_coeff 1 E 1e9 nu 0.3 sigma_c 40", 3e-4);

	calm(sim, N);
	deck(sim, "variable p equal %.17g*(1-exp(-step/300))\nfix load tip addforce 0 v_p 0\nrun 8000",
	     0.9995 * load);
	ck_assert_int_eq(sim->bonds->broken, 0);
	DECK_NEAR(deck_value(sim, "xcm(tip,y)") /
			  (0.9995 * load * (pow(N, 3) / (3 * KN * BEAM_I) + N / (kappa * g * BEAM_A))),
		  1, 1e-9);
	deck(sim, "variable p equal %.17g+%.17g*(step-8000)/4000\nrun 4000", 0.9995 * load, 0.0015 * load);
	ck_assert_int_eq(sim->bonds->broken, 1);
	ck_assert_int_eq(sim->bonds->event[0].tag[0], 1);
	tsim_close(sim);
}
END_TEST

/* Torque breaks by shear, load along the axis by tension or compression. */
START_TEST(modes)
{
	static const struct {
		const char *coeff, *load;
		enum ts_bond_failure mode;
	} cases[] = {
		{ "sigma_c 10", "velocity tip set 1 0 0", TS_BOND_TENSION },
		{ "sigma_c 10 sigma_compression 10", "velocity tip set -1 0 0", TS_BOND_CRUSHED },
		{ "sigma_c 1e9 tau_c 10", "set group tip omegax 1", TS_BOND_SHEARED },
		{ "sigma_c 1e9 tau_c 10", "velocity tip set 0 0 1", TS_BOND_SHEARED },
	};
	struct tsim *sim = cantilever(1, cases[_i].coeff, 1e-4);

	deck(sim, "%s\nrun 200", cases[_i].load);
	ck_assert_int_eq(sim->bonds->broken, 1);
	ck_assert_int_eq(sim->bonds->event[0].mode, (int)cases[_i].mode);
	tsim_close(sim);
}
END_TEST

/* ---- energy and order of the time integration */

START_TEST(no_drift)
{
	struct tsim *sim = cantilever(3, "", 4e-4);
	double mean[2] = { 0 };

	deck(sim, "velocity tip set 0.1 0.3 -0.2\nset group tip omegax 0.4 omegaz 0.3\n"
		  "compute e all pe bond\nvariable e equal ke+erotate+c_e\n"
		  "fix early all ave/time 10 100 1000 v_e\nrun 1000");
	mean[0] = deck_value(sim, "f_early");
	deck(sim, "run 100000");
	mean[1] = deck_value(sim, "f_early");
	DECK_NEAR(mean[1] / mean[0], 1, 3e-4); /* the oscillation of the energy is (w h)^2, some per cent */
	tsim_close(sim);
}
END_TEST

START_TEST(order)
{
	double step[4], error[3], x[4], h = 2e-4;

	for (int k = 0; k < 4; k++, h /= 2) {
		struct tsim *sim = cantilever(3, "", h);

		deck(sim, "velocity tip set 1 3 -2\nset group tip omegax 4 omegaz 3\nrun %d", 100 << k);
		x[k] = deck_value(sim, "xcm(tip,x)+xcm(tip,y)+xcm(tip,z)");
		step[k] = h;
		tsim_close(sim);
	}
	for (int k = 0; k < 3; k++)
		error[k] = fabs(x[k] - x[k + 1]);
	DECK_NEAR(deck_order(step, error, 3), 2, 0.1);
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("parallel bonds");
	TCase *tests = tcase_create("parallel bonds");

	tcase_set_timeout(tests, 60);
	tcase_add_loop_test(tests, plain_loop, 0, 6);
	tcase_add_loop_test(tests, same_bits, 0, 3);
	tcase_add_loop_test(tests, momentum, 0, 2);
	tcase_add_test(tests, rigid_motion);
	tcase_add_test(tests, prescribed_rotation);
	tcase_add_loop_test(tests, deflections, 0, 2);
	tcase_add_test(tests, vibration);
	tcase_add_test(tests, breaking_load);
	tcase_add_test(tests, beam);
	tcase_add_loop_test(tests, modes, 0, 4);
	tcase_add_test(tests, no_drift);
	tcase_add_test(tests, order);
	suite_add_tcase(suite, tests);
	return deck_main(suite);
}
