/* Where the heights of a voxel field come from. */
#ifndef TS_VOXEL_VOXEL_SOURCE_H
#define TS_VOXEL_VOXEL_SOURCE_H

#include "core/sim.h"
#include "voxel/voxel_field.h"
#include "voxel/voxel_grid.h"

enum ts_voxel_kind {
	TS_VOXEL_CONSTANT,
	TS_VOXEL_FILE,
	TS_VOXEL_IMAGE,
	TS_VOXEL_FORMULA,
	TS_VOXEL_GAUSSIAN,
	TS_VOXEL_SELF_AFFINE
};

/* Arguments of `fix surface/voxel` */
struct ts_voxel_source {
	int kind; /* enum ts_voxel_kind */
	double height, scale;
	const char *file;
	double black, white;	  /* image: heights of black and white, length */
	struct ts_number formula; /* of the coordinates in the variables of `set`, for x, y and z */
	const char *set[3];
	double mean, deviation;	     /* random surfaces, length */
	struct ts_words correlation; /* Gaussian surface: one or two correlation lengths */
	double hurst;		     /* self-affine surface: Hurst exponent */
	/* and its wavelengths, length; NaN: twice the width of the columns, the longest, the size of the field */
	double shortest, roll, longest;
	int64_t seed;
	int noise;  /* enum ts_voxel_noise_kind */
	bool exact; /* its sample has the mean and deviation given */
};

/* Reads the file, if there is one; else grid->n is 0. */
enum ts_status ts_voxel_source_read(struct ts_instance *self, struct tsim *sim,
				    const struct ts_voxel_source *source, struct ts_voxel_grid *grid);
/* Sets the heights; those below the datum are raised to it (-INFINITY: none). Heights that are not finite are
 * errors. */
enum ts_status ts_voxel_source_fill(struct ts_instance *self, struct tsim *sim,
				    const struct ts_voxel_source *source, const struct ts_voxel_grid *grid,
				    double datum, struct ts_voxel_field *field);

#endif
