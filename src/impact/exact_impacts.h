/* `impact exact` of fix wall/gran: particles that hit a wall alone are carried through the whole impact in one step,
 * however long the step is (impact/exact_collision.h).
 *
 * In POST_INTEGRATE, after integrators and movers of meshes, particle i has moved from x - h v to x. The first wall of
 * this sort, in script order, looks for the first touch on this path with any of them, replaces the motion from there on
 * by the collision and free flight with the velocity after it, and so on until the end of the step. If the collision
 * lasts beyond the end of the step, the particle waits at the point where it will leave the surface until its time has
 * come (the column impact_wait).
 *
 * A contact is left to the forces of POST_FORCE, as without `impact exact`, if the particle
 *   - overlaps the surface and approaches it at the begin of the step (it has been put there, or was left to them before),
 *   - touches another particle in the step,
 *   - is in a rigid body, or
 *   - stays for more than TS_EXACT_LONGEST steps, which resolve the contact.
 *
 * With several ranks each carries its own particles; all of them get all impacts (impact/exact_sharing.h).
 *
 * A sort of surface takes part by a struct ts_exact_surface (wall/exact_surface.h). */
#ifndef TS_IMPACT_EXACT_IMPACTS_H
#define TS_IMPACT_EXACT_IMPACTS_H

#include "impact/impact_event.h"
#include "wall/exact_surface.h"
#include "wall/wall.h"

struct ts_plan_report;

enum {
	TS_EXACT_LONGEST = 50, /* steps; longer collisions are resolved by the steps */
	TS_EXACT_MOST = 100    /* impacts of one particle in one step */
};

/* An impact that has been computed in this step. */
struct ts_exact_impact {
	struct ts_impact_event event;
	double push[3];	      /* impulse on the particle */
	size_t surface;	      /* of the wall: number of its mesh, or 0 */
	uint32_t groups;      /* of the particle: bits */
	size_t first, nnodes; /* of `nodes`; none if nobody observes contacts with this surface */
};

struct ts_exact_impacts {
	const struct ts_exact_surface *surface;
	void *shape;
	size_t wait;		      /* index of the particle column */
	struct ts_exact_impact *item; /* of this step, by particle and time */
	size_t n, capacity;
	struct ts_contact_nodes nodes; /* of this step */
	int32_t *left; /* tags of the particles that touch others in this step and are left to the forces */
	size_t nleft, left_capacity;
	double warned_left, warned_body, warned_many; /* saved: 1: the warning has been given */
};

/* In init of a wall with the keyword: makes w->exact. */
enum ts_status ts_exact_init(struct ts_instance *self, struct tsim *sim,
			     const struct ts_exact_surface *surface, void *shape);
/* In plan: refuses laws, integrators and particles for which it is not made. */
enum ts_status ts_exact_plan(struct ts_instance *self, struct tsim *sim, struct ts_plan_report *report);
/* In POST_INTEGRATE. */
enum ts_status ts_exact_carry(struct ts_instance *self, struct tsim *sim);
/* In POST_FORCE, after ts_wall_finish: adds the mean forces of the step to w->force. */
void ts_exact_add_force(struct ts_wall *w, const struct tsim *sim);
enum ts_status ts_exact_archive(struct ts_archive *archive, struct tsim *sim, struct ts_wall *w);
void ts_exact_fini(struct ts_wall *w);

/* The impacts on this wall that were computed in this step, *n of them, by particle and time; from POST_INTEGRATE on. */
const struct ts_exact_impact *ts_exact_impacts(const struct ts_wall *w, size_t *n);
/* Whether the path of this particle in this step need not be looked at: it has been carried through its impacts. */
bool ts_exact_passes(const struct ts_wall *w, int32_t tag);

#endif
