/* Means and standard errors of the results over the runs of a group. */
#ifndef TS_STUDY_STUDY_SUMMARY_H
#define TS_STUDY_STUDY_SUMMARY_H

#include "study/study_batch.h"

struct ts_study_mean {
	size_t n;	    /* number of runs that have the result */
	double mean, error; /* error: standard error of the mean; NAN for one run */
};

/* Of a result over the tasks of a group; runs that several tasks share count once. */
struct ts_study_mean ts_study_summary_mean(const struct ts_study *s, const struct ts_study_task *task,
					   size_t n, size_t group, size_t result);
/* Whether the runs of the tasks print the result as a number. */
bool ts_study_summary_has(const struct ts_study *s, const struct ts_study_task *task, size_t n,
			  size_t result);
/* Refuses a result that two scripts print. */
enum ts_status ts_study_summary_check_names(struct ts_study *s);
/* Writes summary.csv and, where one variable with numbers is swept, plot.gp; appends the table. `label`: values of each
 * group. */
enum ts_status ts_study_summary_write(struct ts_study *s, const struct ts_study_task *task, size_t n,
				      const char **const *label, size_t groups, struct ts_str *text);
/* Appends a line for each run that has failed; returns their number. */
size_t ts_study_summary_failures(const struct ts_study *s, const struct ts_study_task *task, size_t n,
				 struct ts_str *text);

#endif
