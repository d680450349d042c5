#include "base/clones.h"
TS_UNROLLED

#include "contact/contact_stages.h"

#include "contact/contact_batch.h"
#include "contact/law_stages.h"

#include "base/banned.h"

TS_INLINE void touch_at(struct ts_batch *b, struct ts_stages *s, size_t k, const struct ts_granular_model *m)
{
	struct ts_contact_inputs e;
	struct ts_touch t;

	ts_batch_inputs(b, k, &e);
	ts_contact_inputs_touch(&e, m, &t);
	ts_stages_store_touch(s, k, m, &t);
	b->touch[k] = -(long long)ts_contact_inputs_within(&e, 0);
}

TS_INLINE void finish_at(struct ts_batch *b, const struct ts_stages *s, size_t k, bool twists)
{
	struct ts_granular_force f;

	ts_stages_force(s, k, twists, &f);
	for (int c = 0; c < 3; c++) {
		b->force[c][k] = b->touch[k] ? f.force[c] : 0;
		b->tangential_torque[c][k] = b->touch[k] ? f.turn[c] : 0;
		b->rolling_torque[c][k] = b->touch[k] ? f.roll[c] : 0;
	}
	b->force[3][k] = b->touch[k] ? s->less[k] : 0;
}

/* Adhesive surfaces that have been in contact attract beyond the touch: marks the few pairs that have just
 * come apart and still attract as touching. */
static void extend_adhesive_contacts(struct ts_batch *b, const struct ts_stages *s, size_t n,
				     const struct ts_granular_model *m, const struct ts_granular_pair *law)
{
	int memories = ts_granular_memory(m);

	for (size_t k = 0; k < n; k++) {
		double memory[TS_GRANULAR_MEMORY];
		struct ts_contact_inputs e;

		if (b->touch[k])
			continue;
		for (int c = 0; c < memories; c++)
			memory[c] = b->memory[c][k];
		ts_batch_inputs(b, k, &e);
		b->touch[k] = -(long long)ts_contact_inputs_within(&e, ts_granular_pull_off_reach(m, law,
												  s->r_eff[k],
												  memory));
	}
}

TS_STAGES_LOOPS(ts_batch)

/* `postponed`: see struct ts_stages; NULL: nothing is postponed. */
static void compute_staged(struct ts_batch *b, size_t n, const struct ts_granular_model *m,
			   const struct ts_granular_pair *law, double dt, long long *postponed)
{
	double *memory[TS_GRANULAR_MEMORY] = { 0 };
	struct ts_stages s;

	for (int c = 0; c < ts_granular_memory(m); c++)
		memory[c] = b->memory[c];
	s.radius[0] = b->omega[0][3];
	s.radius[1] = b->omega[1][3];
	s.mass[0] = b->mass[0];
	s.mass[1] = b->mass[1];
	s.memory = memory;
	s.touch = postponed ? postponed : b->touch;
	s.wall = false;
	s.postpones = postponed;
	touches[m->full_arms][m->full_slip](b, &s, n);
	if (ts_normal_sticks(m))
		extend_adhesive_contacts(b, &s, n, m, law);
	for (size_t k = 0; postponed && k < n; k++)
		postponed[k] = b->touch[k];
	ts_stages_compute(&s, n, m, law, dt);
	for (size_t k = 0; postponed && k < n; k++)
		postponed[k] ^= b->touch[k];
	(m->twisting ? finish_twist : finish)(b, &s, n);
}

static void compute_batch(struct ts_batch *b, size_t n, const struct ts_granular_model *m,
			  const struct ts_granular_pair *law, double dt)
{
	compute_staged(b, n, m, law, dt, NULL);
}

TS_CLONES static void compute_blocks(const struct ts_contact_task *task, size_t from, size_t to)
{
	const struct ts_particles p = *task->p;
	const struct ts_contact_list list = *task->list;
	struct ts_batch b;

	ts_batch_start(&b);
	for (size_t k = from; k < to; k++) {
		struct ts_active_block *block = &list.block[k];

		ts_batch_block(task, &p, &list, ts_pair_model(task->pair, block->type[0], block->type[1]),
			       (size_t)list.parts, compute_batch, block, &b);
	}
}

void ts_contact_share_staged(void *task, size_t from, size_t to)
{
	compute_blocks(task, from, to);
}

/* ---- sub-step detection: contacts that begin or end, a few of each block, are integrated together */

enum { LOCATED_BLOCKS = 8 };

struct located_pairs {
	struct ts_batch
		batch; /* of contacts of the block `open`; first member, by which compute_and_postpone knows the rest */
	const struct ts_contact_task *task;
	struct ts_particles p;
	struct ts_contact_list list;
	struct ts_active_block *open;
	size_t part; /* of the block */
	/* postponed contacts of one law: the pairs, and where their history is */
	struct late_pair {
		struct ts_active_pair active;
		double *memory;
		size_t column; /* distance of numbers of one history */
	} late[TS_ACTIVE_BLOCK + TS_BATCH];
	size_t n;
	struct ts_batch late_batch;
};

