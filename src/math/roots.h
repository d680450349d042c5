/* Square roots and reciprocals of many numbers, correctly rounded, i.e. with the bits of sqrt(x) and 1/x. With
 * AVX-512 they are computed by multiplications and additions, which take a third of the time of the divider. */
#ifndef TS_MATH_ROOTS_H
#define TS_MATH_ROOTS_H

#include <stddef.h>

/* Columns are aligned to 64 bytes, and n is a multiple of 8; a result may replace x. */
enum { TS_ROOTS_AT_ONCE = 8 };

/* root = sqrt(x) */
void ts_roots(const double *x, double *root, size_t n);
/* root = sqrt(x), inverse = 1/root, 0 where the root is 0 */
void ts_roots_and_inverses(const double *x, double *root, double *inverse, size_t n);

#endif
