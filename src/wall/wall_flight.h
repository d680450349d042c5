/* Walls that particles have met before they were inserted: fix insert/jet puts a particle where it has flown freely since
 * it left the nozzle. */
#ifndef TS_WALL_WALL_FLIGHT_H
#define TS_WALL_WALL_FLIGHT_H

#include "particle/particles.h"

/* For the slot find_missed_wall of struct ts_particles. A wall has been missed if the particle has been in contact with it
 * for more than one step, of which it had no forces, or has gone on by more than its radius; a wall with `impact exact` if
 * it is in contact at all. Walls that it parts from are not met. Regions that move are not looked at, meshes that rotate
 * are taken to be at rest. */
enum ts_status ts_wall_flight(struct tsim *sim, size_t from, size_t n, const double *flown,
			      struct ts_missed_wall *out);

#endif
