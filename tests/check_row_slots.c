/* Forces of contacts that nobody looks at stand in few slots, each used by one row at a time, and are the same. */
#include "deck.h"

#include <string.h>

#include "base/alloc.h"
#include "core/sim.h"
#include "neigh/neigh.h"
#include "neigh/row_slots.h"
#include "particles/particles.h"

enum { N = 6000 };

/* A dense block of N grains that shakes between walls or in periodic images. */
static struct tsim *shake(const char *boundary, int threads, const char *more)
{
	return deck_open("package omp %d grain 1\n"
			 "atom_style sphere\n"
			 "boundary %s\n"
			 "region box block 0 1 0 1 0 2 units box\n"
			 "create_box 1 box\n"
			 "fix y all property/global youngsModulus peratomtype 5e6\n"
			 "fix n all property/global poissonsRatio peratomtype 0.3\n"
			 "fix e all property/global coefficientRestitution peratomtypepair 1 0.7\n"
			 "fix c all property/global coefficientFriction peratomtypepair 1 0.4\n"
			 "pair_style gran model hertz tangential history\n"
			 "pair_coeff * *\n"
			 "create_atoms 1 random %d 49979687 box\n"
			 "set type 1 diameter 0.072 density 2000\n"
			 "velocity all create 1 15485863\n"
			 "fix move all nve/limit radius_ratio 0.1\n"
			 "timestep 2e-5\n"
			 "%s",
			 threads, boundary, N, more);
}

struct watch {
	const struct ts_rows *rows;
	size_t *row;	  /* in each slot: the row there + 1, 0: none */
	uint8_t *waiting; /* of each row: partners that have not added it */
};

static void add_chunk(const struct watch *w, size_t c)
{
	const struct ts_rows *rows = w->rows;
	size_t last = (c + 1) * TS_ROW_CHUNK < rows->particles ? (c + 1) * TS_ROW_CHUNK : rows->particles;

	for (size_t k = rows->gather.first[c * TS_ROW_CHUNK]; k < rows->gather.first[last]; k++) {
		size_t r = rows->gather.entry[k] >> 1, slot = rows->sum[k] >> 1;

		ck_assert_uint_eq(rows->sum[k] & 1, rows->gather.entry[k] & 1);
		ck_assert_uint_eq(slot, rows->slot[r]);
		ck_assert_uint_eq(w->row[slot], r + 1); /* nobody has written over it */
		if (!--w->waiting[r])
			w->row[slot] = 0;
	}
}

/* The loop over rows, without forces. */
static void follow(const struct watch *w, size_t share)
{
	const struct ts_rows *rows = w->rows;
	size_t from, to, c = 0, done;

	ts_row_range(rows, share, &from, &to);
	for (size_t r = from; r < to; r += TS_ROW_TURN) {
		size_t end = to - r < TS_ROW_TURN ? to : r + TS_ROW_TURN;

		for (size_t k = r; k < end; k++) {
			ck_assert_uint_lt(rows->slot[k] * (size_t)rows->parts, rows->room);
			ck_assert_uint_eq(w->row[rows->slot[k]], 0);
			w->row[rows->slot[k]] = k + 1;
			w->waiting[k] = (uint8_t)(1 + ((size_t)rows->j[k] < rows->particles));
		}
		while ((done = ts_row_chunk_done(rows, from, end, &c)) < rows->chunks)
			add_chunk(w, done);
	}
}

static void check_slots(struct tsim *sim)
{
	struct ts_rows *rows = &sim->neigh->rows;
	struct watch w = { rows, ts_alloc(rows->n, sizeof *w.row), ts_alloc(rows->n, 1) };
	size_t most = 0;

	ck_assert_int_eq(ts_rows_prepare(sim, rows, false), TS_OK);
	for (size_t r = 0; r < rows->n; r++)
		most = rows->slot[r] >= most ? rows->slot[r] + 1 : most;
	if (rows->shares == 1)
		ck_assert_uint_lt(most, rows->n / 2);
	for (int share = 0; share < rows->shares; share++)
		follow(&w, (size_t)share);
	/* what is left belongs to chunks whose rows are in the shares of several threads */
	for (size_t r = 0; r < rows->n && rows->shares == 1; r++)
		ck_assert_int_eq(w.waiting[r], 0);
	ts_free(w.row);
	ts_free(w.waiting);
}

