/* GSL as this program uses it: errors come back as codes. */
#ifndef TS_MATH_GSL_H
#define TS_MATH_GSL_H

/* Turns off GSL's error handler, which would abort the process: the wrappers in this folder check
 * return codes instead. Call before anything else of this folder; harmless to repeat. */
void ts_math_init(void);

#endif
