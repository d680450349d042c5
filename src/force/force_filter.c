#include "force/force_filter.h"

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

void ts_force_filter_apply(struct ts_instance *self, struct tsim *sim, double along, double across)
{
	struct ts_particles *p = sim->particles;

#pragma omp parallel for num_threads(ts_team(sim, p->n)) schedule(static)
	for (size_t i = 0; i < p->n; i++)
		if (ts_in_group(p, i, self->group))
			ts_force_filter_one(self, along, across, p->f[i]);
}
