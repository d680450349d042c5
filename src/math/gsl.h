/* Set-up of GSL: errors are returned as codes. */
#ifndef TS_MATH_GSL_H
#define TS_MATH_GSL_H

/* Disables the error handler of GSL, which would abort the process; the functions of this folder check
 * return codes. Call before any other function of this folder; may be repeated. */
void ts_math_init(void);

#endif
