/* Batches of active pairs: the inputs of the contact law are copied into columns, so that a law written for
 * one contact is computed for several contacts at once by vector instructions. All pairs of a batch have the
 * same law. Results equal those of the loop over single pairs, bit for bit. */
#ifndef TS_CONTACT_CONTACT_BATCH_H
#define TS_CONTACT_CONTACT_BATCH_H

#include "base/four.h"
#include "contact/contact_loop.h"
#include "contact/contact_roots.h"

struct ts_batch {
	/* inputs, see struct ts_contact_inputs; v[3]: 1/m_i + 1/m_j, omega[0][3], omega[1][3]: radii of i and
	 * j */
	double d[3][TS_BATCH], v[4][TS_BATCH], omega[2][4][TS_BATCH];
	double mass[2][TS_BATCH];
	double r_eff[TS_BATCH], m_eff[TS_BATCH];      /* R*, m* */
	double distance[TS_BATCH], inverse[TS_BATCH]; /* of the centres, and its reciprocal */
	double solved[TS_BATCH];		      /* sqrt(R* delta) in models that are `rooted` */
	/* results, zero for pairs that do not touch; touch: all bits set if the pair touches, else 0 */
	long long touch[TS_BATCH];
	double force[4][TS_BATCH], tangential_torque[3][TS_BATCH], rolling_torque[3][TS_BATCH];
	/* the rest is last, as the members before it are aligned: the history columns of the block; radii and 1/m_i +
	 * 1/m_j that all pairs have if all numbers of r_eff and m_eff are theirs, else alike[0] is no number */
	double *memory[TS_GRANULAR_MEMORY], alike[3];
} __attribute__((aligned(64)));

/* (a + signs b): differences of the three components, sum of the fourth numbers */
static const ts_four ts_contact_signs = { -1, -1, -1, 1 };
#define TS_ALIGNED_FOUR(numbers) (*(const ts_four *)(numbers))

TS_INLINE void ts_batch_start(struct ts_batch *b)
{
	b->alike[0] = NAN;
}

struct ts_batch_particle {
	const struct ts_contact_sphere *sphere;
	const struct ts_contact_motion *motion;
};

/* The two records of a particle. Their sizes are 4 and 8 times 8 bytes, factors that addresses of x86 may contain, so
 * both follow from one shifted index; the empty instruction prevents that the compiler shifts it twice. */
TS_INLINE struct ts_batch_particle ts_batch_particle(const struct ts_contact_list *list, int32_t particle)
{
	size_t at = (size_t)particle * 8;

	_Static_assert(sizeof *list->sphere == 4 * 8 && sizeof *list->motion == 8 * 8, "see above");
	__asm__("" : "+r"(at));
	return (struct ts_batch_particle){
		(const struct ts_contact_sphere *)((const char *)list->sphere + 4 * at),
		(const struct ts_contact_motion *)((const char *)list->motion + 8 * at),
	};
}

/* Loads four active pairs into the places at .. at+3 of the batch. */
TS_INLINE void ts_batch_load(const struct ts_particles *p, const struct ts_contact_list *list,
			     const struct ts_granular_model *m, const struct ts_active_pair active[4],
			     size_t at, struct ts_batch *b)
{
	ts_four d[4], v[4], wi[4], wj[4];

	for (size_t k = 0; k < 4; k++) {
		struct ts_batch_particle i = ts_batch_particle(list, active[k].i),
					 j = ts_batch_particle(list, active[k].j);

		d[k] = TS_ALIGNED_FOUR(i.sphere->position) - TS_ALIGNED_FOUR(j.sphere->position);
		v[k] = TS_ALIGNED_FOUR(i.motion->velocity) +
		       ts_contact_signs * TS_ALIGNED_FOUR(j.motion->velocity);
		wi[k] = TS_ALIGNED_FOUR(i.motion->omega);
		wj[k] = TS_ALIGNED_FOUR(j.motion->omega);
		if (ts_granular_needs_masses(m)) {
			b->mass[0][at + k] = ts_rigid_inertial_mass(p, (size_t)active[k].i);
			b->mass[1][at + k] = ts_rigid_inertial_mass(p, (size_t)active[k].j);
		}
	}
	ts_four_transpose(d);
	for (int c = 0; c < 3; c++)
		*(ts_four *)&b->d[c][at] = d[c];
	ts_four_columns(v, b->v, at);
	ts_four_columns(wi, b->omega[0], at);
	ts_four_columns(wj, b->omega[1], at);
}

