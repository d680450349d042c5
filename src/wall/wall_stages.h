/* Contacts with walls by laws in stages (law_stages.h), for all models that have no loop of their own. */
#ifndef TS_WALL_WALL_STAGES_H
#define TS_WALL_WALL_STAGES_H

#include "wall/wall_batch.h"

/* As ts_wall_batch_contacts. */
ts_wall_batch_fn ts_wall_staged;

#endif
