/* Forces of the fluid on a disc: the laws are those of spheres. */
#ifndef TS_COUPLING_SPHERE_ROWS_H
#define TS_COUPLING_SPHERE_ROWS_H

#include "core/sim.h"

/* Number of spheres that a particle stands for: 1; in two dimensions, where masses and forces are by depth, those of a row
 * along z with the volume of the disc, pi d^2/4 by pi d^3/6. So the force by volume is that on a sphere, in any units. */
static inline double ts_spheres_in_row(const struct tsim *sim, double diameter)
{
	return sim->dimension == 2 ? 3 / (2 * diameter) : 1;
}

#endif
