#include "contact/contact_loop.h"

#include "contact/contact_pass.h"
#include "neigh/active_pairs.h"
#include "neigh/force_slots.h"

#include "base/banned.h"

/* What one row remembers, for laws that are written for one contact: from the columns of its block, and
 * back. */
static void remember(const struct ts_contact_list *rows, const struct ts_active_block *block, size_t at,
		     double memory[])
{
	for (size_t c = 0; c < rows->history_width; c++)
		memory[c] = *ts_contact_memory(rows, block, at, c);
}

static void note(const struct ts_contact_list *rows, const struct ts_active_block *block, size_t at,
		 const double memory[])
{
	for (size_t c = 0; c < rows->history_width; c++)
		*ts_contact_memory(rows, block, at, c) = memory[c];
}

/* How far beyond their touch the partners of a row still pull. */
static double beyond(const struct ts_contact_task *task, const struct ts_active_block *block, size_t at)
{
	const struct ts_contact_list *rows = task->rows;
	const struct ts_active_pair *near = &rows->near[block->first + at];
	const struct ts_granular_model *m = ts_pair_model(task->pair, block->type[0], block->type[1]);
	const struct ts_granular_pair *law = ts_pair_law(task->pair, block->type[0], block->type[1]);
	const struct ts_particles *p = task->p;
	double a = p->radius[near->i], b = p->radius[near->j], memory[TS_GRANULAR_MEMORY] = { 0 };

	if (rows->bulge)
		return rows->bulge[near->row].bulge;
	if (at < block->active)
		remember(rows, block, at, memory);
	if (ts_cohesion_bridges(m))
		return ts_granular_bridged(m, law, (double[2]){ p->liquid[near->i], p->liquid[near->j] },
					   (double[2]){ a, b }, false, memory);
	return ts_granular_beyond(m, law, a * b / (a + b), memory);
}

static void store(const struct ts_contact_list *rows, size_t slot, const struct ts_granular_model *m,
		  const struct ts_touch *t, const struct ts_granular_force *f)
{
	double *force = ts_contact_force(rows, slot), *turn = ts_contact_tangential_torque(rows, slot),
	       *roll = ts_contact_rolling_torque(rows, slot);

	force[3] = turn ? ts_granular_short(m, t) : 0;
	for (int k = 0; k < 3; k++) {
		force[k] = f->force[k];
		if (turn)
			turn[k] = f->turn[k];
		if (roll)
			roll[k] = f->roll[k];
	}
}

static bool touches(const struct ts_contact_task *task, const struct ts_active_block *block, size_t at)
{
	const struct ts_active_pair *near = &task->rows->near[block->first + at];
	const struct ts_particles *p = task->p;
	size_t i = (size_t)near->i, j = (size_t)near->j;
	double sum = p->radius[i] + p->radius[j];

	if (task->pair->sticks)
		sum += beyond(task, block, at);
	return ts_distance2(p->x[i], p->x[j]) < sum * sum;
}

static void work(const struct ts_contact_task *task, const struct ts_active_block *block, size_t at)
{
	const struct ts_pair *pair = task->pair;
	const struct ts_contact_list *rows = task->rows;
	const struct ts_active_pair *near = &rows->near[block->first + at];
	const struct ts_granular_model *m = ts_pair_model(pair, block->type[0], block->type[1]);
	double memory[TS_GRANULAR_MEMORY];
	struct ts_granular_force f;
	struct ts_touch t;

	remember(rows, block, at, memory);
	ts_contact_touch(task->p, (size_t)near->i, (size_t)near->j, m, &t);
	if (rows->bulge) {
		memory[ts_granular_multi_at(m) + TS_MULTI_BULGE] = rows->bulge[near->row].bulge;
		memory[ts_granular_multi_at(m) + TS_MULTI_RADIUS] = rows->bulge[near->row].r_eff;
		ts_granular_stand_out(m, memory, &t);
	}
	ts_granular_contact(m, ts_pair_law(pair, block->type[0], block->type[1]), &t, task->dt, task->advance,
			    memory, &f);
	note(rows, block, at, memory);
	store(rows, near->slot, m, &t, &f);
}

/* Surfaces come apart; a bridge between them that nobody has forgotten (contact/liquid.c) breaks. */
static void part(const struct ts_contact_task *task, struct ts_active_block *block, size_t at)
{
	const struct ts_granular_model *m = &task->pair->model;
	struct ts_contact_list *rows = task->rows;
	size_t met = rows->near[block->first + at].row * rows->history_width + (size_t)ts_granular_met_at(m);
	bool breaks = ts_cohesion_bridges(m) &&
		      *ts_contact_memory(rows, block, at, (size_t)ts_granular_met_at(m)) > 0;

	ts_contact_end(rows, block, at, task->keep);
	if (!breaks)
		return;
	rows->history[met] = TS_BRIDGE_BROKEN;
#pragma omp atomic write
	rows->broken = true;
}

void ts_contact_share_generic(void *context, size_t from, size_t to)
{
	const struct ts_contact_task *task = context;
	const struct ts_contact_list *rows = task->rows;

	for (size_t b = from; b < to; b++) {
		struct ts_active_block *block = &rows->block[b];
		const struct ts_active_pair *near = rows->near + block->first;

		for (size_t k = block->active; k < block->n; k++)
			if (touches(task, block, k))
				ts_contact_begin(rows, block, k);
		for (size_t k = block->active; k-- > 0;)
			if (!touches(task, block, k))
				part(task, block, k);
		for (size_t k = 0; k < block->n; k++)
			if (k < block->active)
				work(task, block, k);
			else
				ts_contact_still(rows, near[k].slot, (size_t)rows->parts);
	}
}

struct loop {
	struct ts_contact_task task;
	ts_share_fn *share;
	ts_contacts_sum_fn *gather;
};

static void force_share(void *context, size_t from, size_t to)
{
	struct loop *loop = context;

	loop->share(&loop->task, from, to);
}

static void gather_share(void *context, size_t from, size_t to)
{
	const struct loop *loop = context;

	loop->gather(loop->task.rows, loop->task.p, from, to);
}

enum ts_status ts_contact_loop(struct tsim *sim, const struct ts_pair *pair, ts_share_fn *share)
{
	struct ts_contact_list *rows = &sim->neigh->rows;
	const struct ts_particles *p = sim->particles;
	struct loop loop = { .task = { p, rows, pair, sim->clock.dt, !sim->run.in_setup,
				       sim->legacy && !pair->mixes }, /* LAMMPS forgets at once */
			     .share = share };
	struct ts_contacts_pass walk = { force_share, gather_share, &loop, rows->sets };

	ts_contact_list_locate(sim, rows);
	rows->all = pair->sticks; /* they pull beyond touch */
	TS_TRY(ts_contact_forces_prepare(sim, rows, sim->run.complete));
	loop.gather = ts_contacts_sum_of(rows);
	rows->unsettled = rows->history_width > 0;
	/* where memory does not advance, there is no loop of its own */
	if (!loop.task.advance || !(loop.task.dt > 0))
		loop.share = ts_contact_share_generic;
	TS_TRY(ts_contacts_compute(sim, &walk));
	rows->sets = false;
	return rows->broken ? ts_liquid_share(sim, pair) : TS_OK;
}
