/* Particles near a wall, and what their contacts with it remember. A wall may have several elements
 * (triangles of a mesh), each with contacts of its own. */
#ifndef TS_NEIGH_WALL_CONTACTS_H
#define TS_NEIGH_WALL_CONTACTS_H

#include "core/sim.h"

struct ts_wall_contacts {
	size_t n;
	int32_t *row;	   /* of the particle */
	int32_t (*key)[2]; /* identity of the particle, number of the element */
	double *memory;	   /* width numbers each; zero where they do not touch */
	size_t width;
	size_t row_capacity, key_capacity, memory_capacity;
};

/* A rebuild: start, add those that may touch before the next one, finish. What is near again keeps
 * its memory. */
struct ts_wall_rebuild {
	struct ts_wall_contacts old;
};
void ts_wall_contacts_start(struct ts_wall_contacts *c, struct ts_wall_rebuild *rebuild,
			    size_t width);
enum ts_status ts_wall_contacts_add(struct tsim *sim, struct ts_wall_contacts *c, size_t i,
				    int element);
enum ts_status ts_wall_contacts_finish(struct tsim *sim, struct ts_wall_contacts *c,
				       struct ts_wall_rebuild *rebuild);

static inline double *ts_wall_memory(const struct ts_wall_contacts *c, size_t k)
{
	return c->width ? c->memory + k * c->width : NULL;
}

/* The contact k has ended. */
void ts_wall_contact_part(struct ts_wall_contacts *c, size_t k);

enum ts_status ts_wall_contacts_archive(struct ts_archive *archive, struct tsim *sim,
					struct ts_wall_contacts *c);
void ts_wall_contacts_release(struct ts_wall_contacts *c);

#endif
