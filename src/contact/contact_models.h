/* Choice of the contact loop for a model. */
#ifndef TS_CONTACT_CONTACT_MODELS_H
#define TS_CONTACT_CONTACT_MODELS_H

#include "base/parallel.h"
#include "contact/pair.h"

/* The loop for whole models if the pair's model has one, else the staged loop (law_stages.h), else, or if
 * `generic` is set, the generic loop. */
ts_range_fn *ts_contact_share_of(const struct ts_pair *pair, bool generic);

#endif
