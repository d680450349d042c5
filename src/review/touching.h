/* What checks of the review add up of overlaps, with particles and with walls. */
#ifndef TS_REVIEW_TOUCHING_H
#define TS_REVIEW_TOUCHING_H

#include "integrate/integrators.h"
#include "law/granular_force.h"
#include "rigid/rigid.h"

struct ts_review_overlaps {
	size_t n;
	double energy;	/* of all */
	double depth;	/* of the worst, by its smaller radius */
	double overlap; /* of it */
	double speed;	/* at which it would open without losses */
	bool newest;	/* the one that was added last is the worst */
	size_t a;	/* row of the particle of the worst */
	int32_t b;	/* identity of its partner */
};

/* A touch this deep, by the smaller radius, is a finding. */
extern const double ts_review_depth;
void ts_review_add(struct ts_review_overlaps *o, const struct ts_granular_model *model,
		   const struct ts_granular_pair *law, const struct ts_touch *t);

/* Overlaps are no finding: nothing moves; steps are bounded (fix nve/limit), so that they are
 * meant; or the particles are not where they will be, as with -check runs before this one have not
 * been stepped. */
static inline bool ts_review_blind(const struct tsim *sim)
{
	return sim->review.stale || sim->run.clamped ||
	       (!ts_integrated_groups(sim, TS_MOVES) && !sim->rigid->n);
}

#endif
