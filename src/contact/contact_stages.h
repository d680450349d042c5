/* The staged contact loop (law_stages.h), for all models without a loop of their own. */
#ifndef TS_CONTACT_CONTACT_STAGES_H
#define TS_CONTACT_CONTACT_STAGES_H

#include <stddef.h>

/* Computes the blocks from .. to-1, whose models have stages; see ts_contact_share_generic. */
void ts_contact_share_staged(void *task, size_t from, size_t to);

/* The same for models with sub-step detection. */
void ts_contact_share_located(void *task, size_t from, size_t to);

#endif
