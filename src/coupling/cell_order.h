/* The particles that are in the fluid, by cell and then by identity: sums over them do not depend on how they
 * lie in memory or on the number of threads.
 *
 * For laying down on the grid the cells are cut into slabs across the last axis, thick enough that what
 * particles of every second slab reach does not meet: these work side by side. The slabs depend on the grid
 * alone. */
#ifndef TS_COUPLING_CELL_ORDER_H
#define TS_COUPLING_CELL_ORDER_H

#include "flow/fluid.h"

/* Zero-initialise; ts_cell_order_release when done. */
struct ts_cell_order {
	int32_t *row, *cell; /* of particles: sorted; cell of each row, or -1 */
	size_t *start;	     /* of each cell, in row */
	size_t *slab;	     /* of each slab, in row */
	size_t n;
	int nslabs;
	bool ring; /* the last slab meets the first */
	size_t row_capacity, cell_capacity, start_capacity, slab_capacity;
};

/* Particles of the group; `reach`: how many cells beyond its own one a particle counts for. */
enum ts_status ts_cell_order_make(struct ts_cell_order *order, struct tsim *sim,
				  const struct ts_fluid *fluid, int group, int reach);
void ts_cell_order_release(struct ts_cell_order *order);

/* Calls lay for each particle; only those that do not meet at the same time. */
typedef void ts_cell_order_fn(void *context, size_t row);
void ts_cell_order_each(const struct ts_cell_order *order, int threads, ts_cell_order_fn *lay,
			void *context);

#endif
