/* Interpolation to a batch of particles, and their reaction on the fluid, in vectors of four particles: the numbers of
 * interpolation_faces.h and of ts_fluid_velocity_in_cell, bit for bit. With linear interpolation in three dimensions.
 *
 * Particles whose stencils are no pairs of neighbours along x, or have a weight of 0, are marked `general`: the caller, or the
 * functions that say so, take the functions of one particle for them. */
#ifndef TS_COUPLING_STENCIL_BATCH_H
#define TS_COUPLING_STENCIL_BATCH_H

#include "coupling/cell_halves.h"
#include "coupling/interpolation_faces.h"
#include "grid/grid_halves.h"

enum { TS_STENCIL_BATCH = 32 }; /* most particles of a batch */

struct ts_stencil_batch {
	size_t n;
	double x[3][TS_STENCIL_BATCH];
	uint64_t where[TS_STENCIL_BATCH];
	bool some_general;
	long long general[TS_STENCIL_BATCH]; /* 0: no */
	/* weights of the high points: of centres and faces along each axis */
	double share[2][3][TS_STENCIL_BATCH];
	/* of each component: positions in a field of the low points along x, row k & 1 along y, k >> 1 along z */
	ptrdiff_t row[3][4][TS_STENCIL_BATCH];
	/* widths of cells at low and high centres, gaps at low and high faces, along each axis */
	double width[2][3][TS_STENCIL_BATCH], gap[2][3][TS_STENCIL_BATCH];
};

/* Whether batches can be used for a fluid. */
static inline bool ts_stencil_batch_possible(const struct ts_fluid *fluid, int interpolation)
{
	return interpolation == TS_INTERPOLATE_LINEAR && fluid->grid.halves && !fluid->grid.by_depth;
}

/* Adds a place and its halves. */
static inline void ts_stencil_batch_add(struct ts_stencil_batch *b, const double x[3], uint64_t where)
{
	for (int d = 0; d < 3; d++)
		b->x[d][b->n] = x[d];
	b->where[b->n++] = where;
}

/* Makes a batch of the places x[of[0]] .. x[of[n - 1]]. */
void ts_stencil_batch_find(struct ts_stencil_batch *b, const struct ts_grid *grid, const double (*x)[3],
			   const size_t *of, size_t n);

/* out[c][k] of particle k, as ts_coupling_faces_interpolate; false if it is outside the grid: see ts_coupling_locate. */
void ts_stencil_batch_interpolate(struct ts_stencil_batch *b, const struct ts_fluid *fluid,
				  double *const field[3], double out[3][TS_STENCIL_BATCH],
				  bool inside[TS_STENCIL_BATCH]);
/* As ts_coupling_faces_gradient. */
void ts_stencil_batch_gradient(struct ts_stencil_batch *b, const struct ts_fluid *fluid, const double *field,
			       double out[3][TS_STENCIL_BATCH], bool inside[TS_STENCIL_BATCH]);
/* As ts_fluid_velocity_in_cell; value may be NULL with `field`. */
void ts_stencil_batch_velocity(struct ts_stencil_batch *b, const struct ts_fluid *fluid,
			       double u[3][TS_STENCIL_BATCH], const double *field,
			       double value[TS_STENCIL_BATCH], bool inside[TS_STENCIL_BATCH]);

/* The reaction of particle k, ts_coupling_faces_react: its force amount[k], its slope[k] (slope NULL: none). velocity[k], if
 * not NULL, gets the result. In the order of the batch. */
struct ts_stencil_reactions {
	bool sloped, along[3];
	const double *amount[TS_STENCIL_BATCH], *slope[TS_STENCIL_BATCH];
	double *velocity[TS_STENCIL_BATCH];
};
void ts_stencil_batch_react(struct ts_stencil_batch *b, struct ts_fluid *fluid,
			    const struct ts_stencil_reactions *reactions);

#endif
