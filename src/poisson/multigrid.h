/* A symmetric multigrid V-cycle for systems of struct ts_stencil, as preconditioner of the conjugate
 * gradient method.
 *
 * Levels: neighbouring cells are merged in pairs (the last three if the number is odd) along the axes on
 * which they are narrow, so that coarse cells approach cubes; the links of a coarse level are sums of
 * those of the finer level, scaled by the larger distance. Corrections are interpolated linearly,
 * residuals are distributed by the transpose of that. Smoothing: one sweep of Gauss-Seidel in red and
 * black order before, one in reverse after. Work is 8/7 (4/3 in two dimensions) of that on the finest
 * level; the number of iterations hardly depends on the number of cells. A. Brandt, Math. Comp. 31 (1977)
 * 333; O. Tatebe, NASA CP-3224 (1993) 621. */
#ifndef TS_POISSON_MULTIGRID_H
#define TS_POISSON_MULTIGRID_H

#include "poisson/stencil.h"

enum { TS_LEVELS = 32 };

/* Grid transfer along an axis between two levels. Prolongation: fine cell i receives (1 - above[i]) of
 * coarse cell below[i] and above[i] of the next one. Restriction: coarse cell c receives weight[k] of the
 * fine cell[k], first[c] <= k < first[c + 1]. Arrays are owned. */
struct ts_multigrid_transfer {
	bool joined; /* cells are merged along this axis; else both levels have the same cells */
	int *begin;  /* first fine cell of each coarse one, and the end */
	int *below;
	double *above;
	int *first, *cell;
	double *weight;
};

struct ts_multigrid_level {
	struct ts_stencil s;
	double *p, *b, *r;
	const double *rhs;			  /* b, or on the finest level the caller's */
	struct ts_multigrid_transfer transfer[3]; /* to the next level */
	double *row; /* work memory: a row of this level for each row of the next */
	/* Of ranks that divide this level, or give each other the right-hand side of the first one that they do not divide. */
	struct ts_slabs slabs;
	/* Planes beside its own ones that a rank needs: of the residual, to restrict it, of the correction of the next
	 * level, to interpolate it, and of the links, to add up those of the next level. */
	struct ts_multigrid_beside {
		int below, above;
	} residual, correction, links;
};

struct ts_multigrid {
	int levels;
	const struct ts_stencil *finest;
	struct ts_multigrid_level level[TS_LEVELS]; /* level[0].s is a copy of *finest */
	int divided; /* number of levels that ranks divide; all others each computes as a whole */
};

/* Makes the levels for the shape of the finest; to be released also after a failure. `slabs`: of ranks that can divide it; NULL:
 * none. They do in cycles in which finest->slabs are active. */
enum ts_status ts_multigrid_make(struct ts_multigrid *m, const struct ts_stencil *finest,
				 const struct ts_slabs *slabs);
void ts_multigrid_release(struct ts_multigrid *m);
/* Computes the links of the coarser levels from the present ones of the finest. */
void ts_multigrid_set_weights(struct ts_multigrid *m);
/* What it exchanges among ranks (rank/rehearsal.h). */
void ts_multigrid_rehearse_weights(struct ts_multigrid *m);
/* z = one cycle for A z = r from z = 0: a ts_precondition_fn. */
void ts_multigrid_cycle(void *multigrid, const double *r, double *z);

#endif
