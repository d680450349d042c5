/* A hierarchy of cell grids: particles of similar size share a grid, whose cells are just as large as the
 * contact distance of two of its largest particles. So a search among mixed radii costs no more than among
 * equal ones (V. Ogarko, S. Luding, Comput. Phys. Commun. 183 (2012) 931). */
#ifndef TS_NEIGH_CELLS_H
#define TS_NEIGH_CELLS_H

#include "core/sim.h"

enum { TS_MAX_LEVELS = 16 };

/* The search reads this number of entries at a time. */
enum { TS_CELLS_VECTOR = 4 };

struct ts_level {
	double reach;		  /* largest radius on this level, length */
	double lo[3], inverse[3]; /* index of the cell in a dimension: (x - lo) * inverse */
	int cells[3];
	size_t ncells, first; /* number of cells; number of those of the levels before */
	/* Particles of cell c: list[start[c]] .. list[start[c+1]-1], in the order of their indices. TS_CELLS_VECTOR
	 * - 1 entries beyond the last one can be read. */
	int32_t *start;
	long long *list;
	double *position[4]; /* by entry of the list: x, y, z (xhold) and radius */
	size_t start_capacity, list_capacity, position_capacity[4];
};

/* Zero-initialise before they are filled; release afterwards. */
struct ts_cells {
	int nlevels;
	struct ts_level level[TS_MAX_LEVELS]; /* from large to small particles */
	uint8_t *level_of;
	int32_t *cell_of;
	int32_t *
		place; /* by share (thread) and cell: number of its particles, then where the next one is listed */
	size_t capacity, cell_capacity, place_capacity;
};

/* Sorts all particles, ghosts included, into cells by their positions at the last rebuild (xhold). */
enum ts_status ts_cells_fill(struct tsim *sim, struct ts_cells *cells, double skin);
void ts_cells_release(struct ts_cells *cells);

/* Range lo .. hi of the cells of a level within `distance` of x. */
void ts_cells_range(const struct ts_level *level, const double x[3], double distance, int lo[3], int hi[3]);

#endif
