#include "particles/integrate.h"

#include "particles/particles.h"

#include "base/banned.h"

void ts_integrate_kick(struct tsim *sim, int group, double kick)
{
	struct ts_particles *p = sim->particles;

#pragma omp parallel for num_threads(ts_team(sim, p->n)) schedule(static)
	for (size_t i = 0; i < p->n; i++) {
		double s = kick / p->mass[i];

		if (!ts_in_group(p, i, group))
			continue;
		for (int k = 0; k < 3; k++)
			p->v[i][k] += s * p->f[i][k];
	}
}

void ts_integrate_kick_drift(struct tsim *sim, int group, double kick, double drift)
{
	struct ts_particles *p = sim->particles;

#pragma omp parallel for num_threads(ts_team(sim, p->n)) schedule(static)
	for (size_t i = 0; i < p->n; i++) {
		double s = kick / p->mass[i];

		if (!ts_in_group(p, i, group))
			continue;
		for (int k = 0; k < 3; k++) {
			p->v[i][k] += s * p->f[i][k];
			p->x[i][k] += drift * p->v[i][k];
		}
	}
}

void ts_integrate_drift_kick(struct tsim *sim, int group, double drift, double kick)
{
	struct ts_particles *p = sim->particles;

#pragma omp parallel for num_threads(ts_team(sim, p->n)) schedule(static)
	for (size_t i = 0; i < p->n; i++) {
		double s = kick / p->mass[i];

		if (!ts_in_group(p, i, group))
			continue;
		for (int k = 0; k < 3; k++) {
			p->x[i][k] += drift * p->v[i][k];
			p->v[i][k] += s * p->f[i][k];
		}
	}
}
