#include "core/sweep.h"

#include <string.h>

#include "base/clock.h"
#include "core/sim.h"

#include "base/banned.h"

/* Particles at a time: their columns fit into the cache nearest to a core, with room for what is sent for. */
enum { SOME = 32 };

static void share(void *context, size_t from, size_t to)
{
	struct ts_sweep *sweep = context;

	for (; from < to; from += SOME) {
		size_t end = to - from < SOME ? to : from + SOME;

		for (size_t k = 0; k < sweep->n; k++)
			sweep->pass[k].share(sweep->pass[k].context, from, end);
	}
}

void ts_sweep(struct tsim *sim)
{
	struct ts_sweep *sweep = &sim->sweep;
	uint64_t begin;

	if (!sweep->n)
		return;
	begin = ts_ticks();
	ts_parallel(ts_team(sim, sweep->n * sweep->rounds), sweep->rounds, share, sweep);
	sweep->n = 0;
	sweep->spent += ts_ticks() - begin;
}

void ts_sweep_add(struct tsim *sim, size_t rounds, ts_share_fn *pass, const void *context, size_t size)
{
	struct ts_sweep *sweep = &sim->sweep;

	if (sweep->n == TS_SWEEP_PASSES || rounds != sweep->rounds)
		ts_sweep(sim);
	sweep->rounds = rounds;
	sweep->pass[sweep->n].share = pass;
	memcpy(sweep->pass[sweep->n++].context, context, size);
}
