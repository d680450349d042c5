/* The models that most scenes have, each with a loop over contact rows of its own. */
#ifndef TS_NEIGH_ROW_MODELS_H
#define TS_NEIGH_ROW_MODELS_H

#include "base/parallel.h"
#include "law/granular.h"

/* The loop for a model; the generic one where there is no faster, or where it is wanted (`generic`). */
ts_share_fn *ts_row_share_of(const struct ts_granular_model *m, bool generic);

#endif
