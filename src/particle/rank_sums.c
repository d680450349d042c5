#include "particle/rank_sums.h"

#include "math/exactsum.h"

#include "base/banned.h"

/* part[k] becomes the sum of those of all ranks. */
static enum ts_status merge_parts(struct tsim *sim, struct ts_exactsum *part, size_t width)
{
	size_t bytes = width * sizeof *part;
	struct ts_parcel mine = { .data = (unsigned char *)part, .n = bytes }, all = { 0 };
	enum ts_status status = ts_world_share(sim->world, &mine, &all);

	for (size_t k = 0; k < width; k++)
		part[k] = ts_exactsum_start();
	for (size_t r = 0; status == TS_OK && r < (size_t)sim->world->n; r++) {
		const struct ts_exactsum *of = (const void *)(all.data + r * bytes);

		for (size_t k = 0; k < width; k++)
			ts_exactsum_merge(&part[k], &of[k]);
	}
	ts_parcel_release(&all);
	return status == TS_OK ? TS_OK : ts_nomem(&sim->error);
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
	if (sim->division)
		TS_TRY(merge_parts(sim, part, width));
	for (size_t k = 0; k < width; k++)
		sum[k] = ts_exactsum_value(&part[k]);
	return TS_OK;
}
