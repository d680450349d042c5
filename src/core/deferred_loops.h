/* Short loops over the particles, deferred and fused.
 *
 * Gravity, integrators and the rebuild check do little arithmetic on long columns; their cost is memory
 * traffic. Such a loop is deferred until something may read what it writes, across the end of a step, too.
 * All deferred loops are then executed together, in their order, on one small block of particles after the
 * other, so that each column is read from memory once.
 *
 * The plan executes them before each hook, but not before hooks that defer loops themselves (`defers` in
 * struct ts_style): these call ts_deferred_loops_run before they read columns of particles. */
#ifndef TS_CORE_DEFERRED_LOOPS_H
#define TS_CORE_DEFERRED_LOOPS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "base/parallel.h"

struct tsim;

enum { TS_MAX_DEFERRED = 8, TS_DEFERRED_CONTEXT = 16 /* doubles */ };
struct ts_deferred_loops {
	struct ts_deferred_loop {
		ts_range_fn *body;
		double context[TS_DEFERRED_CONTEXT];
	} loop[TS_MAX_DEFERRED];
	size_t n;	/* deferred loops */
	size_t rounds;	/* iterations of each */
	bool alone;	/* the last one is not fused with others */
	uint64_t spent; /* time spent in them since the plan read it last, ticks of ts_ticks() */
};

/* Defers body(context, from, to) for the iterations 0 .. rounds-1. The context is copied; what it points
 * to must remain valid. */
#define TS_DEFER_LOOP(sim, rounds, body, context)                                         \
	do {                                                                              \
		_Static_assert(sizeof *(context) <= TS_DEFERRED_CONTEXT * sizeof(double), \
			       "room for a context");                                     \
		ts_defer_loop(sim, rounds, body, context, sizeof *(context));             \
	} while (0)
void ts_defer_loop(struct tsim *sim, size_t rounds, ts_range_fn *body, const void *context, size_t size);

/* A loop whose iterations are not particles: it is deferred, but not fused with others. */
void ts_defer_loop_alone(struct tsim *sim, size_t rounds, ts_range_fn *body, const void *context,
			 size_t size);

/* If this loop is the only deferred one, it is no longer deferred, and the caller executes it. */
bool ts_deferred_loop_take(struct tsim *sim, ts_range_fn *body);

/* Executes the deferred loops; does nothing if there are none. */
void ts_deferred_loops_run(struct tsim *sim);

#endif
