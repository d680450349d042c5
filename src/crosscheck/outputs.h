/* Which output files of the two runs belong together. */
#ifndef TS_CROSSCHECK_OUTPUTS_H
#define TS_CROSSCHECK_OUTPUTS_H

#include "crosscheck/compare.h"
#include "crosscheck/folder.h"

/* Output files with the same names in both folders are paired; files whose names differ in a number (steps)
 * are one output. */
struct ts_outputs {
	struct ts_listing listing[TS_NPROGRAMS];
	struct ts_pairing *pairing;
	size_t n, capacity;
	const char **only[TS_NPROGRAMS];  /* files in only one of them */
	const char **skipped;		  /* in both, but not plain text */
	const char **empty[TS_NPROGRAMS]; /* in both, but empty in that one */
	size_t nonly[TS_NPROGRAMS], nskipped, only_capacity[TS_NPROGRAMS], skipped_capacity;
	size_t nempty[TS_NPROGRAMS], empty_capacity[TS_NPROGRAMS];
	struct ts_arena arena;
};
enum ts_status ts_outputs_pair(struct ts_outputs *o, const char *const folder[TS_NPROGRAMS],
			       struct ts_error *err, struct ts_pool *pool);
void ts_outputs_release(struct ts_outputs *o);

#endif
