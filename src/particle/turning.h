/* Particles that cross a periodic face, with several ranks: what the ranks of both particles of a contact must have. */
#ifndef TS_PARTICLE_TURNING_H
#define TS_PARTICLE_TURNING_H

#include "core/carried.h"
#include "core/sim.h"

struct ts_division;

/* In EXCHANGE, before particles are wrapped or deleted: exchanges the rows of contacts one of whose particles will be wrapped. */
enum ts_status ts_turning_exchange(struct tsim *sim);
/* Whether this rank has got any. */
bool ts_turning_found(const struct ts_division *d);
/* Adds them to the rows that change ranks, d->carried, and forgets them. */
enum ts_status ts_turning_add(struct tsim *sim);
void ts_turning_forget(struct ts_division *d);

#endif
