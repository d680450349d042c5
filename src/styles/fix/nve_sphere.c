#include "particles/particles.h"

#include "base/banned.h"

static const double INERTIA = 0.4; /* of a sphere, in m r^2 */

static void kick(const struct ts_instance *self, struct tsim *sim)
{
	struct ts_particles *p = sim->particles;
	double h = 0.5 * sim->clock.dt;

#pragma omp parallel for num_threads(ts_team(sim, p->n)) schedule(static)
	for (size_t i = 0; i < p->n; i++) {
		double s = h / p->mass[i], r = p->radius[i];
		double w = s / (INERTIA * r * r);

		if (!ts_in_group(p, i, self->group))
			continue;
		for (int k = 0; k < 3; k++)
			p->v[i][k] += s * p->f[i][k];
		for (int k = 0; p->omega && k < 3; k++)
			p->omega[i][k] += w * p->torque[i][k];
	}
}

static enum ts_status initial_integrate(struct ts_instance *self, struct tsim *sim)
{
	struct ts_particles *p = sim->particles;
	double dt = sim->clock.dt;

	kick(self, sim);
#pragma omp parallel for num_threads(ts_team(sim, p->n)) schedule(static)
	for (size_t i = 0; i < p->n; i++)
		if (ts_in_group(p, i, self->group))
			for (int k = 0; k < 3; k++)
				p->x[i][k] += dt * p->v[i][k];
	return TS_OK;
}

static enum ts_status final_integrate(struct ts_instance *self, struct tsim *sim)
{
	kick(self, sim);
	return TS_OK;
}

TS_STYLE(fix, ts_style, ts_fix_nve_sphere)
const struct ts_style ts_fix_nve_sphere = {
	.name = "nve/sphere",
	.kind = TS_KIND_FIX,
	.summary = "moves and turns the spheres of the group by velocity Verlet",
	.doc = "As fix nve, and for the rotation omega += h/2 T/(0.4 m r^2) before and after the "
	       "forces. Where no live style makes torques or reads the rotation, it is left out "
	       "(it would stay as it is).",
	.example = "fix move all nve/sphere",
	.hook = { [TS_STAGE_INITIAL_INTEGRATE] = initial_integrate,
		  [TS_STAGE_FINAL_INTEGRATE] = final_integrate },
};
