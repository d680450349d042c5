/* Which rank has which cells of the grid, while the particles are divided: each those whose centres lie in its block of
 * space. A rank adds what particles do to its own cells; then all ranks get the values of all cells. Where there are few
 * particles for the cells every rank has all cells, and nothing is sent but particles. */
#ifndef TS_FLOW_CELL_OWNERS_H
#define TS_FLOW_CELL_OWNERS_H

#include "grid/grid.h"
#include "rank/blocks.h"
#include "rank/world.h"

/* Zero-initialise; ts_cell_owners_release when done. */
struct ts_cell_owners {
	uint64_t made_for; /* hash of the grid and the blocks */
	bool all;	   /* every rank has all cells */
	int ranks;
	int32_t *rank; /* of each cell; owned, as the arrays below */
	/* Indices in a field of the cells of rank r: point[start[r]] to point[start[r + 1] - 1]. Points on upper boundaries
	 * go with the last cell. */
	size_t *point, *start;
	uint64_t *size;		       /* [ranks]: bytes */
	struct ts_parcel mine, shared; /* values of own cells, and of all */
	size_t rank_capacity, point_capacity, start_capacity, size_capacity;
};

/* Makes them for a grid and blocks with this hash, if they are not there yet. */
enum ts_status ts_cell_owners_make(struct ts_cell_owners *owners, uint64_t hash, const struct ts_grid *grid,
				   const struct ts_rank_blocks *blocks, bool all);
void ts_cell_owners_release(struct ts_cell_owners *owners);

static inline size_t ts_cell_owners_count(const struct ts_cell_owners *owners, int rank)
{
	return owners->start[rank + 1] - owners->start[rank];
}

/* All ranks call it: n fields get the values of the cells of other ranks. NULL: no field. */
enum ts_status ts_cell_owners_share(struct ts_cell_owners *owners, struct ts_world *world,
				    double *const *field, size_t n);

#endif
