/* The load of ranks: the sum of weights of their particles; and cuts that make it even. Weights are integers, whose sums over
 * all ranks are exact: all ranks choose the same cuts. */
#ifndef TS_RANK_LOADS_H
#define TS_RANK_LOADS_H

#include "base/status.h"
#include "rank/blocks.h"
#include "rank/world.h"

struct ts_rank_points {
	double (*x)[3];
	const int64_t *weight; /* > 0, with a sum over all ranks below 2^62; NULL: 1 each */
	size_t n;
	struct ts_world *world; /* all ranks together have the points; NULL: this one has all */
};

struct ts_rank_load {
	int64_t total, most; /* of all ranks, of the one that has most */
	double imbalance;    /* the most divided by the mean; 1 without points */
};

/* All return TS_NOMEM if out of memory. */
enum ts_status ts_rank_load_find(const struct ts_rank_blocks *blocks, const struct ts_rank_points *points,
				 struct ts_rank_load *load);
/* Moves the cuts of a grid along dimension d, which become the same for all its parts: those below block k get k/count[d] of the
 * load, as closely as `most` bisections of their places find. It ends earlier when no slab has more than `stop` times the mean.
 * Adds the number of bisections to *iterations. */
enum ts_status ts_rank_loads_shift(struct ts_rank_blocks *blocks, const struct ts_rank_points *points, int d,
				   int most, double stop, int *iterations);
/* Chooses the cuts of recursive bisection: each across the longest extent of the points of its part. */
enum ts_status ts_rank_loads_bisect(struct ts_rank_blocks *blocks, const struct ts_rank_points *points);

#endif
