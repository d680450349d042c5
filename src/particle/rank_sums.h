/* Exact sums over the particles of all ranks: their bits do not depend on the number of ranks. */
#ifndef TS_PARTICLE_RANK_SUMS_H
#define TS_PARTICLE_RANK_SUMS_H

#include "core/sim.h"
#include "math/exactsum.h"

/* While the particles are divided, sum[0..n) become the sums of the terms of all ranks; else they stay. For the slot
 * `join` of styles: all ranks call it in the same order. */
enum ts_status ts_rank_sums(struct tsim *sim, struct ts_exactsum *sum, size_t n);

#endif
