/* A run in pieces: an outside program steps the simulation and reads it in between. All pieces together
 * are one run, bit for bit and in what is written, as long as nothing changes that forces depend on; after
 * a change the next piece begins a new run, which computes forces anew. */
#ifndef TS_CORE_STEPPING_H
#define TS_CORE_STEPPING_H

#include "core/plan.h"

struct ts_stepping {
	bool open;    /* a run has begun and not ended */
	bool watched; /* `fingerprint` is valid: the state may have been changed since the last piece */
	bool always;  /* take the fingerprint after each piece, since the program has pointers to columns */
	uint64_t fingerprint;
	struct ts_plan plan;
};

/* Makes n steps; TS_STOPPED if a stop was requested. */
enum ts_status ts_stepping_advance(struct ts_stepping *stepping, struct tsim *sim, int64_t n);
/* To be called before the state is changed between pieces. */
enum ts_status ts_stepping_watch(struct ts_stepping *stepping, struct tsim *sim);
/* Ends the run, as before a script line. */
enum ts_status ts_stepping_end(struct ts_stepping *stepping, struct tsim *sim);

#endif
