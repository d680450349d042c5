/* Passes over the particles that wait for each other.
 *
 * Gravity, integrators and checks do little with long columns: what they cost is bringing these from memory. So a
 * pass may wait until somebody may look at what it changes, over the end of a step, too. Those that wait are then done
 * together, in their order, some particles at a time, which stay in the caches meanwhile.
 *
 * The plan does them before each hook, but for hooks that say they wait (`waits` in struct ts_style): these add
 * passes, or call ts_sweep before they look at particles. */
#ifndef TS_CORE_SWEEP_H
#define TS_CORE_SWEEP_H

#include <stddef.h>
#include <stdint.h>

#include "base/parallel.h"

struct tsim;

enum { TS_SWEEP_PASSES = 8, TS_SWEEP_CONTEXT = 16 };
struct ts_sweep {
	struct ts_pass {
		ts_share_fn *share;
		double context[TS_SWEEP_CONTEXT];
	} pass[TS_SWEEP_PASSES];
	size_t n;	/* that wait */
	size_t rounds;	/* of each of them */
	uint64_t spent; /* ticks, since the plan looked last */
};

/* A pass over 0 .. rounds-1 with a copy of the context: what that points to must stay. */
#define TS_SWEEP_ADD(sim, rounds, share, context)                                                            \
	do {                                                                                                 \
		_Static_assert(sizeof *(context) <= TS_SWEEP_CONTEXT * sizeof(double), "room for a context"); \
		ts_sweep_add(sim, rounds, share, context, sizeof *(context));                                \
	} while (0)
void ts_sweep_add(struct tsim *sim, size_t rounds, ts_share_fn *share, const void *context, size_t size);

/* Does all that wait. */
void ts_sweep(struct tsim *sim);

#endif
