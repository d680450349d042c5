/* Variables of a script. */
#ifndef TS_SCRIPT_VARIABLE_H
#define TS_SCRIPT_VARIABLE_H

#include <stdbool.h>
#include <stdint.h>

#include "base/words.h"
#include "core/value.h"

struct ts_script;

enum ts_variable_style {
	TS_VAR_INDEX,
	TS_VAR_LOOP,
	TS_VAR_STRING,
	TS_VAR_GETENV,
	TS_VAR_EQUAL,
	TS_VAR_ATOM
};
extern const char *const ts_variable_styles[]; /* their names, closed by NULL */

struct ts_variable {
	const char *name;
	enum ts_variable_style style;
	struct ts_words values; /* index: all; string, getenv, equal, atom: one */
	int64_t at, last;	/* index: which value; loop: the number itself */
	int pad;		/* loop: digits */
	struct ts_arena arena;
	struct ts_place where;
	bool busy;  /* its formula is being evaluated */
	bool given; /* from the command line */
	bool used;
};

struct ts_variables {
	struct ts_variable **item;
	size_t n, capacity;
};

struct ts_variable *ts_variable_find(const struct ts_script *script, const char *name);
/* The same and marks it used; or an error with a suggestion. */
enum ts_status ts_variable_require(struct ts_script *script, const char *name,
				   const struct ts_place *where, struct ts_variable **out);
/* Defines it, or leaves it alone if it is an index or loop variable that exists. */
enum ts_status ts_variable_define(struct ts_script *script, const struct ts_word *name,
				  enum ts_variable_style style, struct ts_words values);
void ts_variable_delete(struct ts_script *script, struct ts_variable *variable);
void ts_variables_release(struct ts_script *script);

/* What ${name} stands for. */
enum ts_status ts_variable_text(struct ts_script *script, struct ts_variable *variable,
				const struct ts_place *where, struct ts_str *out);
/* What v_name stands for. */
enum ts_status ts_variable_number(struct ts_script *script, struct ts_variable *variable,
				  const struct ts_place *where, double *out);
/* One value per local particle. */
enum ts_status ts_variable_peratom(struct ts_script *script, struct ts_variable *variable,
				   const struct ts_place *where, struct ts_table *out);
/* The next value of an index or loop variable; *exhausted: there is none. */
enum ts_status ts_variable_next(struct ts_script *script, struct ts_variable *variable,
				const struct ts_place *where, bool *exhausted);

#endif
