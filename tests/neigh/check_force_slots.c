/* Forces of contacts that nobody looks at stand in few slots, each used by one row at a time, and are the
 * same. */
#include "deck.h"

#include "base/alloc.h"
#include "core/sim.h"
#include "neigh/active_pairs.h"
#include "neigh/contact_memory.h"
#include "neigh/force_slots.h"
#include "neigh/neigh.h"
#include "neigh/touching_sums.h"
#include "particle/particles.h"

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
	const struct ts_contact_list *rows;
	size_t *place;	  /* in each slot: the place of a near row in the list + 1, 0: none */
	uint8_t *waiting; /* of each row: partners that have not added it */
};

/* Each near row of the chunk is still in its slot; the sums are those of the touching rows, in the order of the
 * gather. */
static void add_chunk(const struct watch *w, size_t c)
{
	const struct ts_contact_list *rows = w->rows;
	size_t last =
		(c + 1) * TS_CONTACT_CHUNK < rows->particles ? (c + 1) * TS_CONTACT_CHUNK : rows->particles;
	const struct ts_gather *g = &rows->gather;

	ts_touching_sums_update(rows, c * TS_CONTACT_CHUNK, last);
	for (size_t i = c * TS_CONTACT_CHUNK; i < last; i++) {
		size_t n = 0;

		for (size_t k = g->first[i]; k < g->first[i + 1]; k++) {
			size_t r = g->entry[k] >> 1, slot = ts_contact_slot(rows, r);

			if (!w->waiting[r]) { /* far */
				ck_assert(!ts_contact_touches(rows, r));
				continue;
			}
			ck_assert(w->place[slot] != 0); /* nobody has written over it */
			ck_assert(rows->active[w->place[slot] - 1].row == r);
			if (ts_contact_touches(rows, r))
				ck_assert(ts_touching_sums_entry(rows, i, n++) ==
					  2 * slot + (g->entry[k] & 1));
			if (!--w->waiting[r])
				w->place[slot] = 0;
		}
		ck_assert(rows->sums[i] == n);
	}
}

/* The loop over rows, without forces. */
static void follow(const struct watch *w, size_t share)
{
	const struct ts_contact_list *rows = w->rows;
	const struct ts_contact_span *span = &rows->span[share];
	size_t c = 0, done;

	for (size_t b = span->block; b < span->block_end; b++) {
		const struct ts_active_block *block = &rows->block[b];
		size_t end = (size_t)block->first + block->n;

		for (size_t k = block->first; k < end; k++) {
			const struct ts_active_pair *near = &rows->active[k];

			ck_assert(near->slot * (size_t)rows->parts < rows->result_capacity);
			ck_assert(w->place[near->slot] == 0);
			w->place[near->slot] = k + 1;
			w->waiting[near->row] = (uint8_t)(1 + ((size_t)near->j < rows->particles));
		}
		if (b + 1 < span->block_end && (b + 1 - span->block) % TS_BLOCKS_PER_SUM)
			continue;
		while ((done = ts_contact_chunk_done(rows, span->active, end, &c)) < rows->chunks)
			add_chunk(w, done);
	}
	ck_assert_uint_eq(span->active_end, span->block_end > span->block
						    ? (size_t)rows->block[span->block_end - 1].first +
							      rows->block[span->block_end - 1].n
						    : span->active);
}

static void check_slots(struct tsim *sim)
{
	struct ts_contact_list *rows = &sim->neigh->contacts;
	struct watch w = { rows, ts_alloc(rows->n, sizeof *w.place), ts_alloc(rows->n, 1) };
	size_t most = 0;

	ck_assert_int_eq(ts_force_slots_prepare(sim, rows, false), TS_OK);
	for (size_t k = rows->span[0].active; k < rows->span[0].active_end; k++)
		most = rows->active[k].slot >= most ? rows->active[k].slot + 1 : most;
	if (rows->shares == 1)
		ck_assert(most < rows->n / 2);
	for (int share = 0; share < rows->shares; share++)
		follow(&w, (size_t)share);
	/* what is left belongs to chunks whose rows are in the shares of several threads */
	for (size_t r = 0; r < rows->n && rows->shares == 1; r++)
		ck_assert(w.waiting[r] == 0);
	ts_free(w.place);
	ts_free(w.waiting);
}

static const char *const boundaries[] = { "f f f", "p p p" };

START_TEST(one_row_at_a_time)
{
	struct tsim *sim = shake(boundaries[_i / 3], 1 + _i % 3, "run 30");

	ck_assert_uint_gt(sim->neigh->contacts.n, N);
	check_slots(sim);
	tsim_close(sim);
}
END_TEST