TS_INLINE void ts_batch_inputs(const struct ts_batch *b, size_t k, struct ts_contact_inputs *e)
{
	*e = (struct ts_contact_inputs){
		.d = { b->d[0][k], b->d[1][k], b->d[2][k] },
		.v = { b->v[0][k], b->v[1][k], b->v[2][k] },
		.omega = { { b->omega[0][0][k], b->omega[0][1][k], b->omega[0][2][k] },
			   { b->omega[1][0][k], b->omega[1][1][k], b->omega[1][2][k] } },
		.radius = { b->omega[0][3][k], b->omega[1][3][k] },
		.mass = { b->mass[0][k], b->mass[1][k] },
		.imass = b->v[3][k],
		.r_eff = b->r_eff[k],
		.m_eff = b->m_eff[k],
		.distance = b->distance[k],
		.inverse = b->inverse[k],
		.solved = b->solved[k],
	};
}

TS_INLINE void ts_batch_reduce_at(struct ts_batch *b, size_t k)
{
	struct ts_contact_inputs e;

	ts_batch_inputs(b, k, &e);
	ts_contact_inputs_complete(&e);
	b->r_eff[k] = e.r_eff;
	b->m_eff[k] = e.m_eff;
}

/* Whether all n pairs, n a multiple of four, have the radii and 1/m_i + 1/m_j b->alike. */
TS_INLINE bool ts_batch_is_alike(const struct ts_batch *b, size_t n)
{
	const ts_four ri = TS_FOUR_BROADCAST(b->alike[0]), rj = TS_FOUR_BROADCAST(b->alike[1]),
		      imass = TS_FOUR_BROADCAST(b->alike[2]);
	ts_four_marks differ = { 0 };

	for (size_t k = 0; k < n; k += 4)
		differ |= (TS_ALIGNED_FOUR(&b->omega[0][3][k]) != ri) |
			  (TS_ALIGNED_FOUR(&b->omega[1][3][k]) != rj) |
			  (TS_ALIGNED_FOUR(&b->v[3][k]) != imass);
	return !(differ[0] | differ[1] | differ[2] | differ[3]);
}

/* R* and m* of the n pairs. Divisions take most of the time of a law: where all pairs have the same radii and masses, one
 * division serves all, also those of later batches, with the same bits. */
TS_INLINE void ts_batch_reduce(struct ts_batch *b, size_t n)
{
	const double first[3] = { b->omega[0][3][0], b->omega[1][3][0], b->v[3][0] };
	bool other = first[0] != b->alike[0] || first[1] != b->alike[1] || first[2] != b->alike[2];

	for (int c = 0; other && c < 3; c++)
		b->alike[c] = first[c];
	if (!ts_batch_is_alike(b, n)) {
		b->alike[0] = NAN;
#pragma omp simd
		for (size_t k = 0; k < n; k++)
			ts_batch_reduce_at(b, k);
	} else if (other) {
		ts_batch_reduce_at(b, 0);
		for (size_t k = 1; k < TS_BATCH; k++) {
			b->r_eff[k] = b->r_eff[0];
			b->m_eff[k] = b->m_eff[0];
		}
	}
}

/* Distances of the n pairs, and the roots of R* delta of hertz, before the loop over the law. */
TS_INLINE void ts_batch_measure(struct ts_batch *b, size_t n, const struct ts_granular_model *m)
{
	ts_contact_roots(&(struct ts_contact_roots){ { b->d[0], b->d[1], b->d[2] },
						     { b->omega[0][3], b->omega[1][3] },
						     m->rooted ? b->r_eff : NULL,
						     b->distance,
						     b->inverse,
						     b->solved },
			 n);
}

/* Whether the distance is less than the sum of the radii plus `beyond` (> 0: range of attraction, length). */
TS_INLINE bool ts_contact_inputs_within(const struct ts_contact_inputs *e, double beyond)
{
	double sum = e->radius[0] + e->radius[1] + beyond;

	return ts_dot(e->d, e->d) < sum * sum;
}

/* Computes contact k. The law is evaluated also for pairs that do not touch, and the result discarded: so
 * there is no branch. */
