/* Where a particle meets the fluid: which faces or cells it counts for, and how much.
 *
 * The weights sum to 1. What a particle gives is laid down by them on faces whose velocity is solved for: what
 * would fall on ghosts or on the boundary goes to the nearest face inside, to the other end of a periodic
 * axis. So the fluid gets all of it. */
#ifndef TS_COUPLING_INTERPOLATION_WEIGHTS_H
#define TS_COUPLING_INTERPOLATION_WEIGHTS_H

#include "flow/fluid.h"

enum ts_coupling_interpolation {
	TS_INTERPOLATE_LINEAR, /* between neighbouring points */
	TS_INTERPOLATE_CELL    /* the cell that holds the centre: mean of its faces */
};
extern const char *const ts_coupling_interpolation_names[];

struct ts_coupling_weights {
	int index[3][2];
	double weight[3][2]; /* of the product along the three axes */
};

/* The place in the grid, by its image across periodic faces, and its cell; false: there is no fluid. */
bool ts_coupling_locate(const struct ts_fluid *fluid, const double x[3], double place[3], int cell[3]);

/* For component c of the velocity, at a place found so. */
void ts_coupling_weights_face(const struct ts_fluid *fluid, int c, const double place[3], const int cell[3],
		     enum ts_coupling_interpolation how, struct ts_coupling_weights *out);
/* For a field at centres. */
void ts_coupling_weights_centre(const struct ts_fluid *fluid, const double place[3], const int cell[3],
		       enum ts_coupling_interpolation how, struct ts_coupling_weights *out);

/* sum of weight * field */
double ts_coupling_interpolate(const struct ts_grid *grid, const struct ts_coupling_weights *s, const double *field);
/* sum of weight * gradient of a centred field along axis c, at the faces of that component */
double ts_coupling_interpolate_gradient(const struct ts_grid *grid, const struct ts_coupling_weights *s, int c, const double *field);

/* What a particle gives that gets the amount F from the field q (of faces across axis c, or of centres: c ==
 * -1), dF/dq = slope: by weight w and control volume V
 *   source += w (slope q - F)/V,  rate += w slope/V,
 * so that source - rate q is the opposite of F now, and with another q later that of F + slope (sum of w q's
 * change). Without `rate` the slope must be 0. Returns the sum of w q. */
double ts_coupling_distribute_force(const struct ts_grid *grid, const struct ts_coupling_weights *s, int c, const double *q,
			double amount, double slope, double *source, double *rate);

#endif
