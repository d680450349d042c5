#include "rank/rehearsal.h"

#include <string.h>

#include "base/banned.h"

static void most(struct ts_world *world, double *value, size_t n)
{
	(void)world;
	(void)value;
	(void)n;
}

static void spread(struct ts_world *world, int from, void *bytes, size_t n)
{
	(void)world;
	(void)from;
	(void)bytes;
	(void)n;
}

static void sizes(struct ts_world *world, uint64_t n, uint64_t *size)
{
	for (int r = 0; r < world->n; r++)
		size[r] = r == world->rank ? n : 0;
}

static enum ts_status collect(struct ts_world *world, const void *mine, const uint64_t *size,
			      unsigned char *all)
{
	(void)mine;
	for (int r = 0; r < world->n; all += size[r++])
		memset(all, 0, size[r]);
	return TS_OK;
}

static void sum(struct ts_world *world, int64_t *number, size_t n)
{
	(void)world;
	(void)number;
	(void)n;
}

static enum ts_status deliver(struct ts_world *world, const struct ts_parcel *out, struct ts_parcel *in)
{
	(void)world;
	(void)out;
	(void)in;
	return TS_OK;
}

static void swap(struct ts_world *world, const struct ts_parcel *out, struct ts_parcel *in)
{
	(void)world;
	(void)out;
	(void)in;
}

static void fail(struct ts_world *world, const char *message)
{
	(void)world;
	(void)message;
}

void ts_rehearsal_make(struct ts_world *world, int rank, int ranks)
{
	static const struct ts_world_functions functions = { .most = most,
							     .spread = spread,
							     .sizes = sizes,
							     .collect = collect,
							     .sum = sum,
							     .deliver = deliver,
							     .swap = swap,
							     .fail = fail };

	*world = (struct ts_world){ .rank = rank, .n = ranks, .call = &functions };
}
