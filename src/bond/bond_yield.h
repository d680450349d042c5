/* Bonds that yield (law/plastic_hinge.h). */
#ifndef TS_BOND_BOND_YIELD_H
#define TS_BOND_BOND_YIELD_H

#include "bond/bonds.h"

/* Turns the particles, and lets the bonds flow whose loads would exceed their limits: changes rest lengths and reference
 * frames, so that the forces of the step do not exceed them. The work lost in the step is sim->bonds->flow. */
enum ts_status ts_bond_turn_and_yield(struct ts_instance *self, struct tsim *sim);

#endif
