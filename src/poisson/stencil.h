/* The balance of cells as iterative solvers use it: links between neighbours, written out.
 *
 * Of a cell P with the neighbours N across its faces, (A p)_P = sum_f link_f (p_P - p_N), link = w A/d: the
 * operator of poisson/poisson.h by -V, symmetric and positive (semi)definite. Fields have one layer of ghost cells,
 * which hold the periodic image, or 0: the value at a face with a given pressure; a link across a face
 * without gradient is 0. So inner loops know no boundaries. */
#ifndef TS_POISSON_STENCIL_H
#define TS_POISSON_STENCIL_H

#include "poisson/poisson.h"

struct ts_stencil {
	int n[3], axes; /* axes along which there are links: 2 or 3 */
	int threads;
	bool periodic[3], singular;
	ptrdiff_t stride[3];
	size_t origin, size;
	double *width[3];    /* of cells */
	double *conduct[3];  /* 1/d of lower faces 0 .. n, 0 where no gradient is */
	double *link[3];     /* fields: of lower faces, upper boundary too */
	double *inverse;     /* field: 1/sum of links; 0 for a cell without */
	int colours;         /* of cells, so that no neighbours have the same: 2, or 3 with an odd period */
	double *colour[3];   /* 0, 1 or 2 by index along each axis; the cell's is the sum modulo `colours` */
	double *rows;        /* one number for each row: parts of sums */
	double *memory, *fields;
};

static inline size_t ts_stencil_at(const struct ts_stencil *s, int i, int j, int k)
{
	return (size_t)((ptrdiff_t)s->origin + i + j * s->stride[1] + k * s->stride[2]);
}

static inline int ts_stencil_rows(const struct ts_stencil *s)
{
	return s->n[1] * s->n[2];
}

/* Where a row begins: row = j + k n[1]. */
static inline size_t ts_stencil_row(const struct ts_stencil *s, int row)
{
	return ts_stencil_at(s, 0, row % s->n[1], row / s->n[1]);
}

/* Geometry, without links; released by ts_stencil_release also after a failure. */
enum ts_status ts_stencil_make(struct ts_stencil *s, const struct ts_poisson *problem);
enum ts_status ts_stencil_shape(struct ts_stencil *s, const int n[3], int axes, const bool periodic[3]);
void ts_stencil_release(struct ts_stencil *s);

/* Links from the problem's weights as they are now. */
void ts_stencil_set_weights(struct ts_stencil *s, const struct ts_poisson *problem);
/* `inverse` from the links. */
void ts_stencil_invert_diagonal(struct ts_stencil *s);

double *ts_stencil_field(const struct ts_stencil *s);
/* Between fields of the grid and those here. `volumes`: multiplied by minus the volume, as right-hand sides are. */
void ts_stencil_from_grid(const struct ts_stencil *s, const struct ts_grid *grid, const double *field,
		     bool volumes, double *out);
void ts_stencil_to_grid(const struct ts_stencil *s, const struct ts_grid *grid, const double *field,
		     double *out);

/* out = -r/V */
void ts_stencil_per_volume(const struct ts_stencil *s, const double *r, double *out);

void ts_stencil_ghosts(const struct ts_stencil *s, double *p);
/* out = A p, after ts_stencil_ghosts(p); returns p.Ap */
double ts_stencil_apply(const struct ts_stencil *s, const double *p, double *out);
/* Gauss-Seidel in the cells of one colour, as the squares of a chess board: p += omega (what balances the cell - p).
 * Ghosts must be right, and are so afterwards. */
void ts_stencil_sweep(const struct ts_stencil *s, double *p, const double *b, int colour, double omega);
/* out = b - A p, after ts_stencil_ghosts(p); returns its largest value by volume. NaN if there is one. */
double ts_stencil_residual(const struct ts_stencil *s, const double *p, const double *b, double *out);
/* Largest value by volume. */
double ts_stencil_largest(const struct ts_stencil *s, const double *r);
double ts_stencil_dot(const struct ts_stencil *s, const double *a, const double *b);
/* Takes off the mean by volume: the solution of a singular system. */
void ts_stencil_centre(const struct ts_stencil *s, double *p);
/* Makes a right-hand side of a singular system sum to zero to the last bit but one. */
void ts_stencil_balance(const struct ts_stencil *s, double *b);
/* The parts of rows, in order. */
double ts_stencil_sum_rows(const struct ts_stencil *s);
double ts_stencil_max_rows(const struct ts_stencil *s);

#endif
