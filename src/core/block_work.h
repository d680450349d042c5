/* Conversion of a large array to what a file contains, block by block, by all threads and ranks: compression, text of numbers. */
#ifndef TS_CORE_BLOCK_WORK_H
#define TS_CORE_BLOCK_WORK_H

#include "core/sim.h"

struct ts_block_work {
	/* Adds what becomes of a block of n bytes. Called by several threads at the same time, and by all ranks. */
	void (*convert)(const void *context, const void *block, size_t n, struct ts_str *out);
	const void *context;
	size_t block; /* bytes of a block, but of the last one */
	size_t sent;  /* blocks that a rank converts at once, at most */
};

static inline size_t ts_block_work_blocks(const struct ts_block_work *w, size_t n)
{
	return (n + w->block - 1) / w->block;
}

/* Adds all blocks of n bytes, in their order, to `out`; length[k]: bytes of block k. All ranks call it with the same n: the data
 * are those of the first one, which gets all; the others get nothing. */
enum ts_status ts_block_work(struct tsim *sim, const struct ts_block_work *w, const void *data, size_t n,
			     struct ts_str *out, uint64_t *length);

#endif
