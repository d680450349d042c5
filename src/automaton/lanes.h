/* Several blocks of one group in lockstep, with the same results as one after the other: one attempt of a granule of each
 * block at a time, in vector instructions. Twice as fast, as no branch depends on what is in the cells. */
#ifndef TS_AUTOMATON_LANES_H
#define TS_AUTOMATON_LANES_H

#include "automaton/draws.h"
#include "automaton/granule_lattice.h"

enum { TS_LANES = 16 };

/* A block, in a lane. */
struct ts_lane {
	uint32_t *mover; /* cells of granules that are to move, which are taken from the end */
	int32_t left;	 /* how many */
	struct ts_draws_stream draws;
};

struct ts_lanes {
	uint32_t *mover; /* [TS_LANES][most] room for the lists of the lanes */
	size_t most;
	/* Sets the next block; false: there is none. A lane whose block is complete takes the next one. */
	bool (*next)(void *context, struct ts_lane *lane);
	void *context;
};

/* Whether there are lanes for these options and this processor (with AVX2, as without gather instructions they are slower); if
 * not, blocks are updated one after the other. */
bool ts_lanes_suit(const struct ts_laws *laws);
void ts_lanes_update(struct ts_automaton_lattice *l, const struct ts_laws *laws, const struct ts_lanes *lanes,
		     struct ts_automaton_count *count);

#endif
