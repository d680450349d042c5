#include "base/clones.h"
TS_UNROLLED

#include "wall/wall_stages.h"

#include <string.h>

#include "contact/law_stages.h"

#include "base/banned.h"

TS_INLINE void touch_at(const struct ts_wall_batch *b, struct ts_stages *s, size_t k,
			const struct ts_granular_model *m)
{
	struct ts_wall_ends e;
	struct ts_touch t;

	ts_wall_batch_ends(b, k, &e);
	ts_wall_ends_touch(&e, m, &t);
	ts_stages_store_touch(s, k, m, &t);
}

TS_INLINE void finish_at(struct ts_wall_batch *b, const struct ts_stages *s, size_t k, bool twists)
{
	struct ts_granular_force f;

	ts_stages_force(s, k, twists, &f);
	for (int c = 0; c < 3; c++) {
		b->force[c][k] = f.force[c];
		b->torque[c][k] = (s->radius[0][k] - s->less[k]) * f.turn[c] + f.roll[c];
		b->roll[c][k] = f.roll[c];
	}
	b->force[3][k] = s->overlap[k];
	b->torque[3][k] = s->r_eff[k];
	b->roll[3][k] = 0;
}

TS_STAGES_LOOPS(ts_wall_batch)

void ts_wall_staged(struct ts_wall_batch *b, size_t n, const struct ts_granular_model *m,
		    const struct ts_granular_pair *law, double dt)
{
	double *memory[TS_GRANULAR_MEMORY];
	long long touch[TS_BATCH];
	struct ts_stages s;

	memset(touch, -1, sizeof touch); /* all contacts of a batch touch */
	for (int c = 0; c < TS_GRANULAR_MEMORY; c++)
		memory[c] = b->memory[c];
	s.radius[0] = s.radius[1] = b->omega[3];
	s.mass[0] = s.mass[1] = b->v[3];
	s.memory = memory;
	s.touch = touch;
	s.wall = true;
	s.postpones = false;
	touches[m->full_arms][m->full_slip](b, &s, n);
	ts_stages_compute(&s, n, m, law, dt);
	(m->twisting ? finish_twist : finish)(b, &s, n);
}
