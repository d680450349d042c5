/* Fix nve/noforce: motion with constant velocity, whatever the forces. */
#include "core/deferred_loops.h"
#include "force/restraint.h"
#include "particle/particles.h"

#include "base/banned.h"

struct task {
	const struct ts_particles *p;
	double dt;
	int group;
};

static void drift_range(void *context, size_t from, size_t to)
{
	const struct task t = *(const struct task *)context;

	for (size_t i = from; i < to; i++)
		for (int k = 0; ts_in_group(t.p, i, t.group) && k < 3; k++)
			t.p->x[i][k] += t.dt * t.p->v[i][k];
}

static enum ts_status initial_integrate(struct ts_instance *self, struct tsim *sim)
{
	struct task task = { sim->particles, sim->clock.dt, self->group };

	TS_DEFER_LOOP(sim, sim->particles->n, drift_range, &task);
	return TS_OK;
}

static void remove_force(const struct ts_instance *self, const struct tsim *sim, size_t i, double f[3])
{
	(void)self;
	(void)sim;
	(void)i;
	f[0] = f[1] = f[2] = 0;
}

static const struct ts_restraint restraint = { NULL, remove_force };

TS_STYLE(fix, ts_style, ts_fix_nve_noforce)
const struct ts_style ts_fix_nve_noforce = {
	.name = "nve/noforce",
	.kind = TS_KIND_FIX,
	.ranks = TS_RANKS_OWN,
	.summary = "moves the particles of the group with constant velocity",
	.doc = "Each step of length h is x += h v; forces do not change the velocity v. Use it for particles "
	       "that exert forces on others but do not respond to any. See fix move for prescribed paths.",
	.example = "velocity piston set 0 0 -0.1\nfix push piston nve/noforce",
	.integrates = TS_MOVES,
	.hook[TS_STAGE_INITIAL_INTEGRATE] = initial_integrate,
	.defers = TS_DEFERS(INITIAL_INTEGRATE),
	.restraint = &restraint,
};