/* Notes the postponed ones of n contacts. */
static void postpone(struct located_pairs *w, const long long *postponed, size_t n)
{
	size_t from = w->part++ * TS_BATCH, left = w->open->touching - from;

	for (uint64_t bits = ts_batch_bits(postponed, n < left ? n : left); bits; bits &= bits - 1) {
		size_t at = from + (size_t)__builtin_ctzll(bits);

		w->late[w->n++] = (struct late_pair){ w->list.active[w->open->first + at],
						      ts_contact_memory(w->open, at, 0), w->open->column };
	}
}

static void compute_and_postpone(struct ts_batch *b, size_t n, const struct ts_granular_model *m,
				 const struct ts_granular_pair *law, double dt)
{
	long long postponed[TS_BATCH];

	compute_staged(b, n, m, law, dt, postponed);
	postpone((struct located_pairs *)b, postponed, n);
}

/* Computes the last of the postponed contacts, at most TS_BATCH. */
TS_INLINE void compute_late(struct located_pairs *w, const struct ts_active_block *like)
{
	size_t n = w->n < TS_BATCH ? w->n : TS_BATCH, whole = 0;
	const struct ts_granular_model *m = ts_pair_model(w->task->pair, like->type[0], like->type[1]);
	const struct late_pair *late = w->late + (w->n -= n), *last = late + n - 1;
	double column[TS_GRANULAR_MEMORY][TS_BATCH];
	struct ts_active_pair active[TS_BATCH];
	struct ts_batch *b = &w->late_batch;

	for (; whole < n || whole % TS_MEMORY_VECTOR; whole++) {
		const struct late_pair *pair = whole < n ? late + whole : last;

		active[whole] = pair->active;
		for (int c = 0; c < ts_granular_memory(m); c++)
			column[c][whole] = pair->memory[(size_t)c * pair->column];
	}
	for (int c = 0; c < ts_granular_memory(m); c++)
		b->memory[c] = column[c];
	for (size_t k = 0; k < whole; k += 4)
		ts_batch_load(&w->p, &w->list, m, active + k, k, b);
	ts_batch_reduce(b, whole);
	ts_batch_measure(b, whole, m);
	compute_batch(b, whole, m, ts_pair_law(w->task->pair, like->type[0], like->type[1]), w->task->dt);
	for (size_t k = 0; k < n; k += 4)
		ts_batch_store(b, (size_t)w->list.parts, active + k, k, n - k < 4 ? n - k : 4, &w->list);
	for (size_t k = 0; k < n; k++)
		for (int c = 0; c < ts_granular_memory(m); c++)
			late[k].memory[(size_t)c * late[k].column] = column[c][k];
}

/* Computes the blocks from .. to-1, at most LOCATED_BLOCKS. Contacts end when all are computed, as they move in the
 * block then. */
TS_INLINE void compute_located_group(struct located_pairs *w, size_t from, size_t to)
{
	uint64_t touching[LOCATED_BLOCKS][TS_ACTIVE_BLOCK / TS_BATCH];

	for (size_t k = from; k < to; k++) {
		struct ts_active_block *block = &w->list.block[k];
		bool same =
			w->open && w->open->type[0] == block->type[0] && w->open->type[1] == block->type[1];

		while (w->n >= (same ? TS_BATCH : 1))
			compute_late(w, w->open);
		w->open = block;
		w->part = 0;
		ts_batch_compute_block(w->task, &w->p, &w->list,
				       ts_pair_model(w->task->pair, block->type[0], block->type[1]),
				       (size_t)w->list.parts, compute_and_postpone, block, &w->batch,
				       touching[k - from]);
	}
	while (w->n)
		compute_late(w, w->open);
	for (size_t k = from; k < to; k++)
		ts_batch_end_contacts(&w->list, &w->list.block[k], touching[k - from], w->task->keep);
}

TS_CLONES static void compute_located(const struct ts_contact_task *task, size_t from, size_t to)
{
	struct located_pairs w;

	w.task = task;
	w.p = *task->p;
	w.list = *task->list;
	w.open = NULL;
	w.n = 0;
	ts_batch_start(&w.batch);
	ts_batch_start(&w.late_batch);
	for (size_t next; from < to; from = next) {
		next = to - from < LOCATED_BLOCKS ? to : from + LOCATED_BLOCKS;
		compute_located_group(&w, from, next);
	}
}

void ts_contact_share_located(void *task, size_t from, size_t to)
{
	compute_located(task, from, to);
}
