/* Gaussian random surfaces: heights with normal distribution and the covariance
 *
 *   <(h(x) - m)(h(x + r) - m)> = s^2 exp(-(r_x/l_x)^2 - (r_y/l_y)^2),
 *
 * l being the correlation lengths, at which it has fallen to 1/e (N. Garcia, E. Stoll, Phys. Rev. Lett. 52 (1984)
 * 1798), summed over all periodic images, as the surface is periodic in x and y. White noise is filtered in Fourier space by the square root of the spectrum. */
#ifndef TS_VOXEL_VOXEL_GAUSSIAN_H
#define TS_VOXEL_VOXEL_GAUSSIAN_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "base/status.h"
#include "voxel/voxel_noise.h"

struct ts_voxel_gaussian {
	int64_t n[2];
	double width[2];	/* of the columns, length */
	double mean, deviation; /* length */
	double correlation[2];	/* length; 0: heights of neighbours are independent */
	uint64_t seed;
	enum ts_voxel_noise_kind noise;
	bool exact; /* the sample is shifted and scaled to have mean and deviation exactly */
};

/* height: [n[1]][n[0]]. Returns TS_OK or TS_NOMEM. */
enum ts_status ts_voxel_gaussian(const struct ts_voxel_gaussian *g, double *height);
/* Filters noise of variance 1 in place, so that its covariance is that of the surface with deviation 1. */
enum ts_status ts_voxel_gaussian_filter(const struct ts_voxel_gaussian *g, double *noise);
/* Shifts and scales n numbers, not all equal, to mean 0 and standard deviation 1. */
void ts_voxel_normalise(double *value, size_t n);

#endif
