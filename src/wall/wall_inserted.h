/* Warning: particles that have been inserted during a run overlap a wall. Fixes that insert keep them apart from each other,
 * but know no walls. The review looks at those that exist when a run begins. */
#ifndef TS_WALL_WALL_INSERTED_H
#define TS_WALL_WALL_INSERTED_H

#include "core/sim.h"

/* In POST_BUILD, after the wall has listed its contacts; all ranks call it. */
enum ts_status ts_wall_look_at_inserted(struct ts_instance *self, struct tsim *sim);

#endif
