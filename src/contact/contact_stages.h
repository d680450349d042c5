/* The loop over rows by laws in stages (law_stages.h), for all models that have no loop of their own. */
#ifndef TS_CONTACT_CONTACT_STAGES_H
#define TS_CONTACT_CONTACT_STAGES_H

#include <stddef.h>

/* The blocks from .. to-1, whose models have stages; see ts_contact_share_generic. */
void ts_contact_share_staged(void *task, size_t from, size_t to);

#endif