/* The slots that particles sum are those of the rows that touch now, though contacts have begun and ended. */
static void sums_current(const struct ts_contact_list *rows)
{
	const struct ts_gather *g = &rows->gather;

	for (size_t i = 0; i < rows->particles; i++) {
		size_t n = 0;

		for (size_t k = g->first[i]; k < g->first[i + 1]; k++) {
			uint32_t r = g->entry[k] >> 1;

			if (ts_contact_touches(rows, r))
				ck_assert(ts_touching_sums_entry(rows, i, n++) ==
					  2 * ts_contact_slot(rows, r) + (g->entry[k] & 1));
		}
		ck_assert(rows->sums[i] == n);
		for (; n < TS_SUM_ROW; n++)
			ck_assert(rows->sum[TS_SUM_ROW * i + n] == 2 * rows->zero_slot);
	}
	for (int part = 0; part < rows->parts; part++)
		for (int c = 0; c < 4; c++)
			ck_assert(rows->result[rows->zero_slot * (size_t)rows->parts + (size_t)part][c] == 0);
}

/* Of rows that are not looked at none touches, though particles have moved since these were chosen. */
START_TEST(none_missed)
{
	struct tsim *sim = shake(boundaries[_i], 2, "run 1");
	const struct ts_contact_list *rows = &sim->neigh->contacts;
	size_t far = 0;

	for (int step = 0; step < 40; step++) {
		deck(sim, "run 1 pre no post no");
		ck_assert(rows->active_chosen && !ts_active_pairs_outdated(rows));
		for (size_t r = 0; r < rows->n; r++) {
			const double *a = sim->particles->x[rows->i[r]], *b = sim->particles->x[rows->j[r]];
			double x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2];

			ck_assert(ts_contact_touches(rows, r) == (x * x + y * y + z * z < 0.072 * 0.072));
		}
		sums_current(rows);
		for (int k = 0; k < rows->shares; k++)
			far += rows->n / (size_t)rows->shares -
			       (rows->span[k].active_end - rows->span[k].active);
	}
	ck_assert_uint_gt(far, 40 * rows->n / 20);
	tsim_close(sim);
}
END_TEST

/* Steps are the same whether an output may look at contacts or not. */
START_TEST(same_bits)
{
	struct tsim *passed = shake(boundaries[_i], 2, "run 40");
	struct tsim *kept = shake(boundaries[_i], 1, "compute c all pair/gran/local force\nrun 40");

	ck_assert_int_gt(kept->neigh->builds, 1);
	deck_same(kept, passed);
	tsim_close(passed);
	tsim_close(kept);
}
END_TEST

/* A formula that names the pressure may be asked within a run, and the last step of each run can be looked
 * at. */
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

/* Pairs that have begun to touch where all results are kept: slots of their own, without gaps. */
static void begun_slots(const struct ts_contact_list *rows)
{
	uint8_t *used = ts_alloc(rows->n + 2, 1);
	size_t touching = 0, begun = 0;

	ck_assert_int_eq(rows->results, TS_RESULTS_KEPT);
	for (size_t r = 0; r < rows->n; r++) {
		size_t slot = ts_contact_slot(rows, r);

		if (!ts_contact_touches(rows, r))
			continue;
		ck_assert(slot < *rows->next_slot && slot != rows->zero_slot && !used[slot]);
		used[slot] = 1;
		touching++;
		begun += slot > rows->zero_slot;
	}
	ck_assert_uint_gt(begun, 0);
	ck_assert_uint_eq(*rows->next_slot, rows->zero_slot + 1 + begun);
	ck_assert_uint_lt(*rows->next_slot, touching + touching / 4);
	ts_free(used);
}

/* Kept results: those of touching pairs are first, without gaps; no other pair has a slot, and what is read of it is zero. */
START_TEST(kept_slots)
{
	struct tsim *sim = shake("p p p", 1 + _i, "run 30");
	struct ts_contact_list *rows = &sim->neigh->contacts;
	uint8_t *used = ts_alloc(rows->n + 1, 1);
	size_t touching = 0;

	begun_slots(rows);
	rows->active_chosen = false;
	ck_assert_int_eq(ts_force_slots_prepare(sim, rows, true), TS_OK);
	ck_assert_int_eq(rows->results, TS_RESULTS_KEPT);
	for (size_t r = 0; r < rows->n; r++) {
		size_t slot = ts_contact_slot(rows, r), kept = ts_contact_kept(rows, r);

		touching += ts_contact_touches(rows, r);
		ck_assert(ts_contact_touches(rows, r) ? kept == slot && slot < rows->zero_slot
						      : kept == rows->zero_slot);
		ck_assert(ts_contact_force(rows, kept)[0] == 0);
		ck_assert(ts_contact_touches(rows, r) || slot == TS_PAIR_INACTIVE);
		if (slot == TS_PAIR_INACTIVE)
			continue;
		ck_assert(!used[slot]);
		ck_assert((slot + 1) * (size_t)rows->parts <= rows->result_capacity);
		used[slot] = 1;
	}
	ck_assert_uint_gt(touching, 0);
	ck_assert_uint_eq(rows->zero_slot, touching);
	ts_free(used);
	tsim_close(sim);
}
END_TEST

