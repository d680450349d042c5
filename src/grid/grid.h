/* The staggered (MAC) grid: Cartesian, each axis uniform or graded by itself.
 *
 * Fields are arrays of doubles of grid.size, ghost cells included; cell (i,j,k), 0 <= i < n[0] ..., is at
 * ts_at(grid, i, j, k). Pressure, void fraction and scalars live in the centres of cells, velocity component
 * d on their lower faces across axis d: u[0] of cell (i,j,k) is at (face[0][i], centre[1][j], centre[2][k]).
 * The faces of the upper boundary are the lower faces of the first ghost cells, i = n[0]; beyond them fields have two
 * layers of faces, as below the lower boundary. */
#ifndef TS_GRID_GRID_H
#define TS_GRID_GRID_H

#include <stdbool.h>
#include <stddef.h>

#include "base/status.h"

#define TS_GRID_GHOSTS 2 /* layers of ghost cells: what schemes of three upwind points need */

struct ts_grid {
	int dimensions;      /* 2: the z axis is one cell thick and nothing varies along it; or 3 */
	bool by_depth;	     /* dimension 2: particles are discs, and they and all that they exchange by unit of depth */
	int n[3];            /* cells, ghosts not counted */
	int ghosts[3];       /* layers on either side: TS_GRID_GHOSTS, along z none in two dimensions */
	ptrdiff_t stride[3]; /* of fields; stride[0] == 1 */
	size_t size;         /* of a field, in doubles */
	size_t origin;       /* of cell (0,0,0) */
	bool periodic[3];
	bool uniform[3];
	/* By index from -ghosts on, as they are used: face[d][i] is the lower face of cell i, up to
	 * i = n + ghosts. Ghost cells mirror the cells at the boundary, or continue periodically. */
	double *face[3];
	double *centre[3];
	double *width[3]; /* face[i+1] - face[i] */
	double *gap[3];   /* centre[i] - centre[i-1] */
	double *memory;   /* of all these */
};

/* Faces of the axes, lowest first: n[d] + 1 each, increasing. `dimensions` 2 wants n[2] == 1. */
enum ts_status ts_grid_make(struct ts_grid *grid, int dimensions, const int n[3],
			    const double *const face[3], const bool periodic[3]);
void ts_grid_release(struct ts_grid *grid);

static inline size_t ts_at(const struct ts_grid *grid, int i, int j, int k)
{
	return (size_t)((ptrdiff_t)grid->origin + i + j * grid->stride[1] + k * grid->stride[2]);
}

static inline double ts_grid_volume(const struct ts_grid *grid, int i, int j, int k)
{
	return grid->width[0][i] * grid->width[1][j] * grid->width[2][k];
}

static inline size_t ts_grid_cells(const struct ts_grid *grid)
{
	return (size_t)grid->n[0] * (size_t)grid->n[1] * (size_t)grid->n[2];
}

/* The cell that holds a coordinate of axis d, from 0 to n - 1; -1 outside the grid (upper face: n - 1).
 * Uniform axes without search. */
int ts_grid_find(const struct ts_grid *grid, int d, double x);

/* A field of zeros, aligned to 64 bytes; NULL: out of memory. Freed by ts_grid_field_free. */
double *ts_grid_field(const struct ts_grid *grid);
void ts_grid_field_free(double *field);

#endif
