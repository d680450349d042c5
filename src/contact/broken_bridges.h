/* Liquid bridges that have broken in a step: their liquid goes to the two particles in proportion to their volumes
 * (contact/liquid.h).
 *
 * A bridge across a periodic face has two entries in the list, one for each particle, which differ by rounding. It ends where
 * the first of them breaks; if both do so in the same step each gives its particle its part. */
#ifndef TS_CONTACT_BROKEN_BRIDGES_H
#define TS_CONTACT_BROKEN_BRIDGES_H

#include "contact/pair.h"

/* History value that marks, until the end of the force computation, a pair whose bridge has just broken. */
enum { TS_BRIDGE_BROKEN = -1 };

/* After the forces of a step, if bridges have broken (bridges_broken of the list); with several ranks and periodic faces in each
 * step, on all of them: the entries may be on two ranks, which tell each other. */
enum ts_status ts_broken_bridges_redistribute(struct tsim *sim, const struct ts_pair *pair);

#endif
