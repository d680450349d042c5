/* Mean and standard error of correlated samples by block averages (Flyvbjerg, Petersen, J. Chem. Phys. 91 (1989)
 * 461), in bounded memory: when the number of blocks has grown to `most`, pairs of them are joined. */
#ifndef TS_AVERAGE_BLOCK_ERROR_H
#define TS_AVERAGE_BLOCK_ERROR_H

#include "core/sim.h"

/* Zero-initialise, set `most`; ts_blocks_release when done. Arrays are of n numbers averaged side by side. */
struct ts_blocks {
	int64_t most;	/* largest number of blocks, even */
	int64_t size;	/* samples of a block; 0: no sample yet */
	int64_t filled; /* complete blocks, fewer than most */
	int64_t inside; /* samples in the open block */
	size_t n;
	/* Sums are of the differences from the first sample: of a constant they are exactly 0. */
	double *first; /* [n] */
	double *sum;   /* [most][n] of the complete blocks, then of the open one */
	size_t first_n, sum_n, first_capacity, sum_capacity;
};

/* Allocates the arrays of n numbers, before any sample. */
enum ts_status ts_blocks_resize(struct ts_blocks *blocks, size_t n);
/* Adds a sample of n numbers, the same n in each call. Returns TS_NOMEM without memory. */
enum ts_status ts_blocks_add(struct ts_blocks *blocks, const double *sample, size_t n);
int64_t ts_blocks_samples(const struct ts_blocks *blocks);

/* Mean of number k over all samples; its standard error from the complete blocks (NaN if fewer than 2); the
 * difference of the means of their second and first half over its standard error, and the correlation
 * coefficient of successive blocks (both NaN if fewer than 4 blocks; 0 if all are equal). */
enum { TS_BLOCKS_COLUMNS = 4 };
void ts_blocks_result(const struct ts_blocks *blocks, size_t k, double out[TS_BLOCKS_COLUMNS]);

/* Saves the arrays; size, filled and inside are saved rows of the style. */
enum ts_status ts_blocks_archive(struct ts_archive *archive, struct ts_blocks *blocks);
/* Whether the numbers of a restart file fit each other. */
bool ts_blocks_valid(const struct ts_blocks *blocks);
void ts_blocks_release(struct ts_blocks *blocks);

#endif
