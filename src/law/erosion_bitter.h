/* Erosion by deformation and cutting (J. G. A. Bitter, Wear 6 (1963) 5 and 169): volume removed by an
 * impact with the normal and tangential speed n = V sin alpha and t = V cos alpha,
 *
 *   m (n - K)^2/(2 epsilon)                      deformation, if n > K
 *   2 m X (t - X phi),  X = C (n - K)^2/sqrt(n)  cutting, the particle leaves with velocity along the surface
 *   m (t^2 - K1 (n - K)^(3/2))/(2 phi)           cutting, its motion along the surface ends in the cut
 *
 * The first cutting term is the energy m (t^2 - (t - 2 X phi)^2)/2 that the motion along the surface
 * loses, over phi. The terms are equal at t = 2 X phi + sqrt(K1 (n - K)^(3/2)), which defines the angle
 * alpha0 of the paper (it depends on the speed): above this t the first one holds, below the second,
 * which is 0 where it would be negative: the contact along the surface is elastic.
 *
 * epsilon  energy that removes a unit of volume by deformation, pressure
 * phi      energy that removes a unit of volume by cutting (rho in the paper), pressure
 * K        normal speed below which the contact is elastic, velocity
 * C        cutting constant, velocity^(-1/2)/pressure
 * K1       loss to elastic deformation by the tangential force, velocity^(1/2)
 *
 * K, C and K1 follow from the elastic load limit y of the surface (pressure), the density rho of the
 * particle and the effective modulus 1/E* = (1 - nu1^2)/E1 + (1 - nu2^2)/E2 in the functions below. That
 * of K is the speed at which the largest pressure of Hertz' impact reaches y, and is checked by it. The
 * numbers 0.288 and 0.82 are as quoted in reviews; the paper itself was not at hand. A plastic groove
 * (law/erosion_zhao_chang.h) has the same form as 2 m X t with 0.237 in place of 0.288 for the whole
 * contact or half of that for the loading. epsilon and phi are fitted to measured volumes. */
#ifndef TS_LAW_EROSION_BITTER_H
#define TS_LAW_EROSION_BITTER_H

#include "law/erosion.h"
#include "math/constants.h"

struct ts_erosion_bitter {
	double deformation, cutting; /* epsilon, phi */
	double threshold;	     /* K */
	double cutting_constant;     /* C */
	double elastic_constant;     /* K1 */
};

/* K: impact speed at which the largest pressure of a Hertzian contact, p0 = 3 F/(2 pi a^2), reaches y.
 * Independent of the radius. For a metal with the yield stress Y the first plastic strain is at y = 1.6 Y
 * (K. L. Johnson, Contact Mechanics, 1985, 6.1). */
static inline double ts_erosion_yield_speed(double y, double density, double modulus)
{
	return TS_PI * TS_PI / (2 * sqrt(10.0)) * y * y * sqrt(y / density) / (modulus * modulus);
}

/* C */
static inline double ts_erosion_bitter_cutting(double y, double density)
{
	return 0.288 / y * sqrt(sqrt(density / y));
}

/* K1 */
static inline double ts_erosion_bitter_elastic(double y, double density, double modulus)
{
	return 0.82 * y * y / (modulus * modulus) * sqrt(sqrt(y / density));
}

static inline double ts_erosion_bitter_volume(const struct ts_erosion_bitter *law,
					      const struct ts_erosion_impact *i)
{
	double excess = i->normal - law->threshold, t = i->tangential, x, elastic, stopped;

	if (i->normal <= 0 || excess <= 0)
		return 0;
	x = law->cutting_constant * excess * excess / sqrt(i->normal);
	elastic = law->elastic_constant * excess * sqrt(excess);
	stopped = (t * t - elastic) / law->cutting;
	if (t > 2 * x * law->cutting + sqrt(elastic))
		stopped = 4 * x * (t - x * law->cutting);
	if (stopped < 0)
		stopped = 0;
	return 0.5 * i->mass * (excess * excess / law->deformation + stopped);
}

#endif