TS_INLINE void ts_batch_contact(struct ts_batch *b, size_t k, const struct ts_granular_model *m,
				const struct ts_granular_pair *law, double dt)
{
	double memory[TS_GRANULAR_MEMORY];
	struct ts_granular_force f;
	struct ts_contact_inputs e;
	struct ts_touch t;
	bool touches;

	ts_batch_inputs(b, k, &e);
	for (int c = 0; c < ts_granular_memory(m); c++)
		memory[c] = b->memory[c][k];
	ts_contact_inputs_touch(&e, m, &t);
	ts_granular_contact(m, law, &t, dt, true, memory, &f);
	touches = ts_contact_inputs_within(&e, 0);
	/* the history of a pair that has parted may still be needed */
	for (int c = 0; c < ts_granular_memory(m); c++)
		b->memory[c][k] = touches ? memory[c] : b->memory[c][k];
	b->touch[k] = -(long long)touches;
	for (int c = 0; c < 3; c++)
		b->force[c][k] = touches ? f.force[c] : 0;
	b->force[3][k] = touches ? ts_granular_arm_reduction(m, &t) : 0;
	for (int c = 0; ts_granular_turns(m) && c < 3; c++)
		b->tangential_torque[c][k] = touches ? f.turn[c] : 0;
	for (int c = 0; ts_granular_rolls(m) && c < 3; c++)
		b->rolling_torque[c][k] = touches ? f.roll[c] : 0;
}

/* Number of vectors in a result (ts_contact_list.parts) with this model. */
TS_INLINE size_t ts_batch_parts(const struct ts_granular_model *m)
{
	return ts_granular_rolls(m) ? 3 : ts_granular_turns(m) ? 2 : 1;
}

/* Writes one vector of the results of four pairs: columns .. at+3, three or four components. */
TS_INLINE void ts_batch_store_part(const double (*column)[TS_BATCH], int columns, size_t at,
				   ts_four *const to[4], size_t part)
{
	ts_four row[4] = { 0 };

	for (int c = 0; c < columns; c++)
		row[c] = *(const ts_four *)&column[c][at];
	ts_four_transpose(row);
	for (size_t k = 0; k < 4; k++)
		to[k][part] = row[k];
}

/* Stores the results of the n <= 4 pairs of the batch from `at` on in their slots. */
TS_INLINE void ts_batch_store(const struct ts_batch *b, size_t parts, const struct ts_active_pair *active,
			      size_t at, size_t n, const struct ts_contact_list *list)
{
	ts_four *to[4], nowhere[3];

	for (size_t k = 0; k < 4; k++)
		to[k] = k < n ? (ts_four *)list->result[active[k].slot * parts] : nowhere;
	ts_batch_store_part(b->force, 4, at, to, 0);
	if (parts > 1)
		ts_batch_store_part(b->tangential_torque, 3, at, to, 1);
	if (parts > 2)
		ts_batch_store_part(b->rolling_torque, 3, at, to, 2);
}

/* Pads the last pairs of a batch of n to a whole vector by repeating the last pair. Returns the number of
 * pairs before them. */
TS_INLINE size_t ts_batch_pad_tail(const struct ts_active_pair *active, size_t n,
				   struct ts_active_pair tail[TS_MEMORY_VECTOR])
{
	size_t from = n & ~(size_t)(TS_MEMORY_VECTOR - 1);

	for (size_t k = 0; k < TS_MEMORY_VECTOR && from < n; k++)
		tail[k] = active[from + k < n ? from + k : n - 1];
	return from;
}

/* Computes the contacts 0 .. n-1 of a batch with a model, which may be a constant; dt > 0. */
typedef void ts_batch_fn(struct ts_batch *b, size_t n, const struct ts_granular_model *m,
			 const struct ts_granular_pair *law, double dt);

TS_INLINE void ts_batch_contacts(struct ts_batch *restrict b, size_t n, const struct ts_granular_model *m,
				 const struct ts_granular_pair *restrict law, double dt)
{
	if (!(dt > 0)) /* never true: tells the compiler that dt > 0 */
		return;
#pragma omp simd
	for (size_t k = 0; k < n; k++)
		ts_batch_contact(b, k, m, law, dt);
}

/* The first n <= 64 marks (0 or all bits set) as bits of one number. The bits come from a table: the oldest
 * processors cannot shift several numbers by different widths at once. */
TS_INLINE uint64_t ts_batch_bits(const long long *mark, size_t n)
{
#define BIT(n) (uint64_t)1 << (n)
#define BITS(n) BIT(n), BIT(n + 1), BIT(n + 2), BIT(n + 3), BIT(n + 4), BIT(n + 5), BIT(n + 6), BIT(n + 7)
	static const uint64_t bit[TS_BATCH] = { BITS(0),  BITS(8),  BITS(16), BITS(24),
						BITS(32), BITS(40), BITS(48), BITS(56) };
#undef BITS
#undef BIT
	uint64_t bits = 0;

#pragma omp simd reduction(| : bits)
	for (size_t k = 0; k < n; k++)
		bits |= (uint64_t)mark[k] & bit[k];
	return bits;
}

