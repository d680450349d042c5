/* Successive over-relaxation (SOR) in red-black order.
 *
 * D. M. Young, Trans. AMS 76 (1954) 92: with rho the spectral radius of the Jacobi iteration, an iteration
 * reduces the error asymptotically by omega - 1 for omega >= omega_b = 2/(1 + sqrt(1 - rho^2)), the best
 * choice; it converges for 0 < omega < 2 (W. Kahan, thesis, Toronto 1958), and diverges otherwise. The
 * number of iterations grows with the cells along the longest axis. */
#ifndef TS_POISSON_RELAXATION_H
#define TS_POISSON_RELAXATION_H

#include "poisson/stencil.h"

/* omega_b of a uniform grid without weights; on other grids that of the mean widths. */
double ts_relaxation_optimal(const struct ts_poisson *problem);

enum {
	TS_RELAXATION_LOOKS = 8
}; /* iterations between computations of the residual, each of which costs as much as one */

/* Iterates from p, or from 0 if that is nearer (`largest`: the largest |b| per volume), until the largest residual per volume is at most `goal`, or `most` times, or until it is 1e6
 * times that of the initial guess. The residual is computed in every eighth iteration. */
struct ts_poisson_report ts_relaxation_solve(const struct ts_stencil *s, double omega, const double *b,
					     double *p, double *spare, double largest, double goal, int most);
/* What so many iterations exchange among ranks; the ghosts of `p` change. */
void ts_relaxation_rehearse(const struct ts_stencil *s, double *p, int iterations);

#endif
