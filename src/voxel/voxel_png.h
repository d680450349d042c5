/* PNG images by libpng; without it they are refused. */
#ifndef TS_VOXEL_VOXEL_PNG_H
#define TS_VOXEL_VOXEL_PNG_H

#include "mesh/mesh_scan.h"
#include "voxel/voxel_grid.h"

/* Reads the image from the bytes of the scanner: fractions, 0 black and 1 white. */
enum ts_status ts_voxel_png_read(struct ts_scan *scan, struct ts_voxel_grid *grid);

#endif
