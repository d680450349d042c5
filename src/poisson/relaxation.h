/* Successive over-relaxation in red and black order.
 *
 * D. M. Young, Trans. AMS 76 (1954) 92: with rho the spectral radius of Jacobi's iteration, an iteration reduces the
 * error in the long run by omega - 1 for omega >= omega_b = 2/(1 + sqrt(1 - rho^2)), the best choice; it converges for
 * 0 < omega < 2 (W. Kahan, thesis, Toronto 1958), for all others it does not. The number of iterations grows with
 * the cells along the longest axis. */
#ifndef TS_POISSON_RELAXATION_H
#define TS_POISSON_RELAXATION_H

#include "poisson/stencil.h"

/* omega_b on a grid with even cells and no weights; by mean widths on others. */
double ts_relaxation_optimal(const struct ts_poisson *problem);

/* Iterates until the largest residual by volume is at most `goal`, or `most` times, or until it is 1e6 times that of the
 * first guess. It is looked at after every eighth iteration. */
struct ts_poisson_report ts_relaxation_solve(const struct ts_stencil *s, double omega, const double *b,
					     double *p, double *spare, double goal, int most);

#endif
