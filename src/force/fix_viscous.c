#include "core/report.h"

#include <math.h>

#include "base/clones.h"
#include "base/four.h"
#include "core/deferred_loops.h"
#include "group/group_members.h"
#include "particle/particles.h"
#include "particle/type_factors.h"

#include "base/banned.h"

struct viscous {
	double gamma;
	struct ts_words scale;
	double *factor; /* by atom type */
};

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct viscous *s = self->state;

	if (s->factor)
		return TS_OK;
	return ts_type_factors(sim, "fix viscous", &self->arena, s->scale, &s->factor);
}

struct task {
	const struct ts_particles *p;
	const double *factor;
	double gamma;
	int group;
};

TS_CLONES static void damp_range(void *context, size_t from, size_t to)
{
	const struct task t = *(const struct task *)context;
	double(*restrict f)[3] = t.p->f, (*restrict v)[3] = t.p->v;
	const int32_t *restrict type = t.p->type;
	bool all = ts_group_members(t.p, t.group, from, to) == to - from;

	for (size_t i = from; i < to; i++) {
		ts_four sum;

		if (!all && !ts_in_group(t.p, i, t.group))
			continue;
		sum = TS_FOUR_LOAD(f[i]) -
		      TS_FOUR_BROADCAST(t.gamma * t.factor[type[i]]) * TS_FOUR_LOAD(v[i]);
		ts_four_store(&sum, 3, f[i]);
	}
}

static enum ts_status add_viscous_force(struct ts_instance *self, struct tsim *sim)
{
	const struct viscous *s = self->state;
	struct task task = { sim->particles, s->factor, s->gamma, self->group };

	TS_DEFER_LOOP(sim, sim->particles->n, damp_range, &task);
	return TS_OK;
}

static void add_ground(const struct ts_instance *self, const struct tsim *sim, size_t i,
		       struct ts_ground_springs *sum)
{
	const struct viscous *s = self->state;
	const struct ts_particles *p = sim->particles;

	for (int d = 0; d < 3; d++)
		sum->rate[d] += s->gamma * s->factor[p->type[i]] * p->imass[i];
}

static const struct ts_arg args[] = {
	TS_REAL("gamma", struct viscous, gamma, .flags = TS_POSITIONAL, .range = TS_NOT_NEGATIVE,
		.unit = "force/velocity", .help = "damping coefficient"),
	TS_TYPE_FACTORS(struct viscous, scale, "the constant"),
	TS_ARGS_END,
};

TS_STYLE(fix, ts_style, ts_fix_viscous)
const struct ts_style ts_fix_viscous = {
	.name = "viscous",
	.kind = TS_KIND_FIX,
	.ranks = TS_RANKS_OWN | TS_RANKS_ROWLESS,
	.summary = "adds a viscous force proportional to the velocity",
	.doc = "Adds the force f = -gamma v to each particle of the group; `scale` multiplies gamma for a "
	       "type. Velocity Verlet is stable for time steps below 2 m/gamma with the smallest mass m.",
	.example = "fix calm all viscous 0.2\nfix calm all viscous 0.2 scale 2 2.385",
	.args = args,
	.state_size = sizeof(struct viscous),
	.init = init,
	.hook = { [TS_STAGE_POST_FORCE] = add_viscous_force },
	.defers = TS_DEFERS(POST_FORCE),
	.ground = add_ground,
};
