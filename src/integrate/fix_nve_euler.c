#include "integrate/integrate.h"

#include "base/banned.h"

static enum ts_status initial_integrate(struct ts_instance *self, struct tsim *sim)
{
	double dt = sim->clock.dt;

	ts_integrate(sim, self->group, &(struct ts_integration){ .drift_first = dt, .kick = dt });
	return TS_OK;
}

/* Contacts and bonds then report the limits of this scheme, only as advice, since earlier work with this
 * scheme did not respect them. */
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
	.ranks = TS_RANKS_OWN,
	.summary = "integrates the motion of the group by the explicit Euler scheme",
	.doc = "Each step of length h is x += h v; v += h f/m, both with the values at the beginning of the "
	       "step. The scheme is of first order. An undamped oscillator of angular frequency omega gains "
	       "energy in every step, its amplitude growing by the factor sqrt(1 + omega^2 h^2); one with "
	       "stiffness k and damping beta is stable for h < beta/k. Larger steps cause only a warning. "
	       "The fix exists to reproduce earlier work; otherwise use fix nve.",
	.example = "fix move rock nve/euler",
	.init = init,
	.integrates = TS_MOVES | TS_OBEYS,
	.hook = { [TS_STAGE_INITIAL_INTEGRATE] = initial_integrate },
	.defers = TS_DEFERS(INITIAL_INTEGRATE),
};
