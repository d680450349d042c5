/* The volume of a particle in the cells of the fluid.
 *
 * centre    all of it in the cell that holds the centre
 * divided   in each cell what of the sphere (in two dimensions: of the disc) lies in it, exactly
 * kernel    smeared along each axis over a length b to either side by (1 + cos(pi s/b))/(2 b), integrated over
 *           each cell: smooth in space and time, and it does not depend on the grid
 * What would lie beyond a boundary goes to the cells along it: the sum over the cells is the volume of the
 * particle. */
#ifndef TS_COUPLING_VOLUME_DISTRIBUTION_H
#define TS_COUPLING_VOLUME_DISTRIBUTION_H

#include "grid/grid.h"

enum ts_coupling_volume_method { TS_VOLUME_CENTRE, TS_VOLUME_DIVIDED, TS_VOLUME_KERNEL };
enum { TS_VOLUME_MAX_CELLS = 32 }; /* cells along an axis that one particle counts for */

struct ts_coupling_volume {
	enum ts_coupling_volume_method method;
	bool disc;    /* two dimensions: the disc's share of the area of the cell */
	double reach; /* b in diameters */
};

/* Cells beyond its own one that a particle may count for. */
int ts_coupling_volume_reach(const struct ts_grid *grid, const struct ts_coupling_volume *how, double radius);

/* Tells each cell that has a part of the volume, with that part. */
typedef void ts_coupling_volume_fn(void *context, const int cell[3], double volume);
void ts_coupling_volume_each_cell(const struct ts_grid *grid, const struct ts_coupling_volume *how, const double place[3],
		    const int cell[3], double radius, ts_coupling_volume_fn *visit, void *context);

/* fraction += part of the volume in the cell / volume of the cell; `place` in the grid and in `cell`. */
void ts_coupling_volume_add(const struct ts_grid *grid, const struct ts_coupling_volume *how,
		      const double place[3], const int cell[3], double radius, double *fraction);

#endif
