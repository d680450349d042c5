/* The reason for a lost particle, for the message: the wall that it has passed, or that there is none. */
#ifndef TS_WALL_WALL_LOSS_H
#define TS_WALL_WALL_LOSS_H

#include "core/sim.h"

/* For the slot explain_loss of struct ts_particles; appends nothing if there
 * are only plane walls, and none at that face. */
void ts_wall_explain_loss(struct tsim *sim, size_t i, int face, struct ts_str *out);

#endif
