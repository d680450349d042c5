/* One rank of a communicator without any other: what it would send is counted (world->counts), and goes nowhere; what it
 * would receive is not written. For -explain, which tells what ranks send without starting them. */
#ifndef TS_RANK_REHEARSAL_H
#define TS_RANK_REHEARSAL_H

#include "rank/world.h"

/* Makes *world rank `rank` of so many. Owns nothing. */
void ts_rehearsal_make(struct ts_world *world, int rank, int ranks);

#endif
