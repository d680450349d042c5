/* Unclaimed state: state of styles read from a restart file, kept until the script defines the style
 * again. */
#ifndef TS_CORE_UNCLAIMED_STATE_H
#define TS_CORE_UNCLAIMED_STATE_H

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
/* Before a run: defines the pair and bond styles of the restart file that the script has not defined again. Reports once
 * fixes and computes that it has not, in the log, and a flow style, or a style of an older file, with a warning. */
enum ts_status ts_unclaimed_complete(struct tsim *sim);
/* The script has said that it does without styles of this kind (`pair_style none`): they are not reported. */
void ts_unclaimed_waive(struct tsim *sim, enum ts_kind kind);
void ts_unclaimed_free(struct tsim *sim);

#endif
