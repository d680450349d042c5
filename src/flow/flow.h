/* The fluid as particles see it: a velocity at each place, a viscosity, a density. */
#ifndef TS_FLOW_FLOW_H
#define TS_FLOW_FLOW_H

#include "core/sim.h"

struct ts_fluid;

struct ts_flow_style {
	struct ts_style style;
	/* Velocity of the undisturbed fluid at x: between the particles, where these leave a void fraction. */
	void (*velocity)(const struct ts_instance *self, const double x[3], double u[3]);
	double (*viscosity)(const struct ts_instance *self); /* dynamic */
	double (*density)(const struct ts_instance *self);
	/* Its fields on a grid, made by now (flow/fluid.h); NULL: the velocity is imposed, nobody acts on it. */
	struct ts_fluid *(*fluid)(const struct ts_instance *self);
};

static inline const struct ts_flow_style *ts_flow_style_of(const struct ts_instance *inst)
{
	return (const struct ts_flow_style *)inst->style;
}

/* The live flow style's fields; an error for `who` ("fix drag/ergun") where there is no fluid that is solved for. */
enum ts_status ts_flow_require_fluid(struct tsim *sim, const char *who, const struct ts_place *where,
				     struct ts_fluid **out);

/* Its numbers for thermo_style and formulas: flow_ke ... */
extern const struct ts_system_style ts_flow_system;

/* The same without an error: NULL. */
struct ts_fluid *ts_flow_fluid(const struct tsim *sim);
/* Fixes of a style that take part in the fluid's steps, from the k-th fix on: start with *k = 0, until NULL. */
const struct ts_instance *ts_flow_part_named(const struct tsim *sim, const char *style, size_t *k);

#endif
