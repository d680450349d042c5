/* Fix momentum: removes linear and angular momentum of a group. */
#include "core/sim.h"

#include "group/group_motion.h"
#include "math/vec3.h"
#include "particle/group_moments.h"
#include "rigid/rigid_change.h"
#include "rigid/rigid_share.h"

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
	if (!(s->linear[0] >= 0) && !s->angular)
		return ts_fail(&sim->error, TS_SYNTAX, &self->where,
			       "fix momentum: expected linear, angular or both");
	return ts_rigid_require_whole(sim, self->group, "fix momentum", &self->where);
}

/* In the group, and not in a rigid body, whose motion is that of the body. */
static bool moves_alone(const struct ts_instance *self, const struct ts_particles *p, size_t i)
{
	return ts_in_group(p, i, self->group) && !ts_rigid_member(p, i);
}

static enum ts_status remove_linear(const struct ts_instance *self, struct tsim *sim)
{
	const struct state *s = self->state;
	struct ts_particles *p = sim->particles;
	struct ts_rigid_motion mean = { 0 };
	double v[3];

	ts_group_velocity(sim, self->group, v);
	for (int k = 0; k < 3; k++)
		mean.v[k] = s->linear[k] > 0 ? v[k] : 0;
#pragma omp parallel for num_threads(ts_team(sim, p->n)) schedule(static)
	for (size_t i = 0; i < p->n; i++)
		if (moves_alone(self, p, i))
			ts_sub(p->v[i], mean.v, p->v[i]);
	return ts_rigid_subtract_motion(sim, self->group, false, &mean);
}

/* v -= omega x (x - x_cm), where L = I omega. */
static enum ts_status remove_angular(const struct ts_instance *self, struct tsim *sim)
{
	struct ts_particles *p = sim->particles;
	struct ts_rigid_motion mean = { 0 };

	ts_group_spin(sim, self->group, mean.centre, mean.omega);
#pragma omp parallel for num_threads(ts_team(sim, p->n)) schedule(static)
	for (size_t i = 0; i < p->n; i++) {
		double arm[3], rotation[3];

		if (!moves_alone(self, p, i))
			continue;
		ts_unwrapped(sim, i, arm);
		ts_sub(arm, mean.centre, arm);
		ts_cross(mean.omega, arm, rotation);
		ts_sub(p->v[i], rotation, p->v[i]);
	}
	return ts_rigid_subtract_motion(sim, self->group, false, &mean);
}

static void twice_kinetic_energy_term(const struct tsim *sim, size_t i, const void *context, double *term)
{
	const double *v = ts_rigid_share_velocity(sim, i);

	(void)context;
	term[0] = sim->particles->mass[i] * ts_dot(v, v);
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
	TS_TRY(ts_rigid_require_whole(sim, self->group, "fix momentum", &self->where));
	if (s->linear[0] >= 0)
		TS_TRY(remove_linear(self, sim));
	if (s->angular)
		TS_TRY(remove_angular(self, sim));
	if (s->rescale)
		ts_group_sum(sim, self->group, 1, twice_kinetic_energy_term, NULL, &after);
	if (!(after > 0))
		return TS_OK;
	factor = sqrt(before / after);
#pragma omp parallel for num_threads(ts_team(sim, p->n)) schedule(static)
	for (size_t i = 0; i < p->n; i++)
		if (moves_alone(self, p, i))
			ts_scale(factor, p->v[i], p->v[i]);
	return ts_rigid_scale_motion(sim, self->group, factor);
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
	       "angular velocities of the particles themselves do not change.\n\n"
	       "Rigid bodies get the same change of the velocity of their centre of mass, and are turned by "
	       "omega less (angular), but not in directions in which they are held. A body that has some of "
	       "its members in the group only is refused. Spheres of clumps count as described for fix "
	       "multisphere.",
	.example = "fix still all momentum 100 linear 1 1 0 angular",
	.args = args,
	.state_size = sizeof(struct state),
	.init = init,
	.hook[TS_STAGE_END_OF_STEP] = end_of_step,
};
