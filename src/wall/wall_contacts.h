/* Particles near a wall, and what their contacts with it remember. A wall may have several elements
 * (triangles of a mesh), each with contacts of its own. */
#ifndef TS_WALL_WALL_CONTACTS_H
#define TS_WALL_WALL_CONTACTS_H

#include "base/parallel.h"
#include "core/sim.h"

/* What a contact did in the last force computation; all zero where they do not touch. Seen from the
 * particle: the wall gets the opposite force at the point. */
struct ts_wall_report {
	double touching; /* 1 */
	double overlap;
	double force[3], torque[3];   /* on the particle; torque about its centre */
	double rolling[3];	      /* the part of the torque that is friction of rolling */
	double point[3], velocity[3]; /* of the surface, nearest to the centre */
	double curvature;	      /* of the surface, > 0: bulging towards the particle */
	double type;		      /* of the surface */
	double mesh, triangle;	      /* from 1 and from 0; 0, 0: the wall is no mesh */
};
enum { TS_WALL_REPORT = sizeof(struct ts_wall_report) / sizeof(double) };

/* How a contact lay in the last force computation: what the limit of the time step needs to know. */
struct ts_wall_seen {
	double n[3], overlap, r_eff; /* overlap 0: it does not touch */
	int32_t type;		     /* of the surface */
};

/* Whether a contact touches: not at all, with a direction, or so that the centre of the particle lies in
 * the surface. */
enum { TS_TOUCH_NOT, TS_TOUCH_BESIDE, TS_TOUCH_INSIDE };

struct ts_wall_contacts {
	size_t n;
	int32_t *row;	   /* of the particle */
	int32_t (*key)[2]; /* identity of the particle, number of the element */
	/* whether they did when they were looked at last, as above; 0: there is no force, no memory */
	uint8_t *touching;
	struct ts_wall_seen *seen;
	/* width numbers each; zero where they do not touch. With contacts it is never NULL */
	double *memory;
	double (*force)[3]; /* on the particle, in this step */
	size_t width;
	bool want_reports;
	struct ts_wall_report *report; /* one each, if somebody wants them; else NULL */
	size_t row_capacity, key_capacity, touching_capacity, seen_capacity, memory_capacity, force_capacity,
		report_capacity;
};

/* A rebuild: start, add those that may touch before the next one, finish. What is near again keeps
 * its memory. */
struct ts_wall_rebuild {
	struct ts_wall_contacts old;
};
void ts_wall_contacts_start(struct ts_wall_contacts *c, struct ts_wall_rebuild *rebuild, size_t width);
enum ts_status ts_wall_contacts_add(struct tsim *sim, struct ts_wall_contacts *c, size_t i, int element);
enum ts_status ts_wall_contacts_finish(struct tsim *sim, struct ts_wall_contacts *c,
				       struct ts_wall_rebuild *rebuild);

/* NULL if they do not touch, or nobody wanted reports. */
static inline const struct ts_wall_report *ts_wall_report(const struct ts_wall_contacts *c, size_t k)
{
	return c->report && c->report[k].touching > 0 ? &c->report[k] : NULL;
}

static inline double *ts_wall_memory(const struct ts_wall_contacts *c, size_t k)
{
	return c->memory + k * c->width;
}

/* The contact k does not touch: it has ended, if it was one. */
void ts_wall_contact_end(struct ts_wall_contacts *c, size_t k);
static inline void ts_wall_contact_part(struct ts_wall_contacts *c, size_t k)
{
	if (c->touching[k])
		ts_wall_contact_end(c, k);
}
/* It exerts no force in this step. */
static inline void ts_wall_contact_rest(const struct ts_wall_contacts *c, size_t k)
{
	for (int d = 0; d < 3; d++)
		c->force[k][d] = 0;
}

/* Calls the share for ranges of contacts side by side; those of a particle come together, and in order. */
void ts_wall_contacts_parallel(const struct tsim *sim, const struct ts_wall_contacts *c, ts_share_fn *share,
			       void *context);

enum ts_status ts_wall_contacts_archive(struct ts_archive *archive, struct tsim *sim,
					struct ts_wall_contacts *c);
void ts_wall_contacts_release(struct ts_wall_contacts *c);

#endif
