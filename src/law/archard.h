/* Sliding wear (J. F. Archard, J. Appl. Phys. 24 (1953) 981): volume removed along a path of sliding s
 * under the normal force F, k F s/H. k: wear coefficient, 1 (1e-8 to 1e-2); H: hardness of the softer
 * material, pressure. DEM programs also state it by the work of friction, mu F s (EDEM, Rocky): k/(mu H)
 * is then one number. */
#ifndef TS_LAW_ARCHARD_H
#define TS_LAW_ARCHARD_H

#include <math.h>

static inline double ts_archard_volume(double coefficient, double hardness, double force, double path)
{
	return force <= 0 ? 0 : coefficient * force * fabs(path) / hardness;
}

#endif
