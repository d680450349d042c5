/* Voxel height fields: a solid made of columns. Column (i, j) of a field of n[0] x n[1] columns is the box
 *
 *   [x_i, x_i+1] x [y_j, y_j+1] x [base, h_ij],   x_i = origin[0] + i width[0], y_j = origin[1] + j width[1]
 *
 * in the coordinates along axis[0], axis[1] and axis[2], the axis of the heights. A column whose height is
 * not above the base is empty. Along a periodic axis columns are counted on without end, with i and i + n the
 * same column; the border x_i is a function of i alone, so that neighbours share it exactly.
 *
 * Maxima over blocks of 4^l x 4^l columns (levels l = 0, 1, ...; level 0 is the heights) bound the height of
 * all columns in a block, so that searches skip blocks that are too low. */
#ifndef TS_VOXEL_VOXEL_FIELD_H
#define TS_VOXEL_VOXEL_FIELD_H

#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "base/status.h"

enum { TS_VOXEL_LEVELS = 17, TS_VOXEL_SHIFT = 2 /* log2 of the block edge from level to level */ };

struct ts_voxel_level {
	int64_t n[2]; /* number of blocks */
	double *top;  /* [n[1]][n[0]] maximum height in each block, length */
};

struct ts_voxel_field {
	int axis[3]; /* dimensions 0..2 of the first and second index and of the heights, in cyclic order */
	int64_t n[2];
	double origin[2], width[2]; /* length */
	double base;		    /* bottom of all columns, length; -INFINITY: there is none */
	bool periodic[2];
	struct ts_voxel_level level[TS_VOXEL_LEVELS];
	int nlevels;
};

/* Allocates the heights, all 0; n, origin, width, base and periodic are set. Returns TS_OK or TS_NOMEM. */
enum ts_status ts_voxel_field_make(struct ts_voxel_field *f);
void ts_voxel_field_release(struct ts_voxel_field *f);
/* Computes the maxima of all blocks; after heights have been written to ts_voxel_heights. */
void ts_voxel_field_update(struct ts_voxel_field *f);
/* Sets the height of column i, j and updates the maxima of its blocks. */
void ts_voxel_set_height(struct ts_voxel_field *f, int64_t i, int64_t j, double height);
/* Least and largest height; of columns that are not empty, if there are any. */
void ts_voxel_field_bounds(const struct ts_voxel_field *f, double *least, double *most);

/* The heights, [n[1]][n[0]]. */
static inline double *ts_voxel_heights(const struct ts_voxel_field *f)
{
	return f->level[0].top;
}

/* The largest height. */
static inline double ts_voxel_highest(const struct ts_voxel_field *f)
{
	return f->level[f->nlevels - 1].top[0];
}

/* Coordinate of the lower border of column i along the first (d = 0) or second index. */
static inline double ts_voxel_border(const struct ts_voxel_field *f, int d, int64_t i)
{
	return f->origin[d] + (double)i * f->width[d];
}

/* Brings i into 0 .. n[d] - 1 along a periodic axis. */
static inline int64_t ts_voxel_wrap(const struct ts_voxel_field *f, int d, int64_t i)
{
	if (i >= 0 && i < f->n[d]) /* divisions of integers are slow */
		return i;
	return (i % f->n[d] + f->n[d]) % f->n[d];
}

/* The periodic image in which column i is: 0 for 0 .. n[d] - 1, 1 for n[d] .. 2 n[d] - 1. */
static inline int64_t ts_voxel_image(const struct ts_voxel_field *f, int d, int64_t i)
{
	return i >= 0 && i < f->n[d] ? 0 : (i - ts_voxel_wrap(f, d, i)) / f->n[d];
}

/* Height of column i, j; -INFINITY: it is empty, or outside of the field. */
static inline double ts_voxel_top(const struct ts_voxel_field *f, int64_t i, int64_t j)
{
	double height;

	if (i < 0 || i >= f->n[0]) {
		if (!f->periodic[0])
			return -INFINITY;
		i = ts_voxel_wrap(f, 0, i);
	}
	if (j < 0 || j >= f->n[1]) {
		if (!f->periodic[1])
			return -INFINITY;
		j = ts_voxel_wrap(f, 1, j);
	}
	height = ts_voxel_heights(f)[j * f->n[0] + i];
	return height > f->base ? height : -INFINITY;
}

/* Index of the column whose half-open interval [x_i, x_i+1) contains the coordinate x. */
int64_t ts_voxel_index(const struct ts_voxel_field *f, int d, double x);

#endif
