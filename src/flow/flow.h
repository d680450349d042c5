/* Flow styles: a velocity at each position, a viscosity, a density; and access to the live flow style. */
#ifndef TS_FLOW_FLOW_H
#define TS_FLOW_FLOW_H

#include "core/sim.h"

struct ts_fluid;
struct ts_rank_blocks;

struct ts_flow_style {
	struct ts_style style;
	/* Velocity of the undisturbed fluid at x; with a void fraction the interstitial velocity. */
	void (*velocity)(const struct ts_instance *self, const double x[3], double u[3]);
	double (*viscosity)(const struct ts_instance *self); /* dynamic */
	double (*density)(const struct ts_instance *self);
	/* Its fields on a grid, which exist (flow/fluid.h); NULL: the velocity is imposed and particles do
	 * not change it. */
	struct ts_fluid *(*fluid)(const struct ts_instance *self);
	/* Bits 1, 2, 4: it has a grid along x, y, z, which does not change with the box in a run. */
	unsigned grid;
	/* All ranks call it: each gets the fields in the whole grid, until the next step. */
	void (*complete)(struct ts_instance *self, const struct tsim *sim);
	/* Those into which the particles are divided among ranks; NULL: they are not. */
	const struct ts_rank_blocks *(*blocks)(const struct tsim *sim);
};

static inline const struct ts_flow_style *ts_flow_style_of(const struct ts_instance *inst)
{
	return (const struct ts_flow_style *)inst->style;
}

/* The fields of the live flow style; an error in the name of `who` ("fix drag/ergun") if there is no fluid
 * that is solved for. */
enum ts_status ts_flow_require_fluid(struct tsim *sim, const char *who, const struct ts_place *where,
				     struct ts_fluid **out);

/* The same for who reads the fields: with several ranks each gets the whole grid. All of them call it, outside of a step that they
 * divide. */
enum ts_status ts_flow_require_fields(struct tsim *sim, const char *who, const struct ts_place *where,
				      struct ts_fluid **out);

/* All ranks call it: each gets the whole grid of the fluid, if there is one of which ranks have planes. */
void ts_flow_complete(const struct tsim *sim);

/* Keywords of the fluid for thermo_style and formulas: flow_ke ... flow_keywords.c */
extern const struct ts_system_style ts_flow_system;

/* The same; NULL in place of an error. */
struct ts_fluid *ts_flow_fluid(const struct tsim *sim);
/* Fails, in the name of a fix, if the fluid of this flow style has no viscosity. */
enum ts_status ts_flow_require_viscosity(struct tsim *sim, const struct ts_instance *fix,
					 const struct ts_instance *flow);
/* Iterates over the fixes of a style that take part in the steps of the fluid: start with *k = 0; NULL at
 * the end. */
const struct ts_instance *ts_flow_part_named(const struct tsim *sim, const char *style, size_t *k);

#endif
