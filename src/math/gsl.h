/* Errors of GSL come back as codes or NULL, and are checked. */
#ifndef TS_MATH_GSL_H
#define TS_MATH_GSL_H

#include <gsl/gsl_errno.h>

/* GSL's default handler of errors aborts the process. Around calls that can fail it is off; then the one of the program
 * around the library is set again:
 *
 *   gsl_error_handler_t *before = ts_gsl_errors_off();
 *   ...
 *   ts_gsl_errors_restore(before); */
static inline gsl_error_handler_t *ts_gsl_errors_off(void)
{
	return gsl_set_error_handler_off();
}

static inline void ts_gsl_errors_restore(gsl_error_handler_t *before)
{
	gsl_set_error_handler(before);
}

#endif
