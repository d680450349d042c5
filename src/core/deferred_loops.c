#include "core/deferred_loops.h"

#include <string.h>

#include "base/clock.h"
#include "core/sim.h"

#include "base/banned.h"

/* Particles per block: their columns fit into the first-level cache together with prefetched data. */
enum { BLOCK = 32 };

/* What an iteration costs, by one of a simple loop: of each fused loop (10 ns for four of them), and of a loop alone, as bodies
 * have members. */
enum { FUSED_COST = 3, ALONE_COST = 4 };

static void execute_fused(void *context, size_t from, size_t to)
{
	struct ts_deferred_loops *deferred = context;

	for (; from < to; from += BLOCK) {
		size_t end = to - from < BLOCK ? to : from + BLOCK;

		for (size_t k = 0; k < deferred->n; k++)
			deferred->loop[k].body(deferred->loop[k].context, from, end);
	}
}

void ts_deferred_loops_run(struct tsim *sim)
{
	struct ts_deferred_loops *deferred = &sim->deferred;
	size_t cost = deferred->alone ? ALONE_COST : FUSED_COST * deferred->n;
	uint64_t begin;

	if (!deferred->n)
		return;
	begin = ts_ticks();
	ts_parallel(ts_team(sim, cost * deferred->rounds), deferred->rounds, execute_fused, deferred);
	deferred->n = 0;
	deferred->alone = false;
	deferred->spent += ts_ticks() - begin;
}

void ts_defer_loop(struct tsim *sim, size_t rounds, ts_range_fn *body, const void *context, size_t size)
{
	struct ts_deferred_loops *deferred = &sim->deferred;

	if (deferred->n == TS_MAX_DEFERRED || rounds != deferred->rounds || deferred->alone)
		ts_deferred_loops_run(sim);
	deferred->rounds = rounds;
	deferred->loop[deferred->n].body = body;
	memcpy(deferred->loop[deferred->n++].context, context, size);
}

void ts_defer_loop_alone(struct tsim *sim, size_t rounds, ts_range_fn *body, const void *context, size_t size)
{
	ts_deferred_loops_run(sim);
	ts_defer_loop(sim, rounds, body, context, size);
	sim->deferred.alone = true;
}

bool ts_deferred_loop_take(struct tsim *sim, ts_range_fn *body)
{
	struct ts_deferred_loops *deferred = &sim->deferred;

	if (!deferred->alone || deferred->loop[0].body != body)
		return false;
	deferred->n = 0;
	deferred->alone = false;
	return true;
}
