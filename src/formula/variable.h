/* Variables of a script. Each style is a constant table: variable_list.c (index, loop, world ...),
 * variable_text.c, variable_file.c, variable_formula.c. */
#ifndef TS_FORMULA_VARIABLE_H
#define TS_FORMULA_VARIABLE_H

#include <stdbool.h>
#include <stdint.h>

#include "base/map.h"
#include "base/words.h"
#include "core/archive.h"
#include "core/value.h"

struct ts_formulas;
struct ts_variable;

/* All styles, in the order of the manual. */
/* clang-format off */
#define TS_VARIABLE_STYLES(X)                                                                      \
	X(index)                                                                                   \
	X(loop)                                                                                    \
	X(world)                                                                                   \
	X(universe)                                                                                \
	X(uloop)                                                                                   \
	X(string)                                                                                  \
	X(once)                                                                                    \
	X(getenv)                                                                                  \
	X(format)                                                                                  \
	X(timer)                                                                                   \
	X(internal)                                                                                \
	X(file)                                                                                    \
	X(atomfile)                                                                                \
	X(equal)                                                                                   \
	X(atom)                                                                                    \
	X(vector)
/* clang-format on */

/* State of a variable in a restart file, restored for a variable of the same style, name and first word. */
struct ts_variable_state {
	const char *style, *name, *text;
	double number; /* defined by the style: a value, or a position in a file */
};

/* A slot left NULL: not possible with this style; `number` NULL: the text is parsed as a number. */
struct ts_variable_style {
	const char *name, *values, *help;
	size_t least, most; /* number of words; most 0: no limit */
	bool keeps;	    /* defining a variable that exists already does nothing */
	bool reads_all;	    /* struct ts_formulas */
	enum ts_status (*define)(struct ts_formulas *formulas, struct ts_variable *variable);
	/* value of ${name} */
	enum ts_status (*text)(struct ts_formulas *formulas, struct ts_variable *variable,
			       const struct ts_place *where, struct ts_str *out);
	/* value of v_name */
	enum ts_status (*number)(struct ts_formulas *formulas, struct ts_variable *variable,
				 const struct ts_place *where, double *out);
	/* one value per local particle; rows x 1 */
	enum ts_status (*peratom)(struct ts_formulas *formulas, struct ts_variable *variable,
				  const struct ts_place *where, struct ts_table *out);
	/* a list of numbers; rows x 1 */
	enum ts_status (*vector)(struct ts_formulas *formulas, struct ts_variable *variable,
				 const struct ts_place *where, struct ts_table *out);
	/* a number for each row of the columns that variables of style internal have; rows x 1 */
	enum ts_status (*columns)(struct ts_formulas *formulas, struct ts_variable *variable,
				  const struct ts_place *where, struct ts_table *out);
	/* advances to the next value; *exhausted: there is none */
	enum ts_status (*next)(struct ts_formulas *formulas, struct ts_variable *variable, bool *exhausted);
	/* For restart files; false: there is nothing to save. */
	bool (*save)(const struct ts_variable *variable, double *number);
	enum ts_status (*restore)(struct ts_formulas *formulas, struct ts_variable *variable, double number);
	void (*release)(struct ts_variable *variable);
};
#define TS_VARIABLE_DECLARE(style) extern const struct ts_variable_style ts_var_##style;
TS_VARIABLE_STYLES(TS_VARIABLE_DECLARE)
#undef TS_VARIABLE_DECLARE
extern const struct ts_variable_style *const ts_variable_styles[]; /* closed by NULL */

struct ts_variable_feed; /* variable_file.c */

struct ts_variable {
	const char *name;
	const struct ts_variable_style *style;
	struct ts_words values; /* as written */
	int64_t at, last;	/* present and last value; index: counted from 0, loop: the number itself */
	int pad;		/* loop: digits */
	double number;		/* internal, once, timer: the value; equal: its last value */
	const double *column;	/* internal: numbers of the rows that are evaluated; NULL: `number` */
	uint64_t evaluation;	/* formulas->evaluation when `number` or `kept` was evaluated */
	struct ts_table kept;	/* atom, vector: values, cached within one evaluation */
	struct ts_variable *next_kept;
	size_t place; /* index in ts_variables.item */
	struct ts_variable_feed *feed;
	struct ts_arena arena;
	struct ts_place where;
	bool busy;  /* its formula is being evaluated */
	bool given; /* from the command line */
	bool used;
	bool open;   /* -explain: set in a branch of which it is unknown whether it is taken */
	bool in_run; /* file, atomfile: a run has read values */
};

/* In the order in which they were defined, and by name. */
struct ts_variables {
	struct ts_variable **item; /* NULL: deleted since the last ts_variables_compact */
	size_t n, capacity, deleted;
	struct ts_map by_name;
};

struct ts_variable *ts_variable_find(const struct ts_formulas *formulas, const char *name);
/* The same, and marks it as used; or an error with a suggestion. */
enum ts_status ts_variable_require(struct ts_formulas *formulas, const char *name,
				   const struct ts_place *where, struct ts_variable **out);
/* Defines a variable; one that exists is replaced, or kept if its style `keeps`. */
enum ts_status ts_variable_define(struct ts_formulas *formulas, const struct ts_word *name,
				  const struct ts_variable_style *style, struct ts_words values);
void ts_variable_delete(struct ts_formulas *formulas, struct ts_variable *variable);
/* Removes the gaps in variables.item: until a variable is deleted, item[0..n-1] are not NULL. */
void ts_variables_compact(struct ts_formulas *formulas);
void ts_variables_release(struct ts_formulas *formulas);

enum ts_status ts_variable_text(struct ts_formulas *formulas, struct ts_variable *variable,
				const struct ts_place *where, struct ts_str *out);
enum ts_status ts_variable_number(struct ts_formulas *formulas, struct ts_variable *variable,
				  const struct ts_place *where, double *out);
enum ts_status ts_variable_peratom(struct ts_formulas *formulas, struct ts_variable *variable,
				   const struct ts_place *where, struct ts_table *out);
enum ts_status ts_variable_vector(struct ts_formulas *formulas, struct ts_variable *variable,
				  const struct ts_place *where, struct ts_table *out);
enum ts_status ts_variable_column(struct ts_formulas *formulas, struct ts_variable *variable,
				  const struct ts_place *where, struct ts_table *out);

/* The numbers `row` that a variable of style internal has, one after the other. */
struct ts_variable_rows {
	struct ts_variable *internal;
	const double *row;
};
/* out[k] = the number of the variable with row k of each of the `nset` variables, k = 0 .. n-1, n >= 1: as setting them and
 * ts_variable_number for each row, bit for bit; formulas are read twice rather than n times if they permit it. */
enum ts_status ts_variable_columns(struct ts_formulas *formulas, struct ts_variable *variable,
				   const struct ts_place *where, const struct ts_variable_rows *set,
				   size_t nset, size_t n, double *out);
enum ts_status ts_variable_next(struct ts_formulas *formulas, struct ts_variable *variable,
				const struct ts_place *where, bool *exhausted);

/* At the end of an evaluation: releases the columns and lists cached within it. */
void ts_variables_release_cache(struct ts_formulas *formulas);

/* Restores the state of a variable that is being defined from the restart file; *resumed: there was one. */
enum ts_status ts_variable_resume(struct ts_formulas *formulas, struct ts_variable *variable, bool *resumed);
/* Saves or restores the states of all variables. */
enum ts_status ts_variables_archive(struct ts_formulas *formulas, struct ts_archive *archive);

#endif
