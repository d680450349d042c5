/* Contact points on meshes for laws that act at a distance (model jkr, liquid bridges).
 *
 * Beyond the touch a particle may interact with several triangles at once. A contact point is a local
 * minimum of the distance between the particle and the surface: a point inside of a face, or a point of an
 * edge or corner if none of the triangles that share it has a nearer point. Each such point is one
 * contact, which keeps its history when the point moves to another triangle. */
#ifndef TS_WALL_MESH_STICK_H
#define TS_WALL_MESH_STICK_H

#include "wall/mesh_wall.h"

/* Computes mw->place for the contacts of particle `v`; `own` is set for those whose triangle has the
 * contact point. Triangles farther from the centre than its radius plus `reach` have none. */
void ts_mesh_places(const struct tsim *sim, const struct ts_mesh_wall *mw, const struct ts_mesh_neighbor *v,
		    double reach);
/* The contact of particle `v` that has lost its contact point to contact k, which continues its history;
 * SIZE_MAX: none. */
size_t ts_mesh_donor(const struct ts_mesh_wall *mw, const struct ts_wall_contacts *c,
		     const struct ts_mesh_neighbor *v, size_t k);

#endif
