#include "particle/rank_sums.h"

#include "base/banned.h"

void ts_rank_sums_merge(const struct tsim *sim, struct ts_exactsum *part, size_t width)
{
	int64_t integer[TS_RANK_SUMS_MOST][TS_EXACTSUM_INTEGERS];

	if (!sim->division)
		return;
	for (size_t k = 0; k < width; k++)
		ts_exactsum_pack(&part[k], integer[k]);
	ts_world_sums(sim->world, integer[0], width * TS_EXACTSUM_INTEGERS);
	for (size_t k = 0; k < width; k++)
		part[k] = ts_exactsum_unpack(integer[k]);
}

enum ts_status ts_rank_sums(struct tsim *sim, const double *data, size_t n, size_t stride, size_t width,
			    double *sum)
{
	struct ts_exactsum part[TS_RANK_SUMS_MOST];

	for (size_t k = 0; k < width; k++) {
		part[k] = ts_exactsum_start();
		for (size_t i = 0; i < n; i++)
			ts_exactsum_add(&part[k], data[stride * i + k]);
	}
	ts_rank_sums_merge(sim, part, width);
	for (size_t k = 0; k < width; k++)
		sum[k] = ts_exactsum_value(&part[k]);
	return TS_OK;
}

void ts_rank_sums_count(const struct tsim *sim, int64_t *number)
{
	if (sim->division)
		ts_world_sum(sim->world, number);
}
