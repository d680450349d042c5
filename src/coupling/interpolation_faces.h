/* Interpolation of all components of a velocity, of the gradient of a pressure, and the reaction on the fluid: the numbers
 * of interpolation_weights.h, bit for bit, with the weights of a particle computed once and kept in registers. */
#ifndef TS_COUPLING_INTERPOLATION_FACES_H
#define TS_COUPLING_INTERPOLATION_FACES_H

#include "coupling/interpolation_weights.h"

/* A place found by ts_coupling_locate. */
struct ts_coupling_place {
	double x[3];
	int cell[3];
	enum ts_coupling_interpolation how;
};

/* out[c] = sum of weight * field[c], as ts_coupling_interpolate; for c below the number of dimensions. */
void ts_coupling_faces_interpolate(const struct ts_fluid *fluid, const struct ts_coupling_place *at,
				   double *const field[3], double out[3]);
/* out[c] as ts_coupling_interpolate_gradient. */
void ts_coupling_faces_gradient(const struct ts_fluid *fluid, const struct ts_coupling_place *at,
				const double *field, double out[3]);

/* What acts on a particle and is taken from the fluid: ts_coupling_distribute_force for each component. */
struct ts_coupling_reaction {
	const double *amount, *slope; /* force and its slope; slope NULL: 0, and no rates */
	bool along[3];		      /* components that are distributed */
};
/* velocity[c] is what ts_coupling_distribute_force returns; NULL: not needed. */
void ts_coupling_faces_react(struct ts_fluid *fluid, const struct ts_coupling_place *at,
			     const struct ts_coupling_reaction *reaction, double *velocity);

#endif
