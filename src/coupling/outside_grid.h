/* Particles that are not in the grid of a fluid that is solved for: no force of the fluid acts on them. */
#ifndef TS_COUPLING_OUTSIDE_GRID_H
#define TS_COUPLING_OUTSIDE_GRID_H

#include "flow/fluid.h"

/* Of the particles that a fix acts on, n are outside in this step, the first of them by identity `tag` (ignored where n
 * is 0). Warns once in a run. */
void ts_coupling_count_outside(struct ts_fluid *fluid, struct tsim *sim, const struct ts_instance *self, size_t n,
			   int64_t tag);
/* At the end of the run: what has come of it. */
void ts_coupling_report_outside(struct ts_fluid *fluid, struct tsim *sim);

#endif
