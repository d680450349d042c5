#include "particles/particles.h"

#include "base/banned.h"

static enum ts_status initial_integrate(struct ts_instance *self, struct tsim *sim)
{
	struct ts_particles *p = sim->particles;
	double dt = sim->clock.dt;

#pragma omp parallel for num_threads(ts_team(sim, p->n)) schedule(static)
	for (size_t i = 0; i < p->n; i++) {
		double s = dt / p->mass[i];

		if (!ts_in_group(p, i, self->group))
			continue;
		for (int k = 0; k < 3; k++) {
			p->v[i][k] += s * p->f[i][k];
			p->x[i][k] += dt * p->v[i][k];
		}
	}
	return TS_OK;
}

TS_STYLE(fix, ts_style, ts_fix_nve_symplectic)
const struct ts_style ts_fix_nve_symplectic = {
	.name = "nve/symplectic",
	.kind = TS_KIND_FIX,
	.summary = "moves the particles of the group by the symplectic Euler scheme",
	.doc = "v += h f/m; x += h v (the new one); forces. First order, symplectic: energy stays "
	       "bounded; stable for h < 2/omega as velocity Verlet.",
	.example = "fix move rock nve/symplectic",
	.cite = "E. Hairer, C. Lubich, G. Wanner, Geometric Numerical Integration (2006), I.1",
	.hook = { [TS_STAGE_INITIAL_INTEGRATE] = initial_integrate },
};
