/* A run in pieces: a program outside steps the simulation and looks at it in between. All pieces
 * together are one run, bit for bit and in what is written, as long as nobody changes what forces
 * depend on; after a change the next piece begins a new run, which computes forces anew. */
#ifndef TS_CORE_STEPPING_H
#define TS_CORE_STEPPING_H

#include "core/plan.h"

struct ts_stepping {
	bool open;
	bool watched; /* at the end of the last piece the fingerprint was taken: someone can
			   * change the state without our knowledge */
	bool always;  /* watch after each piece: pointers to columns have been given away */
	uint64_t fingerprint;
	struct ts_plan plan;
};

/* Steps n times; TS_STOPPED if someone asked for it. */
enum ts_status ts_stepping_advance(struct ts_stepping *stepping, struct tsim *sim, int64_t n);
/* To be called before the state is changed between pieces. */
enum ts_status ts_stepping_watch(struct ts_stepping *stepping, struct tsim *sim);
/* Ends the run, as before a script line. */
enum ts_status ts_stepping_end(struct ts_stepping *stepping, struct tsim *sim);

#endif
