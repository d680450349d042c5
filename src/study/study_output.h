/* What a run has printed: lines RESULT and STUDY, its error message, variables that it does not use. */
#ifndef TS_STUDY_STUDY_OUTPUT_H
#define TS_STUDY_STUDY_OUTPUT_H

#include "study/study_runs.h"

/* Adds the results in a file of screen output to the last row of the table:
 *   RESULT NAME VALUE ... [ok|off]   a result NAME; `off` at the end is counted
 *   STUDY NAME=VALUE ...             results with these names
 *   STUDY VALUE VALUE ...            results STUDY_1, STUDY_2 ...
 * and, if the run has failed, its message: the line that has "error:" or "ERROR", otherwise the last one. */
enum ts_status ts_study_output_read(struct ts_study_runs *runs, struct tsim *sim, const char *path);

/* Whether the output has the warning that the script does not use a variable that was set for it; of -check, whether it lists
 * files that the script would write; message of the first error. */
enum ts_status ts_study_output_unused(struct tsim *sim, const char *path, const char *variable, bool *unused);
enum ts_status ts_study_output_writes(struct tsim *sim, const char *path, bool *writes);
enum ts_status ts_study_output_error(struct tsim *sim, const char *path, struct ts_str *message);

#endif
