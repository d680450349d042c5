/* The words of -sweep, -vary, -replicate and -calibrate: variables with their values, and targets. */
#ifndef TS_STUDY_STUDY_WORDS_H
#define TS_STUDY_STUDY_WORDS_H

#include "base/words.h"

enum ts_study_role {
	TS_STUDY_SWEPT,	    /* takes each of its values */
	TS_STUDY_REPLICATE, /* the same; the runs that differ in it alone are averaged */
	TS_STUDY_VARIED,    /* adjusted between bounds */
	TS_STUDY_TIED,	    /* a multiple of another variable */
	TS_STUDY_FIXED,	    /* -var */
};

struct ts_study_variable {
	const char *name;
	enum ts_study_role role;
	const char **value; /* [n]: texts as passed to -var; fixed: one, which may have several words */
	size_t n;
	double start, lo, hi; /* varied; all > 0 */
	size_t tied;	      /* index of the other variable */
	double factor;
};

struct ts_study_target {
	const char *name;
	double value, tolerance; /* tolerance: relative */
};

struct ts_study_words {
	struct ts_arena arena;
	struct ts_study_variable *variable;
	struct ts_study_target *target;
	size_t variables, targets, variable_capacity, target_capacity;
};

/* Parts of -sweep and -replicate (role SWEPT, REPLICATE): NAME=ITEM[,ITEM...], an item being a word, LO:HI:N or
 * LO:HI:N:log; of -vary (role VARIED): NAME=START[:LO:HI]. NAME=OTHER or NAME=OTHER*FACTOR ties a variable to one that
 * stands before. `option` names the option in messages. */
enum ts_status ts_study_words_variables(struct ts_study_words *w, const char *option, enum ts_study_role role,
					struct ts_words words, struct ts_error *err);
/* -var NAME VALUE ... of the command line. */
enum ts_status ts_study_words_fixed(struct ts_study_words *w, struct ts_words words, struct ts_error *err);
/* NAME=VALUE[:TOLERANCE] ... */
enum ts_status ts_study_words_targets(struct ts_study_words *w, struct ts_words words, double tolerance,
				      struct ts_error *err);
/* Index of the variable; SIZE_MAX: none. */
size_t ts_study_words_find(const struct ts_study_words *w, const char *name);
/* Text of a number as a value of a variable. */
const char *ts_study_words_number(struct ts_study_words *w, double value);
void ts_study_words_release(struct ts_study_words *w);

#endif
