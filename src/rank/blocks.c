#include "rank/blocks.h"

#include <math.h>

#include "base/alloc.h"

#include "base/banned.h"

bool ts_rank_blocks_choose(int n, const int given[3], const double length[3], int dimension, int out[3])
{
	double best = INFINITY;

	for (int a = 1; a <= n; a++) {
		for (int b = 1; n % a == 0 && b <= n / a; b++) {
			int count[3] = { a, b, n / a / b };
			double area = (a - 1) * length[1] * length[2] + (b - 1) * length[0] * length[2] +
				      (count[2] - 1) * length[0] * length[1];
			bool fits = n / a % b == 0 && (dimension == 3 || count[2] == 1);

			for (int d = 0; d < 3; d++)
				fits &= (!given[d] || given[d] == count[d]) && count[d] <= TS_BLOCKS_MOST;
			if (!fits || !(area < best))
				continue;
			best = area;
			for (int d = 0; d < 3; d++)
				out[d] = count[d];
		}
	}
	return best < INFINITY;
}

bool ts_rank_blocks_cut(struct ts_rank_blocks *blocks, const int count[3], const double lo[3],
			const double hi[3], const bool periodic[3])
{
	for (int d = 0; d < 3; d++) {
		if (!blocks->cut[d] || blocks->count[d] != count[d]) {
			ts_free(blocks->cut[d]);
			blocks->cut[d] = ts_alloc((size_t)count[d] + 1, sizeof *blocks->cut[d]);
		}
		if (!blocks->cut[d])
			return false;
		blocks->count[d] = count[d];
		blocks->length[d] = hi[d] - lo[d];
		blocks->periodic[d] = periodic[d];
		for (int k = 0; k < count[d]; k++)
			blocks->cut[d][k] = lo[d] + (hi[d] - lo[d]) * k / count[d];
		blocks->cut[d][count[d]] = hi[d];
	}
	return true;
}

void ts_rank_blocks_release(struct ts_rank_blocks *blocks)
{
	for (int d = 0; d < 3; d++)
		ts_free(blocks->cut[d]);
	*blocks = (struct ts_rank_blocks){ 0 };
}

/* The last block whose lower face is not above x: compared with the same numbers by all ranks, so that a point on a
 * cut belongs to exactly one. */
static int block_along(const struct ts_rank_blocks *blocks, int d, double x)
{
	int lo = 0, hi = blocks->count[d];

	while (hi - lo > 1) {
		int middle = lo + (hi - lo) / 2;

		if (x >= blocks->cut[d][middle])
			lo = middle;
		else
			hi = middle;
	}
	return lo;
}

int ts_rank_blocks_owner(const struct ts_rank_blocks *blocks, const double x[3])
{
	int k[3];

	for (int d = 0; d < 3; d++)
		k[d] = block_along(blocks, d, x[d]);
	return k[0] + blocks->count[0] * (k[1] + blocks->count[1] * k[2]);
}

bool ts_rank_blocks_near(const struct ts_rank_blocks *blocks, int rank, int d, double x, double reach)
{
	const int *n = blocks->count;
	int k = d == 0 ? rank % n[0] : d == 1 ? rank / n[0] % n[1] : rank / n[0] / n[1];
	bool open[2] = { k == 0 && !blocks->periodic[d], k == n[d] - 1 && !blocks->periodic[d] };

	return (open[0] || x >= blocks->cut[d][k] - reach) && (open[1] || x <= blocks->cut[d][k + 1] + reach);
}

bool ts_rank_blocks_reach(const struct ts_rank_blocks *blocks, int rank, const double x[3], double reach)
{
	for (int d = 0; d < 3; d++) {
		bool near = ts_rank_blocks_near(blocks, rank, d, x[d], reach);

		for (int turn = -1; blocks->periodic[d] && !near && turn <= 1; turn += 2)
			near = ts_rank_blocks_near(blocks, rank, d, x[d] + turn * blocks->length[d], reach);
		if (!near)
			return false;
	}
	return true;
}
