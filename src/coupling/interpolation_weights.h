/* Interpolation of the fluid's fields to a particle, and distribution of the particle's force to the fluid
 * by the same weights.
 *
 * The weights of a particle sum to 1. Forces are distributed over faces whose velocity is solved for: the
 * part of ghosts and boundary faces goes to the nearest face inside, or to the other end of a periodic
 * axis. So the fluid receives the whole force. */
#ifndef TS_COUPLING_INTERPOLATION_WEIGHTS_H
#define TS_COUPLING_INTERPOLATION_WEIGHTS_H

#include <math.h>

#include "flow/fluid.h"

enum ts_coupling_interpolation {
	TS_INTERPOLATE_LINEAR, /* trilinear between neighbouring points */
	/* value of the cell that contains the particle's centre; velocities: mean of its faces */
	TS_INTERPOLATE_CELL
};
extern const char *const ts_coupling_interpolation_names[];

struct ts_coupling_weights {
	int index[3][2];     /* indices of the two points along each axis */
	double weight[3][2]; /* their weights; that of a point is the product over the three axes */
};

/* Finds the image of x in the grid, across periodic faces, and its cell; false if x is outside the grid. */
static inline bool ts_coupling_locate(const struct ts_fluid *fluid, const double x[3], double place[3],
				      int cell[3])
{
	const struct ts_grid *grid = &fluid->grid;

	for (int d = 0; d < 3; d++) {
		double lo = grid->face[d][0], hi = grid->face[d][grid->n[d]];

		place[d] = x[d];
		if (grid->periodic[d] && !(x[d] >= lo && x[d] <= hi))
			place[d] -= floor((x[d] - lo) / (hi - lo)) * (hi - lo);
		if (grid->periodic[d] || grid->ghosts[d] == 0)
			place[d] = place[d] < lo ? lo : place[d] > hi ? hi : place[d];
		cell[d] = ts_grid_find(grid, d, place[d]);
		if (cell[d] < 0)
			return false;
	}
	return true;
}

/* Weights for each component of the velocity, at a place found by ts_coupling_locate. */
void ts_coupling_weights_faces(const struct ts_fluid *fluid, const double place[3], const int cell[3],
			       enum ts_coupling_interpolation how, struct ts_coupling_weights out[3]);
/* Weights for a field at centres. */
void ts_coupling_weights_centre(const struct ts_fluid *fluid, const double place[3], const int cell[3],
				enum ts_coupling_interpolation how, struct ts_coupling_weights *out);

/* Returns sum of weight * field. */
double ts_coupling_interpolate(const struct ts_grid *grid, const struct ts_coupling_weights *s,
			       const double *field);
/* Returns sum of weight * gradient along axis c of a centred field, taken at the faces of component c. */
double ts_coupling_interpolate_gradient(const struct ts_grid *grid, const struct ts_coupling_weights *s,
					int c, const double *field);

/* Distributes the reaction to the force F = `amount` of field q (at faces across axis c, or at centres: c
 * == -1) on a particle, with dF/dq = slope. For each point with weight w and control volume V
 *   source += w (slope q - F)/V,  rate += w slope/V,
 * so that source - rate q sums to -F for the present q, and for a later q to -(F + slope sum w (change of
 * q)). Without `rate` (NULL) slope must be 0. Returns sum of w q. */
double ts_coupling_distribute_force(const struct ts_grid *grid, const struct ts_coupling_weights *s, int c,
				    const double *q, double amount, double slope, double *source,
				    double *rate);

#endif
