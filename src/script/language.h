/* The words of formulas and variables, from the tables that the interpreter itself uses: for -help, the manual
 * and grammars of editors. */
#ifndef TS_SCRIPT_LANGUAGE_H
#define TS_SCRIPT_LANGUAGE_H

#include <stdbool.h>
#include <stddef.h>

/* A word, what follows it, and what it is. Operators have their level, 1 (loose) to 7, else it is 0. */
struct ts_language_row {
	const char *name, *arguments, *help;
	int level;
};

/* A table of such words. */
struct ts_language_topic {
	const char *name;  /* "functions" */
	const char *title; /* "Functions of numbers" */
	bool (*row)(size_t k, struct ts_language_row *out); /* false: there are no more */
};
extern const struct ts_language_topic ts_language_topics[]; /* closed by .name NULL; several may have the
							     * same name and belong together */

#endif
