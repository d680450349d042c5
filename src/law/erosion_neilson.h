/* Erosion by cutting and deformation (J. H. Neilson, A. Gilchrist, Wear 11 (1968) 111): volume removed by
 * an impact of the speed V at the angle alpha,
 *
 *   m V^2 cos^2 alpha sin(n alpha)/(2 phi)  for alpha < alpha0 = pi/(2 n),  m V^2 cos^2 alpha/(2 phi) above
 *   + m (V sin alpha - K)^2/(2 epsilon)     if V sin alpha > K
 *
 * phi      energy that removes a unit of volume by cutting, pressure
 * epsilon  energy that removes a unit of volume by deformation, pressure
 * K        normal speed below which the contact is elastic, velocity (ts_erosion_yield_speed in
 *          law/erosion_bitter.h)
 * alpha0   angle from which on the particle does not leave with velocity along the surface, radians, in
 *          (0, pi/2]
 *
 * phi, epsilon, K and alpha0 are fitted to measured volumes of one pair of materials. Both cutting terms
 * are equal at alpha0. */
#ifndef TS_LAW_EROSION_NEILSON_H
#define TS_LAW_EROSION_NEILSON_H

#include "law/erosion.h"
#include "math/constants.h"

struct ts_erosion_neilson {
	double cutting, deformation; /* phi, epsilon */
	double threshold;	     /* K */
	double transition;	     /* alpha0 */
};

static inline double ts_erosion_neilson_volume(const struct ts_erosion_neilson *law,
					       const struct ts_erosion_impact *i)
{
	double angle = atan2(i->normal, i->tangential), excess = i->normal - law->threshold;
	double cut = i->tangential * i->tangential / law->cutting;

	if (i->normal <= 0)
		return 0;
	if (angle < law->transition)
		cut *= sin(0.5 * TS_PI / law->transition * angle);
	if (excess <= 0)
		excess = 0;
	return 0.5 * i->mass * (cut + excess * excess / law->deformation);
}

#endif
