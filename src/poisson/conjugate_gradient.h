/* The preconditioned conjugate gradient method, for positive (semi)definite systems of struct ts_stencil.
 *
 * Hestenes & Stiefel, J. Res. Nat. Bur. Stand. 49 (1952) 409. An iteration reduces the error in the energy
 * norm by about (sqrt(c) - 1)/(sqrt(c) + 1), c the condition number of the preconditioned system; without
 * a preconditioner sqrt(c) is 2/pi times the number of cells along the longest axis.
 *
 * A preconditioner that is not quite symmetric is taken by the flexible method, Y. Notay, SIAM J. Sci. Comput. 22 (2000)
 * 1444: a direction is orthogonal to the last one whatever the preconditioner is, for one more sum an iteration. */
#ifndef TS_POISSON_CONJUGATE_GRADIENT_H
#define TS_POISSON_CONJUGATE_GRADIENT_H

#include "poisson/stencil.h"

/* z = M^-1 r with M symmetric and positive definite; NULL: M is the diagonal. */
typedef void ts_precondition_fn(void *context, const double *r, double *z);

struct ts_conjugate_gradient {
	double *r, *z, *d, *q; /* residual, preconditioned residual, search direction, A d; owned */
	bool flexible;
	double step; /* of the last iteration, along d */
};

enum ts_status ts_conjugate_gradient_make(struct ts_conjugate_gradient *c, const struct ts_stencil *s);
void ts_conjugate_gradient_release(struct ts_conjugate_gradient *c);

/* Solves A p = b from the guess in p, or from 0 if that is nearer, until the largest residual per volume is at most `goal`,
 * or for `most` iterations; `largest`: the largest |b| per volume. The residual in the report is recomputed from p at the end. */
struct ts_poisson_report ts_conjugate_gradient_solve(struct ts_conjugate_gradient *c,
						     const struct ts_stencil *s,
						     ts_precondition_fn *precondition, void *context,
						     const double *b, double *p, double largest, double goal,
						     int most);
/* What a solve of so many iterations that converges exchanges among ranks; r, z, d and q lose their values. */
void ts_conjugate_gradient_rehearse(struct ts_conjugate_gradient *c, const struct ts_stencil *s,
				    ts_precondition_fn *precondition, void *context, int iterations);

#endif
