/* The contact loop: forces of all active pairs. Here for any model; contact_batch.h has the loop for models
 * known at compile time. Both give the same bits. */
#ifndef TS_CONTACT_CONTACT_LOOP_H
#define TS_CONTACT_CONTACT_LOOP_H

#include <math.h>

#include "base/four.h"
#include "base/parallel.h"
#include "contact/pair.h"
#include "law/granular_force.h"
#include "neigh/contact_memory.h"
#include "neigh/touching_sums.h"
#include "rigid/rigid.h"

struct ts_contact_task {
	const struct ts_particles *p;
	struct ts_contact_list *list;
	const struct ts_pair *pair;
	double dt;
	bool advance; /* the history advances; false in the set-up of a run */
	bool keep;    /* a pair that parts keeps its history until the next rebuild (legacy) */
};

/* Begins a contact: the pair `at` of the block becomes the last of the touching ones, with the history that
 * it has in the list: that is read only where it may not be zero, as it is not in the cache. Where all results
 * are kept, it gets its slot when it first touches; which slot depends on the threads, but is of no effect. */
TS_INLINE void ts_contact_begin(const struct ts_contact_list *list, struct ts_active_block *block, size_t at)
{
	struct ts_active_pair *active = list->active + block->first, pair = active[at];

	active[at] = active[block->touching];
	if (pair.slot == (uint32_t)TS_PAIR_INACTIVE)
		pair.slot = __atomic_fetch_add(list->next_slot, 1, __ATOMIC_RELAXED);
	active[block->touching] = pair;
	if (list->history_width && block->touching == block->column)
		ts_contact_memory_extend(list, block);
	for (size_t c = 0; c < list->history_width; c++)
		*ts_contact_memory(block, block->touching, c) =
			list->history_by_pair ? ts_contact_history(list, pair.row)[c] : 0;
	block->touching++;
	ts_contact_set_active(list, &pair, true);
	ts_touching_sums_change(list, &pair, true);
}

/* Ends a contact: the touching pair `at` becomes the first of those that do not touch. Its history is set to
 * zero; with `keep` it stays in the list until the next rebuild. */
TS_INLINE void ts_contact_end(const struct ts_contact_list *list, struct ts_active_block *block, size_t at,
			      bool keep)
{
	struct ts_active_pair *active = list->active + block->first, pair = active[at];

	block->touching--;
	for (size_t c = 0; c < list->history_width; c++) {
		double *memory = ts_contact_memory(block, at, c);

		if (list->history_by_pair)
			ts_contact_history(list, pair.row)[c] = keep ? *memory : 0;
		*memory = *ts_contact_memory(block, block->touching, c);
	}
	active[at] = active[block->touching];
	active[block->touching] = pair;
	ts_contact_set_active(list, &pair, false);
	ts_touching_sums_change(list, &pair, false);
}

/* Sets the force and torques of a slot to zero; `parts` as in struct ts_contact_list. */
TS_INLINE void ts_contact_clear_result(const struct ts_contact_list *list, size_t slot, size_t parts)
{
	const ts_four zero = { 0 };
	ts_four *result = (ts_four *)list->result[slot * parts];

	result[0] = zero;
	if (parts > 1)
		result[1] = zero;
	if (parts > 2)
		result[2] = zero;
}

/* Inputs of the contact law: what it needs of particles i and j. Angular velocities and liquid only if the
 * model uses them. */
struct ts_contact_inputs {
	double d[3], v[3]; /* x_i - x_j, v_i - v_j: length, velocity */
	double omega[2][3], radius[2], mass[2], liquid[2];
	double imass; /* 1/m_i + 1/m_j */
	/* ts_contact_inputs_complete: R*, m*; length of d and its reciprocal, 0 for coincident centres */
	double r_eff, m_eff, distance, inverse;
	/* precomputed root, if ts_granular_model.rooted */
	double solved;
};

/* Sets what follows from d, the radii and imass. */
TS_INLINE void ts_contact_inputs_complete(struct ts_contact_inputs *e)
{
	e->distance = sqrt(ts_dot(e->d, e->d));
	e->inverse = e->distance > 0 ? 1 / e->distance : 0;
	e->r_eff = e->radius[0] * e->radius[1] / (e->radius[0] + e->radius[1]);
	e->m_eff = 1 / e->imass;
}

TS_INLINE void ts_contact_inputs(const struct ts_particles *p, size_t i, size_t j,
				 const struct ts_granular_model *m, struct ts_contact_inputs *e)
{
	for (int c = 0; c < 3; c++) {
		e->d[c] = p->x[i][c] - p->x[j][c];
		e->v[c] = p->v[i][c] - p->v[j][c];
	}
	for (int c = 0; ts_granular_turns(m) && c < 3; c++) {
		e->omega[0][c] = p->omega[i][c];
		e->omega[1][c] = p->omega[j][c];
	}
	if (ts_cohesion_bridges(m)) {
		e->liquid[0] = p->liquid[i];
		e->liquid[1] = p->liquid[j];
	}
	e->radius[0] = p->radius[i];
	e->radius[1] = p->radius[j];
	e->mass[0] = ts_rigid_inertial_mass(p, i);
	e->mass[1] = ts_rigid_inertial_mass(p, j);
	e->imass = p->imass[i] + p->imass[j];
	ts_contact_inputs_complete(e);
}

TS_INLINE void ts_contact_inputs_touch(const struct ts_contact_inputs *e, const struct ts_granular_model *m,
				       struct ts_touch *t)
{
	t->wall = false;
	t->solved = e->solved;
	t->bulge = 0;
	t->distance = e->distance;
	t->radius[0] = e->radius[0];
	t->radius[1] = e->radius[1];
	t->overlap = t->radius[0] + t->radius[1] - e->distance;
	t->r_eff = e->r_eff;
	t->m_eff = e->m_eff;
	t->mass[0] = e->mass[0];
	t->mass[1] = e->mass[1];
	t->liquid[0] = e->liquid[0];
	t->liquid[1] = e->liquid[1];
	for (int k = 0; k < 3; k++)
		t->n[k] = e->d[k] * e->inverse; /* coincident centres: no direction, so no force */
	ts_granular_arms(m, t);
	t->vn = ts_dot(e->v, t->n);
	for (int k = 0; k < 3; k++)
		t->slip[k] = t->roll[k] = t->spin[k] = 0;
	if (ts_granular_turns(m))
		ts_touch_motion(t, e->v, e->omega[0], e->omega[1]);
}

TS_INLINE void ts_contact_touch(const struct ts_particles *p, size_t i, size_t j,
				const struct ts_granular_model *m, struct ts_touch *t)
{
	struct ts_contact_inputs e = { 0 };

	ts_contact_inputs(p, i, j, m, &e);
	ts_contact_inputs_touch(&e, m, t);
}

/* Computes the blocks from .. to-1 with any model: that of the pair style, or those of the pairs of types. */
void ts_contact_share_generic(void *task, size_t from, size_t to);

/* Computes the forces of all active pairs with the function `share`, then their sum for each particle. */
enum ts_status ts_contact_loop(struct tsim *sim, const struct ts_pair *pair, ts_range_fn *share);

#endif
