/* Why a particle has left the box: which wall it was behind, or that there is none. */
#ifndef TS_WALL_LOSS_H
#define TS_WALL_LOSS_H

#include "core/sim.h"

/* The slot explain_loss of struct ts_particles; says nothing where no wall stands at the face. */
void ts_explain_loss(struct tsim *sim, size_t i, int face, struct ts_str *out);

#endif
