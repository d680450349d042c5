/* Grey images: portable graymaps (PGM, plain P2 and raw P5, 8 and 16 bit) and, with libpng, PNG. The values are
 * fractions, 0 black and 1 white; the top row of the image is the last one of the grid. */
#ifndef TS_VOXEL_VOXEL_IMAGE_H
#define TS_VOXEL_VOXEL_IMAGE_H

#include "voxel/voxel_source.h"

enum ts_status ts_voxel_image_read(struct tsim *sim, const struct ts_place *where, const char *path,
				   struct ts_voxel_grid *grid);

/* Largest number of columns of a field: their indices are 32-bit numbers. */
enum { TS_VOXEL_MOST_COLUMNS = INT32_MAX };
/* Sets the size of the grid and allocates it; TS_RANGE: no or too many columns, or TS_NOMEM. */
enum ts_status ts_voxel_grid_resize(struct ts_voxel_grid *grid, int64_t nx, int64_t ny);

struct ts_scan;
/* Reads a PNG from the bytes of the scanner. */
enum ts_status ts_voxel_png_read(struct ts_scan *scan, struct ts_voxel_grid *grid);

#endif
