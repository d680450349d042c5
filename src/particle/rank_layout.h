/* What each of N ranks would have and send if the present particles were divided among them, without running on N ranks:
 * exact for the present positions. doc/scaling.md. */
#ifndef TS_PARTICLE_RANK_LAYOUT_H
#define TS_PARTICLE_RANK_LAYOUT_H

#include "core/sim.h"
#include "rank/blocks.h"

/* The numbers of one rank. */
struct ts_rank_part {
	size_t particles;
	size_t copies;	 /* of particles of other ranks, that it has */
	size_t sent;	 /* copies of its particles, that others have */
	size_t partners; /* ranks that these are on: messages of a step */
};

struct ts_rank_layout {
	int ranks;
	struct ts_rank_blocks blocks;
	struct ts_rank_part *part; /* by rank */
	int32_t *owner;		   /* [particles]: the rank of each */
};

/* cutoff: distance from a block up to which its rank has copies [length]. Released by ts_rank_layout_release, also
 * after an error. */
enum ts_status ts_rank_layout_make(struct tsim *sim, int ranks, double cutoff, struct ts_rank_layout *layout);
void ts_rank_layout_release(struct ts_rank_layout *layout);

#endif
