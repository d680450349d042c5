/* Impacts of particles on the surfaces of a wall, from touch to separation (impact/impact_event.h).
 *
 * A wall keeps a struct ts_impacts if some fix observes the impacts on one of its surfaces. An impact belongs to one
 * particle and one surface of one wall; it goes on while the particle touches any element of the surface, in any
 * periodic image. So a particle that rolls from triangle to triangle makes one impact, one that touches two meshes of
 * a wall makes two, and two walls made of the same mesh have impacts of their own, each with its own force.
 *
 * An impact begins with the first step in which the surfaces overlap. Contact laws have the velocities of the half
 * step, which at entry no contact force has changed yet: that is the entry velocity. The time of entry within the step
 * follows from the overlap and the normal speed. The impact ends in the first step without contact; if the particle has
 * been deleted or has left the box in the run, too: what has happened so far counts.
 *
 * Contacts that exist when the observation begins, or that other commands than a run have made, are no impacts: nobody
 * has seen the entry.
 *
 * An observer reads the impacts that have ended in this step in late[TS_LATE_CONTACTS]:
 *
 *	struct ts_surface_impacts it = ts_surface_impacts(sim, surface.by);
 *	const struct ts_surface_impact *impact;
 *	while ((impact = ts_surface_impacts_next(&it))) ...
 *
 * walls in script order, in each of them by element and there by the particles' identities: sums over them depend neither
 * on threads nor on where particles are in memory. */
#ifndef TS_IMPACT_IMPACTS_H
#define TS_IMPACT_IMPACTS_H

#include "impact/impact_event.h"
#include "wall/wall.h"

/* All members are numbers of type double, so that restart files store it as a row of numbers. */
struct ts_surface_impact {
	struct ts_impact_event event;
	double surface; /* of the wall: number of its mesh, from 0; 0: a primitive */
	double groups;	/* of the particle at entry: bits */
	double seen;	/* 0: the contact existed when the observation began */
	double tail;	/* estimated time from the last step with contact to separation */
	double touches; /* in this step */
};
enum { TS_SURFACE_IMPACT_NUMBERS = sizeof(struct ts_surface_impact) / sizeof(double) };

struct ts_impact_list {
	struct ts_surface_impact *item;
	size_t n, capacity;
};

struct ts_impacts {
	struct ts_impact_list live;  /* by surface and particle */
	struct ts_impact_list ended; /* in this step, by surface, element and particle */
	struct ts_impact_list added; /* since the last update, by ts_impacts_append */
	uint8_t *tracked;	     /* [surfaces] whether contacts are tracked since an earlier step */
	size_t surfaces, tracked_capacity;
	struct ts_impact_touch *touch; /* buffer */
	size_t touch_capacity;
};

static inline bool ts_surface_impact_in_group(const struct ts_surface_impact *impact, int group)
{
	return ((uint32_t)impact->groups >> group) & 1u;
}

/* ---- by observers ---- */

/* The state of an iteration. */
struct ts_surface_impacts {
	const struct tsim *sim;
	const struct ts_instance *surface;
	size_t next_wall; /* of ts_walls_next */
	const struct ts_wall *wall;
	size_t at;
};
struct ts_surface_impacts ts_surface_impacts(const struct tsim *sim, const struct ts_instance *surface);
/* NULL: there are no more. */
const struct ts_surface_impact *ts_surface_impacts_next(struct ts_surface_impacts *it);

/* ---- by walls ---- */

/* In POST_BUILD, when contacts are listed: makes w->impacts, or frees it, as observers want. */
enum ts_status ts_impacts_prepare(struct ts_instance *wall, struct tsim *sim);
/* In POST_FORCE, after ts_surface_contacts_collect: follows the contacts of this step. */
enum ts_status ts_impacts_update(struct tsim *sim, struct ts_wall *w);
/* Adds a whole impact of a particle of these groups on this surface of the wall (0 if it is a primitive), which has been
 * computed otherwise than step by step; at any time between the updates of the last and of this step, on all ranks. */
enum ts_status ts_impacts_append(struct tsim *sim, struct ts_impacts *impacts, size_t surface,
				 uint32_t groups, const struct ts_impact_event *event);
enum ts_status ts_impacts_archive(struct ts_archive *archive, struct tsim *sim, struct ts_wall *w);
void ts_impacts_free(struct ts_impacts *impacts);

#endif
