/* Between which points of the grid, and with which weights, fields are interpolated to a place: the same for all places in
 * one half of a cell along an axis. Only in three dimensions. */
#ifndef TS_GRID_GRID_HALVES_H
#define TS_GRID_GRID_HALVES_H

#include "grid/grid.h"

/* Half h of an axis: below the centre of cell h/2 if h is even, from it on if h is odd. Positions are those in a field,
 * without its origin; low and high are [0] and [1]. One cell of the cache each: the rules of coupling/axis_points.h, and
 * those of velocities in flow/fluid_interpolation.c. */
struct ts_grid_half {
	double centre, gap;		     /* of the low centre, and from it to the high one */
	double face, width;		     /* of the cell */
	ptrdiff_t centre_at[2], face_at[2];  /* across boundaries: images, or the nearest points inside */
	double centre_width[2], face_gap[2]; /* widths of the cells and of the control volumes there */
	double face_distance;		     /* from face to face */
	ptrdiff_t centre_first, face_first, unused; /* low points; those beyond boundaries are ghosts */
};

/* Makes grid->half of all axes; ts_grid_release frees them. */
enum ts_status ts_grid_halves_make(struct ts_grid *grid);

#endif
