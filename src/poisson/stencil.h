/* The system of equations of iterative solvers: a 5- or 7-point stencil with a coefficient (link) for each
 * face.
 *
 * For a cell P with the neighbours N across its faces, (A p)_P = sum_f link_f (p_P - p_N), link = w A/d:
 * the operator of poisson/poisson.h multiplied by -V, symmetric and positive (semi)definite. Fields have
 * one layer of ghost cells, which hold the periodic image, or 0, the value on a face with a given
 * pressure; the link across a face with zero gradient is 0. So inner loops need no case for boundaries. */
#ifndef TS_POISSON_STENCIL_H
#define TS_POISSON_STENCIL_H

#include "poisson/poisson.h"

struct ts_stencil {
	int n[3], axes; /* number of cells; number of axes with links: 2 or 3 */
	int threads;
	bool periodic[3], singular;
	bool sparse; /* fields take memory where they are written only: a rank has some planes of them */
	ptrdiff_t stride[3];
	size_t origin, size;
	double *width[3];	/* of cells */
	double *conductance[3]; /* 1/d of lower faces 0 .. n; 0 with zero gradient */
	double *link[3];	/* fields: links of lower faces, including the upper boundary */
	double *inverse;	/* field: 1/sum of the links of a cell; 0 if it has none */
	int colours; /* number of colours, such that neighbours differ: 2, or 3 if a periodic axis has an odd
			      * number of cells */
	/* 0, 1 or 2 by index along each axis; the colour of a cell is their sum modulo `colours` */
	double *colour[3];
	struct ts_slabs *slabs;	 /* of ranks, in a solve that they divide; NULL: all rows */
	double *rows;		 /* partial sums, one for each row of cells */
	double *memory, *fields; /* of the arrays and of the fields above; owned */
};

static inline size_t ts_stencil_at(const struct ts_stencil *s, int i, int j, int k)
{
	return (size_t)((ptrdiff_t)s->origin + i + j * s->stride[1] + k * s->stride[2]);
}

static inline int ts_stencil_rows(const struct ts_stencil *s)
{
	return s->n[1] * s->n[2];
}

/* Index of the first cell of a row, row = j + k n[1]. */
static inline size_t ts_stencil_row(const struct ts_stencil *s, int row)
{
	return ts_stencil_at(s, 0, row % s->n[1], row / s->n[1]);
}

/* The rows of this rank: from `first` to end - 1. */
static inline void ts_stencil_own(const struct ts_stencil *s, int *first, int *end)
{
	long from, to;

	ts_slabs_rows(s->slabs, s->n[2], s->n[1], 0, &from, &to);
	*first = (int)from;
	*end = (int)to;
}

/* Sets the geometry, without links; to be released by ts_stencil_release also after a failure. */
enum ts_status ts_stencil_make(struct ts_stencil *s, const struct ts_poisson *problem);
enum ts_status ts_stencil_shape(struct ts_stencil *s, const int n[3], int axes, const bool periodic[3],
				bool sparse);
void ts_stencil_release(struct ts_stencil *s);

/* Computes the links from the present weights of the problem. While ranks have slabs: those of its planes, of the faces above
 * them, and of as many planes below them, and above, as the grid has ghosts. */
void ts_stencil_set_weights(struct ts_stencil *s, const struct ts_poisson *problem);
/* Computes `inverse` from the links. */
void ts_stencil_invert_diagonal(struct ts_stencil *s);

/* The functions below share the rows among ranks by `slabs`; sums and maxima are those of all. */
double *ts_stencil_field(const struct ts_stencil *s);
void ts_stencil_field_free(double *field);
/* p = 0 in the planes of this rank and in those beside them, ghosts included. */
void ts_stencil_clear(const struct ts_stencil *s, double *p);
/* Copies between fields of the grid and fields of the stencil. `volumes`: multiplied by minus the volume,
 * as for right-hand sides. */
void ts_stencil_from_grid(const struct ts_stencil *s, const struct ts_grid *grid, const double *field,
			  bool volumes, double *out);
void ts_stencil_to_grid(const struct ts_stencil *s, const struct ts_grid *grid, const double *field,
			double *out);

/* out = -r/V */
void ts_stencil_per_volume(const struct ts_stencil *s, const double *r, double *out);

void ts_stencil_ghosts(const struct ts_stencil *s, double *p);
/* With so many planes of the ranks beside this one, instead of one. */
void ts_stencil_ghosts_beside(const struct ts_stencil *s, double *p, int below, int above);
/* out = A p, after ts_stencil_ghosts(p); returns p.Ap */
double ts_stencil_apply(const struct ts_stencil *s, const double *p, double *out);
/* A Gauss-Seidel sweep over the cells of one colour: p += omega (p_GS - p), with p_GS the value that
 * solves the equation of the cell. Ghosts must be set before, and are set afterwards. */
void ts_stencil_sweep(const struct ts_stencil *s, double *p, const double *b, int colour, double omega);
/* out = b - A p, after ts_stencil_ghosts(p); returns the largest |out|/V, NaN if a value is NaN. */
double ts_stencil_residual(const struct ts_stencil *s, const double *p, const double *b, double *out);
/* The same of a guess, which is set to 0 if it leaves more than that, `largest`, the largest |b|/V: the last pressure may be
 * so much larger than the next one that its round-off is more than b. */
double ts_stencil_residual_of_guess(const struct ts_stencil *s, double *p, const double *b, double largest,
				    double *out);
/* Returns the largest |r|/V. */
double ts_stencil_largest(const struct ts_stencil *s, const double *r);
double ts_stencil_dot(const struct ts_stencil *s, const double *a, const double *b);
/* Subtracts the volume-weighted mean: the solution of a singular system. */
void ts_stencil_centre(const struct ts_stencil *s, double *p);
/* Corrects the right-hand side of a singular system so that it sums to zero, to round-off. */
void ts_stencil_balance(const struct ts_stencil *s, double *b);
/* Sum and maximum of the partial results in `rows`, in their order. */
double ts_stencil_sum_rows(const struct ts_stencil *s);
double ts_stencil_max_rows(const struct ts_stencil *s);

#endif
