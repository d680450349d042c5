/* A calibration: points in the space of the varied variables, their runs, and how far their results are from the
 * targets. */
#ifndef TS_STUDY_CALIBRATION_H
#define TS_STUDY_CALIBRATION_H

#include "study/secant.h"
#include "study/study_batch.h"

/* A set of values of the variables, with runs for each replicate or for the first one only. */
struct ts_calibration_point {
	const char **value;	  /* [variables of the study]; that of the replicate is open */
	double x[TS_SECANT_MOST]; /* logarithms of the varied ones */
};

enum ts_calibration_end { TS_CALIBRATION_REACHED, TS_CALIBRATION_NO_STEP, TS_CALIBRATION_TOO_LONG };

struct ts_calibration {
	struct ts_study study;
	size_t varied[TS_SECANT_MOST], n; /* indices of the varied variables */
	size_t replicate,
		replicates; /* index of the variable, SIZE_MAX: none; number of its values, at least 1 */
	struct ts_calibration_point *point;
	size_t points, capacity;
	double *jacobian;	  /* [targets * n] */
	bool has_jacobian, fresh; /* fresh: measured beside the best point */
	size_t best;		  /* index of a point */
	double *f;		  /* [targets]: of the best point */
	size_t tried;		  /* number of points tried */
	enum ts_calibration_end end;
};

/* Adds a point, or finds it among those that are there. Values are rounded to 9 digits. */
enum ts_status ts_calibration_add(struct ts_calibration *c, const double *x, size_t *index);
enum ts_status ts_calibration_add_values(struct ts_calibration *c, const char *const *value, size_t *index);
/* Tasks of a point for the first `replicates` replicates; memory of the study. */
enum ts_status ts_calibration_tasks(struct ts_calibration *c, size_t point, size_t replicates,
				    struct ts_study_task **task, size_t *n);
/* Logarithms of results by targets in one replicate of a point; false: not all are known. */
bool ts_calibration_sample(const struct ts_calibration *c, size_t point, size_t replicate, double *f);
/* The same for the means over all replicates. */
bool ts_calibration_means(const struct ts_calibration *c, size_t point, double *f);
/* Value of a target in one replicate of a point. */
bool ts_calibration_value(const struct ts_calibration *c, size_t point, size_t replicate, size_t target,
			  double *value);

/* The table at the end. */
void ts_calibration_report(struct ts_calibration *c, struct ts_str *text);

#endif
