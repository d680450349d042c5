/* Check of the grid resolution, from the solution at the end of a run. */
#ifndef TS_FLOW_FLOW_RESOLUTION_H
#define TS_FLOW_FLOW_RESOLUTION_H

#include "flow/projection.h"

/* Reports velocities that alternate from cell to cell, and walls whose first cells do not resolve the
 * velocity profile (review: flow_resolution). */
enum ts_status ts_projection_check_resolution(const struct ts_instance *self, struct tsim *sim);

#endif
