/* Erosive and abrasive wear of a surface by I. Finnie, Wear 3 (1960) 87: depth that a force F removes
 * from an area A in the time h, at the relative velocity v with the impact angle g to the surface,
 *
 *   2 k v F f(g) h/A,   f = cos^2 g/3 for tan g > 1/3, else sin 2g - 3 sin^2 g
 *
 * The factor 1/3 is 0.33333, as in LIGGGHTS. */
#ifndef TS_LAW_CONTACT_WEAR_H
#define TS_LAW_CONTACT_WEAR_H

#include <math.h>

#include "math/vec3.h"

/* f(g); s, c: sine and cosine of the impact angle. */
static inline double ts_wear_angle(double s, double c)
{
	return 3 * s > c ? 0.33333 * c * c : 2 * s * c - 3 * s * s;
}

/* Wear depth, length; v: velocity of the particle relative to the surface. 0 at rest. */
static inline double ts_wear_finnie(double k, const double v[3], const double normal[3], double force,
				    double area, double step)
{
	double speed = ts_norm(v), across[3];

	if (!(speed > 0))
		return 0;
	ts_cross(v, normal, across);
	return 2 * k * speed * force *
	       ts_wear_angle(fabs(ts_dot(v, normal)) / speed, ts_norm(across) / speed) * step / area;
}

#endif
