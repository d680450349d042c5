/* Numbers read from a file, for the heights of a voxel field. */
#ifndef TS_VOXEL_VOXEL_GRID_H
#define TS_VOXEL_VOXEL_GRID_H

#include <stddef.h>
#include <stdint.h>

#include "base/status.h"

/* Largest number of columns of a field: their indices are 32-bit numbers. */
enum { TS_VOXEL_MOST_COLUMNS = INT32_MAX };

/* Zero-initialise. */
struct ts_voxel_grid {
	int64_t n[2];
	double *value; /* [n[1]][n[0]], the row of least coordinate first */
	size_t capacity;
};

/* Sets the size and allocates the numbers; TS_RANGE: no or too many columns, or TS_NOMEM. */
enum ts_status ts_voxel_grid_resize(struct ts_voxel_grid *grid, int64_t nx, int64_t ny);
void ts_voxel_grid_release(struct ts_voxel_grid *grid);

#endif
