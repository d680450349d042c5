#include "integrate/integrate.h"

#include "base/banned.h"

static enum ts_status initial_integrate(struct ts_instance *self, struct tsim *sim)
{
	double dt = sim->clock.dt;

	ts_integrate(sim, self->group, &(struct ts_integration){ .kick = dt, .drift = dt });
	return TS_OK;
}

TS_STYLE(fix, ts_style, ts_fix_nve_symplectic)
const struct ts_style ts_fix_nve_symplectic = {
	.name = "nve/symplectic",
	.kind = TS_KIND_FIX,
	.ranks = TS_RANKS_OWN,
	.summary = "integrates the motion of the group by the symplectic Euler scheme",
	.doc = "Each step of length h is v += h f/m; x += h v with the new velocity; computation of the "
	       "forces. The scheme is of first order and symplectic: the energy error stays bounded. It is "
	       "stable for h < 2/omega, as velocity Verlet.",
	.example = "fix move rock nve/symplectic",
	.cite = "E. Hairer, C. Lubich, G. Wanner, Geometric Numerical Integration (2006), I.1",
	.integrates = TS_MOVES | TS_OBEYS,
	.hook = { [TS_STAGE_INITIAL_INTEGRATE] = initial_integrate },
	.defers = TS_DEFERS(INITIAL_INTEGRATE),
};
