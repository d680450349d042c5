/* Complex Fourier transforms of many lines at once: the innermost index counts lines, so that all arithmetic runs
 * along it in step, whatever the length. Mixed radix (4, 2, 3, and any other prime by its sums), self-sorting.
 *
 * Stockham's algorithm: Cochran et al., Proc. IEEE 55 (1967) 1664; C. Van Loan, Computational Frameworks for the
 * Fast Fourier Transform (1992), section 1.7. The order of operations depends on nothing but the length. */
#ifndef TS_FLOW_FOURIER_H
#define TS_FLOW_FOURIER_H

#include "base/status.h"

enum { TS_FOURIER_STAGES = 32 };

struct ts_fourier {
	int n, stages;
	int radix[TS_FOURIER_STAGES];
	double (*root)[2]; /* cos and sin of 2 pi k/n */
};

/* cos and sin of 2 pi k/n to the last bit or so, whatever k. */
void ts_fourier_root(long k, long n, double root[2]);

enum ts_status ts_fourier_make(struct ts_fourier *f, int n);
void ts_fourier_release(struct ts_fourier *f);

/* X_k = sum_j x_j exp(-2 pi i j k/n) of each line: x_j of line l at [j lines + l]. Result in place; spare: of the same
 * size each. The inverse is the same with re and im exchanged, by n. */
void ts_fourier_apply(const struct ts_fourier *f, int lines, double *re, double *im, double *spare_re,
		      double *spare_im);

#endif
