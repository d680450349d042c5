/* Exact sums over the particles of all ranks: their bits do not depend on the number of ranks. */
#ifndef TS_PARTICLE_RANK_SUMS_H
#define TS_PARTICLE_RANK_SUMS_H

#include "core/sim.h"
#include "math/exactsum.h"

enum { TS_RANK_SUMS_MOST = 8 };

/* sum[k]: exact sum, rounded once, of data[stride * i + k] over i < n and, while the particles are divided, over all
 * ranks; k < width <= TS_RANK_SUMS_MOST. For the slot `join` of styles: all ranks call it in the same order. */
enum ts_status ts_rank_sums(struct tsim *sim, const double *data, size_t n, size_t stride, size_t width,
			    double *sum);

/* While the particles are divided: part[k] becomes the sum of those of all ranks, which all call it in the same order;
 * width <= TS_RANK_SUMS_MOST. */
void ts_rank_sums_merge(const struct tsim *sim, struct ts_exactsum *part, size_t width);

/* While the particles are divided: *number becomes the sum of those of all ranks. */
void ts_rank_sums_count(const struct tsim *sim, int64_t *number);

#endif
