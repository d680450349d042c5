/* Values of a grid of cells, as fix ave/euler finds them and dump euler/vtk writes them. */
#ifndef TS_AVERAGE_EULER_H
#define TS_AVERAGE_EULER_H

#include "core/sim.h"

/* Columns of a cell. */
enum ts_euler_column {
	TS_EULER_X,	       /* its centre */
	TS_EULER_V = 3,	       /* mean velocity, by mass */
	TS_EULER_FRACTION = 6, /* volume of particles by that of the cell */
	TS_EULER_RADIUS,       /* mean */
	TS_EULER_PRESSURE,
	TS_EULER_COUNT,
	TS_EULER_MASS,
	TS_EULER_STRESS, /* xx, yy, zz, xy, xz, yz; > 0 pulls */
	TS_EULER_COLUMNS = TS_EULER_STRESS + 6
};

/* First member of the state of fixes of TS_FAMILY_EULER. */
struct ts_euler {
	int64_t n[3];		       /* cells along each axis; 0: no grid yet */
	double *cell;		       /* TS_EULER_COLUMNS each, x counts fastest; in the box as it was */
	size_t ncells, size, capacity; /* of all, numbers, room */
};
#define TS_FAMILY_EULER "euler"

#endif
