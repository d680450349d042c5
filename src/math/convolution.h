/* Convolution of a real function on a two-dimensional grid with a real, even kernel:
 *
 *   out_ij = sum_kl K(i - k, j - l) in_kl,   K(i, j) = K(-i, j) = K(i, -j)
 *
 * by Fourier transforms; either periodic, or not (outside of the grid the function is 0): then the transforms are
 * padded to twice the length, which gives the sum exactly (R. W. Hockney, Methods Comput. Phys. 9 (1970) 135).
 *
 * As function and kernel are real, two columns are the real and imaginary part of one complex line, and only half of
 * the modes along the second axis are stored. Transforms along the first axis, the product and the inverse are made
 * for blocks of lines that stay in the cache. Results do not depend on the number of threads. */
#ifndef TS_MATH_CONVOLUTION_H
#define TS_MATH_CONVOLUTION_H

#include <stdbool.h>

#include "math/fourier.h"

struct ts_convolution {
	int n[2];      /* of the grid; functions are [n[1]][n[0]] */
	int length[2]; /* of the transforms */
	int threads;
	struct ts_fourier fourier[2];
	int modes;	  /* length[1]/2 + 1 */
	double *spectrum; /* [modes][length[0]] of the kernel, divided by length[0] length[1] */
	double *re, *im;  /* [modes][n[0]] */
	int pairs;	  /* of columns: (n[0] + 1)/2 */
};

/* Allocates; the spectrum is 0. Call one of the next two. To be released also after a failure. */
enum ts_status ts_convolution_make(struct ts_convolution *c, const int n[2], bool periodic, int threads);
void ts_convolution_release(struct ts_convolution *c);

/* Sets the kernel from its values at distances of 0 <= i <= length[0]/2 columns and 0 <= j <= length[1]/2
 * rows. Returns TS_OK or TS_NOMEM. */
typedef double ts_kernel_fn(const void *context, int i, int j);
enum ts_status ts_convolution_set_kernel(struct ts_convolution *c, ts_kernel_fn *kernel, const void *context);
/* Sets the spectrum of the kernel: its value for mode k, l, 0 <= k <= length[0]/2, 0 <= l <= length[1]/2. */
void ts_convolution_set_spectrum(struct ts_convolution *c, ts_kernel_fn *spectrum, const void *context);

/* `out` may be `in`. Returns TS_OK or TS_NOMEM. */
enum ts_status ts_convolution_apply(struct ts_convolution *c, const double *in, double *out);

#endif