static const char *const boundaries[] = { "f f f", "p p p" };

START_TEST(one_row_at_a_time)
{
	struct tsim *sim = shake(boundaries[_i / 3], 1 + _i % 3, "run 30");

	ck_assert_uint_gt(sim->neigh->rows.n, N);
	check_slots(sim);
	tsim_close(sim);
}
END_TEST

static void same(const struct tsim *one, const struct tsim *other)
{
	const struct ts_particles *a = one->particles, *b = other->particles;

	ck_assert_uint_eq(a->n, b->n);
	ck_assert(!memcmp(a->tag, b->tag, a->n * sizeof *a->tag));
	ck_assert(!memcmp(a->x, b->x, a->n * sizeof *a->x));
	ck_assert(!memcmp(a->v, b->v, a->n * sizeof *a->v));
	ck_assert(!memcmp(a->omega, b->omega, a->n * sizeof *a->omega));
	ck_assert(!memcmp(a->f, b->f, a->n * sizeof *a->f));
	ck_assert(!memcmp(a->torque, b->torque, a->n * sizeof *a->torque));
}

/* Steps are the same whether an output may look at contacts or not. */
START_TEST(same_bits)
{
	struct tsim *passed = shake(boundaries[_i], 2, "run 40");
	struct tsim *kept = shake(boundaries[_i], 1, "compute c all pair/gran/local force\nrun 40");

	ck_assert_int_gt(kept->neigh->builds, 1);
	same(kept, passed);
	tsim_close(passed);
	tsim_close(kept);
}
END_TEST

/* A formula that names the pressure may be asked within a run, and the last step of each run can be looked at. */
START_TEST(looked_at)
{
	struct tsim *kept = shake("f f f", 1, "compute c all pair/local force\nrun 12");
	struct tsim *late = shake("f f f", 1, "run 5\nrun 7\ncompute c all pair/local force");
	struct tsim *asked = shake("f f f", 1,
				   "variable p equal press\nfix m all ave/time 1 1 3 v_p\nrun 12\n"
				   "variable m equal f_m");
	struct tsim *table = shake("f f f", 1, "thermo_style custom step enthalpy\nthermo 5\nrun 12");

	deck(kept, "compute s all reduce sum c_c");
	deck(late, "compute s all reduce sum c_c");
	ck_assert_double_gt(deck_value(kept, "c_s"), 0);
	ck_assert_double_eq(deck_value(kept, "c_s"), deck_value(late, "c_s"));
	ck_assert_double_eq(deck_value(asked, "f_m"), deck_value(late, "press"));
	ck_assert_double_eq(deck_value(table, "press"), deck_value(late, "press"));
	tsim_close(kept);
	tsim_close(late);
	tsim_close(asked);
	tsim_close(table);
}
END_TEST

static int stop(struct tsim *sim, void *data)
{
	(void)data;
	if (sim->clock.step == 7)
		tsim_stop(sim);
	return 0;
}

/* A run that is stopped does one more step, of which all is there. */
START_TEST(stopped)
{
	struct tsim *sim = shake("f f f", 1, "");

	ck_assert_int_eq(tsim_on_step(sim, TSIM_END_OF_STEP, stop, NULL), 0);
	sim->shows_contacts = false; /* the function does not look at any */
	ck_assert(!deck_accepts(sim, "run 40"));
	tsim_error_clear(sim);
	ck_assert_int_eq(sim->clock.step, 8);
	ck_assert_int_eq(sim->neigh->rows.results, TS_RESULTS_KEPT);
	tsim_close(sim);
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("slots of rows");
	TCase *tests = tcase_create("slots");

	tcase_set_timeout(tests, 60);
	tcase_add_loop_test(tests, one_row_at_a_time, 0, 6);
	tcase_add_loop_test(tests, same_bits, 0, 2);
	tcase_add_test(tests, looked_at);
	tcase_add_test(tests, stopped);
	suite_add_tcase(suite, tests);
	return deck_main(suite);
}
