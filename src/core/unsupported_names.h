/* Names of LIGGGHTS and LAMMPS that tsim does not support, so that the error says why, and what to use
 * instead. */
#ifndef TS_CORE_UNSUPPORTED_NAMES_H
#define TS_CORE_UNSUPPORTED_NAMES_H

#include "core/style.h"

struct ts_unsupported {
	enum ts_kind kind;
	const char *names;  /* separated by blanks; a trailing * stands for any ending */
	const char *remark; /* what tsim has instead, or why not */
};

extern const struct ts_unsupported
	ts_unsupported_table[]; /* closed by .names NULL; core/unsupported_styles.c */

/* Whether the name is one of the row. */
bool ts_unsupported_names(const struct ts_unsupported *row, const char *name);
/* NULL: not in the table. */
const struct ts_unsupported *ts_unsupported_find(enum ts_kind kind, const char *name);

/* The remark about a word of a line, or NULL. `of` is the keyword of which it is a choice (`model` of
 * contact laws), the command or style of which it is a keyword ("set", "fix wall/gran"), or, for
 * quantities of particles, TS_UNSUPPORTED_QUANTITY. */
#define TS_UNSUPPORTED_QUANTITY "quantity"
const char *ts_unsupported_word_remark(const char *of, const char *word);

#endif
