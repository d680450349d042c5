/* -explain prices a run by trying some steps of it: nothing of that may be seen afterwards. */
#include <string.h>

#include "deck.h"

#include "core/sim.h"
#include "explain/price.h"

static const char scene[] = "units si\n"
			    "boundary p p p\n"
			    "region b block 0 1 0 1 0 1 units box\n"
			    "create_box 1 b\n"
			    "create_atoms 1 random 60 86028157 b\n"
			    "set type 1 diameter 0.11 density 2385\n"
			    "velocity all create 0.385 49979687\n"
			    "pair_style spring/dashpot\n"
			    "pair_coeff * * stiffness 2385 restitution 0.5\n"
			    "fix move all nve\n"
			    "fix pull all gravity 9.81 vector 0 0 -1\n"
			    "timestep 1e-4\n";
enum { N = 60 };
static const char *const columns[] = { "x", "y", "z", "vx", "vy", "vz", "fx", "fy", "fz" };

static void state(struct tsim *sim, double out[DECK_LENGTH(columns)][N])
{
	for (size_t k = 0; k < DECK_LENGTH(columns); k++)
		ck_assert_int_eq(tsim_column_read(sim, columns[k], out[k], N), 0);
}

/* With two threads too: the copy must not wait for threads it does not have. */
static void no_trace(int threads)
{
	struct tsim *sim = deck_open("package omp %d grain 8\n%s", threads, scene);
	double before[DECK_LENGTH(columns)][N], after[DECK_LENGTH(columns)][N];

	deck(sim, "run 20");
	state(sim, before);
	sim->reading.explain = true;
	deck(sim, "run 1000");
	sim->reading.explain = false;
	state(sim, after);
	ck_assert_mem_eq(before, after, sizeof before);
	ck_assert_msg(sim->cost.last.seconds > 0 && sim->cost.last.seconds < 1, "a step takes %g s",
		      sim->cost.last.seconds);
	ck_assert(fabs(sim->cost.seconds / (1000 * sim->cost.last.seconds) - 1) < 1e-9);
	tsim_close(sim);
}

START_TEST(trial_leaves_no_trace)
{
	no_trace(1);
	no_trace(2);
}
END_TEST

START_TEST(units)
{
	struct ts_str text = { 0 };

	ts_price_time(0.002385, &text);
	ts_str_add(&text, " ");
	ts_price_time(23.85, &text);
	ts_str_add(&text, " ");
	ts_price_time(2385, &text);
	ts_str_add(&text, " ");
	ts_price_time(238500, &text);
	ts_str_add(&text, " ");
	ts_price_bytes(238, &text);
	ts_str_add(&text, " ");
	ts_price_bytes(23.85e6, &text);
	ck_assert_str_eq(ts_str_text(&text), "2.38 ms 23.9 s 39.8 min 2.76 days 238 bytes 23.9 MB");
	ts_str_release(&text);
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("price");
	TCase *all = tcase_create("all");

	tcase_set_timeout(all, 60);
	tcase_add_test(all, trial_leaves_no_trace);
	tcase_add_test(all, units);
	suite_add_tcase(suite, all);
	return deck_main(suite);
}
