/* Per-particle quantities written by the names that scripts use. */
#ifndef TS_PARTICLE_ASSIGN_H
#define TS_PARTICLE_ASSIGN_H

#include "particle/particles.h"

/* What a write changes: nothing, the name cannot be written; the state of motion; forces; or a property. */
enum ts_assign { TS_ASSIGN_NOT, TS_ASSIGN_MOTION, TS_ASSIGN_FORCE, TS_ASSIGN_PROPERTY };
enum ts_assign ts_particles_assignable(const struct tsim *sim, const char *name);
/* Writes value[k], 0 <= k < n, to particle row[k], or to particle k if row is NULL. All values are checked
 * before the first is written. A new radius changes the mass at constant density; a new density or mass
 * leaves the radius as it is. */
enum ts_status ts_particles_assign(struct tsim *sim, const char *name, const int32_t *row,
				   const double *value, size_t n);

#endif
