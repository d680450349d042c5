/* Whether the cells are fine enough for the flow: seen in the solution itself, at the end of a run.
 */
#ifndef TS_FLOW_FLOW_RESOLUTION_H
#define TS_FLOW_FLOW_RESOLUTION_H

#include "flow/projection.h"

/* Tells where velocities alternate from cell to cell, and where the first cells beside a wall miss
 * the profile (review: flow_resolution). */
enum ts_status ts_projection_check_resolution(const struct ts_instance *self, struct tsim *sim);

#endif
