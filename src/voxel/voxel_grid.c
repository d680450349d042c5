#include "voxel/voxel_grid.h"

#include "base/alloc.h"

#include "base/banned.h"

enum ts_status ts_voxel_grid_resize(struct ts_voxel_grid *grid, int64_t nx, int64_t ny)
{
	if (nx < 1 || ny < 1 || nx > TS_VOXEL_MOST_COLUMNS / ny)
		return TS_RANGE;
	grid->n[0] = nx;
	grid->n[1] = ny;
	return TS_GROW(grid->value, grid->capacity, (size_t)nx * (size_t)ny);
}

void ts_voxel_grid_release(struct ts_voxel_grid *grid)
{
	ts_free(grid->value);
	*grid = (struct ts_voxel_grid){ .n = { 0 } };
}
