/* Robust linear regression with up to three coefficients: iteratively reweighted least squares with Tukey's biweight, at
 * 4.685 times the scale of the residuals from the median of their absolute values (P. J. Huber, Robust Statistics, 1981).
 * Points far from the others do not count. */
#ifndef TS_BED_ROBUST_FIT_H
#define TS_BED_ROBUST_FIT_H

#include <stdbool.h>
#include <stddef.h>

#include "base/status.h"

enum { TS_ROBUST_TERMS = 3 };

struct ts_robust_point {
	double term[TS_ROBUST_TERMS]; /* of order 1; unused ones 0 */
	double y;
	bool selected; /* others are left out */
};

struct ts_robust_fit {
	double coefficient[TS_ROBUST_TERMS], error[TS_ROBUST_TERMS]; /* and their standard errors */
	double rms;						     /* of the residuals, weighted */
	size_t points;						     /* with a weight that is not 0 */
	bool defined; /* more points than coefficients, which are determined by them */
};

/* y = sum coefficient[k] term[k], k < terms. */
enum ts_status ts_robust_fit(const struct ts_robust_point *point, size_t n, int terms,
			     struct ts_robust_fit *out);
double ts_robust_value(const struct ts_robust_fit *fit, const struct ts_robust_point *point);

#endif
