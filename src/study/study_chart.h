/* The chart of a sweep. */
#ifndef TS_STUDY_STUDY_CHART_H
#define TS_STUDY_STUDY_CHART_H

#include "study/study_summary.h"

/* Draws summary.svg and summary.png from summary.csv: all results against the first variable with several numbers, a curve
 * for each set of values of the others, error bars where there are several runs. Nothing without such a variable or
 * without results. What cannot be drawn is told in `text` and is no error of the study. */
enum ts_status ts_study_chart(struct ts_study *s, const struct ts_study_task *task, size_t n,
			      const char **const *label, size_t groups, struct ts_str *text);

#endif
