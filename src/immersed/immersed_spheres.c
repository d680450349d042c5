#include "immersed/immersed_spheres.h"

#include <stdio.h>
#include <string.h>

#include "math/exactsum.h"
#include "math/vec3.h"
#include "particle/columns.h"
#include "particle/particles.h"

#include "base/banned.h"

enum { RECORD = sizeof(struct ts_immersed_record) / sizeof(double) };

enum ts_status ts_immersed_spheres_prepare(struct ts_immersed_spheres *spheres, struct tsim *sim,
					   struct ts_instance *self)
{
	char name[64];

	spheres->group = self->group;
	/* the fluid exerts torques */
	TS_TRY(ts_particles_need(sim, TS_NEED(OMEGA) | TS_NEED(TORQUE)));
	snprintf(name, sizeof name, "immersed %s", self->id);
	TS_TRY(ts_particles_add_column(sim, name, RECORD, 0, &spheres->column));
	snprintf(name, sizeof name, "immersed net %s", self->id);
	return ts_particles_add_column(sim, name, TS_NET_FORCE_NUMBERS, 0, &spheres->net_column);
}

enum ts_status ts_immersed_spheres_archive(const struct ts_immersed_spheres *spheres, struct tsim *sim,
					   struct ts_archive *archive)
{
	TS_TRY(ts_particles_archive_column(archive, sim, "record", spheres->column));
	return ts_particles_archive_column(archive, sim, "net force", spheres->net_column);
}

struct ts_immersed_record *ts_immersed_sphere_record(const struct ts_immersed_spheres *spheres,
						     const struct tsim *sim, size_t row)
{
	return (struct ts_immersed_record *)sim->particles->column[spheres->column].data + row;
}

struct ts_net_force *ts_immersed_sphere_net_force(const struct ts_immersed_spheres *spheres,
						  const struct tsim *sim, size_t row)
{
	return (struct ts_net_force *)sim->particles->column[spheres->net_column].data + row;
}

void ts_immersed_spheres_add_forces(const struct ts_immersed_spheres *spheres, struct tsim *sim)
{
	struct ts_particles *p = sim->particles;

	for (size_t i = 0; i < p->n; i++) {
		const struct ts_immersed_record *record = ts_immersed_sphere_record(spheres, sim, i);

		if (!ts_in_group(p, i, spheres->group))
			continue;
		ts_add(p->f[i], record->force, p->f[i]);
		if (p->torque)
			ts_add(p->torque[i], record->torque, p->torque[i]);
	}
}

void ts_immersed_spheres_total(const struct ts_immersed_spheres *spheres, const struct tsim *sim,
			       double out[6])
{
	struct ts_exactsum sum[6];

	for (int k = 0; k < 6; k++)
		sum[k] = ts_exactsum_start();
	for (size_t i = 0; i < sim->particles->n; i++) {
		const struct ts_immersed_record *r = ts_immersed_sphere_record(spheres, sim, i);

		for (int k = 0; k < 6 && ts_in_group(sim->particles, i, spheres->group); k++)
			ts_exactsum_add(&sum[k], k < 3 ? r->force[k] : r->torque[k - 3]);
	}
	for (int k = 0; k < 6; k++)
		out[k] = ts_exactsum_value(&sum[k]);
}

void ts_immersed_spheres_forces(const struct ts_immersed_spheres *spheres, const struct tsim *sim,
				double *out)
{
	for (size_t i = 0; i < sim->particles->n; i++) {
		const struct ts_immersed_record *r = ts_immersed_sphere_record(spheres, sim, i);

		if (!ts_in_group(sim->particles, i, spheres->group))
			continue;
		memcpy(&out[6 * i], r->force, sizeof r->force);
		memcpy(&out[6 * i + 3], r->torque, sizeof r->torque);
	}
}
