/* The C library: stepping from outside, functions that take part in steps, two simulations at once. */
#include <pthread.h>
#include <stdlib.h>
#include <string.h>

#include "deck.h"
#include "packing.h"

#include "core/sim.h"
#include "math/rng.h"
#include "neigh/neigh.h"

static struct tsim *sim;

static void open_sim(void)
{
	sim = packing_open();
}

static void close_sim(void)
{
	packing_close(sim);
}

START_TEST(pieces_are_one_run)
{
	struct tsim *whole = deck_open("%s", packing);
	struct tsim_view v = TSIM_INIT(struct tsim_view);

	deck(whole, "run 600\n");
	for (int k = 0; k < 200; k++)
		ck_assert_msg(tsim_step(sim, 1) == 0, "%s", tsim_error(sim));
	/* with a view given out, changes are looked for: there are none */
	ck_assert_int_eq(tsim_column_view(sim, "v", &v), 0);
	for (int k = 0; k < 100; k++)
		ck_assert_int_eq(tsim_step(sim, 3), 0);
	ck_assert_int_eq(tsim_step(sim, 0), 0);
	deck(sim, "run 100\n");
	packing_same(sim, whole);
	/* averages and histories too: 61 samples, none twice */
	DECK_NEAR(deck_value(sim, "f_trace[61]"), deck_value(whole, "f_trace[61]"), 0);
	tsim_close(whole);
}
END_TEST

/* Pieces do not build the contacts anew, as runs do. */
START_TEST(pieces_are_cheap)
{
	for (int k = 0; k < 100; k++)
		ck_assert_int_eq(tsim_step(sim, 1), 0);
	ck_assert_int_le(sim->neigh->builds, 20);
}
END_TEST

/* Each piece after a change is as the script would run it. */
START_TEST(a_change_between_pieces_is_seen)
{
	struct tsim *script = deck_open("%s", packing);
	size_t n = tsim_count(sim);
	double *vz = calloc(n, sizeof *vz);
	struct tsim_view v = TSIM_INIT(struct tsim_view);

	deck(script, "run 150\nvelocity all set NULL NULL -0.385 units box\nrun 150\n"
		     "velocity all set 0.2385 NULL NULL units box\nrun 150\n");
	ck_assert_int_eq(tsim_step(sim, 100), 0);
	ck_assert_int_eq(tsim_step(sim, 50), 0);
	for (size_t i = 0; i < n; i++)
		vz[i] = -0.385;
	ck_assert_int_eq(tsim_column_write(sim, "vz", vz, n), 0);
	ck_assert_int_eq(tsim_step(sim, 150), 0);
	ck_assert_int_eq(tsim_column_view(sim, "v", &v), 0);
	ck_assert(v.type == TSIM_F64 && v.width == 3 && v.count == n && v.writable);
	for (size_t i = 0; i < n; i++)
		((double(*)[3])v.data)[i][0] = 0.2385;
	ck_assert_int_eq(tsim_step(sim, 150), 0);
	packing_same(sim, script);
	free(vz);
	tsim_close(script);
}
END_TEST

struct recorder {
	int calls[3], fail_at;
	double sum_f, t_last;
};

static int record_before(struct tsim *s, void *data)
{
	(void)s;
	((struct recorder *)data)->calls[0]++;
	return 0;
}

static int push_up(struct tsim *s, void *data)
{
	struct recorder *r = data;
	struct tsim_view f = TSIM_INIT(struct tsim_view), m = TSIM_INIT(struct tsim_view);

	r->calls[1]++;
	if (tsim_column_view(s, "f", &f) || tsim_column_view(s, "mass", &m) || !f.writable || m.writable)
		return 1;
	for (size_t i = 0; i < f.count; i++)
		((double(*)[3])f.data)[i][2] += 9.81 * ((double *)m.data)[i];
	return 0;
}

static int record_end(struct tsim *s, void *data)
{
	struct recorder *r = data;

	tsim_clock(s, NULL, &r->t_last, NULL);
	return ++r->calls[2] == r->fail_at ? 17 : 0;
}

