#include "integrate/integrate.h"

#include "base/banned.h"

static enum ts_status initial_integrate(struct ts_instance *self, struct tsim *sim)
{
	double dt = sim->clock.dt;

	ts_integrate(sim, self->group, &(struct ts_integration){ .kick = 0.5 * dt, .drift = dt });
	return TS_OK;
}

static enum ts_status final_integrate(struct ts_instance *self, struct tsim *sim)
{
	ts_integrate(sim, self->group, &(struct ts_integration){ .kick = 0.5 * sim->clock.dt });
	return TS_OK;
}

TS_STYLE(fix, ts_style, ts_fix_nve)
const struct ts_style ts_fix_nve = {
	.name = "nve",
	.kind = TS_KIND_FIX,
	.ranks = TS_RANKS_OWN,
	.summary = "integrates the motion of the group by velocity Verlet",
	.doc = "Each step of length h is v += h/2 f/m; x += h v; computation of the forces f; v += h/2 f/m. "
	       "Velocity Verlet is of second order and symplectic, and stable for h < 2/omega, omega the "
	       "highest angular frequency. Contact forces use the velocities of the half step, as in "
	       "LIGGGHTS and LAMMPS. Rotation is not integrated; see fix nve/sphere.\n\n"
	       "Equations typeset, assumptions, order and limits: doc/theory-motion.md.",
	.example = "fix move rock nve",
	.cite = "W. C. Swope et al., J. Chem. Phys. 76 (1982) 637",
	.integrates = TS_MOVES | TS_OBEYS,
	.hook = { [TS_STAGE_INITIAL_INTEGRATE] = initial_integrate,
		  [TS_STAGE_FINAL_INTEGRATE] = final_integrate },
	.defers = TS_DEFERS(INITIAL_INTEGRATE) | TS_DEFERS(FINAL_INTEGRATE),
};