/* Only pairs that touch have history, which stays the same when all pairs get entries. */
START_TEST(history_entries)
{
	struct tsim *sim = shake("p p p", 1 + _i, "run 30");
	struct ts_contact_list *rows = &sim->neigh->contacts;
	size_t width = rows->history_width, touching = 0, slid = 0;
	double *before = ts_alloc(rows->n * width, sizeof *before);

	ts_contacts_store_history(sim, rows);
	for (size_t r = 0; r < rows->n; r++) {
		touching += ts_contact_touches(rows, r);
		memcpy(before + r * width, ts_contact_history(rows, r), width * sizeof *before);
		ck_assert(ts_contact_touches(rows, r) != (ts_contact_history(rows, r) == rows->history));
		ck_assert(ts_contact_touches(rows, r) || before[r * width] == 0);
		slid += before[r * width] != 0;
	}
	ck_assert_uint_eq(ts_contacts_with_history(rows), touching);
	ck_assert_uint_gt(slid, touching / 2);
	ts_contacts_spread_history(rows);
	for (size_t r = 0; r < rows->n; r++)
		ck_assert(memcmp(before + r * width, ts_contact_history(rows, r), width * sizeof *before) ==
			  0);
	ts_free(before);
	tsim_close(sim);
}
END_TEST

/* A block of several pages and parts of pages, of which some bytes at both ends keep their values. */
START_TEST(cleared)
{
	enum { BYTES = 20011 };
	const size_t from[] = { 0, 1, 64, 4095 }, to[] = { BYTES, BYTES - 1, 70, 4097 };
	unsigned char *block = ts_alloc_unset(BYTES, 1);

	memset(block, 85, BYTES);
	ts_alloc_clear(block + from[_i], to[_i] - from[_i]);
	for (size_t k = 0; k < BYTES; k++)
		ck_assert(block[k] == (k >= from[_i] && k < to[_i] ? 0 : 85));
	ts_free(block);
}
END_TEST

/* The next list has the memory of results that were passed on, and of its active pairs; that of kept results is given back. */
START_TEST(memory_serves_again)
{
	struct tsim *sim = shake("p p p", 1 + _i, "run 30");
	struct ts_contact_list *rows = &sim->neigh->contacts;
	const void *results, *active;

	ck_assert_int_eq(ts_force_slots_prepare(sim, rows, false), TS_OK);
	results = rows->result;
	active = rows->active;
	ck_assert_ptr_nonnull(results);
	ck_assert_int_eq(ts_contact_list_build(sim, rows, rows->skin, NULL), TS_OK);
	ck_assert_int_eq(rows->results, TS_RESULTS_NONE);
	ck_assert_ptr_eq(rows->result, results);
	ck_assert_ptr_eq(rows->active, active);
	ck_assert(!rows->active_chosen);
	ck_assert_int_eq(ts_force_slots_prepare(sim, rows, true), TS_OK);
	ts_force_slots_forget(rows);
	ck_assert_ptr_null(rows->result);
	tsim_close(sim);
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
	sim->run.shows_contacts = false; /* the function does not look at any */
	ck_assert(!deck_accepts(sim, "run 40"));
	tsim_error_clear(sim);
	ck_assert_int_eq(sim->clock.step, 8);
	ck_assert_int_eq(sim->neigh->contacts.results, TS_RESULTS_KEPT);
	tsim_close(sim);
}
END_TEST

int main(void)
{
	Suite *suite = suite_create("slots of rows");
	TCase *tests = tcase_create("slots");

	tcase_set_timeout(tests, 60);
	tcase_add_loop_test(tests, one_row_at_a_time, 0, 6);
	tcase_add_loop_test(tests, none_missed, 0, 2);
	tcase_add_loop_test(tests, same_bits, 0, 2);
	tcase_add_loop_test(tests, kept_slots, 0, 3);
	tcase_add_loop_test(tests, history_entries, 0, 2);
	tcase_add_loop_test(tests, cleared, 0, 4);
	tcase_add_loop_test(tests, memory_serves_again, 0, 2);
	tcase_add_test(tests, looked_at);
	tcase_add_test(tests, stopped);
	suite_add_tcase(suite, tests);
	return deck_main(suite);
}