/* Marks which of the pairs active[0 .. n-1], n <= 4, touch; marks of others are those of the first. */
TS_INLINE void ts_batch_mark_touching(const struct ts_contact_list *list, const struct ts_active_pair *active,
				      size_t n, ts_four_marks *touch)
{
	ts_four d[4];

	for (size_t k = 0; k < 4; k++) { /* vector between the centres, and sum of the radii */
		const struct ts_active_pair *pair = active + (k < n ? k : 0);

		d[k] = TS_ALIGNED_FOUR(list->sphere[pair->i].position) +
		       ts_contact_signs * TS_ALIGNED_FOUR(list->sphere[pair->j].position);
	}
	ts_four_transpose(d);
	*touch = d[0] * d[0] + d[1] * d[1] + d[2] * d[2] < d[3] * d[3];
}

/* Which of the n <= TS_BATCH pairs touch, as bits. They are collected in a vector: marks that are stored by fours and loaded
 * by eights would wait for the stores. */
TS_INLINE uint64_t ts_batch_find_touching(const struct ts_contact_list *list,
					  const struct ts_active_pair *active, size_t n)
{
	ts_four_marks bit = { 1, 2, 4, 8 }, bits = { 0 }, touch;
	size_t k = 0;

	for (; k + 4 <= n; k += 4, bit <<= 4) {
		ts_batch_mark_touching(list, active + k, 4, &touch);
		bits |= touch & bit;
	}
	if (k < n) {
		ts_batch_mark_touching(list, active + k, n - k, &touch);
		bits |= touch & bit;
	}
	return (uint64_t)(bits[0] | bits[1] | bits[2] | bits[3]) & ~(uint64_t)0 >> (TS_BATCH - n);
}

/* Begins the contacts of those pairs of the block that touch now and did not before. */
TS_INLINE void ts_batch_begin_contacts(const struct ts_contact_list *list, struct ts_active_block *block)
{
	const struct ts_active_pair *active = list->active + block->first;

	for (size_t from = block->touching; from < block->n; from += TS_BATCH) {
		size_t n = block->n - from < TS_BATCH ? block->n - from : TS_BATCH;

		for (uint64_t bits = ts_batch_find_touching(list, active + from, n); bits; bits &= bits - 1)
			ts_contact_begin(list, block, from + (size_t)__builtin_ctzll(bits));
	}
}

/* Ends the contacts that do not touch any more, from the last to the first; bits: which of the touching pairs
 * still touch. */
TS_INLINE void ts_batch_end_contacts(const struct ts_contact_list *list, struct ts_active_block *block,
				     const uint64_t *bits, bool keep)
{
	for (size_t part = TS_ACTIVE_BLOCK / TS_BATCH, active = block->touching; part-- > 0;) {
		size_t n = active > part * TS_BATCH ? active - part * TS_BATCH : 0;
		uint64_t gone = n ? ~bits[part] & ~(uint64_t)0 >> (n < TS_BATCH ? TS_BATCH - n : 0) : 0;

		while (gone) {
			int last = 63 - __builtin_clzll(gone);

			ts_contact_end(list, block, part * TS_BATCH + (size_t)last, keep);
			gone ^= (uint64_t)1 << last;
		}
	}
}

/* Prefetches what the block needs: for touching pairs the second particles and the history, for all others
 * the positions of the second particles. First particles follow each other in memory and need no prefetch. */
TS_INLINE void ts_batch_prefetch(const struct ts_contact_list *list, const struct ts_granular_model *m,
				 const struct ts_active_block *block)
{
	const struct ts_active_pair *active = list->active + block->first;

#pragma GCC unroll 4
	for (size_t k = 0; k < block->touching; k++) {
		struct ts_batch_particle j = ts_batch_particle(list, active[k].j);

		__builtin_prefetch(j.sphere);
		__builtin_prefetch(j.motion);
	}
#pragma GCC unroll 4
	for (size_t k = block->touching; k < block->n; k++)
		__builtin_prefetch(list->sphere[active[k].j].position);
	for (int c = 0; c < ts_granular_memory(m); c++)
		for (size_t k = 0; k < block->touching; k += TS_MEMORY_VECTOR)
			__builtin_prefetch(ts_contact_memory(block, k, (size_t)c), 1);
}

