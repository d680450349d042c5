/* Automaton styles: granules on a lattice of cells between two walls; and access to the live one. */
#ifndef TS_AUTOMATON_AUTOMATON_H
#define TS_AUTOMATON_AUTOMATON_H

#include "automaton/granule_lattice.h"
#include "core/sim.h"

/* What outputs read. */
struct ts_automaton {
	struct ts_automaton_lattice lattice;
	double cell;	     /* edge of a cell [length] */
	double dt;	     /* time step that speeds refer to: one cell a step is cell/dt */
	double wall[2];	     /* velocity of the lower and the upper wall along x */
	double lo[3], hi[3]; /* the box */
	int64_t steps;	     /* so far */
	struct ts_automaton_count count;
};

struct ts_automaton_style {
	struct ts_style style;
	struct ts_automaton *(*of)(const struct ts_instance *self);
};

/* The live one; an error in the name of `who` ("compute automaton/profile") if there is none. */
enum ts_status ts_automaton_require(struct tsim *sim, const char *who, const struct ts_place *where,
				    struct ts_automaton **out);
/* The same; NULL in place of an error. */
struct ts_automaton *ts_automaton_of(const struct tsim *sim);

/* Velocity [velocity] of the integer 1. */
static inline double ts_automaton_unit(const struct ts_automaton *a)
{
	return a->cell / a->dt / TS_CELL_ONE;
}

#endif
