/* Fix enforce2d: keeps particles in the x-y plane. */
#include "force/restraint.h"
#include "particle/particles.h"

#include "base/banned.h"

static enum ts_status require_two_dimensions(struct ts_instance *self, struct tsim *sim)
{
	if (sim->dimension == 2)
		return TS_OK;
	return ts_fail(&sim->error, TS_STATE, &self->where,
		       "fix enforce2d requires two dimensions: use `dimension 2` before the box is created");
}

static enum ts_status clear_out_of_plane(struct ts_instance *self, struct tsim *sim)
{
	struct ts_particles *p = sim->particles;

#pragma omp parallel for num_threads(ts_team(sim, p->n)) schedule(static)
	for (size_t i = 0; i < p->n; i++) {
		if (!ts_in_group(p, i, self->group))
			continue;
		p->v[i][2] = p->f[i][2] = 0;
		if (p->omega)
			p->omega[i][0] = p->omega[i][1] = 0;
		if (p->torque)
			p->torque[i][0] = p->torque[i][1] = 0;
	}
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
	.restraint = &restraint,
};
