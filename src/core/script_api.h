/* Functions of the script interpreter for the core and the styles, which stand below it. Their first
 * argument is sim->script_api_data. */
#ifndef TS_CORE_SCRIPT_API_H
#define TS_CORE_SCRIPT_API_H

#include "base/status.h"
#include "base/str.h"
#include "core/archive.h"
#include "core/value.h"

enum { TS_SCRIPT_ROWS = 8 /* at most, in `columns` below */ };

struct ts_script_rows {
	const char *internal; /* name of a variable */
	const double *row;
};

struct ts_script_api {
	/* Executes command lines; `where` is the place of their errors. */
	enum ts_status (*execute)(void *data, const char *text, const struct ts_place *where);
	/* Whether a command has been `quit`: nothing more is executed. */
	bool (*has_quit)(void *data);
	/* Substitutes ${x}, $x and $(...) in the text. */
	enum ts_status (*substitute)(void *data, const char *text, const struct ts_place *where,
				     struct ts_str *out);
	/* The present number of a variable of style equal, index, loop, string ... */
	enum ts_status (*scalar)(void *data, const char *variable, const struct ts_place *where, double *out);
	/* The values of a variable of style atom or atomfile: one column, a row per local particle. */
	enum ts_status (*peratom)(void *data, const char *variable, const struct ts_place *where,
				  struct ts_table *out);
	/* The numbers of a variable of style vector: one column. */
	enum ts_status (*vector)(void *data, const char *variable, const struct ts_place *where,
				 struct ts_table *out);
	bool (*has_variable)(void *data, const char *variable);
	bool (*is_peratom)(void *data, const char *variable);
	bool (*is_vector)(void *data, const char *variable);
	/* Checks names and shapes in the formula of a variable, without evaluating it: can it have this
	 * shape? */
	enum ts_status (*check_variable)(void *data, const char *variable, enum ts_shape shape,
					 const struct ts_place *where);
	/* Whether the value of a variable that exists is not the same on ranks with particles of their own: it depends on those
	 * of all, on a clock or on random numbers. */
	bool (*reads_all)(void *data, const char *variable);
	/* Whether it depends on the fields of the fluid. */
	bool (*reads_fluid)(void *data, const char *variable);
	/* The words of its definition: formulas, texts, names of files; false: there is none of this name. */
	bool (*words_of_variable)(void *data, const char *variable, struct ts_words *out);
	/* Checks commands that will be executed later, one after the other. */
	enum ts_status (*check_commands)(void *data, struct ts_words commands);
	/* Checks a text in which variables and formulas will be substituted later. */
	enum ts_status (*check_text)(void *data, const char *text, const struct ts_place *where);
	/* Announces commands that will be executed during the run (`run every`): until then checks accept
	 * names that these commands define. */
	void (*expect_commands)(void *data, struct ts_words commands);
	/* Sets the number of a variable of style internal, for formulas that use it. */
	enum ts_status (*set)(void *data, const char *variable, const struct ts_place *where, double value);
	/* out[k] = the present number of a variable with the numbers set[i].row[k] of `nset` variables of style internal,
	 * k = 0 .. n-1, n >= 1: as `set` and `scalar` for each k, but faster. */
	enum ts_status (*columns)(void *data, const char *variable, const struct ts_place *where,
				  const struct ts_script_rows *set, size_t nset, size_t n, double *out);
	/* Saves or restores state of formulas between runs: streams of random numbers, variables. */
	enum ts_status (*archive)(void *data, struct ts_archive *archive);
	/* Appends a line for each variable: name, style, definition, place. */
	enum ts_status (*list_variables)(void *data, struct ts_str *out);
	void (*suggest_variable)(void *data, struct ts_suggest *suggest);
	/* Name, and text as far as it has been read, of the k-th script; NULL: there are no more. Scripts that have been
	 * left and are read again appear twice. */
	const char *(*script_text)(void *data, size_t k, const char **name);
	/* -check: records the message of an error and returns TS_OK, so that further errors are found. */
	enum ts_status (*defer_error)(void *data, enum ts_status status);
	/* -check: records a run, or a file that would be written or changed. */
	enum ts_status (*planned)(void *data, const struct ts_place *where, int64_t steps);
	enum ts_status (*would_write)(void *data, const struct ts_place *where, const char *what,
				      const char *path);
};

#endif
