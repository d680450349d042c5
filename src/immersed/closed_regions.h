/* Regions of fluid that bodies separate from all open faces: a net flow into such a closed region cannot
 * leave, and no pressure makes the flow free of divergence.
 *
 * A body prescribes the velocity at all faces of cells inside it. Cells connected through all other faces
 * form sets (connected_cells.h); those without an open face are closed regions. A closed region with a net inflow from faces of the grid, or from bodies of prescribed
 * motion, has no solution and is an error; without net inflow it is legal. */
#ifndef TS_IMMERSED_CLOSED_REGIONS_H
#define TS_IMMERSED_CLOSED_REGIONS_H

#include "immersed/immersed.h"

struct ts_closed_search;

/* Checks all bodies at their present positions; an error if a closed region has a net inflow, or if a body
 * covers an inlet of another velocity. */
enum ts_status ts_immersed_check_closed(struct tsim *sim);

enum ts_immersed_motion {
	TS_BODY_FREE,	/* moved by the fluid: its velocity adapts to a closed region */
	TS_BODY_DRIVEN, /* prescribed motion */
	/* velocity not known before the first step: regions beside it are not checked before */
	TS_BODY_UNKNOWN
};

/* Adds a body with its forced points to the search. For the slot mark_closed of struct ts_flow_part. */
void ts_closed_search_add_body(struct ts_closed_search *search, const struct ts_instance *self,
			       const struct ts_immersed *ib, const struct ts_solid *solid,
			       enum ts_immersed_motion motion);

#endif