/* Gravity taken away again by a force from outside: a particle thrown flies straight. */
START_TEST(forces_from_outside)
{
	struct recorder r = { .fail_at = 1 << 30 };
	double v0, x0;

	tsim_close(sim);
	sim = deck_open("boundary f f f\nregion b block 0 9 0 9 0 9 units box\ncreate_box 1 b\n"
			"create_atoms 1 single 1 1 2.385 units box\n"
			"velocity all set 0 0 0.385\nfix g all gravity 9.81 vector 0 0 -1\n"
			"fix m all nve\ntimestep 1e-3\n");
	ck_assert_int_eq(tsim_on_step(sim, TSIM_BEFORE_FORCE, record_before, &r), 0);
	ck_assert_int_eq(tsim_on_step(sim, TSIM_AFTER_FORCE, push_up, &r), 0);
	ck_assert_int_eq(tsim_on_step(sim, TSIM_END_OF_STEP, record_end, &r), 0);
	deck(sim, "run 500\n");
	ck_assert_int_eq(tsim_step(sim, 500), 0);
	ck_assert_int_eq(r.calls[0], 1001); /* and once when the first run begins */
	ck_assert_int_eq(r.calls[1], 1001);
	ck_assert_int_eq(r.calls[2], 1000);
	DECK_NEAR(r.t_last, 1.0, 1e-12);
	DECK_NEAR(deck_value(sim, "vz[1]"), 0.385, 1e-13);
	DECK_NEAR(deck_value(sim, "z[1]"), 2.385 + 0.385, 1e-12);
	/* without it the particle falls, from the first step on */
	ck_assert_int_eq(tsim_off_step(sim, TSIM_AFTER_FORCE, push_up, &r), 0);
	ck_assert_int_eq(tsim_off_step(sim, TSIM_AFTER_FORCE, push_up, &r), TSIM_UNKNOWN);
	tsim_error_clear(sim);
	v0 = deck_value(sim, "vz[1]");
	x0 = deck_value(sim, "z[1]");
	deck(sim, "run 200\n");
	DECK_NEAR(deck_value(sim, "vz[1]"), v0 - 9.81 * 0.2, 1e-12);
	DECK_NEAR(deck_value(sim, "z[1]"), x0 + 0.2 * v0 - 9.81 * 0.2 * 0.2 / 2, 1e-12);
}
END_TEST

START_TEST(a_function_ends_the_run)
{
	struct recorder r = { .fail_at = 7 };

	ck_assert_int_eq(tsim_on_step(sim, TSIM_END_OF_STEP, record_end, &r), 0);
	ck_assert_int_eq(tsim_string(sim, "run 100\n"), TSIM_STOPPED);
	ck_assert_ptr_nonnull(strstr(tsim_error(sim), "at step 7 with code 17"));
	tsim_error_clear(sim);
	DECK_NEAR(deck_value(sim, "step"), 7, 0);
	ck_assert_int_eq(tsim_step(sim, 3), 0);
	DECK_NEAR(deck_value(sim, "step"), 10, 0);
}
END_TEST

static int ask_for_stop(struct tsim *s, void *data)
{
	int64_t step;

	tsim_clock(s, &step, NULL, NULL);
	if (step == *(const int *)data)
		tsim_stop(s);
	return 0;
}

START_TEST(stop_and_go_on)
{
	struct tsim *whole = deck_open("%s", packing);
	int at = 33;

	deck(whole, "run 100\n");
	ck_assert_int_eq(tsim_on_step(sim, TSIM_END_OF_STEP, ask_for_stop, &at), 0);
	ck_assert_int_eq(tsim_step(sim, 100), TSIM_STOPPED);
	DECK_NEAR(deck_value(sim, "step"), 33, 0);
	tsim_error_clear(sim);
	ck_assert_int_eq(tsim_step(sim, 67), 0);
	packing_same(sim, whole);
	tsim_close(whole);
}
END_TEST

/* What a function of a stage may not do, and does not harm when it tries. */
static int try_forbidden(struct tsim *s, void *data)
{
	double one = 1, many[1024] = { 0 };
	int32_t id = 1;
	struct tsim_particles p = TSIM_INIT(struct tsim_particles);
	unsigned char member[1024] = { 0 };
	int *stage = data;

	p.n = 1;
	p.x = many;
#define REFUSED(call)                       \
	ck_assert_int_eq(call, TSIM_STATE); \
	tsim_error_clear(s)
	REFUSED(tsim_line(s, "print no"));
	REFUSED(tsim_file(s, "none"));
	REFUSED(tsim_step(s, 1));
	REFUSED(tsim_create(s, &p, NULL));
	REFUSED(tsim_delete(s, &id, 1));
	REFUSED(tsim_group_set(s, "rock", member, tsim_count(s)));
	REFUSED(tsim_scatter(s, "mass", &id, &one, 1));
	REFUSED(tsim_on_step(s, TSIM_AFTER_FORCE, try_forbidden, data));
	if (*stage != TSIM_END_OF_STEP) {
		REFUSED(tsim_scatter(s, "vx", &id, &one, 1));
	}
#undef REFUSED
	tsim_close(s);
	ck_assert_int_eq(tsim_variable_number(s, "seen", *stage), 0);
	return 0;
}

