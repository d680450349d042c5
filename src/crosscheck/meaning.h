/* Information on columns of outputs from the commands of the script: which belong to contacts, whose numbers
 * depend on the order of the two partners, and which differ from those of the other program on purpose. */
#ifndef TS_CROSSCHECK_MEANING_H
#define TS_CROSSCHECK_MEANING_H

#include "base/map.h"
#include "base/words.h"
#include "crosscheck/frame.h"

/* Zero-initialise but for err and pool. */
struct ts_meanings {
	struct ts_error *err;
	struct ts_pool *pool;
	struct ts_map contacts; /* ID of a compute pair/gran/local -> its columns */
	struct ts_map differs;	/* "c_ID", "v_NAME" that differ on purpose */
	struct ts_map titles;	/* titles of thermo output, truncated, -> "c_ID" */
	struct ts_arena arena;
};

/* Evaluates a command of the script. */
enum ts_status ts_meanings_read_command(struct ts_meanings *m, const char *const *word, size_t n);
/* Whether a column differs on purpose; see the manual page of the command legacy. */
bool ts_meanings_differ(const struct ts_meanings *m, enum ts_frame_kind kind, const char *column);
/* Exchanges the partners in rows of contacts so that the one with the smaller identity is first. */
enum ts_status ts_meanings_order_partners(const struct ts_meanings *m, struct ts_frame *frame);
void ts_meanings_release(struct ts_meanings *m);

#endif
