/* Stability limits of the drag fixes in the plan of a run. */
#ifndef TS_COUPLING_DRAG_LIMITS_H
#define TS_COUPLING_DRAG_LIMITS_H

#include "core/sim.h"

/* Slot `plan` of struct ts_style. */
enum ts_status ts_drag_report_limits(struct ts_instance *self, struct tsim *sim,
				     struct ts_plan_report *report);
/* Slot `ground`. */
void ts_drag_add_ground(const struct ts_instance *self, const struct tsim *sim, size_t i,
			struct ts_ground_springs *sum);

#endif