START_TEST(forbidden_inside_a_step)
{
	int stage[3] = { TSIM_BEFORE_FORCE, TSIM_AFTER_FORCE, TSIM_END_OF_STEP };
	double zero = 0;
	int32_t id = 1;

	for (int k = 0; k < 3; k++)
		ck_assert_int_eq(tsim_on_step(sim, (enum tsim_stage)k, try_forbidden, &stage[k]), 0);
	deck(sim, "run 5\n");
	DECK_NEAR(deck_value(sim, "v_seen"), TSIM_END_OF_STEP, 0);
	ck_assert_int_eq(tsim_scatter(sim, "fx", &id, &zero, 1), TSIM_STATE);
	tsim_error_clear(sim);
	ck_assert_int_eq(tsim_on_step(sim, (enum tsim_stage)9, try_forbidden, NULL), TSIM_RANGE);
}
END_TEST

START_TEST(halt_makes_a_call_shorter)
{
	deck(sim, "variable now equal step\nfix end all halt 10 v_now >= 25 error soft\n");
	ck_assert_int_eq(tsim_step(sim, 20), 0);
	ck_assert_int_eq(tsim_step(sim, 20), 0);
	DECK_NEAR(deck_value(sim, "step"), 30, 0);
	ck_assert_int_eq(tsim_step(sim, 20), 0);
	DECK_NEAR(deck_value(sim, "step"), 30, 0);
}
END_TEST

START_TEST(steps_refused)
{
	struct tsim *empty = tsim_open();

	ck_assert_int_eq(tsim_step(empty, 1), TSIM_STATE);
	tsim_close(empty);
	ck_assert_int_eq(tsim_step(sim, -1), TSIM_RANGE);
	tsim_error_clear(sim);
	deck(sim, "timestep 1\n");
	ck_assert_int_ne(tsim_step(sim, 1), 0); /* beyond the limit of stability */
	tsim_error_clear(sim);
	deck(sim, "timestep 1e-4\n");
	ck_assert_int_eq(tsim_step(sim, 1), 0);
}
END_TEST

/* The k-th thing a program may do, the same for the same numbers. */
static void act(struct tsim *s, struct ts_rng *rng)
{
	size_t n = tsim_count(s);
	int32_t chosen;
	double *tags = calloc(n, sizeof *tags), value = ts_rng_uniform(rng) - 0.5;
	double x[3] = { 0.38 * ts_rng_uniform(rng), 0.1 + 0.2 * ts_rng_uniform(rng), 0.8 };
	struct tsim_particles one = { .size = sizeof one, .n = 1, .x = x };
	struct tsim_view v = TSIM_INIT(struct tsim_view);
	int what = (int)(10 * ts_rng_uniform(rng)), bad = 0;

	bad |= tsim_gather(s, "id", NULL, tags, n);
	chosen = (int32_t)tags[(size_t)((double)n * ts_rng_uniform(rng))];
	if (what < 4)
		bad |= tsim_step(s, 1 + what * what * 5);
	else if (what == 4)
		bad |= tsim_line(s, "run 7");
	else if (what == 5)
		bad |= tsim_scatter(s, "vx", &chosen, &value, 1);
	else if (what == 6)
		bad |= tsim_delete(s, &chosen, 1);
	else if (what == 7)
		bad |= tsim_create(s, &one, &chosen) ||
		       tsim_scatter(s, "radius", &chosen, (double[1]){ 0.02385 }, 1) ||
		       tsim_scatter(s, "density", &chosen, (double[1]){ 2000 }, 1);
	else if (what == 8)
		bad |= tsim_value(s, "c_nix", &value) == 0;
	else if (!tsim_column_view(s, "v", &v))
		for (size_t i = 0; i < v.count; i++)
			((double(*)[3])v.data)[i][1] *= 0.9;
	ck_assert_msg(!bad, "%s", tsim_error(s));
	tsim_error_clear(s);
	free(tags);
}

/* Any order of calls, with one thread and with two: the same bits. */
START_TEST(whatever_is_done)
{
	for (uint64_t seed = 1; seed <= 6; seed++) {
		struct tsim *one = packing_open(), *two = packing_open();
		struct ts_rng rng[2] = { ts_rng_start(2385, seed), ts_rng_start(2385, seed) };

		two->threads = 2;
		two->grain = 1;
		for (int k = 0; k < 60; k++) {
			act(one, &rng[0]);
			act(two, &rng[1]);
		}
		packing_same(one, two);
		tsim_close(one);
		tsim_close(two);
	}
}
END_TEST

static void *run_alone(void *data)
{
	struct tsim *one = tsim_open();
	double *ke = data;

	if (!tsim_string(one, packing) && !tsim_step(one, 150) && !tsim_string(one, "run 50"))
		tsim_value(one, "ke", ke);
	tsim_close(one);
	return NULL;
}

