/* The pressure on a grid without weights, to round-off, without iterations.
 *
 * The operator is a sum of one-dimensional ones, so it falls apart into the modes of all axes but one
 * (poisson/transform.h); along that one, the third, remains a tridiagonal system for each mode, solved by
 * elimination, or it is transformed as well where it is periodic. R. W. Hockney, J. ACM 12 (1965) 95; for graded axes
 * R. E. Lynch, J. R. Rice & D. H. Thomas, Numer. Math. 6 (1964) 185. Work: n log n on even axes; an
 * axis that is graded costs n for each cell, so the dearest one is eliminated.
 *
 * Every number is made by the same operations whatever the number of threads, and on any processor. */
#ifndef TS_POISSON_DIRECT_H
#define TS_POISSON_DIRECT_H

#include "poisson/transform.h"

struct ts_direct {
	size_t origin;       /* of fields: those of the grid, if not others are set */
	ptrdiff_t stride[3];
	int threads;
	int axis[3], n[3]; /* first, second, third: which axis, and its cells */
	struct ts_transform transform[3];
	bool eliminates;   /* the third axis */
	size_t plane;      /* doubles from one plane of modes to the next */
	double *work;
	double *eigenvalue; /* of the modes of a plane */
	double *below, *above; /* along the third axis: coupling of cells by their width */
	double *share;     /* of a cell of the third axis in its length */
	double *spare;     /* of threads, each `spare_size`; the first `line_size` for lines */
	size_t spare_size, line_size;
	size_t singular;   /* the mode that is determined up to a constant; else SIZE_MAX */
};

/* Released also after a failure. */
enum ts_status ts_direct_make(struct ts_direct *s, const struct ts_poisson *problem, int threads);
void ts_direct_release(struct ts_direct *s);

/* Seconds of a solve, roughly, a thousandth of the preparation included. */
double ts_direct_cost(const struct ts_poisson *problem);
/* p = solution for rhs, inner cells; they may be the same field. */
void ts_direct_solve(const struct ts_direct *s, const double *rhs, double *p);

#endif
