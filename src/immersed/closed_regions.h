/* Fluid that bodies close off from all open faces: what comes in there, or is pushed, has no way
 * out, and no pressure could make the flow free of divergence.
 *
 * A body gives the velocity at all faces of cells inside it. From the open faces on, cells are
 * filled through the other faces; what is left are regions. One into which the faces of the grid,
 * or bodies whose motion is given, bring more than they take has no solution. Regions without are
 * legal. */
#ifndef TS_IMMERSED_CLOSED_REGIONS_H
#define TS_IMMERSED_CLOSED_REGIONS_H

#include "immersed/immersed.h"

struct ts_closed_search;

/* Looks at all bodies as they are now; an error where one closes off what comes in, or stands on an
 * inlet. */
enum ts_status ts_immersed_check_closed(struct tsim *sim);

enum ts_immersed_motion {
	TS_BODY_FREE,	/* the fluid moves it: it pushes none for long */
	TS_BODY_DRIVEN, /* its motion is given, whatever the fluid does */
	TS_BODY_UNKNOWN /* that will be known in the first step: regions beside it are not judged
			   before */
};

/* For the slot `block` of those who take part in a step of the fluid: these points are those of a
 * body. */
void ts_closed_search_add_body(struct ts_closed_search *search, const struct ts_instance *self,
		     const struct ts_immersed *ib, const struct ts_solid *solid,
		     enum ts_immersed_motion motion);

#endif