/* Prefetches the active pairs of a block, one block earlier. */
TS_INLINE void ts_batch_prefetch_list(const struct ts_contact_list *list, const struct ts_active_block *block)
{
	const struct ts_active_pair *active = list->active + block->first;

	for (size_t k = 0; k < block->n; k += 64 / sizeof *active)
		__builtin_prefetch(active + k, 1);
}

/* Computes the touching pairs of part `part` (TS_BATCH pairs) of a block; returns which of them touch, as
 * bits. */
TS_INLINE uint64_t ts_batch_compute_part(const struct ts_contact_task *task, const struct ts_particles *p,
					 const struct ts_contact_list *list,
					 const struct ts_granular_model *m, size_t parts,
					 ts_batch_fn *contacts, const struct ts_active_block *block,
					 size_t part, struct ts_batch *b)
{
	const struct ts_active_pair *active = list->active + block->first + part * TS_BATCH;
	const struct ts_granular_pair *law = ts_pair_law(task->pair, block->type[0], block->type[1]);
	size_t some = block->touching - part * TS_BATCH, n, whole;
	struct ts_active_pair tail[TS_MEMORY_VECTOR];

	some = some < TS_BATCH ? some : TS_BATCH;
	whole = ts_batch_pad_tail(active, some, tail);
	n = whole < some ? whole + TS_MEMORY_VECTOR : whole;
	for (int c = 0; c < ts_granular_memory(m); c++)
		b->memory[c] = ts_contact_memory(block, part * TS_BATCH, (size_t)c);
	for (size_t at = 0; at < whole; at += 4)
		ts_batch_load(p, list, m, active + at, at, b);
	for (size_t at = whole; at < n; at += 4)
		ts_batch_load(p, list, m, &tail[at - whole], at, b);
	ts_batch_reduce(b, n);
	ts_batch_measure(b, n, m);
	contacts(b, n, m, law, task->dt);
	for (size_t at = 0; at < whole; at += 4)
		ts_batch_store(b, parts, active + at, at, 4, list);
	for (size_t at = whole; at < some; at += 4)
		ts_batch_store(b, parts, &tail[at - whole], at, some - at, list);
	return ts_batch_bits(b->touch, some);
}

/* Begins and computes contacts of a block, which others follow (TS_BLOCKS_AHEAD); `parts` as in struct ts_contact_list; b: of
 * the blocks before, too. touching: which pairs still touch, for ts_batch_end_contacts. */
TS_INLINE void ts_batch_compute_block(const struct ts_contact_task *task, const struct ts_particles *p,
				      const struct ts_contact_list *list, const struct ts_granular_model *m,
				      size_t parts, ts_batch_fn *contacts, struct ts_active_block *block,
				      struct ts_batch *b, uint64_t touching[TS_ACTIVE_BLOCK / TS_BATCH])
{
	ts_batch_prefetch_list(list, block + 2);
	ts_batch_prefetch(list, m, block + 1);
	ts_batch_begin_contacts(list, block);
	for (size_t part = 0; part * TS_BATCH < block->touching; part++)
		touching[part] = ts_batch_compute_part(task, p, list, m, parts, contacts, block, part, b);
}

/* The same, and ends contacts. */
TS_INLINE void ts_batch_block(const struct ts_contact_task *task, const struct ts_particles *p,
			      const struct ts_contact_list *list, const struct ts_granular_model *m,
			      size_t parts, ts_batch_fn *contacts, struct ts_active_block *block,
			      struct ts_batch *b)
{
	uint64_t touching[TS_ACTIVE_BLOCK / TS_BATCH];

	ts_batch_compute_block(task, p, list, m, parts, contacts, block, b, touching);
	ts_batch_end_contacts(list, block, touching, task->keep);
}

/* Computes the blocks from .. to-1 of pairs that have this constant model; see ts_contact_share_generic. */
TS_INLINE void ts_contact_share_batched(const struct ts_contact_task *task, size_t from, size_t to,
					const struct ts_granular_model *m, ts_batch_fn *contacts)
{
	const struct ts_particles p = *task->p;
	const struct ts_contact_list list = *task->list;
	struct ts_batch b;

	ts_batch_start(&b);
	for (size_t k = from; k < to; k++)
		ts_batch_block(task, &p, &list, m, ts_batch_parts(m), contacts, &list.block[k], &b);
}

#endif
