/* The settings of a style when a restart file was written, against those of the script that reads it. */
#ifndef TS_CORE_ARG_CHANGE_H
#define TS_CORE_ARG_CHANGE_H

#include "core/style.h"

/* Appends one line "name value" per argument that is set, with digits that give the same numbers again. */
void ts_args_lines(const struct tsim *sim, const struct ts_arg *rows, const void *base, struct ts_str *out);

/* Compares the arguments of an instance with the lines of a restart file. A TS_STATEFUL argument with
 * another value is an error at its word in `words`; other changes are appended to `out` as "bit 0.4 ->
 * 0.5, ...". `what`, for messages: "fix mean (ave/time)". */
enum ts_status ts_args_changes(struct tsim *sim, const struct ts_instance *inst, const char *what,
			       const char *lines, struct ts_words words, struct ts_str *out);

#endif
