/* Words of LIGGGHTS and LAMMPS that tsim knows of but does not have, so that a script that uses
 * one is told why instead of "unknown". */
#ifndef TS_CORE_UNSUPPORTED_NAMES_H
#define TS_CORE_UNSUPPORTED_NAMES_H

#include "core/style.h"

struct ts_unsupported {
	enum ts_kind kind;
	const char *name;   /* a trailing * stands for any ending */
	const char *remark; /* what tsim offers instead, or why not */
};

extern const struct ts_unsupported ts_unsupported_table[]; /* closed by .name NULL */

/* NULL: not known either. */
const struct ts_unsupported *ts_unsupported_find(enum ts_kind kind, const char *name);

/* The same for words in lines, the remark or NULL. `of` is the keyword whose choice it is (`model` of
 * contact laws), the line it is a keyword of ("set", "fix wall/gran"), or, for quantities of particles,
 * TS_UNSUPPORTED_QUANTITY. */
#define TS_UNSUPPORTED_QUANTITY "quantity"
const char *ts_unsupported_word_remark(const char *of, const char *word);

#endif
