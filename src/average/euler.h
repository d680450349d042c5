/* Eulerian averages on a grid of cells, computed by fix ave/euler and written by dump euler/vtk. */
#ifndef TS_AVERAGE_EULER_H
#define TS_AVERAGE_EULER_H

#include "core/sim.h"

/* Columns of a cell; in two dimensions volumes are areas. */
enum ts_euler_column {
	TS_EULER_X,	       /* centre of the cell (length) */
	TS_EULER_V = 3,	       /* mass-weighted mean velocity */
	TS_EULER_FRACTION = 6, /* volume of the particles / volume of the cell */
	TS_EULER_RADIUS,       /* mean radius (length) */
	TS_EULER_PRESSURE,     /* - trace of the stress / dimension */
	TS_EULER_COUNT,	       /* number of particles */
	TS_EULER_MASS,
	TS_EULER_STRESS, /* xx, yy, zz, xy, xz, yz (pressure); tension is positive */
	TS_EULER_COLUMNS = TS_EULER_STRESS + 6
};

/* First member of the state of fixes of TS_FAMILY_EULER. */
struct ts_euler {
	int64_t n[3];	       /* cells along each axis; 0: no grid yet */
	double *cell;	       /* [ncells][TS_EULER_COLUMNS] of the last evaluation, x index fastest */
	size_t ncells;	       /* n[0] n[1] n[2] */
	size_t size, capacity; /* of `cell`, in numbers */
};
#define TS_FAMILY_EULER "euler"

#endif
