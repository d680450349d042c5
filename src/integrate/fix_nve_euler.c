#include "integrate/integrate.h"

#include "base/banned.h"

static enum ts_status initial_integrate(struct ts_instance *self, struct tsim *sim)
{
	double dt = sim->clock.dt;

	ts_integrate(sim, self->group, &(struct ts_integration){ .early = dt, .kick = dt });
	return TS_OK;
}

/* Contacts and bonds then report the limits of this scheme, as advice: work done with it did not keep
 * them. */
static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	(void)self;
	sim->run.explicit_euler = true;
	return TS_OK;
}

TS_STYLE(fix, ts_style, ts_fix_nve_euler)
const struct ts_style ts_fix_nve_euler = {
	.name = "nve/euler",
	.kind = TS_KIND_FIX,
	.summary = "moves the particles of the group by the explicit Euler scheme",
	.doc = "x += h v; v += h f/m (both with the values at the beginning of the step). First order. An "
	       "undamped oscillator gains energy at every step, its amplitude growing by sqrt(1 + omega^2 "
	       "h^2); one with a dashpot is stable for h < beta/k. A larger step is only warned of. Kept to "
	       "reproduce work done with it; prefer fix nve.",
	.example = "fix move rock nve/euler",
	.init = init,
	.integrates = TS_MOVES | TS_OBEYS,
	.hook = { [TS_STAGE_INITIAL_INTEGRATE] = initial_integrate },
	.defers = TS_DEFERS(INITIAL_INTEGRATE),
};
