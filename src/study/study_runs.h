/* The table of the runs of a study: a row a run with its variables, its end and its results. It is kept as a CSV
 * file, which is replaced as a whole whenever a run has ended, so each row is complete or absent. */
#ifndef TS_STUDY_STUDY_RUNS_H
#define TS_STUDY_STUDY_RUNS_H

#include "core/sim.h"

struct ts_study_run {
	int64_t number; /* its folder */
	const char *script;
	const char *version; /* hash of the script */
	const char **value;  /* [variables]; "": the script does not use the variable */
	int status;	     /* exit status, or 128 + number of the signal that ended it */
	double seconds;	     /* wall time */
	int off;	     /* number of lines RESULT that end with `off` */
	const char *error;   /* its message; "": none */
	const char **result; /* [results]; "": not printed */
	size_t results;
};

/* Zero-initialise. */
struct ts_study_runs {
	struct ts_arena arena;
	const char **variable, **result; /* names of the columns */
	size_t variables, results, variable_capacity, result_capacity;
	struct ts_study_run *run;
	size_t n, capacity;
};

/* Reads the file if it exists. Refuses one whose variables are not those of the table. */
enum ts_status ts_study_runs_read(struct ts_study_runs *runs, struct tsim *sim, const char *path);
/* Replaces the file. */
enum ts_status ts_study_runs_write(const struct ts_study_runs *runs, struct tsim *sim, const char *path);

enum ts_status ts_study_runs_add_variable(struct ts_study_runs *runs, const char *name, struct ts_error *err);
/* Adds a row; texts are copied. Results are set afterwards. */
enum ts_status ts_study_runs_add(struct ts_study_runs *runs, const struct ts_study_run *run,
				 struct ts_error *err);
/* Sets a result of the last row; a name that it has already, or that another column has, gets a number:
 * NAME_2. */
enum ts_status ts_study_runs_set_result(struct ts_study_runs *runs, const char *name, const char *value,
					struct ts_error *err);
/* Index of a result; SIZE_MAX: no run has it. */
size_t ts_study_runs_result(const struct ts_study_runs *runs, const char *name);
/* Number that the run printed; false: none, or not a finite number. */
bool ts_study_runs_value(const struct ts_study_run *run, size_t result, double *out);
/* Row of a run that came to its end by itself, with this script, version and values; SIZE_MAX: none. */
size_t ts_study_runs_find(const struct ts_study_runs *runs, const char *script, const char *version,
			  const char *const *value);
void ts_study_runs_release(struct ts_study_runs *runs);

#endif
