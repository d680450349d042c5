/* What ranks would send of particles that add to cells of the fluid, counted without starting them: by the functions that send
 * it (coupling/cell_rows.h), for the present particles. */
#ifndef TS_COUPLING_CELL_REHEARSAL_H
#define TS_COUPLING_CELL_REHEARSAL_H

#include "flow/fluid.h"
#include "particle/rank_layout.h"
#include "rank/world.h"

/* Adds to sent[r] what rank r sends in so many steps, in which particles move; `near`: without what they have added to cells,
 * where ranks have the fluid near their particles (flow/step_rehearsal.h). */
enum ts_status ts_cell_rehearse(struct tsim *sim, const struct ts_fluid *fluid,
				const struct ts_rank_layout *layout, int64_t steps, bool near,
				struct ts_world_counts *sent);

#endif
