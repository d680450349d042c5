/* Fix enforce2d: keeps particles in the x-y plane. */
#include "base/clones.h"
#include "core/deferred_loops.h"
#include "force/restraint.h"
#include "group/group_members.h"
#include "particle/particles.h"

#include "base/banned.h"

static enum ts_status require_two_dimensions(struct ts_instance *self, struct tsim *sim)
{
	if (sim->dimension == 2)
		return TS_OK;
	return ts_fail(&sim->error, TS_STATE, &self->where,
		       "fix enforce2d requires two dimensions: use `dimension 2` before the box is created");
}

struct task {
	const struct ts_particles *p;
	int group;
};

TS_CLONES static void flatten_range(void *context, size_t from, size_t to)
{
	const struct task t = *(const struct task *)context;
	double(*restrict v)[3] = t.p->v, (*restrict f)[3] = t.p->f;
	double(*restrict omega)[3] = t.p->omega, (*restrict torque)[3] = t.p->torque;
	bool all = ts_group_members(t.p, t.group, from, to) == to - from;

	for (size_t i = from; i < to; i++) {
		if (!all && !ts_in_group(t.p, i, t.group))
			continue;
		v[i][2] = f[i][2] = 0;
		if (omega)
			omega[i][0] = omega[i][1] = 0;
		if (torque)
			torque[i][0] = torque[i][1] = 0;
	}
}

static enum ts_status clear_out_of_plane(struct ts_instance *self, struct tsim *sim)
{
	struct task task = { sim->particles, self->group };

	TS_DEFER_LOOP(sim, sim->particles->n, flatten_range, &task);
	return TS_OK;
}

static void clear_z_force(const struct ts_instance *self, const struct tsim *sim, size_t i, double f[3])
{
	(void)self;
	(void)sim;
	(void)i;
	f[2] = 0;
}

static const struct ts_restraint restraint = { NULL, clear_z_force };

TS_STYLE(fix, ts_style, ts_fix_enforce2d)
const struct ts_style ts_fix_enforce2d = {
	.name = "enforce2d",
	.kind = TS_KIND_FIX,
	.ranks = TS_RANKS_OWN,
	.summary = "keeps the particles of the group in the x-y plane",
	.doc = "In each time step the z components of velocity and force and the x and y components of "
	       "angular velocity and torque are set to 0. Define this fix after all fixes that add forces. "
	       "It requires `dimension 2`.",
	.example = "dimension 2\nfix flat all enforce2d",
	.init = require_two_dimensions,
	.hook[TS_STAGE_POST_FORCE] = clear_out_of_plane,
	.defers = TS_DEFERS(POST_FORCE),
	.restraint = &restraint,
};
