/* Complex Fourier transforms of many lines at once: the innermost index is that of the line, so that
 * arithmetic vectorizes over lines for any length. Mixed radix (4, 2, 3, 5, other small primes by direct
 * sums), self-sorting; lengths with a large prime as a convolution of a longer, smooth length (L. I.
 * Bluestein, IEEE Trans. AU 18 (1970) 451).
 *
 * Stockham's algorithm: Cochran et al., Proc. IEEE 55 (1967) 1664; C. Van Loan, Computational Frameworks
 * for the Fast Fourier Transform (1992), section 1.7. The order of operations depends on nothing but the
 * length. */
#ifndef TS_MATH_FOURIER_H
#define TS_MATH_FOURIER_H

#include <stddef.h>

#include "base/status.h"

enum { TS_FOURIER_STAGES = 32 };

struct ts_fourier {
	int n, stages;
	int radix[TS_FOURIER_STAGES];
	double (*root)[2]; /* cos and sin of 2 pi k/n */
	/* Lengths with a large prime: X_k = c_k sum_j (x_j c_j) c*_{k-j}, c_j = exp(-pi i j^2/n) */
	struct ts_fourier *longer;
	double (*chirp)[2];
	double (*filter)[2]; /* transform of c* divided by the length */
};

/* cos and sin of 2 pi k/n, to about one unit in the last place for any k. */
void ts_fourier_root(long k, long n, double root[2]);

enum ts_status ts_fourier_make(struct ts_fourier *f, int n);
void ts_fourier_release(struct ts_fourier *f);

/* Size of the work memory for `lines` lines, in doubles. */
size_t ts_fourier_work_size(const struct ts_fourier *f, int lines);
/* X_k = sum_j x_j exp(-2 pi i j k/n) of each line: x_j of line l at [j lines + l]. In place. The inverse
 * is the same transform with re and im exchanged, divided by n. */
void ts_fourier_apply(const struct ts_fourier *f, int lines, double *re, double *im, double *spare);

#endif
