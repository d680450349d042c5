/* A hierarchy of cell grids: particles of similar size share a grid whose cells just hold a contact
 * between two of the largest, so that mixed radii cost no more than equal ones (Ogarko & Luding,
 * Comput. Phys. Commun. 183 (2012) 931). */
#ifndef TS_NEIGH_CELLS_H
#define TS_NEIGH_CELLS_H

#include "core/sim.h"

enum { TS_MAX_LEVELS = 16 };

struct ts_level {
	double reach;		  /* the largest radius on this level */
	double lo[3], inverse[3]; /* cell number = (x - lo) * inverse */
	int cells[3];
	/* particles of cell c: list[start[c]] .. list[start[c+1]-1]; behind the last, three more can be
	 * read */
	int32_t *start;
	long long *list;
	double *position[4]; /* of those in the list: where they are held, and their radius */
	size_t start_capacity, list_capacity, position_capacity[4];
};

struct ts_cells {
	int nlevels;
	struct ts_level level[TS_MAX_LEVELS]; /* from large to small particles */
	uint8_t *level_of;
	int32_t *cell_of;
	size_t capacity, cell_capacity;
};

/* Sorts all particles, ghosts included, into cells by xhold. */
enum ts_status ts_cells_fill(struct tsim *sim, struct ts_cells *cells, double skin);
void ts_cells_release(struct ts_cells *cells);

/* Range of cells of a level within `distance` of x. */
void ts_cells_range(const struct ts_level *level, const double x[3], double distance, int lo[3], int hi[3]);

#endif
