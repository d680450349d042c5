/* Particles as bodies in a fluid: what the fluid does to each, in columns of particles. */
#ifndef TS_IMMERSED_IMMERSED_SPHERES_H
#define TS_IMMERSED_IMMERSED_SPHERES_H

#include "core/archive.h"
#include "core/sim.h"
#include "immersed/immersed_record.h"
#include "immersed/virtual_mass_stabilization.h"

struct ts_immersed_spheres {
	int group;
	size_t column, net_column; /* of struct ts_immersed_record and struct ts_net_force */
};

/* In the init of the fix, whose group they are. */
enum ts_status ts_immersed_spheres_prepare(struct ts_immersed_spheres *spheres, struct tsim *sim,
					   struct ts_instance *self);
enum ts_status ts_immersed_spheres_archive(const struct ts_immersed_spheres *spheres, struct tsim *sim,
					   struct ts_archive *archive);

struct ts_immersed_record *ts_immersed_sphere_record(const struct ts_immersed_spheres *spheres,
						     const struct tsim *sim, size_t row);
struct ts_net_force *ts_immersed_sphere_net_force(const struct ts_immersed_spheres *spheres,
						  const struct tsim *sim, size_t row);

/* Adds the force and torque of the fluid to those on the particles. */
void ts_immersed_spheres_add_forces(const struct ts_immersed_spheres *spheres, struct tsim *sim);
/* Force and torque of the fluid on all of them; of each particle, [n][6], 0 of those beside the group. */
void ts_immersed_spheres_total(const struct ts_immersed_spheres *spheres, const struct tsim *sim,
			       double out[6]);
void ts_immersed_spheres_forces(const struct ts_immersed_spheres *spheres, const struct tsim *sim,
				double *out);

#endif