START_TEST(two_at_once)
{
	pthread_t thread[2];
	double ke[2] = { 0, 1 };

	for (int k = 0; k < 2; k++)
		ck_assert_int_eq(pthread_create(&thread[k], NULL, run_alone, &ke[k]), 0);
	for (int k = 0; k < 2; k++)
		pthread_join(thread[k], NULL);
	deck(sim, "run 200\n");
	DECK_NEAR(ke[0], deck_value(sim, "ke"), 0);
	DECK_NEAR(ke[1], ke[0], 0);
}
END_TEST

struct rows {
	int n;
	int64_t step;
	double last[3];
	int64_t stop;
};

static int count_rows(void *data, const struct tsim_row *row)
{
	struct rows *rows = data;

	ck_assert_uint_eq(row->columns, 3);
	ck_assert_str_eq(row->names[0], "Step");
	ck_assert_str_eq(row->names[2], "third");
	memcpy(rows->last, row->values, sizeof rows->last);
	rows->step = row->step;
	rows->n++;
	return row->step == rows->stop ? 7 : 0;
}

/* Each row of the log, with all digits; results do not depend on it; a code of its own ends the run. */
START_TEST(rows_are_told)
{
	struct rows rows = { .stop = 90 };
	struct tsim *other = deck_open("%s", packing);

	deck(sim, "variable third equal step/3\nthermo_style custom step ke v_third\nthermo 10\n");
	tsim_on_row(sim, count_rows, &rows);
	deck(sim, "run 25\n");
	ck_assert(rows.n == 4 && rows.step == 25);
	DECK_NEAR(rows.last[2], 25.0 / 3, 0);
	DECK_NEAR(rows.last[1], deck_value(sim, "ke"), 0);
	ck_assert_int_eq(tsim_step(sim, 35), 0);
	ck_assert_int_eq(rows.step, 60);
	deck(other, "run 60\n");
	packing_same(sim, other);
	tsim_close(other);
	ck_assert_int_eq(tsim_text(sim, "run 100", "rows"), TSIM_STOPPED);
	ck_assert_ptr_nonnull(strstr(tsim_error(sim), "ended the run at step 90 with code 7"));
	tsim_error_clear(sim);
	tsim_on_row(sim, NULL, NULL);
	deck(sim, "run 10\n");
	ck_assert_int_eq(rows.step, 90);
}
END_TEST

START_TEST(tables_are_read)
{
	static const char *const path = "check_library_steps.csv";
	struct tsim_sheet sheet = TSIM_INIT(struct tsim_sheet);
	FILE *file = fopen(path, "w");
	const double *values;
	const char *name;
	size_t n;

	fputs("depth,rate of wear\n1,2.385\n2,\n", file);
	fclose(file);
	ck_assert_msg(tsim_tables(sim, path, &n) == 0, "%s", tsim_error(sim));
	remove(path);
	ck_assert_uint_eq(n, 1);
	ck_assert_int_eq(tsim_table(sim, 0, &sheet), 0);
	ck_assert(sheet.rows == 2 && sheet.columns == 2 && !*sheet.title);
	ck_assert_int_eq(tsim_table_column(sim, 0, 1, &name, &values), 0);
	ck_assert_str_eq(name, "rate of wear");
	DECK_NEAR(values[0], 2.385, 0);
	ck_assert(values[1] != values[1]);
	ck_assert_int_eq(tsim_table_column(sim, 0, 2, &name, &values), TSIM_UNKNOWN);
	tsim_error_clear(sim);
	ck_assert_int_eq(tsim_table(sim, 1, &sheet), TSIM_UNKNOWN);
	tsim_error_clear(sim);
	ck_assert_int_eq(tsim_tables(sim, "no such file", &n), TSIM_IO);
	ck_assert_uint_eq(n, 0);
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("library steps");
	TCase *tests = tcase_create("all");

	tcase_add_checked_fixture(tests, open_sim, close_sim);
	tcase_set_timeout(tests, 120);
	tcase_add_test(tests, pieces_are_one_run);
	tcase_add_test(tests, pieces_are_cheap);
	tcase_add_test(tests, rows_are_told);
	tcase_add_test(tests, tables_are_read);
	tcase_add_test(tests, a_change_between_pieces_is_seen);
	tcase_add_test(tests, forces_from_outside);
	tcase_add_test(tests, a_function_ends_the_run);
	tcase_add_test(tests, stop_and_go_on);
	tcase_add_test(tests, forbidden_inside_a_step);
	tcase_add_test(tests, steps_refused);
	tcase_add_test(tests, halt_makes_a_call_shorter);
	tcase_add_test(tests, whatever_is_done);
	tcase_add_test(tests, two_at_once);
	suite_add_tcase(suite, tests);
	return deck_main(suite);
}
