/* The blocks of space of ranks whose particles are divided: chosen, and cut by the places of the particles. What other folders
 * need of them is in particle/division.h. */
#ifndef TS_PARTICLE_DIVISION_BLOCKS_H
#define TS_PARTICLE_DIVISION_BLOCKS_H

#include "particle/division.h"

/* Where particles are, and the box. */
struct ts_placed {
	double (*x)[3];
	const int32_t *tag; /* NULL: their numbers instead */
	size_t n;
	const double *lo, *hi;
};
/* At the last rebuild of the contact list; now. */
struct ts_placed ts_placed_before(const struct tsim *sim);
struct ts_placed ts_placed_now(const struct tsim *sim);

/* Makes the division, if there is none yet. */
enum ts_status ts_division_new(struct tsim *sim);
/* Whether the present blocks are those of the script's grid; their outer faces become those of the box. */
bool ts_division_blocks_fit(const struct tsim *sim, struct ts_division *d, const double lo[3],
			    const double hi[3]);
/* Blocks with about the same number of the particles; while these are divided, of those of all ranks. */
enum ts_status ts_division_cut_space(struct tsim *sim, int ranks, struct ts_placed placed,
				     struct ts_rank_blocks *blocks);
/* owner[i]: the rank of each particle, of which all ranks have the same; blocks that are uneven are cut again. */
enum ts_status ts_division_choose_blocks(struct tsim *sim, struct ts_division *d,
					 const struct ts_placed *placed, int32_t *owner);
/* While the particles are divided: new blocks, to which they move in this rebuild. */
enum ts_status ts_division_cut_again(struct tsim *sim, struct ts_division *d);
/* Whether this rank, or another one, has so many more particles than when the blocks were cut that they should be cut again;
 * counts the least and the most. */
bool ts_division_is_uneven(struct tsim *sim, struct ts_division *d);
/* The same for n, the particles of the rank that has most, in any rebuild. */
bool ts_division_is_very_uneven(const struct ts_division *d, double n);

#endif
