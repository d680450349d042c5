/* Several blocks of one group in lockstep, with the same results as one after the other: one attempt of a granule of each
 * block at a time, in vector instructions. Twice as fast, as no branch depends on what is in the cells. */
#ifndef TS_AUTOMATON_LANES_H
#define TS_AUTOMATON_LANES_H

#include "automaton/draws.h"
#include "automaton/granule_lattice.h"

enum { TS_LANES = 16 };

struct ts_lanes {
	const uint32_t *
		mover; /* cells of granules that are to move: lane k begins at `first`, and takes them from the end */
	int32_t first[TS_LANES];
	int32_t left[TS_LANES]; /* how many; 0: the lane is not used */
	struct ts_draws_stream draws[TS_LANES];
};

/* Whether there are lanes for these options; if not, blocks are updated one after the other. */
bool ts_lanes_suit(const struct ts_laws *laws);
void ts_lanes_update(struct ts_automaton_lattice *l, const struct ts_laws *laws, const struct ts_lanes *lanes,
		     struct ts_automaton_count *count);

#endif
