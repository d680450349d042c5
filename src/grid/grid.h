/* The staggered (MAC) grid: Cartesian, each axis uniform or graded by itself.
 *
 * Fields are arrays of doubles of grid.size, ghost cells included; cell (i,j,k), 0 <= i < n[0] ..., is at
 * ts_at(grid, i, j, k). Pressure, void fraction and scalars are stored at cell centres; velocity component
 * d is stored at the lower faces across axis d: u[0] of cell (i,j,k) is at (face[0][i], centre[1][j],
 * centre[2][k]). The faces of the upper boundary are the lower faces of the first ghost cells, i = n[0];
 * two layers of faces follow beyond each boundary. Lengths are in the units of the script. */
#ifndef TS_GRID_GRID_H
#define TS_GRID_GRID_H

#include <stdbool.h>
#include <stddef.h>

#include "base/status.h"

#define TS_GRID_GHOSTS 2 /* layers of ghost cells, as schemes with three upwind points need them */

enum ts_grid_side { TS_LOW, TS_HIGH }; /* of an axis: its lower and its upper boundary */

struct ts_grid {
	int dimensions; /* 2: one cell along z and no gradient along z; or 3 */
	/* `dimension 2`: particles are discs; masses, forces and volumes are per unit of depth */
	bool by_depth;
	int n[3];      /* number of cells, without ghosts */
	int ghosts[3]; /* layers on either side: TS_GRID_GHOSTS, none along z in two dimensions */
	/* distance in a field between neighbours along an axis, in doubles; stride[0] == 1 */
	ptrdiff_t stride[3];
	size_t size;   /* of a field, in doubles */
	size_t origin; /* index of cell (0,0,0) in a field */
	bool periodic[3];
	bool uniform[3]; /* all cells along the axis have the same width */
	/* Indexed from -ghosts to n + ghosts: face[d][i] is the coordinate of the lower face of cell i.
	 * Ghost cells have the widths of the cells they mirror at a boundary, or of their periodic images. */
	double *face[3];
	double *centre[3];
	double *width[3]; /* face[i+1] - face[i] */
	double *gap[3];	  /* centre[i] - centre[i-1] */
	double *memory;	  /* of all these arrays; owned */
	bool sparse;	  /* fields take memory where they are written only: a rank has some planes of them */
	const struct ts_grid_half
		*half[3];	     /* of each half of a cell, from 0 to 2 n - 1; NULL in two dimensions */
	struct ts_grid_half *halves; /* of all axes; owned */
};

/* Makes the grid from the coordinates of the faces of each axis: n[d] + 1 each, increasing. With
 * `dimensions` 2 n[2] must be 1. Released by ts_grid_release. */
enum ts_status ts_grid_make(struct ts_grid *grid, int dimensions, const int n[3], const double *const face[3],
			    const bool periodic[3]);
void ts_grid_release(struct ts_grid *grid);

static inline size_t ts_at(const struct ts_grid *grid, int i, int j, int k)
{
	return (size_t)((ptrdiff_t)grid->origin + i + j * grid->stride[1] + k * grid->stride[2]);
}

/* Indices of the cell, or of the ghost, at an index of a field. */
static inline void ts_grid_indices(const struct ts_grid *grid, size_t at, int i[3])
{
	ptrdiff_t rest = (ptrdiff_t)at - (ptrdiff_t)grid->origin;

	for (int d = 0; d < grid->dimensions; d++)
		rest += grid->ghosts[d] * grid->stride[d];
	i[2] = 0;
	for (int d = grid->dimensions - 1; d >= 0; d--) {
		i[d] = (int)(rest / grid->stride[d]) - grid->ghosts[d];
		rest %= grid->stride[d];
	}
}

static inline double ts_grid_volume(const struct ts_grid *grid, int i, int j, int k)
{
	return grid->width[0][i] * grid->width[1][j] * grid->width[2][k];
}

static inline size_t ts_grid_cells(const struct ts_grid *grid)
{
	return (size_t)grid->n[0] * (size_t)grid->n[1] * (size_t)grid->n[2];
}

/* Width of the narrowest cell along any axis. */
double ts_grid_least_width(const struct ts_grid *grid);

/* ts_grid_find by bisection, for x in the grid. */
int ts_grid_bisect(const struct ts_grid *grid, int d, double x);

/* The index of the cell along axis d that contains the coordinate x, from 0 to n - 1; -1 if x is outside
 * the grid. The upper boundary belongs to cell n - 1. Constant time on uniform axes, else a bisection. */
static inline int ts_grid_find(const struct ts_grid *grid, int d, double x)
{
	const double *face = grid->face[d];
	int n = grid->n[d], i;

	if (!(x >= face[0] && x <= face[n]))
		return -1;
	if (!grid->uniform[d])
		return ts_grid_bisect(grid, d, x);
	i = (int)((x - face[0]) / grid->width[d][0]);
	return i < n ? i : n - 1;
}

/* Allocates a field of zeros, aligned to 64 bytes; NULL if out of memory. Freed by ts_grid_field_free. */
double *ts_grid_field(const struct ts_grid *grid);
void ts_grid_field_free(double *field);
/* Sets the values first .. end - 1 to 0; their pages are not in memory until they are written again. */
void ts_grid_field_clear(double *field, size_t first, size_t end);

#endif
