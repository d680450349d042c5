/* Fix viscous/sphere: damping of the rotation. */
#include "core/report.h"

#include <math.h>

#include "base/clones.h"
#include "core/deferred_loops.h"
#include "particle/sphere_shape.h"
#include "particle/type_factors.h"

#include "base/banned.h"

struct state {
	double gamma;
	struct ts_words scale;
	double *factor; /* by atom type */
};

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	if (s->factor)
		return TS_OK;
	return ts_type_factors(sim, "fix viscous/sphere", &self->arena, s->scale, &s->factor);
}

struct task {
	const struct ts_particles *p;
	const struct state *s;
	int group;
};

TS_CLONES static void damp_range(void *context, size_t from, size_t to)
{
	const struct task t = *(const struct task *)context;
	double(*restrict torque)[3] = t.p->torque, (*restrict omega)[3] = t.p->omega;

	for (size_t i = from; i < to; i++) {
		double gamma = t.s->gamma * t.s->factor[t.p->type[i]];

		for (int k = 0; ts_in_group(t.p, i, t.group) && k < 3; k++)
			torque[i][k] -= gamma * omega[i][k];
	}
}

static enum ts_status add_viscous_torque(struct ts_instance *self, struct tsim *sim)
{
	struct task task = { sim->particles, self->state, self->group };

	TS_DEFER_LOOP(sim, sim->particles->n, damp_range, &task);
	return TS_OK;
}

static void add_ground(const struct ts_instance *self, const struct tsim *sim, size_t i,
		       struct ts_ground_springs *sum)
{
	const struct state *s = self->state;

	sum->turning += s->gamma * s->factor[sim->particles->type[i]] / ts_inertia(sim, i);
}

static const struct ts_arg args[] = {
	TS_REAL("gamma", struct state, gamma, .flags = TS_POSITIONAL, .range = TS_NOT_NEGATIVE,
		.unit = "torque/angular velocity", .help = "damping coefficient"),
	TS_TYPE_FACTORS(struct state, scale, "the constant"),
	TS_ARGS_END,
};

TS_STYLE(fix, ts_style, ts_fix_viscous_sphere)
const struct ts_style ts_fix_viscous_sphere = {
	.name = "viscous/sphere",
	.kind = TS_KIND_FIX,
	.ranks = TS_RANKS_OWN,
	.summary = "adds a viscous torque proportional to the angular velocity",
	.doc = "Adds the torque T = -gamma omega to each particle of the group; `scale` multiplies gamma for "
	       "a type. Velocity Verlet is stable for time steps below 2 I/gamma with the smallest moment of "
	       "inertia I.",
	.example = "fix calm all viscous/sphere 1e-6 scale 2 2.385",
	.args = args,
	.state_size = sizeof(struct state),
	.columns = TS_NEED(OMEGA) | TS_NEED(TORQUE),
	.init = init,
	.hook[TS_STAGE_POST_FORCE] = add_viscous_torque,
	.defers = TS_DEFERS(POST_FORCE),
	.ground = add_ground,
};
