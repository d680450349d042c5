/* Batches of wall contacts for all models without a loop of their own: the law is computed in stages
 * (contact/law_stages.h). */
#ifndef TS_WALL_WALL_STAGES_H
#define TS_WALL_WALL_STAGES_H

#include "wall/wall_batch.h"

/* Computes contacts 0 .. n-1 of a batch, as ts_wall_batch_contacts does. */
void ts_wall_staged(struct ts_wall_batch *b, size_t n, const struct ts_granular_model *m,
		    const struct ts_granular_pair *law, double dt);

#endif
