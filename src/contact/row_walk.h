/* Something is computed of all near rows, into their slots, and summed over the particles: forces, and what else is
 * wanted of the same rows while these are near in the caches. */
#ifndef TS_CONTACT_ROW_WALK_H
#define TS_CONTACT_ROW_WALK_H

#include "base/parallel.h"
#include "neigh/rows.h"

struct ts_row_walk {
	ts_share_fn *rows; /* of the blocks from .. to-1 */
	ts_share_fn *sums; /* of the particles from .. to-1, whose rows are all done */
	void *context;	   /* of both; the threads share it */
	bool all;	   /* sums also of particles without near rows */
};

/* One that follows the forces of a step, if there are rows: it finds in each block those that touch at its front. */
struct ts_row_follower {
	struct ts_row_walk walk;
	enum ts_status (*start)(struct tsim *sim, void *context); /* slots have been given */
	bool begun; /* in this step */
};

/* In PRE_FORCE; one may. */
void ts_rows_follow(struct tsim *sim, struct ts_row_follower *follower);

/* Goes over the rows of the simulation for the forces. */
enum ts_status ts_rows_walk(struct tsim *sim, const struct ts_row_walk *forces);

#endif
