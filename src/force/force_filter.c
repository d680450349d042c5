#include "force/force_filter.h"

#include "core/deferred_loops.h"
#include "math/vec3.h"
#include "particle/particles.h"

#include "base/banned.h"

enum ts_status ts_force_filter_init(struct ts_instance *self, struct tsim *sim)
{
	struct ts_force_filter *s = self->state;
	double length = ts_norm(s->direction);

	if (!(length > 0))
		return ts_fail(&sim->error, TS_RANGE, &self->where, "fix %s: the direction has no length",
			       self->style->name);
	for (int k = 0; k < 3; k++)
		s->unit[k] = s->direction[k] / length;
	return TS_OK;
}

void ts_force_filter_one(const struct ts_instance *self, double along, double across, double f[3])
{
	const struct ts_force_filter *s = self->state;
	double part = ts_dot(f, s->unit);

	for (int k = 0; k < 3; k++) {
		double line = part * s->unit[k];

		f[k] = along * line + across * (f[k] - line);
	}
}

struct task {
	const struct ts_particles *p;
	const struct ts_instance *self;
	double along, across;
};

static void filter_range(void *context, size_t from, size_t to)
{
	const struct task *t = context;

	for (size_t i = from; i < to; i++)
		if (ts_in_group(t->p, i, t->self->group))
			ts_force_filter_one(t->self, t->along, t->across, t->p->f[i]);
}

void ts_force_filter_apply(struct ts_instance *self, struct tsim *sim, double along, double across)
{
	struct task task = { sim->particles, self, along, across };

	TS_DEFER_LOOP(sim, sim->particles->n, filter_range, &task);
}
