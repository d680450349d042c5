/* Contacts of particles with the elements of one surface, after the walls have computed their forces:
 *
 *   .observes = TS_OBSERVES_CONTACTS   in the table of the style: walls keep reports of these contacts
 *   late[TS_LATE_CONTACTS]             struct ts_surface_contacts it = ts_surface_contacts(sim, surface.by);
 *                                      struct ts_surface_contact c;
 *                                      while (ts_surface_contacts_next(&it, &c)) ...
 *
 * All walls that are made of the surface are gone through in script order, in each of them the touching contacts by
 * element and there by the particles' identities: sums over them depend neither on threads nor on where particles
 * are in memory. Velocities are those of the half step, as in contact laws.
 *
 * Immobile particles touch without force: planes, cylinders and height fields compute none for them. They conduct
 * heat; ts_surface_heat_contacts starts an iteration that also visits them, in each wall after the others.
 *
 * A contact that begins and ends within the step (`impact exact`, impact/exact_impacts.h; refused if an observer of contacts
 * has not TS_OBSERVES_BRIEF, too) is gone through as the nodes of a quadrature over its time (wall/contact_node.h), each a
 * contact with a duration of its own, after the contacts of the same wall, by particle and time. All of them belong to the
 * element touched first. So the sum of f duration over contacts and steps is the integral of f dt for both sorts. */
#ifndef TS_WALL_SURFACE_CONTACTS_H
#define TS_WALL_SURFACE_CONTACTS_H

#include "wall/wall.h"

struct ts_surface_contact {
	size_t element; /* of the surface */
	size_t particle; /* local index; SIZE_MAX: a particle of another rank, or a node, whose one may have left the box */
	int32_t tag; /* of the particle, as all that follow; 0: of a node */
	int type;
	uint32_t groups; /* bits */
	double mass, radius;
	double inertial_mass; /* of its rigid body, if it is a member of one */
	double omega[3];
	double duration; /* of the contact in this step, time */
	double force[3]; /* of the particle on the surface */
	/* In the frame of the surface, not of its periodic image that is touched: */
	double point[3];  /* where the force acts: the point of the surface nearest to the centre */
	double centre[3]; /* of the particle */
	double overlap;
	double lever; /* lever arm of the tangential force, as the contact law has it: R - overlap/2 or R, length */
	double normal[3];   /* unit vector from the point to the centre */
	double velocity[3]; /* of the centre relative to the surface at the point */
	/* Conductance h, energy/(time temperature), and heat flow from the particle to the surface, energy/time, at the
	 * temperatures with which forces were computed. Over this step it is on average heat + h ts_heat_mean_rise(i)
	 * (heat/heat.h). 0: no heat is conducted. */
	double conductance, heat;
};

/* The state of an iteration. */
struct ts_surface_contacts {
	const struct tsim *sim;
	const struct ts_instance *surface; /* its fix */
	size_t next_wall;		   /* of ts_walls_next */
	const struct ts_wall *wall;
	size_t at;	    /* in the wall's list of touching contacts */
	bool immobile;	    /* also those of immobile particles, without force */
	size_t brief, node; /* in its list of brief contacts; number of the node */
};

struct ts_surface_contacts ts_surface_contacts(const struct tsim *sim, const struct ts_instance *surface);
struct ts_surface_contacts ts_surface_heat_contacts(const struct tsim *sim,
						    const struct ts_instance *surface);
/* false: there are no more. */
bool ts_surface_contacts_next(struct ts_surface_contacts *it, struct ts_surface_contact *out);
/* Normal force on the surface. */
double ts_surface_contact_normal_force(const struct ts_surface_contact *c);
/* Velocity v of the contact point of the particle along the surface, with its rotation. Returns the power of friction:
 * what the tangential force takes from the particle. */
double ts_surface_contact_slip(const struct ts_surface_contact *c, double v[3]);
static inline bool ts_surface_contact_in_group(const struct ts_surface_contact *c, int group)
{
	return (c->groups >> group) & 1u;
}
/* Warns if no wall is made of the surface that the argument `word` of an instance names. In its plan. */
void ts_surface_warn_without_wall(struct ts_instance *self, struct tsim *sim,
				  const struct ts_instance *surface, const char *word);
/* Whether some pair of a particle and an element of the surface is listed, touching or not. */
bool ts_surface_contacts_listed(const struct tsim *sim, const struct ts_instance *surface);

/* By a wall in POST_BUILD, before contacts are listed: finds out what is observed of its surfaces. */
enum ts_status ts_surface_contacts_find_observers(struct tsim *sim, struct ts_wall *w);
/* By a wall in POST_FORCE: makes its list of touching contacts, if somebody observes them. */
enum ts_status ts_surface_contacts_collect(struct tsim *sim, struct ts_wall *w);
/* The order of struct ts_wall_touching. */
int ts_wall_touching_order(const void *a, const void *b);
/* Contact k of a wall, which touches. */
void ts_surface_contact_of(const struct tsim *sim, const struct ts_wall *w, size_t k,
			   struct ts_surface_contact *out);

#endif
