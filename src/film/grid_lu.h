/* Direct solver for systems of equations on a plane grid whose cells are coupled with their four neighbours.
 *
 * A = L U without pivoting, which is stable for matrices that are diagonally dominant by columns (the growth
 * of elements is at most 2; N. J. Higham, Accuracy and Stability of Numerical Algorithms, 2nd ed. (2002),
 * theorem 9.9): those of diffusion and of upwind transport in conservative form. The cells are ordered by nested
 * dissection (A. George, SIAM J. Numer. Anal. 10 (1973) 345): for n x n cells about 4 n^2 log2(n) coefficients in
 * L and in U each, and 15 n^3 multiplications (counted: 3.0 and 11 for n = 32, 4.0 and 16 for n = 128, 4.7 and 18 for
 * n = 512). The pattern of L is found from the elimination tree (J. W. H. Liu,
 * SIAM J. Matrix Anal. Appl. 11 (1990) 134); rows of L and columns of U are computed together.
 *
 * The result depends only on the matrix: the factorization is not divided among threads. */
#ifndef TS_FILM_GRID_LU_H
#define TS_FILM_GRID_LU_H

#include <stdbool.h>
#include <stddef.h>

#include "base/status.h"

/* Neighbours of a cell in the order of enum: lower and upper along the first and the second index. */
enum { TS_GRID_NEIGHBOURS = 4 };

/* Coefficients of a cell's equation: `centre` times its own unknown, side[k] times that of the neighbour k (lower
 * i, upper i, lower j, upper j). Coefficients of neighbours that do not exist, or are not unknown, are not read. */
struct ts_grid_row {
	double centre, side[TS_GRID_NEIGHBOURS];
};

struct ts_grid_lu {
	int n[2];
	bool periodic[2];
	size_t unknowns;
	int *number; /* of each cell [n[1]][n[0]] in the elimination; -1: not an unknown. Owned, as all below */
	int *cell;   /* of each number */
	int *parent;   /* elimination tree; -1: a root */
	size_t *begin; /* column k of L and row k of U have the entries begin[k] .. end[k] - 1 */
	size_t *end;   /* of the part that is computed */
	int *index;    /* number of the row of L, column of U, ascending */
	double *lower; /* L below the diagonal; its diagonal is 1 */
	double *upper; /* U above the diagonal */
	double *pivot; /* diagonal of U */
	double *work;  /* 2 per unknown */
	int *mark, *path;
};

/* Orders the cells and allocates the factors. `unknown`: [n[1]][n[0]], whether a cell has an equation. A periodic
 * axis has at least 3 cells. Returns TS_OK or TS_NOMEM; to be released also after a failure. */
enum ts_status ts_grid_lu_make(struct ts_grid_lu *lu, const int n[2], const bool periodic[2],
			       const bool *unknown);
void ts_grid_lu_release(struct ts_grid_lu *lu);

/* Cell number of the neighbour k of a cell, or -1. */
int ts_grid_lu_neighbour(const struct ts_grid_lu *lu, int cell, int k);

/* Factorizes the matrix with these rows, [n[1]][n[0]]. Returns -1, or the cell at which the pivot is not positive
 * to round-off: the matrix is singular or not diagonally dominant. */
int ts_grid_lu_factorize(struct ts_grid_lu *lu, const struct ts_grid_row *row);
/* Solves A x = b; fields [n[1]][n[0]], other cells are neither read nor written. b and x may be the same. */
void ts_grid_lu_solve(struct ts_grid_lu *lu, const double *b, double *x);

#endif
