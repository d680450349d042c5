/* The reaction of all particles of a fix on the fluid. */
#ifndef TS_COUPLING_REACTIONS_H
#define TS_COUPLING_REACTIONS_H

#include "coupling/cell_order.h"
#include "coupling/interpolation_weights.h"

struct ts_reactions {
	struct ts_fluid *fluid;
	const struct ts_cell_order *order;
	enum ts_coupling_interpolation how;
	struct ts_cell_numbers force, slope; /* of particles; slope.own NULL: 0, and no rates */
	bool along[3];			     /* components that are distributed */
	double *velocity; /* of own particle i velocity[stride i] gets that of the fluid; NULL: not needed */
	size_t stride;
};

/* ts_coupling_faces_react for each particle of the group of the order. */
void ts_reactions_add(const struct ts_reactions *reactions, int threads);

#endif
