/* Grey images: portable graymaps (PGM, plain P2 and raw P5, 8 and 16 bit) and, with libpng, PNG. The values are
 * fractions, 0 black and 1 white; the top row of the image is the last one of the grid. */
#ifndef TS_VOXEL_VOXEL_IMAGE_H
#define TS_VOXEL_VOXEL_IMAGE_H

#include "core/sim.h"
#include "voxel/voxel_grid.h"

enum ts_status ts_voxel_image_read(struct tsim *sim, const struct ts_place *where, const char *path,
				   struct ts_voxel_grid *grid);

#endif
