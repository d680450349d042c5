/* Which rank has which cells of the grid, while the particles are divided: each those whose centres lie in its block of
 * space, a box of cells. A rank adds what particles do to its own cells; then those that need the values get them. Where
 * there are few particles for the cells every rank may have all cells, and nothing is sent but particles. */
#ifndef TS_FLOW_CELL_OWNERS_H
#define TS_FLOW_CELL_OWNERS_H

#include "grid/grid.h"
#include "rank/blocks.h"
#include "rank/world.h"

/* The points from[d] .. to[d] - 1 of a field along each axis; none if to <= from along one of them. */
struct ts_cell_box {
	int from[3], to[3];
};

/* The points of both boxes. */
struct ts_cell_box ts_cell_box_common(const struct ts_cell_box *a, const struct ts_cell_box *b);
size_t ts_cell_box_size(const struct ts_cell_box *box);
/* Copies the values of the points of a box to, or from, size of them in a row; returns where these end. */
double *ts_cell_box_pack(const struct ts_grid *grid, const struct ts_cell_box *box, const double *field,
			 double *to);
const double *ts_cell_box_unpack(const struct ts_grid *grid, const struct ts_cell_box *box,
				 const double *from, double *field);

/* Zero-initialise; ts_cell_owners_release when done. */
struct ts_cell_owners {
	uint64_t made_for; /* ts_cell_owners_hash, and `all` */
	bool all;	   /* every rank has all cells */
	int ranks;
	/* The points of each rank, those on upper boundaries with the last cell; [ranks]. Owned, as the arrays below */
	struct ts_cell_box *box;
	uint64_t *size;		       /* [ranks]: bytes */
	struct ts_parcel mine, shared; /* values of own cells, and of all */
	size_t box_capacity, size_capacity;
};

/* Another grid, or other blocks (NULL: none), have another one. */
uint64_t ts_cell_owners_hash(const struct ts_grid *grid, const struct ts_rank_blocks *blocks);
/* Makes them for a grid and blocks with this hash, if they are not there yet. */
enum ts_status ts_cell_owners_make(struct ts_cell_owners *owners, uint64_t hash, const struct ts_grid *grid,
				   const struct ts_rank_blocks *blocks, bool all);
void ts_cell_owners_release(struct ts_cell_owners *owners);

static inline size_t ts_cell_owners_count(const struct ts_cell_owners *owners, int rank)
{
	return ts_cell_box_size(&owners->box[rank]);
}

/* All ranks call it: n fields get the values of the cells of other ranks. */
enum ts_status ts_cell_owners_share(struct ts_cell_owners *owners, struct ts_world *world,
				    const struct ts_grid *grid, double *const *field, size_t n);

#endif
