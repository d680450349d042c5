#include "particles/particles.h"

#include "base/banned.h"

static void kick(const struct ts_instance *self, struct tsim *sim)
{
	struct ts_particles *p = sim->particles;
	double h = 0.5 * sim->clock.dt;

#pragma omp parallel for num_threads(ts_team(sim, p->n)) schedule(static)
	for (size_t i = 0; i < p->n; i++) {
		double s = h / p->mass[i];

		if (!ts_in_group(p, i, self->group))
			continue;
		for (int k = 0; k < 3; k++)
			p->v[i][k] += s * p->f[i][k];
	}
}

static enum ts_status initial_integrate(struct ts_instance *self, struct tsim *sim)
{
	struct ts_particles *p = sim->particles;
	double dt = sim->clock.dt, h = 0.5 * dt;

#pragma omp parallel for num_threads(ts_team(sim, p->n)) schedule(static)
	for (size_t i = 0; i < p->n; i++) {
		double s = h / p->mass[i];

		if (!ts_in_group(p, i, self->group))
			continue;
		for (int k = 0; k < 3; k++) {
			p->v[i][k] += s * p->f[i][k];
			p->x[i][k] += dt * p->v[i][k];
		}
	}
	return TS_OK;
}

static enum ts_status final_integrate(struct ts_instance *self, struct tsim *sim)
{
	kick(self, sim);
	return TS_OK;
}

TS_STYLE(fix, ts_style, ts_fix_nve)
const struct ts_style ts_fix_nve = {
	.name = "nve",
	.kind = TS_KIND_FIX,
	.summary = "moves the particles of the group by velocity Verlet",
	.doc = "v += h/2 f/m; x += h v; forces; v += h/2 f/m. Second order and symplectic; stable for "
	       "h < 2/omega of the fastest oscillator. Contact forces see the half-step velocity, as in "
	       "LIGGGHTS and LAMMPS.",
	.example = "fix move rock nve",
	.cite = "W. C. Swope et al., J. Chem. Phys. 76 (1982) 637",
	.hook = { [TS_STAGE_INITIAL_INTEGRATE] = initial_integrate,
		  [TS_STAGE_FINAL_INTEGRATE] = final_integrate },
};
