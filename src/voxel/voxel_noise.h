/* White noise on a grid of columns, of variance 1, for random surfaces:
 *   columns   a normal number for each column, a function of seed and index of the column
 *   waves     a normal amplitude and phase for each wave that is periodic in the field, a function of the seed and the
 *             wave numbers: filtered by one spectrum it is the same surface on any grid that resolves the spectrum,
 *             sampled at the centres of the columns (but for waves of two columns, whose phase no grid can show) */
#ifndef TS_VOXEL_VOXEL_NOISE_H
#define TS_VOXEL_VOXEL_NOISE_H

#include <stdint.h>

#include "base/status.h"

enum ts_voxel_noise_kind { TS_VOXEL_NOISE_COLUMNS, TS_VOXEL_NOISE_WAVES };

/* noise: [n[1]][n[0]]. Returns TS_OK or TS_NOMEM. */
enum ts_status ts_voxel_noise(enum ts_voxel_noise_kind kind, uint64_t seed, const int n[2], double *noise);

#endif
