/* Least squares by secants: the step towards targets of functions that are known from runs only.
 *
 * x: logarithms of the variables; f: logarithms of results by targets. Both are nearly linear in each other where
 * results are products of powers of the variables, as for rock of linear bonds and contacts. */
#ifndef TS_STUDY_SECANT_H
#define TS_STUDY_SECANT_H

#include <stdbool.h>
#include <stddef.h>

#include "base/status.h"

enum { TS_SECANT_MOST = 8 /* variables */ };

/* Two runs that differ in the variables alone (the same replicate). */
struct ts_secant_pair {
	double dx[TS_SECANT_MOST];
	const double *df; /* [targets] */
};

/* The matrix d f / d x, row by row, from pairs of runs: weighted linear regression through the present point. A pair
 * counts 1/(noise^2 + |dx|^4), since the curvature changes f by |dx|^2 about. `noise`: of f. jacobian != NULL on input
 * with `keep`: changed as little as the pairs permit (a ridge), as in Broyden's method. Returns TS_RANGE if the pairs
 * do not determine it. */
enum ts_status ts_secant_jacobian(const struct ts_secant_pair *pair, size_t pairs, size_t variables,
				  size_t targets, double noise, bool keep, double *jacobian);

/* The step dx between lo and hi for which sum ((f + J dx) / tolerance)^2 is least, the shortest one if there are
 * several; *left is the root of that sum. Each of the 3^n sets of variables at their bounds is tried (n <= 8). */
enum ts_status ts_secant_step(size_t variables, size_t targets, const double *jacobian, const double *f,
			      const double *tolerance, const double *lo, const double *hi, double *dx,
			      double *left);

#endif
