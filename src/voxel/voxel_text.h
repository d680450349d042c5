/* Heights as text: a matrix of numbers as seen from above, the first line being the row of the largest second
 * coordinate. `#` starts a comment. */
#ifndef TS_VOXEL_VOXEL_TEXT_H
#define TS_VOXEL_VOXEL_TEXT_H

#include "core/sim.h"
#include "voxel/voxel_grid.h"

enum ts_status ts_voxel_text_read(struct tsim *sim, const struct ts_place *where, const char *path,
				  struct ts_voxel_grid *grid);

#endif
