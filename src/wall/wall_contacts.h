/* Lists of pairs of a particle and an element of a wall (a plane, a face, a triangle) that may touch
 * before the next rebuild, with the history of their contacts. */
#ifndef TS_WALL_WALL_CONTACTS_H
#define TS_WALL_WALL_CONTACTS_H

#include "base/parallel.h"
#include "core/carried.h"
#include "core/sim.h"

/* The contact in the last force computation; all zero if particle and wall do not touch. Forces act on the
 * particle; the opposite force acts on the wall at the contact point. */
struct ts_wall_report {
	double touching;	    /* 1 */
	double overlap;		    /* length */
	double force[3], torque[3]; /* on the particle; torque about its centre */
	double rolling[3];	    /* the part of the torque that is rolling friction */
	double point[3];	    /* the contact point: the point of the surface nearest to the centre */
	double velocity[3];	    /* of the surface at this point */
	double curvature;      /* mean curvature of the surface, 1/length, > 0: convex towards the particle */
	double type;	       /* particle type whose material the surface has */
	double mesh, triangle; /* as in struct ts_wall_contact_point */
	/* Conductance of the contact, energy/(time temperature), and heat flow from the particle into the surface,
	 * energy/time, at the temperatures of this force computation; 0: no heat is conducted. Immobile particles
	 * conduct heat, too: if no force was computed, touching and all forces are 0. */
	double conductance, heat;
	double temperature; /* of the surface; 0 if no heat is conducted */
};
enum { TS_WALL_REPORT = sizeof(struct ts_wall_report) / sizeof(double) };

/* Geometry of the contact in the last force computation, for the limit of the time step. */
struct ts_wall_last_contact {
	double n[3], overlap, r_eff; /* unit normal, overlap (0: no touch), R* */
	int32_t type;		     /* particle type whose material the surface has */
};

/* State of a contact: no touch, a touch, or a touch with the centre of the particle in the surface, where the
 * normal is undefined. */
enum { TS_TOUCH_NOT, TS_TOUCH_BESIDE, TS_TOUCH_INSIDE };

enum { TS_WALL_KEY = 3 };

struct ts_wall_contacts {
	size_t n;		     /* all arrays have n elements, one for each listed pair */
	int32_t *row;		     /* index of the particle */
	int32_t (*key)[TS_WALL_KEY]; /* id of the particle, number of the element, of its periodic image */
	bool old_keys; /* read from a restart file without numbers of images, which are not compared then */
	/* TS_TOUCH_... at the last evaluation; TS_TOUCH_NOT: force and history are zero */
	uint8_t *touching;
	struct ts_wall_last_contact *last;
	/* history, [n * width]; zero without touch. Never NULL if n > 0 */
	double *memory;
	double (*force)[3]; /* on the particle, in this step */
	size_t width;	    /* history values of each contact */
	size_t expected;    /* room to begin with: a little more than the list before had; 0: not known */
	bool want_reports;
	struct ts_wall_report *report; /* NULL if no output needs them */
	size_t row_capacity, key_capacity, touching_capacity, last_capacity, memory_capacity, force_capacity,
		report_capacity;
};

/* A rebuild: start, add the pairs that may touch before the next rebuild, finish. Pairs that were listed
 * before keep their history. */
struct ts_wall_rebuild {
	struct ts_wall_contacts old;
};
void ts_wall_contacts_start(struct ts_wall_contacts *c, struct ts_wall_rebuild *rebuild, size_t width);
/* image: tells images of an element apart that have the same number `element`; 0 if there is one only. */
enum ts_status ts_wall_contacts_add(struct tsim *sim, struct ts_wall_contacts *c, size_t i, int element,
				    int image);
enum ts_status ts_wall_contacts_finish(struct tsim *sim, struct ts_wall_contacts *c,
				       struct ts_wall_rebuild *rebuild);

/* NULL if they do not touch, if the particle is immobile and no force was computed, or if reports are not
 * stored. */
static inline const struct ts_wall_report *ts_wall_report(const struct ts_wall_contacts *c, size_t k)
{
	return c->report && c->report[k].touching > 0 ? &c->report[k] : NULL;
}

/* Whether contact k only conducts heat: the particle is immobile, and no force was computed. */
static inline bool ts_wall_only_conducts(const struct ts_wall_contacts *c, size_t k)
{
	return c->report && !(c->report[k].touching > 0) && c->report[k].conductance > 0;
}

/* The history of contact k: `width` values. */
static inline double *ts_wall_memory(const struct ts_wall_contacts *c, size_t k)
{
	return c->memory + k * c->width;
}

/* Clears force, history and report of contact k. */
void ts_wall_contact_reset(struct ts_wall_contacts *c, size_t k);
/* To be called where pair k does not touch: ends the contact if there was one. */
static inline void ts_wall_contact_end(struct ts_wall_contacts *c, size_t k)
{
	if (c->touching[k])
		ts_wall_contact_reset(c, k);
}
/* Sets the force of contact k in this step to 0. */
static inline void ts_wall_contact_zero_force(const struct ts_wall_contacts *c, size_t k)
{
	for (int d = 0; d < 3; d++)
		c->force[k][d] = 0;
}

/* Calls `share` for ranges of contacts in parallel. The contacts of a particle are never split between
 * ranges, so that its forces are summed in a fixed order. */
void ts_wall_contacts_parallel(const struct tsim *sim, const struct ts_wall_contacts *c, ts_range_fn *share,
			       void *context);

enum ts_status ts_wall_contacts_archive(struct ts_archive *archive, struct tsim *sim,
					struct ts_wall_contacts *c);
/* For the carrier of a wall: core/carried.h. */
enum ts_status ts_wall_contacts_give(struct tsim *sim, struct ts_wall_contacts *c,
				     const struct ts_leaving *leaving, struct ts_carried *out);
enum ts_status ts_wall_contacts_take(struct tsim *sim, struct ts_wall_contacts *c,
				     const struct ts_carried *rows);
/* Between runs: finds the rows of the particles if some have been deleted, created or read since; -1: it is gone. For
 * outputs. */
enum ts_status ts_wall_contacts_connect(struct tsim *sim, struct ts_wall_contacts *c);
void ts_wall_contacts_release(struct ts_wall_contacts *c);

#endif
