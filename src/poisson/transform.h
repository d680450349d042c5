/* Transforms to the modes of an axis, the eigenvectors of the second difference with the conditions at its
 * ends.
 *
 *   (T p)_i = [ (p_{i+1} - p_i)/d_{i+1} - (p_i - p_{i-1})/d_i ]/h_i
 *
 * On n uniform cells the eigenvalues are -(2/h sin(a/2))^2, and the modes are waves:
 *   periodic                     a = 2 pi k/n          Fourier
 *   no gradient at both ends     a = pi k/n            cosine, DCT-II
 *   given at both ends           a = pi (k+1)/n        sine, DST-II
 *   no gradient | given          a = pi (k+1/2)/n      cosine of quarter waves, DCT-IV; reversed: mirrored
 * They are computed by complex Fourier transforms; two lines are the real and imaginary part of one
 * complex line (J. Makhoul, IEEE Trans. ASSP 28 (1980) 27, for the cosines). Graded axes, and quarter
 * waves with odd n, use the matrix of eigenvectors of the symmetric h^1/2 T h^-1/2. */
#ifndef TS_POISSON_TRANSFORM_H
#define TS_POISSON_TRANSFORM_H

#include "math/fourier.h"
#include "poisson/poisson.h"

enum { TS_LINES = 16 }; /* number of lines transformed at once */

enum ts_transform_kind { TS_WAVES_FOURIER, TS_WAVES_HALF, TS_WAVES_QUARTER, TS_WAVES_MATRIX };

struct ts_transform {
	enum ts_transform_kind waves;
	int n;
	bool odd; /* signs alternate: sines are computed from cosines */
	bool mirrored;
	struct ts_fourier fourier;
	double (*turn)[2];
	double *forward, *backward; /* matrices, [mode][cell] and [cell][mode] */
	double *eigenvalue;
	int constant; /* index of the constant mode, of eigenvalue 0; -1 if there is none */
};

/* To be released also after a failure. */
enum ts_status ts_transform_make(struct ts_transform *t, const struct ts_poisson *problem, int d);
void ts_transform_release(struct ts_transform *t);

/* Size of the work memory of a transform, in doubles. */
size_t ts_transform_work_size(const struct ts_transform *t);
/* lines: value i of line l at [i TS_LINES + l]; forward replaces it by the amplitude of mode i, backward
 * the reverse. */
void ts_transform_forward(const struct ts_transform *t, double *lines, double *spare);
void ts_transform_backward(const struct ts_transform *t, double *lines, double *spare);

#endif
