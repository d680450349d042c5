#include "contact/contact_loop.h"

#include "contact/broken_bridges.h"
#include "contact/contact_pass.h"
#include "contact/contact_sums.h"
#include "neigh/active_pairs.h"
#include "neigh/force_slots.h"

#include "base/banned.h"

/* The history of one pair, for laws that are written for one contact: copied from the columns of its block,
 * and back. */
static void load_memory(const struct ts_contact_list *list, const struct ts_active_block *block, size_t at,
			double memory[])
{
	for (size_t c = 0; c < list->history_width; c++)
		memory[c] = *ts_contact_memory(block, at, c);
}

static void store_memory(const struct ts_contact_list *list, const struct ts_active_block *block, size_t at,
			 const double memory[])
{
	for (size_t c = 0; c < list->history_width; c++)
		*ts_contact_memory(block, at, c) = memory[c];
}

/* Largest gap, length, at which the pair `at` of the block still attracts; < 0 where surfaces are pressed in.
 */
static double attraction_range(const struct ts_contact_task *task, const struct ts_active_block *block,
			       size_t at)
{
	const struct ts_contact_list *list = task->list;
	const struct ts_active_pair *active = &list->active[block->first + at];
	const struct ts_granular_model *m = ts_pair_model(task->pair, block->type[0], block->type[1]);
	const struct ts_granular_pair *law = ts_pair_law(task->pair, block->type[0], block->type[1]);
	const struct ts_particles *p = task->p;
	double a = p->radius[active->i], b = p->radius[active->j], memory[TS_GRANULAR_MEMORY] = { 0 };

	if (list->bulge)
		return list->bulge[active->row].bulge;
	if (at < block->touching)
		load_memory(list, block, at, memory);
	if (ts_cohesion_bridges(m))
		return ts_granular_bridge_reach(m, law,
						(double[2]){ p->liquid[active->i], p->liquid[active->j] },
						(double[2]){ a, b }, false, memory);
	return ts_granular_pull_off_reach(m, law, a * b / (a + b), memory);
}

static void store_result(const struct ts_contact_list *list, size_t slot, const struct ts_granular_model *m,
			 const struct ts_touch *t, const struct ts_granular_force *f)
{
	double *force = ts_contact_force(list, slot), *turn = ts_contact_tangential_torque(list, slot),
	       *roll = ts_contact_rolling_torque(list, slot);

	force[3] = turn ? ts_granular_arm_reduction(m, t) : 0;
	for (int k = 0; k < 3; k++) {
		force[k] = f->force[k];
		if (turn)
			turn[k] = f->turn[k];
		if (roll)
			roll[k] = f->roll[k];
	}
}

static bool is_in_contact(const struct ts_contact_task *task, const struct ts_active_block *block, size_t at)
{
	const struct ts_active_pair *active = &task->list->active[block->first + at];
	const struct ts_particles *p = task->p;
	size_t i = (size_t)active->i, j = (size_t)active->j;
	double sum = p->radius[i] + p->radius[j];

	if (task->pair->sticks)
		sum += attraction_range(task, block, at);
	return ts_distance2(p->x[i], p->x[j]) < sum * sum;
}

static void compute_pair(const struct ts_contact_task *task, const struct ts_active_block *block, size_t at)
{
	const struct ts_pair *pair = task->pair;
	const struct ts_contact_list *list = task->list;
	const struct ts_active_pair *active = &list->active[block->first + at];
	const struct ts_granular_model *m = ts_pair_model(pair, block->type[0], block->type[1]);
	double memory[TS_GRANULAR_MEMORY];
	struct ts_granular_force f;
	struct ts_touch t;

	load_memory(list, block, at, memory);
	ts_contact_touch(task->p, (size_t)active->i, (size_t)active->j, m, &t);
	if (list->bulge) {
		memory[ts_granular_multi_at(m) + TS_MULTI_BULGE] = list->bulge[active->row].bulge;
		memory[ts_granular_multi_at(m) + TS_MULTI_RADIUS] = list->bulge[active->row].r_eff;
		ts_granular_add_bulge(m, memory, &t);
	}
	ts_granular_contact(m, ts_pair_law(pair, block->type[0], block->type[1]), &t, task->dt, task->advance,
			    memory, &f);
	store_memory(list, block, at, memory);
	store_result(list, active->slot, m, &t, &f);
}

/* Ends a contact. If its liquid bridge still exists (contact/broken_bridges.c has not cleared it), the bridge breaks.
 */
static void end_contact(const struct ts_contact_task *task, struct ts_active_block *block, size_t at)
{
	const struct ts_granular_model *m = &task->pair->model;
	struct ts_contact_list *list = task->list;
	uint32_t r = list->active[block->first + at].row;
	bool breaks =
		ts_cohesion_bridges(m) && *ts_contact_memory(block, at, (size_t)ts_granular_met_at(m)) > 0;

	ts_contact_clear_result(list, list->active[block->first + at].slot, (size_t)list->parts);
	ts_contact_end(list, block, at, task->keep);
	if (!breaks)
		return;
	ts_contact_history(list, r)[ts_granular_met_at(m)] = TS_BRIDGE_BROKEN;
#pragma omp atomic write
	list->bridges_broken = true;
}

void ts_contact_share_generic(void *context, size_t from, size_t to)
{
	const struct ts_contact_task *task = context;
	const struct ts_contact_list *list = task->list;

	for (size_t b = from; b < to; b++) {
		struct ts_active_block *block = &list->block[b];

		for (size_t k = block->touching; k < block->n; k++)
			if (is_in_contact(task, block, k))
				ts_contact_begin(list, block, k);
		for (size_t k = block->touching; k-- > 0;)
			if (!is_in_contact(task, block, k))
				end_contact(task, block, k);
		for (size_t k = 0; k < block->touching; k++)
			compute_pair(task, block, k);
	}
}

struct force_pass {
	struct ts_contact_task task;
	ts_range_fn *share;
	ts_contact_sums_fn *sum;
};

static void force_share(void *context, size_t from, size_t to)
{
	struct force_pass *loop = context;

	loop->share(&loop->task, from, to);
}

static void sum_share(void *context, size_t from, size_t to)
{
	const struct force_pass *loop = context;

	loop->sum(loop->task.list, loop->task.p, from, to);
}

enum ts_status ts_contact_loop(struct tsim *sim, const struct ts_pair *pair, ts_range_fn *share)
{
	struct ts_contact_list *list = &sim->neigh->contacts;
	const struct ts_particles *p = sim->particles;
	struct force_pass loop = { .task = { p, list, pair, sim->clock.dt, !sim->run.in_setup,
					     /* the history of LAMMPS' laws ends with the contact */
					     sim->legacy == TS_LEGACY_LIGGGHTS && !pair->mixes },
				   .share = share };
	struct ts_contacts_pass pass = { force_share, sum_share, &loop, list->overwrite_sums };

	ts_contact_list_locate(sim, list);
	list->all_active = pair->sticks; /* adhesive laws attract beyond the touch */
	TS_TRY(ts_force_slots_prepare(sim, list, sim->run.complete));
	loop.sum = ts_contact_sums_of(list);
	list->memory_newer = list->history_width > 0;
	/* the specialised loops always advance the history */
	if (!loop.task.advance || !(loop.task.dt > 0))
		loop.share = ts_contact_share_generic;
	TS_TRY(ts_contacts_compute(sim, &pass));
	list->overwrite_sums = false;
	return list->bridge_column ? ts_broken_bridges_redistribute(sim, pair) : TS_OK;
}
