/* Forces of bonds are those of a plain loop, bit for bit, whatever types and threads there are; each bond
 * stands in the slices once for either partner. Bonds that transmit moments: each is computed once. */
#include "deck.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bond/bonds.h"
#include "core/sim.h"
#include "particle/particles.h"

enum { TYPES = 3 };
static const double STIFFNESS = 400, ULTIMATE = 12, DAMPING = 0.7;

/* Type t: stiffness 400 t, the last one damped. */
static struct tsim *network(int threads, double damping)
{
	return deck_open("package omp %d grain 1\n"
			 "units lj\n"
			 "atom_style sphere\n"
			 "boundary f p f\n"
			 "region box block 0 1 0 1 0 1 units box\n"
			 "create_box 2 box\n"
			 "create_atoms 1 random 700 49979687 box\n"
			 "set type 1 diameter 0.05 density 2000\n"
			 "set group all type/fraction 2 0.4 86028121\n"
			 "velocity all create 1 15485863\n"
			 "group a type 1\n"
			 "group b type 2\n"
			 "bond_style contact\n"
			 "bond_coeff 1 stiffness %g ultimate %g\n"
			 "bond_coeff 2 stiffness %g ultimate %g\n"
			 "bond_coeff 3 stiffness %g ultimate %g damping %g\n"
			 "create_bonds many a a 1 0 0.17\n"
			 "create_bonds many b b 2 0 0.2\n"
			 "create_bonds many a b 3 0 0.09\n"
			 "fix move all nve/sphere\n"
			 "timestep 1e-5\n",
			 threads, STIFFNESS, ULTIMATE, 2 * STIFFNESS, ULTIMATE, 3 * STIFFNESS, ULTIMATE,
			 damping);
}

/* So that bonds are strained. */
static void shake(struct tsim *sim)
{
	struct ts_particles *p = sim->particles;

	for (size_t i = 0; i < p->n; i++)
		for (int k = 0; k < 3; k++)
			p->x[i][k] = fmin(fmax(p->x[i][k] + 0.01 * sin(p->tag[i] * (7.0 + k)), 0), 1);
}

/* On particle i by particle j; returns the tension. */
static double force_of(const struct tsim *sim, size_t bond, size_t i, size_t j, double damping,
		       double force[3])
{
	const struct ts_particles *p = sim->particles;
	const struct ts_bonds *b = sim->bonds;
	double d[3], length, tension;

	ts_bond_separation(sim, i, j, d);
	length = sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
	for (int k = 0; k < 3; k++)
		d[k] *= 1 / length;
	tension = b->type[bond] * STIFFNESS * (length - b->rest[bond]);
	ck_assert_double_le(fabs(tension), ULTIMATE);
	if (b->type[bond] == TYPES && damping > 0)
		tension += damping * ((p->v[i][0] - p->v[j][0]) * d[0] + (p->v[i][1] - p->v[j][1]) * d[1] +
				      (p->v[i][2] - p->v[j][2]) * d[2]);
	for (int k = 0; k < 3; k++)
		force[k] = -tension * d[k];
	return tension;
}

START_TEST(plain_loop)
{
	double damping = _i & 1 ? DAMPING : 0;
	struct tsim *sim = network(1 + (_i >> 1), damping);
	const struct ts_bonds *b = sim->bonds;
	const struct ts_particles *p = sim->particles;

	shake(sim);
	deck(sim, "run 0");
	ck_assert_int_gt(b->broken, 20);
	ck_assert_uint_gt(b->n, 1000);
	for (size_t i = 0; i < p->n; i++) {
		double sum[3] = { 0 }, force[3];

		for (size_t k = b->gather.first[i]; k < b->gather.first[i + 1]; k++) {
			size_t bond = b->gather.entry[k] >> 1,
			       j = (size_t)b->row[bond][!(b->gather.entry[k] & 1)];

			ck_assert_double_eq(b->tension[bond], force_of(sim, bond, i, j, damping, force));
			for (int c = 0; c < 3; c++)
				sum[c] += force[c];
		}
		for (int c = 0; c < 3; c++)
			ck_assert_double_eq(p->f[i][c], sum[c]);
	}
	for (size_t k = 0; k < b->nevents; k++)
		ck_assert_double_gt(fabs(b->event[k].force), ULTIMATE);
	tsim_close(sim);
}
END_TEST

/* Those of a slice have their bonds in the order of the gather, and nothing else. */
static size_t count_lane(const struct ts_bonds *b, const struct ts_bond_slice *slice, size_t lane)
{
	const struct ts_bond_slices *s = &b->slices;
	size_t i = (size_t)slice->particle[lane], first = b->gather.first[i],
	       n = b->gather.first[i + 1] - first;

	ck_assert_uint_le(n, slice->depth);
	if (lane >= slice->n)
		n = 0;
	for (size_t k = 0; k < slice->depth; k++) {
		size_t row = slice->first + k;

		ck_assert_uint_eq(s->bond[row][lane], k < n ? b->gather.entry[first + k] : TS_BOND_NONE);
		if (k >= n)
			ck_assert_int_eq(s->partner[row][lane], (int)i);
		else if (slice->type)
			ck_assert_int_eq(b->type[s->bond[row][lane] >> 1], slice->type);
	}
	return n;
}

START_TEST(slices)
{
	struct tsim *sim = network(2, 0);
	const struct ts_bonds *b = sim->bonds;
	size_t entries = 0;

	deck(sim, "delete_atoms group a\nrun 0"); /* many are left without bonds */
	ck_assert_uint_gt(b->n, 100);
	for (size_t k = 0; k < b->slices.n; k++)
		for (size_t lane = 0; lane < TS_BOND_LANES; lane++)
			entries += count_lane(b, &b->slices.slice[k], lane);
	ck_assert_uint_eq(entries, 2 * b->n);
	tsim_close(sim);
}
END_TEST

