/* Distribution of the volume of a particle over the cells of the fluid.
 *
 * centre    the whole volume is in the cell that contains the centre of the particle
 * divided   each cell contains the part of the sphere (in two dimensions: of the disc) that lies in it,
 *           exactly
 * kernel    the volume is distributed along each axis with the density (1 + cos(pi s/b))/(2 b), |s| < b,
 *           integrated over each cell: smooth in space and time, and independent of the grid
 * The part beyond a boundary goes to the cells along it: the sum over the cells is the volume of the
 * particle. */
#ifndef TS_COUPLING_VOLUME_DISTRIBUTION_H
#define TS_COUPLING_VOLUME_DISTRIBUTION_H

#include "grid/grid.h"

enum ts_coupling_volume_method { TS_VOLUME_CENTRE, TS_VOLUME_DIVIDED, TS_VOLUME_KERNEL };
enum { TS_VOLUME_MAX_CELLS = 32 }; /* largest number of cells along an axis that one particle covers */

struct ts_coupling_volume {
	enum ts_coupling_volume_method method;
	bool disc;    /* two dimensions: fractions are those of areas, of the disc in the cell */
	double reach; /* b of the kernel, in particle diameters */
};

/* Number of cells beyond its own that a particle of this radius may cover, along any axis. */
int ts_coupling_volume_reach(const struct ts_grid *grid, const struct ts_coupling_volume *how, double radius);

/* Called for each cell with a part of the volume. */
typedef void ts_coupling_volume_fn(void *context, const int cell[3], double volume);
void ts_coupling_volume_each_cell(const struct ts_grid *grid, const struct ts_coupling_volume *how,
				  const double place[3], const int cell[3], double radius,
				  ts_coupling_volume_fn *visit, void *context);

/* Adds to the field `fraction`: part of the volume in the cell / volume of the cell. `place`: centre of
 * the particle, in the grid and in `cell`. */
void ts_coupling_volume_add(const struct ts_grid *grid, const struct ts_coupling_volume *how,
			    const double place[3], const int cell[3], double radius, double *fraction);

#endif
