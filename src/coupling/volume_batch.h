/* Exact volumes of a batch of particles in the cells of a uniform grid, in vectors of particles: the numbers of
 * ts_coupling_volume_add, bit for bit. */
#ifndef TS_COUPLING_VOLUME_BATCH_H
#define TS_COUPLING_VOLUME_BATCH_H

#include "coupling/cell_halves.h"
#include "coupling/volume_distribution.h"

enum { TS_VOLUME_BATCH = 32 }; /* most particles of a batch */

struct ts_volume_batch {
	size_t n;
	double x[3][TS_VOLUME_BATCH], radius[TS_VOLUME_BATCH];
	uint64_t where[TS_VOLUME_BATCH]; /* in the grid at their own coordinates */
};

/* Whether batches can be used. */
bool ts_volume_batch_possible(const struct ts_grid *grid, const struct ts_coupling_volume *how);
/* Adds all of the batch, in its order. */
void ts_volume_batch_add(struct ts_volume_batch *batch, const struct ts_grid *grid,
			 const struct ts_coupling_volume *how, double *fraction);

#endif
