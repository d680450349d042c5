/* The impact of a particle on a surface, as laws of erosion see it. They give the volume that it removes,
 * length^3.
 *
 * Laws are written in the components of the impact velocity, V sin(alpha) and V cos(alpha) with the
 * impact angle alpha (0: along the surface), instead of V and alpha: no division by a speed of zero, and
 * no functions of angles.
 *
 * A particle that does not approach the surface (normal speed zero or negative, a negative angle) removes
 * nothing. Not a number (NaN) in gives NaN out: it is not taken for an impact without wear. Numbers are
 * in one consistent system of units, except where a law names its units (law/erosion_oka.h). */
#ifndef TS_LAW_EROSION_H
#define TS_LAW_EROSION_H

#include <math.h>

struct ts_erosion_impact {
	double mass, diameter;	   /* of the particle */
	double normal, tangential; /* impact speed towards the surface, and along it (>= 0) */
};

/* From the impact speed and the impact angle, radians. */
static inline struct ts_erosion_impact ts_erosion_impact_at(double mass, double diameter, double speed,
							    double angle)
{
	return (struct ts_erosion_impact){ mass, diameter, speed * sin(angle), speed * fabs(cos(angle)) };
}

#endif
