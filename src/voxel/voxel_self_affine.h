/* Self-affine random surfaces: heights with normal distribution and the isotropic power spectrum
 *
 *   C(q) = constant                   q_long <= q < q_roll
 *        ~ (q/q_roll)^(-2 - 2 H)      q_roll <= q <= q_short
 *        = 0                          else,          q = 2 pi/wavelength,
 *
 * H being the Hurst exponent (B. N. J. Persson et al, J. Phys.: Condens. Matter 17 (2005) R1). White noise is filtered in Fourier space by the square root of the spectrum; the surface is periodic. */
#ifndef TS_VOXEL_VOXEL_SELF_AFFINE_H
#define TS_VOXEL_VOXEL_SELF_AFFINE_H

#include <stdbool.h>
#include <stdint.h>

#include "base/status.h"
#include "voxel/voxel_noise.h"

struct ts_voxel_self_affine {
	int n[2];
	double width[2];		/* of the columns, length */
	double mean, deviation;		/* length */
	double hurst;			/* 0 < H <= 1 */
	double longest, roll, shortest; /* wavelengths, length: longest >= roll >= shortest */
	uint64_t seed;
	enum ts_voxel_noise_kind noise;
	bool exact; /* the sample is shifted and scaled to have mean and deviation exactly */
};

/* height: [n[1]][n[0]]. Returns TS_OK, TS_NOMEM, or TS_RANGE: the grid has no wave within the spectrum. */
enum ts_status ts_voxel_self_affine(const struct ts_voxel_self_affine *s, double *height);

#endif
