/* The order in memory follows space where there are many particles, and no result depends on it. */
#include "deck.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/sim.h"
#include "math/vec3.h"
#include "neigh/neigh.h"
#include "neigh/order.h"
#include "particle/particles.h"

enum { N = TS_ORDER_LEAST - 1 };

/* A soft cloud that flies apart; with `extra` there is one more particle, out of reach of all, and
 * with it enough of them to be sorted. */
static struct tsim *explode(bool extra)
{
	struct tsim *sim = deck_open("boundary f f f\n"
				     "region box block -1 2 -1 2 -1 2 units box\n"
				     "create_box 1 box\n"
				     "region cube block 0 1 0 1 0 1 units box\n"
				     "pair_style spring/dashpot\n"
				     "pair_coeff * * stiffness 1.03e4 damping 3.7\n"
				     "fix move all nve\n"
				     "timestep 2.1e-4\n"
				     "create_atoms 1 random %d 86028157 cube",
				     N);

	if (extra)
		deck(sim, "create_atoms 1 single 1.7 1.8 1.9 units box");
	deck(sim, "set type 1 diameter 0.053 density 2070");
	return sim;
}

static size_t unlike(struct tsim *a, struct tsim *b, const char *column)
{
	static double x[N + 1], y[N + 1];
	size_t n = 0;

	deck_column(a, column, x, tsim_count(a), 0);
	deck_column(b, column, y, tsim_count(b), 0);
	for (int i = 0; i < N; i++)
		n += x[i] != y[i];
	return n;
}

/* Mean distance in memory between the partners of a row. */
static double spread(const struct tsim *sim)
{
	const struct ts_contact_list *rows = &sim->neigh->contacts;
	double sum = 0;

	for (size_t r = 0; r < rows->n; r++)
		sum += abs(rows->i[r] - rows->j[r]);
	return sum / (double)rows->n;
}

START_TEST(same_bits)
{
	static const char *const columns[] = { "x", "y", "z", "vx", "fy", "fz" };
	struct tsim *small = explode(false), *large = explode(true), *cut = explode(true);

	deck(small, "run 80");
	deck(large, "run 80");
	deck(cut, "run 33\nrun 0\nrun 47");
	ck_assert_int_gt(large->neigh->builds, 5);
	for (size_t k = 0; k < DECK_LENGTH(columns); k++) {
		ck_assert_uint_eq(unlike(small, large, columns[k]), 0);
		ck_assert_uint_eq(unlike(cut, large, columns[k]), 0);
	}
	ck_assert(!memcmp(cut->particles->tag, large->particles->tag, (N + 1) * sizeof(int32_t)));
	/* any two of n are n/3 apart */
	ck_assert_double_gt(spread(small), 0.3 * N);
	ck_assert_double_lt(spread(large), 0.1 * N);
	tsim_close(small);
	tsim_close(large);
	tsim_close(cut);
}
END_TEST

/* Flat, thin and coincident clouds have an order too. */
START_TEST(degenerate)
{
	static const char *const regions[] = { "0 1 0 1 0 0", "0.5 0.5 0.3 0.3 -1 2", "0 0 0 0 0 0" };
	struct tsim *sim = deck_open("boundary f f f\n"
				     "region box block -1 2 -1 2 -1 2 units box\n"
				     "create_box 1 box\n"
				     "region some block %s units box\n"
				     "create_atoms 1 random %d 86028157 some\n"
				     "set type 1 diameter 1e-9\n"
				     "fix move all nve\n"
				     "timestep 0.01",
				     regions[_i], N + 2);
	static char seen[N + 3];

	deck(sim, "run 1");
	memset(seen, 0, sizeof seen);
	for (int i = 0; i < N + 2; i++)
		seen[sim->particles->tag[i]]++;
	for (int tag = 1; tag <= N + 2; tag++)
		ck_assert_int_eq(seen[tag], 1);
	tsim_close(sim);
}
END_TEST

/* Mean distance between particles that follow one another in memory. */
static double step_in_memory(const struct tsim *sim)
{
	const struct ts_particles *p = sim->particles;
	double sum = 0;

	for (size_t i = 1; i < p->n; i++)
		sum += sqrt(ts_distance2(p->x[i], p->x[i - 1]));
	return sum / (double)(p->n - 1);
}

/* Clumps follow one another as in space, the members of each next to one another. */
START_TEST(clumps)
{
	enum { CLUMPS = N / 3 + 2 };
	struct tsim *sim = deck_open("boundary f f f\n"
				     "region box block 0 1 0 1 0 1 units box\n"
				     "create_box 1 box\n"
				     "fix three all particletemplate/multisphere 15485863 atom_type 1 "
				     "density constant 2500 nspheres 3 "
				     "ntry 2000 spheres 0 0 0 0.01 0.011 0 0 0.009 0 0.01 0 0.008 type 1\n"
				     "fix mix all particledistribution/discrete 32452843 1 three 1.0\n"
				     "fix fill all insert/pack seed 49979687 distributiontemplate mix "
				     "insert_every once overlapcheck yes "
				     "orientation random all_in yes particles_in_region %d region box\n"
				     "fix move all multisphere\n"
				     "timestep 1e-5",
				     (int)CLUMPS);
	const struct ts_particles *p = sim->particles;
	size_t changes = 0;

	deck(sim, "run 1");
	ck_assert_uint_eq(p->n, 3 * CLUMPS);
	for (size_t i = 1; i < p->n; i++)
		changes += p->body[i] != p->body[i - 1];
	ck_assert_uint_eq(changes, CLUMPS - 1);
	ck_assert_double_lt(step_in_memory(sim), 0.1);
	tsim_close(sim);
}
END_TEST

/* The members of one large body are sorted by place; any two are 0.66 apart. */
START_TEST(large_body)
{
	struct tsim *sim = explode(true);

	deck(sim, "unfix move\nfix whole all rigid single\nrun 1");
	ck_assert_double_lt(step_in_memory(sim), 0.33);
	tsim_close(sim);
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("order");
	TCase *tests = tcase_create("order in memory");

	tcase_set_timeout(tests, 60);
	tcase_add_test(tests, same_bits);
	tcase_add_test(tests, clumps);
	tcase_add_test(tests, large_body);
	tcase_add_loop_test(tests, degenerate, 0, 3);
	suite_add_tcase(suite, tests);
	return deck_main(suite);
}
