/* Fix enforce2d: nothing leaves the plane. */
#include "force/restraint.h"
#include "particle/particles.h"

#include "base/banned.h"

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	if (sim->dimension == 2)
		return TS_OK;
	return ts_fail(&sim->error, TS_STATE, &self->where,
		       "fix enforce2d is for two dimensions: say `dimension 2` before the box is made");
}

static enum ts_status post_force(struct ts_instance *self, struct tsim *sim)
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

static void leave(const struct ts_instance *self, const struct tsim *sim, size_t i, double f[3])
{
	(void)self;
	(void)sim;
	(void)i;
	f[2] = 0;
}

static const struct ts_restraint restraint = { NULL, leave };

TS_STYLE(fix, ts_style, ts_fix_enforce2d)
const struct ts_style ts_fix_enforce2d = {
	.name = "enforce2d",
	.kind = TS_KIND_FIX,
	.summary = "Keeps the particles of the group in the x-y plane",
	.doc = "In each step v_z, f_z and the x and y components of spin and torque become 0. Define it "
	       "after\n"
	       "the fixes whose forces it cancels. Only with `dimension 2`.",
	.example = "dimension 2\nfix flat all enforce2d",
	.init = init,
	.hook[TS_STAGE_POST_FORCE] = post_force,
	.restraint = &restraint,
};
