/* Variables of a script. Each style is a constant record in its own file: variable_list.c (index, loop and
 * their kin), variable_text.c, variable_file.c, variable_formula.c. */
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

/* What a restart file keeps of a variable, for the one of the same style, name and first word. */
struct ts_variable_state {
	const char *style, *name, *text;
	double number; /* what the style makes of it */
};

/* A slot left NULL: not possible with this style; `number` NULL: the text, read as a number. */
struct ts_variable_style {
	const char *name, *values, *help;
	size_t least, most; /* how many words it takes; most 0: any number */
	bool keeps;	    /* defining one that exists already does nothing */
	enum ts_status (*define)(struct ts_formulas *formulas, struct ts_variable *variable);
	/* what ${name} stands for */
	enum ts_status (*text)(struct ts_formulas *formulas, struct ts_variable *variable,
			       const struct ts_place *where, struct ts_str *out);
	/* what v_name stands for */
	enum ts_status (*number)(struct ts_formulas *formulas, struct ts_variable *variable,
				 const struct ts_place *where, double *out);
	/* one value per local particle; rows x 1 */
	enum ts_status (*peratom)(struct ts_formulas *formulas, struct ts_variable *variable,
				  const struct ts_place *where, struct ts_table *out);
	/* a list of numbers; rows x 1 */
	enum ts_status (*vector)(struct ts_formulas *formulas, struct ts_variable *variable,
				 const struct ts_place *where, struct ts_table *out);
	/* goes on to the next value; *exhausted: there is none */
	enum ts_status (*next)(struct ts_formulas *formulas, struct ts_variable *variable, bool *exhausted);
	/* For restart files; false: there is nothing to keep. */
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
	int64_t at, last;	/* index: which value; loop: the number itself */
	int pad;		/* loop: digits */
	double number;		/* internal, once, timer; of a formula: as it was read last */
	uint64_t evaluation;	/* of the script, when that was */
	struct ts_table kept;	/* of a formula of particles or a list: likewise, within a reading */
	struct ts_variable *next_kept;
	size_t place; /* among all */
	struct ts_variable_feed *feed;
	struct ts_arena arena;
	struct ts_place where;
	bool busy;  /* its formula is being evaluated */
	bool given; /* from the command line */
	bool used;
	bool open;   /* -explain: set in a branch that may not be the one */
	bool in_run; /* a run has taken values from its file */
};

/* In the order in which they were defined, and by name. */
struct ts_variables {
	struct ts_variable **item; /* NULL: deleted since the last ts_variables_pack */
	size_t n, capacity, deleted;
	struct ts_map by_name;
};

struct ts_variable *ts_variable_find(const struct ts_formulas *formulas, const char *name);
/* The same and marks it used; or an error with a suggestion. */
enum ts_status ts_variable_require(struct ts_formulas *formulas, const char *name,
				   const struct ts_place *where, struct ts_variable **out);
/* Defines it, or leaves it alone if it exists and its style says so. */
enum ts_status ts_variable_define(struct ts_formulas *formulas, const struct ts_word *name,
				  const struct ts_variable_style *style, struct ts_words values);
void ts_variable_delete(struct ts_formulas *formulas, struct ts_variable *variable);
/* From now on until one is deleted item[0..n-1] are those that exist. */
void ts_variables_pack(struct ts_formulas *formulas);
void ts_variables_release(struct ts_formulas *formulas);

enum ts_status ts_variable_text(struct ts_formulas *formulas, struct ts_variable *variable,
				const struct ts_place *where, struct ts_str *out);
enum ts_status ts_variable_number(struct ts_formulas *formulas, struct ts_variable *variable,
				  const struct ts_place *where, double *out);
enum ts_status ts_variable_peratom(struct ts_formulas *formulas, struct ts_variable *variable,
				   const struct ts_place *where, struct ts_table *out);
enum ts_status ts_variable_vector(struct ts_formulas *formulas, struct ts_variable *variable,
				  const struct ts_place *where, struct ts_table *out);
enum ts_status ts_variable_next(struct ts_formulas *formulas, struct ts_variable *variable,
				const struct ts_place *where, bool *exhausted);

/* At the end of a reading: columns and lists that were kept within it. */
void ts_variables_forget(struct ts_formulas *formulas);

/* Gives a variable that is being defined what a restart file keeps of it; *resumed: there was something. */
enum ts_status ts_variable_resume(struct ts_formulas *formulas, struct ts_variable *variable, bool *resumed);
/* The states of all variables, written or read. */
enum ts_status ts_variables_archive(struct ts_formulas *formulas, struct ts_archive *archive);

#endif
