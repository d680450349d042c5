/* Direct solver for the pressure on a grid without weights, accurate to round-off.
 *
 * The operator is a sum of one-dimensional ones, so it separates into the modes of all axes but one
 * (poisson/transform.h); along the third axis a tridiagonal system remains for each mode, which is solved
 * by elimination; a periodic third axis is transformed as well. R. W. Hockney, J. ACM 12 (1965) 95; for
 * graded axes R. E. Lynch, J. R. Rice & D. H. Thomas, Numer. Math. 6 (1964) 185. Work: n log n on uniform
 * axes; a graded axis costs n operations per cell, so the most expensive axis is eliminated.
 *
 * Results are bitwise the same for any number of threads and on any processor. */
#ifndef TS_POISSON_DIRECT_H
#define TS_POISSON_DIRECT_H

#include "poisson/transform.h"

struct ts_direct {
	size_t origin; /* of the fields: those of the grid unless the caller sets others */
	ptrdiff_t stride[3];
	int threads;
	int axis[3], n[3]; /* axes in the order of treatment, and their numbers of cells */
	struct ts_transform transform[3];
	size_t strip; /* number of modes that are eliminated, or transformed along the third axis, at once */
	bool eliminates;	/* the third axis is solved by elimination, not transformed */
	size_t plane;		/* doubles from one plane of modes to the next */
	double *work;		/* the field of modes; owned, as all arrays below */
	double *eigenvalue;	/* of the modes of a plane */
	double *below, *above;	/* along the third axis: coefficients of the tridiagonal system, 1/length^2 */
	double *width_fraction; /* width of a cell of the third axis by the length of the axis */
	/* work memory of threads, `spare_size` doubles each, of which the first `line_size` hold lines */
	double *spare;
	size_t spare_size, line_size;
	size_t singular;	/* index of the mode of eigenvalue 0; SIZE_MAX if there is none */
	struct ts_slabs *slabs; /* of ranks: poisson/direct_exchange.h; NULL: none */
	/* If the slabs are across the second axis: the part of the modes of the first axis that this rank eliminates. Owned */
	struct ts_direct *columns;
};

/* Doubles from one plane of modes to the next: an odd number of cache lines, so that planes do not map to the same cache sets. */
static inline size_t ts_direct_plane(size_t modes)
{
	return ((modes + 7) / 8 | 1) * 8;
}

/* Released also after a failure. */
enum ts_status ts_direct_make(struct ts_direct *s, const struct ts_poisson *problem, int threads);
void ts_direct_release(struct ts_direct *s);

/* Estimated time of a solve in seconds, including a thousandth of the preparation. */
double ts_direct_cost(const struct ts_poisson *problem);
/* Solves for p in the inner cells; p and rhs may be the same field. While ranks have slabs: in the planes of this rank. */
void ts_direct_solve(const struct ts_direct *s, const double *rhs, double *p);

#endif
