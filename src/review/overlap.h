/* Sums over large initial overlaps, of particles with each other and with walls. */
#ifndef TS_REVIEW_OVERLAP_H
#define TS_REVIEW_OVERLAP_H

#include "integrate/integrators.h"
#include "law/granular_force.h"
#include "rigid/rigid.h"

struct ts_review_overlaps {
	size_t n;	/* number of such contacts */
	double energy;	/* elastic energy of all */
	double depth;	/* of the deepest: overlap / smaller radius */
	double overlap; /* of the deepest (length) */
	double speed;	/* relative velocity at which it would separate without dissipation */
	bool newest;	/* the contact added last is the deepest */
	size_t a;	/* index of the (first) particle of the deepest */
	int32_t b;	/* id of its partner */
};

/* Adds a contact. */
void ts_review_add(struct ts_review_overlaps *o, const struct ts_granular_model *model,
		   const struct ts_granular_pair *law, const struct ts_touch *t);

/* Whether overlaps are not checked: no particle moves; fix nve/limit bounds displacements, so that overlaps
 * are intended; or, with -check, previous runs were not stepped, so that positions are not those of the
 * run. */
static inline bool ts_review_blind(const struct tsim *sim)
{
	return sim->review.stale || sim->run.clamped ||
	       (!ts_integrated_groups(sim, TS_MOVES) && !sim->rigid->n);
}

#endif
