/* The fluid as particles see it: a velocity at each place, a viscosity, a density. */
#ifndef TS_FLOW_FLOW_H
#define TS_FLOW_FLOW_H

#include "core/sim.h"

struct ts_flow_style {
	struct ts_style style;
	/* Velocity of the undisturbed fluid at x. */
	void (*velocity)(const struct ts_instance *self, const double x[3], double u[3]);
	double (*viscosity)(const struct ts_instance *self); /* dynamic */
	double (*density)(const struct ts_instance *self);
};

static inline const struct ts_flow_style *ts_flow_style_of(const struct ts_instance *inst)
{
	return (const struct ts_flow_style *)inst->style;
}

#endif