/* Whether tensions are left in each step or at the end changes nothing, nor do threads. */
START_TEST(same_bits)
{
	struct tsim *one = network(1, DAMPING), *other = network(2, DAMPING);

	deck(one, "run 300");
	deck(other, "compute c all bond/local dist force\nrun 120\nrun 180");
	ck_assert_int_gt(one->bonds->broken, 20);
	ck_assert_uint_eq(one->bonds->n, other->bonds->n);
	for (size_t k = 0; k < one->bonds->n; k++)
		ck_assert_double_eq(one->bonds->tension[k], other->bonds->tension[k]);
	for (size_t i = 0; i < one->particles->n; i++)
		for (int k = 0; k < 3; k++)
			ck_assert_double_eq(one->particles->x[i][k], other->particles->x[i][k]);
	tsim_close(one);
	tsim_close(other);
}
END_TEST

/* Bonds that transmit moments, one type. */
static struct tsim *stiff_network(int threads)
{
	return deck_open("package omp %d grain 1\n"
			 "units lj\n"
			 "atom_style sphere\n"
			 "boundary f p f\n"
			 "region box block 0 1 0 1 0 1 units box\n"
			 "create_box 1 box\n"
			 "create_atoms 1 random 700 49979687 box\n"
			 "set type 1 diameter 0.05 density 2000\n"
			 "velocity all create 1 15485863\n"
			 "bond_style parallel\n"
			 "bond_coeff 1 kn 1e4 ks 4e3 sigma_c 60\n"
			 "create_bonds many all all 1 0 0.17\n"
			 "fix move all nve/sphere\n"
			 "timestep 1e-5\n",
			 threads);
}

/* Which bond has written each slot last. */
struct slots {
	uint32_t bond[20000];
	size_t computed;
};

static void compute_chunk(const struct ts_bond_rows *rows, size_t c, struct slots *s)
{
	for (size_t r = rows->first[c]; r < rows->first[c + 1]; r++)
		for (int k = 0; k < TS_BOND_ROW_LANES; k++) {
			if (rows->row[r].bond[k] == TS_BOND_NONE)
				continue;
			ck_assert_uint_lt(rows->row[r].slot[k], sizeof s->bond / sizeof *s->bond);
			s->bond[rows->row[r].slot[k]] = rows->row[r].bond[k];
			s->computed++;
		}
}

/* A bond between two shares is computed in both, any other once; a slot is not used again before both particles
 * have summed it. */
START_TEST(each_once)
{
	struct tsim *sim = stiff_network(_i);
	const struct ts_bonds *b = sim->bonds;
	const struct ts_bond_rows *rows = &b->rows;
	struct slots s = { .computed = 0 };
	size_t between = 0;

	deck(sim, "run 0");
	ck_assert_uint_gt(b->n, 3000);
	ck_assert_int_eq(rows->shares, _i);
	for (size_t share = 0; share < (size_t)rows->shares; share++) {
		size_t c = ts_bond_share_begin(rows, share), end = ts_bond_share_begin(rows, share + 1);
		const size_t begin = c * TS_BOND_CHUNK, n = end * TS_BOND_CHUNK - begin;

		for (size_t k = 0; k < b->n; k++) /* of one end in this share */
			between += ((size_t)b->row[k][0] - begin < n) != ((size_t)b->row[k][1] - begin < n);
		for (; c < end; c++) {
			compute_chunk(rows, c, &s);
			for (size_t k = b->gather.first[c * TS_BOND_CHUNK];
			     k < b->gather.first[ts_bond_chunk_end(rows, c)]; k++) {
				ck_assert_uint_eq(rows->sum[k] & 1, b->gather.entry[k] & 1);
				ck_assert_uint_eq(s.bond[rows->sum[k] >> 1], b->gather.entry[k] >> 1);
			}
		}
	}
	ck_assert_uint_eq(s.computed, b->n + between / 2);
	tsim_close(sim);
}
END_TEST

/* Bonds that transmit moments: threads and stored loads change nothing, also while bonds break. */
START_TEST(same_moments)
{
	struct tsim *one = stiff_network(1), *other = stiff_network(3);

	deck(one, "run 300");
	deck(other, "compute c all bond/local dist force\nrun 120\nrun 180");
	ck_assert_int_gt(one->bonds->broken, 20);
	ck_assert_uint_eq(one->bonds->n, other->bonds->n);
	for (size_t k = 0; k < one->bonds->n; k++)
		ck_assert_int_eq(memcmp(&one->bonds->load[k], &other->bonds->load[k],
					sizeof one->bonds->load[k]),
				 0);
	for (size_t i = 0; i < one->particles->n; i++)
		for (int k = 0; k < 3; k++) {
			ck_assert_double_eq(one->particles->x[i][k], other->particles->x[i][k]);
			ck_assert_double_eq(one->particles->omega[i][k], other->particles->omega[i][k]);
		}
	tsim_close(one);
	tsim_close(other);
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("bonds");
	TCase *tests = tcase_create("bonds");

	tcase_set_timeout(tests, 60);
	tcase_add_loop_test(tests, plain_loop, 0, 4);
	tcase_add_test(tests, slices);
	tcase_add_test(tests, same_bits);
	tcase_add_loop_test(tests, each_once, 1, 4);
	tcase_add_test(tests, same_moments);
	suite_add_tcase(suite, tests);
	return deck_main(suite);
}
