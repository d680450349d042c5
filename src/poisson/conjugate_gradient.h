/* Conjugate gradients with a preconditioner, for any positive (semi)definite balance of cells.
 *
 * Hestenes & Stiefel, J. Res. Nat. Bur. Stand. 49 (1952) 409. Reduces the error in the energy norm by about
 * (sqrt(c) - 1)/(sqrt(c) + 1) in an iteration, c the condition of the preconditioned system; without one,
 * sqrt(c) is 2/pi times the cells along the longest axis. */
#ifndef TS_POISSON_CONJUGATE_GRADIENT_H
#define TS_POISSON_CONJUGATE_GRADIENT_H

#include "poisson/stencil.h"

/* z = M^-1 r, M symmetric and definite; NULL: the diagonal. */
typedef void ts_precondition_fn(void *context, const double *r, double *z);

struct ts_conjugate_gradient {
	double *r, *z, *d, *q;
};

enum ts_status ts_conjugate_gradient_make(struct ts_conjugate_gradient *c, const struct ts_stencil *s);
void ts_conjugate_gradient_release(struct ts_conjugate_gradient *c);

/* Solves A p = b from the guess in p until the largest residual by volume is at most `goal`, or after `most`
 * iterations. The residual reported is computed anew at the end. */
struct ts_poisson_report ts_conjugate_gradient_solve(struct ts_conjugate_gradient *c, const struct ts_stencil *s,
					    ts_precondition_fn *precondition, void *context,
					    const double *b, double *p, double goal, int most);

#endif
