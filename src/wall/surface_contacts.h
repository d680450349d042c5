/* Contacts of particles with the triangles of one mesh, after the walls have computed their forces:
 *
 *   init                          surface->observed = true: walls keep reports of these contacts
 *   late[TS_LATE_CONTACTS]        struct ts_surface_contacts it = ts_surface_contacts(sim, surface);
 *                                 struct ts_surface_contact c;
 *                                 while (ts_surface_contacts_next(&it, &c)) ...
 *
 * All walls that are made of the mesh are gone through in script order, in each of them the touching contacts by
 * triangle and there by the particles' identities: sums over them depend neither on threads nor on where particles
 * are in memory. */
#ifndef TS_WALL_SURFACE_CONTACTS_H
#define TS_WALL_SURFACE_CONTACTS_H

#include "wall/mesh_wall.h"

struct ts_surface_contact {
	size_t triangle; /* of the mesh */
	size_t particle; /* local index */
	double force[3]; /* of the particle on the triangle */
	/* In the frame of the mesh, not of its periodic image that is touched: */
	double point[3];  /* where the force acts */
	double centre[3]; /* of the particle */
	double overlap;
};

/* The state of an iteration. */
struct ts_surface_contacts {
	struct tsim *sim;
	const struct ts_mesh_surface *surface;
	size_t next_wall; /* of ts_walls_next */
	const struct ts_wall *wall;
	size_t at; /* in the wall's list of touching contacts */
};

struct ts_surface_contacts ts_surface_contacts(struct tsim *sim, const struct ts_mesh_surface *surface);
/* false: there are no more. */
bool ts_surface_contacts_next(struct ts_surface_contacts *it, struct ts_surface_contact *out);
/* Unit vector n from the point of the triangle nearest to the particle's centre to that centre, and the velocity v of
 * the centre relative to that point. */
void ts_surface_contact_motion(const struct ts_surface_contacts *it, const struct ts_surface_contact *contact,
			       double n[3], double v[3]);
/* Whether some pair of a particle and a triangle of the mesh is listed, touching or not. */
bool ts_surface_contacts_listed(const struct tsim *sim, const struct ts_mesh_surface *surface);

/* By a wall in POST_FORCE: makes its list of touching contacts, if somebody reads it. */
enum ts_status ts_surface_contacts_collect(struct tsim *sim, const struct ts_wall *w,
					   struct ts_mesh_wall *mw);

#endif
