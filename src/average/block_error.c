#include "average/block_error.h"

#include <math.h>
#include <string.h>

#include "base/banned.h"

enum ts_status ts_blocks_resize(struct ts_blocks *b, size_t n)
{
	size_t numbers = (size_t)b->most * n;

	if (TS_GROW(b->first, b->first_capacity, n) != TS_OK ||
	    TS_GROW(b->sum, b->sum_capacity, numbers) != TS_OK)
		return TS_NOMEM;
	b->n = b->first_n = n;
	b->sum_n = numbers;
	for (size_t k = 0; k < n; k++)
		b->first[k] = 0;
	for (size_t k = 0; k < numbers; k++)
		b->sum[k] = 0;
	return TS_OK;
}

/* Joins pairs of blocks: half as many, twice as long. */
static void join_pairs(struct ts_blocks *b)
{
	for (size_t k = 0; k < b->sum_n; k++) {
		size_t block = k / b->n, number = k % b->n;
		const double *pair = b->sum + 2 * block * b->n + number;

		b->sum[k] = 2 * block < (size_t)b->most ? pair[0] + pair[b->n] : 0;
	}
	b->filled /= 2;
	b->size *= 2;
}

enum ts_status ts_blocks_add(struct ts_blocks *b, const double *sample, size_t n)
{
	if (!b->size) {
		TS_TRY(ts_blocks_resize(b, n));
		b->size = 1;
		for (size_t k = 0; k < n; k++)
			b->first[k] = sample[k];
	}
	for (size_t k = 0; k < n; k++)
		b->sum[(size_t)b->filled * n + k] += sample[k] - b->first[k];
	if (++b->inside < b->size)
		return TS_OK;
	b->inside = 0;
	if (++b->filled == b->most)
		join_pairs(b);
	return TS_OK;
}

int64_t ts_blocks_samples(const struct ts_blocks *b)
{
	return b->filled * b->size + b->inside;
}

/* Mean of the blocks from .. to-1 of number k, relative to its first sample, and the sum of their squared
 * deviations. */
static double mean_of_blocks(const struct ts_blocks *b, size_t k, int64_t from, int64_t to, double *squares)
{
	double mean = 0;

	for (int64_t j = from; j < to; j++)
		mean += b->sum[(size_t)j * b->n + k] / (double)b->size;
	mean /= (double)(to - from);
	*squares = 0;
	for (int64_t j = from; j < to; j++) {
		double d = b->sum[(size_t)j * b->n + k] / (double)b->size - mean;

		*squares += d * d;
	}
	return mean;
}

static double trend(const struct ts_blocks *b, size_t k)
{
	int64_t half = b->filled / 2;
	double early, late, difference, error2;

	difference = -mean_of_blocks(b, k, 0, half, &early);
	difference += mean_of_blocks(b, k, b->filled - half, b->filled, &late);
	error2 = (early + late) / (double)(half * (half - 1));
	return difference != 0 ? difference / sqrt(error2) : 0;
}

static double correlation(const struct ts_blocks *b, size_t k)
{
	double squares, products = 0, mean = mean_of_blocks(b, k, 0, b->filled, &squares), before = 0;

	for (int64_t j = 0; j < b->filled; j++) {
		double d = b->sum[(size_t)j * b->n + k] / (double)b->size - mean;

		products += before * d;
		before = d;
	}
	return squares > 0 ? products / squares : 0;
}

void ts_blocks_result(const struct ts_blocks *b, size_t k, double out[TS_BLOCKS_COLUMNS])
{
	double sum = 0, squares;

	for (int j = 0; j < TS_BLOCKS_COLUMNS; j++)
		out[j] = NAN;
	if (!ts_blocks_samples(b))
		return;
	for (int64_t j = 0; j <= b->filled && j < b->most; j++)
		sum += b->sum[(size_t)j * b->n + k];
	out[0] = b->first[k] + sum / (double)ts_blocks_samples(b);
	if (b->filled >= 2) {
		mean_of_blocks(b, k, 0, b->filled, &squares);
		out[1] = sqrt(squares / (double)(b->filled * (b->filled - 1)));
	}
	if (b->filled >= 4) {
		out[2] = trend(b, k);
		out[3] = correlation(b, k);
	}
}

enum ts_status ts_blocks_archive(struct ts_archive *archive, struct ts_blocks *b)
{
	TS_TRY(ts_archive_array(archive, "first", TS_SAVED_F64, (void **)&b->first, &b->first_capacity,
				&b->first_n));
	TS_TRY(ts_archive_array(archive, "sum", TS_SAVED_F64, (void **)&b->sum, &b->sum_capacity, &b->sum_n));
	b->n = b->first_n;
	return TS_OK;
}

bool ts_blocks_valid(const struct ts_blocks *b)
{
	if (b->sum_n != b->n * (size_t)b->most)
		return false;
	if (b->size == 0)
		return b->filled == 0 && b->inside == 0;
	return b->size > 0 && b->filled >= 0 && b->filled < b->most && b->inside >= 0 && b->inside < b->size;
}

void ts_blocks_release(struct ts_blocks *b)
{
	ts_free(b->first);
	ts_free(b->sum);
}
