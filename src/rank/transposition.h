/* Transposition of a field that ranks have in slabs: each gets columns of its own in all planes, works along them, and gives them
 * back. */
#ifndef TS_RANK_TRANSPOSITION_H
#define TS_RANK_TRANSPOSITION_H

#include "rank/slabs.h"

struct ts_transposition {
	struct ts_slabs *slabs;
	struct ts_slabs_field field; /* without planes before plane 0 */
	size_t layers, apart;	     /* so many fields, `apart` values from one to the next; 0: one */
	/* Another field, which has the columns of this rank alone; NULL: they stay where they are. */
	double *turned;
	size_t turned_stride, turned_apart;
	/* The columns from[0] .. from[1] - 1 are those of this rank. */
	void (*columns)(const void *of, int rank, size_t from[2]);
	const void *of;
};

/* Room for what goes to each rank and comes from it, both ways; while the slabs are active. */
enum ts_status ts_transposition_room(const struct ts_transposition *t);
/* All ranks call it. Each gets its columns of all planes; `back`: all columns of its planes. */
void ts_transpose(const struct ts_transposition *t, bool back);

#endif
