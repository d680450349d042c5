/* Which loop over contact rows there is for a model. */
#ifndef TS_CONTACT_CONTACT_MODELS_H
#define TS_CONTACT_CONTACT_MODELS_H

#include "base/parallel.h"
#include "contact/pair.h"

/* That of the pair's model, or by its stages (law_stages.h); the generic one where there is no faster, or
 * where it is wanted (`generic`). */
ts_share_fn *ts_contact_share_of(const struct ts_pair *pair, bool generic);

#endif
