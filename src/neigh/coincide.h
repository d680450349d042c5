/* Coincident centres of two particles, or a centre in the surface of a wall (wall/wall_coincide.h): the
 * contact has no direction, hence no force, and the particles would pass through each other silently. Such a
 * scene is an error. Pairs of particles are checked when the contact list is built, contacts with walls in
 * each step. On the axis of a cylinder the force is zero by symmetry, which is right. */
#ifndef TS_NEIGH_COINCIDE_H
#define TS_NEIGH_COINCIDE_H

#include "neigh/contact_list.h"

/* Centres nearer to each other or to a surface than this fraction of a radius: their distance is rounding
 * error. */
#define TS_COINCIDE 1e-12

static inline bool ts_coincide(double distance, double radius)
{
	return !(distance > TS_COINCIDE * radius);
}

/* Fails if the list has a pair of coincident particles that have a contact law and of which at least one is
 * free to move. To be called when the search has found coincident centres. */
enum ts_status ts_coincide_check_pairs(struct tsim *sim, const struct ts_contact_list *list);
/* Fails if a new bond would join coincident particles; `distance` is that of particles i and j. */
enum ts_status ts_coincide_bond(struct tsim *sim, const struct ts_place *where, size_t i, size_t j,
				double distance);

/* Fails because a surface moves by `way` in one step, more than the radius of particle i next to it, and so
 * passes through it without a contact. `what` names the surface in the message. */
enum ts_status ts_coincide_passed(struct tsim *sim, const struct ts_place *where, size_t i, double way,
				  const char *what);

#endif
