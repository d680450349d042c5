/* Fix momentum: removes linear and angular momentum of a group. */
#include "core/sim.h"

#include "group/group_spin.h"
#include "math/vec3.h"
#include "particle/group_moments.h"

#include "base/banned.h"

struct state {
	int64_t every;
	double linear[3]; /* 1: remove this component, 0: keep it; NaN: not given */
	bool angular, rescale;
};

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	const struct state *s = self->state;

	for (int k = 0; k < 3; k++)
		if (s->linear[k] > 0 && s->linear[k] < 1)
			return ts_fail(&sim->error, TS_RANGE, &self->where,
				       "fix momentum: linear takes three numbers that are 0 or 1");
	if (s->linear[0] >= 0 || s->angular)
		return TS_OK;
	return ts_fail(&sim->error, TS_SYNTAX, &self->where,
		       "fix momentum: expected linear, angular or both");
}

static void remove_linear(const struct ts_instance *self, struct tsim *sim)
{
	const struct state *s = self->state;
	struct ts_particles *p = sim->particles;
	double v[3];

	ts_group_velocity(sim, self->group, v);
#pragma omp parallel for num_threads(ts_team(sim, p->n)) schedule(static)
	for (size_t i = 0; i < p->n; i++)
		for (int k = 0; ts_in_group(p, i, self->group) && k < 3; k++)
			if (s->linear[k] > 0)
				p->v[i][k] -= v[k];
}

/* v -= omega x (x - x_cm), where L = I omega. */
static void remove_angular(const struct ts_instance *self, struct tsim *sim)
{
	struct ts_particles *p = sim->particles;
	double centre[3], omega[3];

	ts_group_spin(sim, self->group, centre, omega);
#pragma omp parallel for num_threads(ts_team(sim, p->n)) schedule(static)
	for (size_t i = 0; i < p->n; i++) {
		double arm[3], rotation[3];

		if (!ts_in_group(p, i, self->group))
			continue;
		ts_unwrapped(sim, i, arm);
		ts_sub(arm, centre, arm);
		ts_cross(omega, arm, rotation);
		ts_sub(p->v[i], rotation, p->v[i]);
	}
}

static void twice_kinetic_energy_term(const struct tsim *sim, size_t i, void *context, double *term)
{
	const struct ts_particles *p = sim->particles;

	(void)context;
	term[0] = p->mass[i] * ts_dot(p->v[i], p->v[i]);
}

static bool due(const struct ts_instance *self, const struct tsim *sim)
{
	const struct state *s = self->state;

	return sim->clock.step % s->every == 0;
}

static enum ts_status end_of_step(struct ts_instance *self, struct tsim *sim)
{
	const struct state *s = self->state;
	struct ts_particles *p = sim->particles;
	double before = 0, after = 0, factor;

	if (!due(self, sim))
		return TS_OK;
	if (s->rescale)
		ts_group_sum(sim, self->group, 1, twice_kinetic_energy_term, NULL, &before);
	if (s->linear[0] >= 0)
		remove_linear(self, sim);
	if (s->angular)
		remove_angular(self, sim);
	if (s->rescale)
		ts_group_sum(sim, self->group, 1, twice_kinetic_energy_term, NULL, &after);
	if (!(after > 0))
		return TS_OK;
	factor = sqrt(before / after);
#pragma omp parallel for num_threads(ts_team(sim, p->n)) schedule(static)
	for (size_t i = 0; i < p->n; i++)
		if (ts_in_group(p, i, self->group))
			ts_scale(factor, p->v[i], p->v[i]);
	return TS_OK;
}

static const struct ts_arg args[] = {
	TS_INT("every", struct state, every, .flags = TS_POSITIONAL, .range = TS_WITHIN, .lo = 1, .hi = 1e15,
	       .help = "steps between corrections"),
	TS_VEC3("linear", struct state, linear, .flags = TS_OPTIONAL, .range = TS_FRACTION,
		.help = "three numbers, 1 or 0 for x, y and z: components of the momentum that are removed"),
	TS_FLAG("angular", struct state, angular, .help = "remove the angular momentum"),
	TS_FLAG("rescale", struct state, rescale,
		.help = "scale the velocities to keep the kinetic energy of translation"),
	TS_ARGS_END,
};

TS_STYLE(fix, ts_style, ts_fix_momentum)
const struct ts_style ts_fix_momentum = {
	.name = "momentum",
	.kind = TS_KIND_FIX,
	.ranks = TS_RANKS_OWN,
	.due = due,
	.summary = "Removes linear and angular momentum of a group",
	.doc = "Every N steps, at the end of the step, the velocity of the centre of mass is subtracted from "
	       "the velocities of the group (linear), then the rigid-body rotation omega x (x - x_cm) "
	       "(angular), where omega follows from the angular momentum L = I omega of the group. The "
	       "angular velocities of the particles themselves do not change.",
	.example = "fix still all momentum 100 linear 1 1 0 angular",
	.args = args,
	.state_size = sizeof(struct state),
	.init = init,
	.hook[TS_STAGE_END_OF_STEP] = end_of_step,
};
