#include "group/kinetic_energy.h"

#include "math/vec3.h"
#include "particle/sphere_shape.h"
#include "rigid/rigid_share.h"

#include "base/banned.h"

double ts_kinetic_energy(const struct tsim *sim, size_t i)
{
	const struct ts_particles *p = sim->particles;
	const double *v = ts_rigid_share_velocity(sim, i);

	return 0.5 * p->mass[i] * ts_dot(v, v);
}

double ts_kinetic_energy_rotation(const struct tsim *sim, size_t i)
{
	const struct ts_particles *p = sim->particles;

	if (!p->omega || ts_rigid_clump_of(sim, i))
		return 0;
	return 0.5 * ts_inertia(sim, i) * ts_dot(p->omega[i], p->omega[i]);
}

void ts_kinetic_energy_terms(const struct tsim *sim, size_t from, size_t n, const void *context,
			     double (*term)[TS_TERM_BLOCK])
{
	const double *m = sim->particles->mass + from;
	const double(*v)[3] = (const double(*)[3])sim->particles->v + from;

	(void)context;
	for (size_t i = 0; i < n && !sim->rigid->n; i++)
		term[0][i] = 0.5 * m[i] * ts_dot(v[i], v[i]);
	for (size_t i = 0; i < n && sim->rigid->n; i++)
		term[0][i] = ts_kinetic_energy(sim, from + i);
}

static void rotation_term(const struct tsim *sim, size_t i, const void *context, double *term)
{
	(void)context;
	term[0] = ts_kinetic_energy_rotation(sim, i);
}

/* Spheres of clumps have shares of the energy of their clump. */
static void all_rotation_term(const struct tsim *sim, size_t i, const void *context, double *term)
{
	const struct ts_body *clump = ts_rigid_clump_of(sim, i);

	(void)context;
	term[0] = clump ? 0.5 * ts_dot(clump->spin, clump->omega) * (sim->particles->mass[i] / clump->mass)
			: ts_kinetic_energy_rotation(sim, i);
}

double ts_group_kinetic_energy(const struct tsim *sim, int group)
{
	double sum;

	ts_group_sum_blocks(sim, group, 1, ts_kinetic_energy_terms, NULL, &sum);
	return sum;
}

double ts_group_rotation_energy(const struct tsim *sim, int group)
{
	double sum;

	ts_group_sum(sim, group, 1, rotation_term, NULL, &sum);
	return sum;
}

double ts_group_all_rotation_energy(const struct tsim *sim, int group)
{
	double sum;

	ts_group_sum(sim, group, 1, all_rotation_term, NULL, &sum);
	return sum;
}
