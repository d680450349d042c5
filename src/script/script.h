/* The script interpreter of a simulation. It sets sim->script_api and sim->script_api_data. */
#ifndef TS_SCRIPT_SCRIPT_H
#define TS_SCRIPT_SCRIPT_H

#include <stdbool.h>
#include <stdio.h>

#include "base/status.h"
#include "base/str.h"

struct tsim;
struct ts_script;

struct ts_script *ts_script_new(struct tsim *sim); /* NULL: out of memory */
void ts_script_free(struct ts_script *script);

/* Execute a script to its end, to `quit`, or to its first error. */
enum ts_status ts_script_file(struct ts_script *script, const char *path);
enum ts_status ts_script_stream(struct ts_script *script, FILE *stream, const char *name);
enum ts_status ts_script_string(struct ts_script *script, const char *text, const char *name);

/* Sets a variable of style index from outside (option -var), which overrides that of the script. `origin`
 * replaces the file name in messages. */
enum ts_status ts_script_set_variable(struct ts_script *script, const char *name, const char *const *values,
				      size_t n, const char *origin);
/* Executes `variable NAME STYLE VALUE` without substitution. It replaces a variable of any style, which is
 * kept if the line is wrong. value NULL: none. */
enum ts_status ts_script_define_variable(struct ts_script *script, const char *name, const char *style,
					 const char *value);
/* Name of the k-th variable; NULL: there are no more. */
const char *ts_script_variable_name(struct ts_script *script, size_t k);
/* The value of a formula: "v_x", "2*PI", "c_ke", "step" ... */
enum ts_status ts_script_value(struct ts_script *script, const char *expression, double *out);

/* Whether `shell` may start programs, set the environment, and remove and move files outside of the
 * working folder; default: no. */
void ts_script_allow_programs(struct ts_script *script, bool allowed);

/* Whether the script has executed `quit`, and its exit status. */
bool ts_script_quit(const struct ts_script *script, int *status);
/* Warns of variables of ts_script_set_variable that the script has not used, and of names that it defines
 * and never mentions again: most often misspelt ones. */
void ts_script_warn_unused(struct ts_script *script);

/* -check: from now on scripts are read without running the simulation, and errors do not end them. */
enum ts_status ts_script_check(struct ts_script *script);
/* Appends all errors as diagnostics, and a report of what the script does and would write; *nerrors: their
 * number. */
enum ts_status ts_script_check_report(struct ts_script *script, struct ts_str *errors, struct ts_str *report,
				      int *nerrors);

#endif
