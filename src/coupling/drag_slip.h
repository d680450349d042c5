/* Slip between fluid and particle, and the particles on which a drag has an effect. */
#ifndef TS_COUPLING_DRAG_SLIP_H
#define TS_COUPLING_DRAG_SLIP_H

#include "coupling/drag_force.h"

/* Whether the drag acts along axis k (keyword axes). */
static inline bool ts_drag_acts_along(const struct ts_drag *drag, int k)
{
	static const int bits[] = { 1, 2, 4, 3, 5, 6, 7 };

	return bits[drag->axes] >> k & 1;
}
/* Whether forces do not change the velocity of particle i: it is frozen or no fix integrates it. (With an
 * outside program attached, particles without such a fix are not counted: the program may move them.) */
bool ts_drag_motion_prescribed(const struct ts_drag *drag, const struct tsim *sim, size_t i);
/* Mass of particle i, including added mass. */
double ts_drag_mass(const struct ts_drag *s, const struct tsim *sim, size_t i);
/* Finds the slip w = u - v at particle i, and diameter, speed and void fraction for the law; false if the
 * particle is outside the fluid. */
bool ts_drag_slip_at(const struct ts_instance *self, const struct ts_particles *p, size_t i,
		     struct ts_slip *slip, double w[3]);

#endif
