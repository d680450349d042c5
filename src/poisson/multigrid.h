/* A multigrid V-cycle for balances of cells, symmetric, as the preconditioner of conjugate gradients.
 *
 * Levels: neighbouring cells are joined in pairs (the last three where the number is odd) along the axes on which
 * they are narrow, so that coarser cells come nearer to cubes; links across their faces are those of the finer
 * level, longer by the distance. Corrections are interpolated linearly, residuals are distributed by the
 * transpose of that. Smoothing: one sweep of Gauss-Seidel in red and black order before, one in reverse after.
 * Work is 8/7 (4/3 in two dimensions) of that on the finest level; the number of iterations hardly depends on
 * the number of cells. A. Brandt, Math. Comp. 31 (1977) 333; O. Tatebe, NASA CP-3224 (1993) 621. */
#ifndef TS_POISSON_MULTIGRID_H
#define TS_POISSON_MULTIGRID_H

#include "poisson/stencil.h"

enum { TS_LEVELS = 32 };

/* An axis between two levels. Cell i of the finer one gets (1 - share) of the coarser cell below[i] and the rest of
 * the one above that; coarser cell c gets share[k] of the finer cell[k], first[c] <= k < first[c + 1]. */
struct ts_multigrid_transfer {
	bool joined;
	int *begin; /* first finer cell of each coarser one, and the end */
	int *below;
	double *above;
	int *first, *cell;
	double *share;
};

struct ts_multigrid_level {
	struct ts_stencil s;
	double *p, *b, *r;
	const double *rhs; /* b, or of the finest level the caller's */
	struct ts_multigrid_transfer way[3]; /* to the next level */
	double *row; /* numbers of a row of this level, for each row of the next */
};

struct ts_multigrid {
	int levels;
	const struct ts_stencil *finest;
	struct ts_multigrid_level level[TS_LEVELS]; /* of the first one `s` is a copy of `finest` */
};

/* For the finest level's shape; released also after a failure. */
enum ts_status ts_multigrid_make(struct ts_multigrid *m, const struct ts_stencil *finest);
void ts_multigrid_release(struct ts_multigrid *m);
/* Links of coarser levels, from those of the finest as they are now. */
void ts_multigrid_set_weights(struct ts_multigrid *m);
/* z = one cycle for A z = r from z = 0: a ts_precondition_fn. */
void ts_multigrid_cycle(void *multigrid, const double *r, double *z);

#endif
