/* Where surfaces of meshes that act beyond the touch (model jkr) are met.
 *
 * Beyond the touch a particle may see several triangles at once. A contact is a place of the
 * surface that is nearest to the particle among all triangles that contain it: inside a face; on an
 * edge or corner only if none of the triangles that meet there comes nearer. Each such place is one
 * contact, whichever triangle has it, and goes on with its memory when it moves to another
 * triangle. */
#ifndef TS_WALL_MESH_STICK_H
#define TS_WALL_MESH_STICK_H

#include "wall/mesh_wall.h"

/* Finds the places of the contacts of a visitor, in mw->place: `own` where the contact has one.
 * Triangles farther than its radius and `reach` have none. */
void ts_mesh_places(const struct tsim *sim, const struct ts_mesh_wall *mw, const struct ts_mesh_neighbor *v,
		    double reach);
/* The contact of the visitor that has ended at its place and goes on at that of contact k;
 * SIZE_MAX: none. */
size_t ts_mesh_donor(const struct ts_mesh_wall *mw, const struct ts_wall_contacts *c,
		     const struct ts_mesh_neighbor *v, size_t k);

#endif
