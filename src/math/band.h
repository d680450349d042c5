/* Systems of linear equations with a band matrix, by Gaussian elimination with row scaling and partial pivoting (G. H.
 * Golub, C. F. Van Loan, Matrix Computations, section 4.3). */
#ifndef TS_MATH_BAND_H
#define TS_MATH_BAND_H

#include <stdbool.h>
#include <stddef.h>

/* Numbers to allocate for n rows with `low` diagonals below and `high` above the main one; 0 at first. */
static inline size_t ts_band_length(size_t n, size_t low, size_t high)
{
	return n * (2 * low + high + 1);
}

/* Element (i, j), i - low <= j <= i + high. */
static inline double *ts_band_at(double *a, size_t low, size_t high, size_t i, size_t j)
{
	return a + i * (2 * low + high + 1) + (j + low - i);
}

/* Solves a x = b; x replaces b, a is destroyed. Returns false if a is singular or not finite. */
bool ts_band_solve(size_t n, size_t low, size_t high, double *a, double *b);

#endif
