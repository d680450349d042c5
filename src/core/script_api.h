/* Functions of the script interpreter for the core and the styles, which stand below it. Their first argument is
 * sim->script_api_data. */
#ifndef TS_CORE_SCRIPT_API_H
#define TS_CORE_SCRIPT_API_H

#include "base/status.h"
#include "base/str.h"
#include "core/archive.h"
#include "core/value.h"

struct ts_script_api {
	/* Executes command lines; `where` is blamed for errors in them. */
	enum ts_status (*execute)(void *data, const char *text, const struct ts_place *where);
	/* Substitutes ${x}, $x and $(...) in the text. */
	enum ts_status (*substitute)(void *data, const char *text, const struct ts_place *where,
				     struct ts_str *out);
	/* The number an equal-, index-, loop- or string-style variable stands for now. */
	enum ts_status (*scalar)(void *data, const char *variable, const struct ts_place *where, double *out);
	/* The values of an atom-style variable, one per local particle (one column). */
	enum ts_status (*peratom)(void *data, const char *variable, const struct ts_place *where,
				  struct ts_table *out);
	/* The numbers of a vector-style variable, rows x 1. */
	enum ts_status (*vector)(void *data, const char *variable, const struct ts_place *where,
				 struct ts_table *out);
	bool (*has_variable)(void *data, const char *variable);
	bool (*is_peratom)(void *data, const char *variable);
	bool (*is_vector)(void *data, const char *variable);
	/* Whether the variable can give a value of this shape as far as names and shapes in its formula
	 * say, before it is asked for one. */
	enum ts_status (*check_variable)(void *data, const char *variable, enum ts_shape shape,
					 const struct ts_place *where);
	/* The same of commands that are to be executed later, one after the other. */
	enum ts_status (*check_commands)(void *data, struct ts_words commands);
	/* The same of a text whose variables and formulas are to be replaced later. */
	enum ts_status (*check_text)(void *data, const char *text, const struct ts_place *where);
	/* Commands that are executed while a run goes on: what they define may be named before it is
	 * there. */
	void (*expect_commands)(void *data, struct ts_words commands);
	/* Gives a variable of style internal its number, for the formulas that use it. */
	enum ts_status (*set)(void *data, const char *variable, const struct ts_place *where, double value);
	/* Writes or reads what the script must remember between runs: its streams of random numbers. */
	enum ts_status (*archive)(void *data, struct ts_archive *archive);
	/* A line for each variable: name, style, definition, place. */
	enum ts_status (*list_variables)(void *data, struct ts_str *out);
	void (*suggest_variable)(void *data, struct ts_suggest *suggest);
	/* -check: keeps the message of an error that others may follow, and makes a success of it. */
	enum ts_status (*defer_error)(void *data, enum ts_status status);
	/* -check: told of each run, and of each file that would be written or changed. */
	enum ts_status (*planned)(void *data, const struct ts_place *where, int64_t steps);
	enum ts_status (*would_write)(void *data, const struct ts_place *where, const char *what,
				      const char *path);
};

#endif
