/* Which output files of the two runs belong together. */
#ifndef TS_CROSSCHECK_OUTPUTS_H
#define TS_CROSSCHECK_OUTPUTS_H

#include "crosscheck/compare.h"
#include "crosscheck/folder.h"

/* outputs.c: files of both sides with the same names, those numbered in their names together. */
struct ts_outputs {
	struct ts_listing listing[TS_BOTH];
	struct ts_pairing *pairing;
	size_t n, capacity;
	const char **only[TS_BOTH], **skipped; /* in one of them; in both and not to be read as text */
	const char **empty[TS_BOTH];	       /* in both, and of that one without a word */
	size_t nonly[TS_BOTH], nskipped, only_capacity[TS_BOTH], skipped_capacity;
	size_t nempty[TS_BOTH], empty_capacity[TS_BOTH];
	struct ts_arena arena;
};
enum ts_status ts_outputs_pair(struct ts_outputs *o, const char *const folder[TS_BOTH], struct ts_error *err,
			       struct ts_pool *pool);
void ts_outputs_release(struct ts_outputs *o);

#endif
