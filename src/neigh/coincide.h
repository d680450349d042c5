/* Centres at the same place, or in the surface of a wall (wall/wall_coincide.h): a contact has no
 * direction there, and so no force. Such a scene is refused, for it would go on without a word. Rows of
 * particles are looked at when they are built, contacts with walls in each step. On the axis of a cylinder
 * there is no force by symmetry: that is right. */
#ifndef TS_NEIGH_COINCIDE_H
#define TS_NEIGH_COINCIDE_H

#include "neigh/contact_list.h"

/* Centres nearer to each other, or to a surface, than this part of a radius are told apart by
 * rounding only. */
#define TS_COINCIDE 1e-12

static inline bool ts_coincide(double distance, double radius)
{
	return !(distance > TS_COINCIDE * radius);
}

/* Refuses rows of two particles at the same place, of which one is free to move; to be called where
 * there may be some. */
enum ts_status ts_coincide_check_pairs(struct tsim *sim, const struct ts_contact_list *list);
/* Refuses a bond between particles at the same place; `distance` is that of the rows i and j. */
enum ts_status ts_coincide_bond(struct tsim *sim, const struct ts_place *where, size_t i, size_t j,
				double distance);

/* Refuses a surface that passes through a particle in one step: one that moves by `way`, more than the
 * radius of particle i, which is as near as that. `what`: the surface. */
enum ts_status ts_coincide_passed(struct tsim *sim, const struct ts_place *where, size_t i, double way,
				  const char *what);

#endif
