/* The direct solver divided among ranks: each transforms planes of its own, and eliminates modes of its own in all planes; in
 * between all ranks exchange what one has of the modes of another (a transposition). If the axis across the slabs of ranks is
 * not the third one, which is eliminated, but the second, a rank transforms along the first axis in its slab, and has columns then:
 * of some modes of the first axis all of the others, which it transforms along the second axis and eliminates. */
#ifndef TS_POISSON_DIRECT_EXCHANGE_H
#define TS_POISSON_DIRECT_EXCHANGE_H

#include "poisson/direct.h"

/* Divides the solver by these slabs, where it can: planes of the third axis, or the second, are then those of the slabs. */
enum ts_status ts_direct_divide(struct ts_direct *solver, struct ts_slabs *slabs);
/* Whether ranks have slabs now. */
bool ts_direct_divided(const struct ts_direct *solver);
void ts_direct_release_columns(struct ts_direct *solver);
/* Each rank gets its modes of all planes; `back`: all modes of its planes. */
void ts_direct_exchange(const struct ts_direct *solver, bool back);
/* The exchanges of a solve (rank/rehearsal.h). When the rank is another one it is divided again before, for the room. */
void ts_direct_rehearse(const struct ts_direct *solver);

#endif
