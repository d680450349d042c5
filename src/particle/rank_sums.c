#include "particle/rank_sums.h"

#include "base/banned.h"

enum ts_status ts_rank_sums(struct tsim *sim, struct ts_exactsum *sum, size_t n)
{
	size_t bytes = n * sizeof *sum;
	struct ts_parcel mine = { .data = (unsigned char *)sum, .n = bytes }, all = { 0 };

	if (!sim->division)
		return TS_OK;
	if (ts_world_share(sim->world, &mine, &all) != TS_OK) {
		ts_parcel_release(&all);
		return ts_nomem(&sim->error);
	}
	for (size_t k = 0; k < n; k++)
		sum[k] = ts_exactsum_start();
	for (size_t r = 0; r < (size_t)sim->world->n; r++) {
		const struct ts_exactsum *of = (const void *)(all.data + r * bytes);

		for (size_t k = 0; k < n; k++)
			ts_exactsum_merge(&sum[k], &of[k]);
	}
	ts_parcel_release(&all);
	return TS_OK;
}
