/* Unclaimed state: state of styles read from a restart file, kept until the script defines the style
 * again. */
#ifndef TS_CORE_UNCLAIMED_STATE_H
#define TS_CORE_UNCLAIMED_STATE_H

#include "base/str.h"
#include "core/style.h"

/* Stores a copy of the block for the style of this kind, name and id. */
enum ts_status ts_unclaimed_add(struct tsim *sim, enum ts_kind kind, const char *style, const char *id,
				const char *group, const unsigned char *bytes, size_t n);
/* Restores the state of a new instance with the arguments `args` if there is state for it, and reports it
 * in the log. A fix or compute of another style or group, or with another TS_STATEFUL argument, is
 * refused. */
enum ts_status ts_unclaimed_apply(struct tsim *sim, struct ts_instance *inst, struct ts_words args);

/* The same for fixes that were defined before the file was read. */
enum ts_status ts_unclaimed_apply_earlier(struct tsim *sim);

/* Whether there is state for this instance; then its init must not set initial values. */
bool ts_unclaimed_exists(const struct tsim *sim, const struct ts_instance *inst);

/* Pair, bond and flow styles: a run without them has other forces, or no fluid. */
bool ts_unclaimed_is_model(enum ts_kind kind);

/* Writes an instance to a restart file: its present arguments, then its state. */
enum ts_status ts_unclaimed_write(struct tsim *sim, struct ts_instance *inst, struct ts_archive *archive);
/* Style and arguments, one a line, of the next pair or bond style that the script has not defined again; empty: there is none.
 * Each is given once. A flow style, or a style of a file of an older version, is reported instead, with a warning. */
enum ts_status ts_unclaimed_model(struct tsim *sim, enum ts_kind *kind, struct ts_str *lines);
/* Reports once, in the log, which fixes and computes of the restart file the script has not defined again. */
void ts_unclaimed_report(struct tsim *sim);
/* The script has said that it does without styles of this kind (`pair_style none`): they are not reported. */
void ts_unclaimed_waive(struct tsim *sim, enum ts_kind kind);
void ts_unclaimed_free(struct tsim *sim);

#endif
