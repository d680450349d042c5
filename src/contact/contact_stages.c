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

static void compute_batch(struct ts_batch *b, size_t n, const struct ts_granular_model *m,
			  const struct ts_granular_pair *law, double dt)
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
	s.touch = b->touch;
	s.wall = false;
	touches[m->full_arms][m->full_slip](b, &s, n);
	if (ts_normal_sticks(m))
		extend_adhesive_contacts(b, &s, n, m, law);
	ts_stages_compute(&s, n, m, law, dt);
	(m->twisting ? finish_twist : finish)(b, &s, n);
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
