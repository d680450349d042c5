/* Passes over particles that wait for each other: in their order, with the context they were given, and a
 * run with them is the run in which each is done at once. */
#include "deck.h"

#include "core/sim.h"
#include "particle/particles.h"

enum { N = 3000 };

struct add {
	double *to, what;
};

static void add_share(void *context, size_t from, size_t to)
{
	const struct add *a = context;

	for (size_t i = from; i < to; i++)
		a->to[i] += a->what;
}

static void double_share(void *context, size_t from, size_t to)
{
	const struct add *a = context;

	for (size_t i = from; i < to; i++)
		a->to[i] *= 2;
}

START_TEST(in_order)
{
	struct tsim *sim = deck_open("package omp 2 grain 1\n");
	double number[N] = { 0 };
	struct add a = { number, 1 };

	TS_DEFER_LOOP(sim, N, add_share, &a);
	TS_DEFER_LOOP(sim, N, double_share, &a);
	a.what = 5; /* the first pass has its own copy */
	TS_DEFER_LOOP(sim, N, add_share, &a);
	ck_assert_double_eq(number[0], 0);
	ts_deferred_loops_run(sim);
	ts_deferred_loops_run(sim); /* nothing waits any more */
	for (size_t i = 0; i < N; i++)
		ck_assert_double_eq(number[i], 7);
	for (int k = 0; k < 3 * TS_MAX_DEFERRED; k++)
		TS_DEFER_LOOP(sim, N, add_share, &a);
	a.what = 1000;
	TS_DEFER_LOOP(sim, N / 2, add_share, &a); /* of another length: those before are done */
	ck_assert_double_eq(number[N - 1], 7 + 5 * 3 * TS_MAX_DEFERRED);
	ts_deferred_loops_run(sim);
	ck_assert_double_eq(number[0], 1007 + 5 * 3 * TS_MAX_DEFERRED);
	ck_assert_double_eq(number[N / 2], 7 + 5 * 3 * TS_MAX_DEFERRED);
	tsim_close(sim);
}
END_TEST

static struct tsim *fall(const char *more)
{
	return deck_open("atom_style sphere\n"
			 "boundary f p f\n"
			 "region box block 0 1 0 1 0 1 units box\n"
			 "create_box 2 box\n"
			 "fix y all property/global youngsModulus peratomtype 5e6 5e6\n"
			 "fix n all property/global poissonsRatio peratomtype 0.3 0.3\n"
			 "fix e all property/global coefficientRestitution peratomtypepair 2 0.7 0.5 0.5 "
			 "0.6\n"
			 "fix c all property/global coefficientFriction peratomtypepair 2 0.4 0.3 0.3 0.2\n"
			 "pair_style gran model hertz tangential history\n"
			 "pair_coeff * *\n"
			 "create_atoms 1 random 400 49979687 box\n"
			 "set type 1 diameter 0.08 density 2000\n"
			 "set atom 1*100 type 2\n"
			 "group some type 2\n"
			 "group others subtract all some\n"
			 "fix floor all wall/gran model hertz tangential history primitive type 1 zplane 0\n"
			 "fix side all wall/gran model hertz tangential history primitive type 1 xplane 0\n"
			 "fix down all gravity 9.81 vector 0.1 0 -1\n"
			 "fix move some nve/limit radius_ratio 0.1\n"
			 "fix turn others nve/sphere\n"
			 "fix calm some viscous 0.01\n"
			 "thermo_modify lost ignore\n"
			 "timestep 2e-5\n"
			 "%s",
			 more);
}

/* Outputs that look in each step leave no pass waiting. */
START_TEST(same_bits)
{
	static const char *const look[] = {
		"thermo 1\nthermo_style custom step ke\nrun 300",
		"compute c all com\nfix m all ave/time 1 1 7 c_c[3]\nrun 300",
		"group quick dynamic all region box every 3\nrun 300",
		"run 100\nrun 150\nrun 50 pre no",
	};
	struct tsim *waiting = fall("run 300"), *looking = fall(look[_i]);

	ck_assert_uint_gt(waiting->particles->n, 300);
	deck_same(waiting, looking);
	tsim_close(waiting);
	tsim_close(looking);
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("sweep");
	TCase *tests = tcase_create("passes");

	tcase_set_timeout(tests, 60);
	tcase_add_test(tests, in_order);
	tcase_add_loop_test(tests, same_bits, 0, 4);
	suite_add_tcase(suite, tests);
	return deck_main(suite);
}
