/* Particles in the fluid sorted by cell and then by identity: sums over them do not depend on the order of
 * particles in memory or on the number of threads.
 *
 * For adding to fields of the grid in parallel the cells are divided into slabs across the last axis,
 * thick enough that particles of every second slab write to different cells: these slabs are processed in
 * parallel. Slabs depend on the grid only. */
#ifndef TS_COUPLING_CELL_ORDER_H
#define TS_COUPLING_CELL_ORDER_H

#include "flow/fluid.h"

/* Zero-initialise; ts_cell_order_release when done. */
struct ts_cell_order {
	/* indices of particles, sorted; cell of each particle, or -1. Owned, as the arrays below */
	int32_t *row, *cell;
	size_t *start; /* of each cell: its first index in `row` */
	size_t *slab;  /* of each slab: its first index in `row` */
	size_t n;      /* number of particles in the fluid */
	int nslabs;
	bool ring; /* periodic axis: the last slab is beside the first */
	size_t row_capacity, cell_capacity, start_capacity, slab_capacity;
};

/* Sorts the particles of the group; `reach`: number of cells beyond its own to which a particle adds. */
enum ts_status ts_cell_order_make(struct ts_cell_order *order, struct tsim *sim, const struct ts_fluid *fluid,
				  int group, int reach);
void ts_cell_order_release(struct ts_cell_order *order);

/* Calls `add` for each particle, in parallel for particles that add to different cells. */
typedef void ts_cell_order_fn(void *context, size_t row);
void ts_cell_order_each(const struct ts_cell_order *order, int threads, ts_cell_order_fn *add, void *context);

#endif
