/* Wear of a surface by particles that hit it or slide over it, after I. Finnie, Wear 3 (1960) 87: the depth
 * that a force F removes in a time h from an area A, at the relative velocity v that makes the angle g with
 * the surface,
 *
 *   2 k v F f(g) h / A,   f = cos^2 g / 3 where tan g > 1/3, else sin 2g - 3 sin^2 g
 *
 * The factor 1/3 is taken as 0.33333, as LIGGGHTS does. */
#ifndef TS_LAW_WEAR_H
#define TS_LAW_WEAR_H

#include <math.h>

#include "math/vec3.h"

/* sin and cos of the angle between velocity and surface. */
static inline double ts_wear_angle(double s, double c)
{
	return 3 * s > c ? 0.33333 * c * c : 2 * s * c - 3 * s * s;
}

/* v: of the particle relative to the surface. Nothing is worn by what is at rest. */
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
