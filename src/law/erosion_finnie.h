/* Erosion of ductile materials by cutting (I. Finnie, Wear 3 (1960) 87): volume removed by an impact of
 * the speed V at the angle alpha,
 *
 *   c m V^2/(p psi K) (sin 2 alpha - (6/K) sin^2 alpha)  for tan alpha <= K/6: leaves while it cuts
 *   c m V^2/(p psi K) K cos^2 alpha/6                    above: comes to rest along the surface
 *
 * p    plastic flow stress of the surface (about its hardness), pressure
 * psi  length of the cut over its depth, 2 in the paper
 * K    normal over tangential force, 2 in the paper
 * c    fraction of the particles that cut in this way (1 in the paper of 1960; I. Finnie, Wear 19 (1972)
 *      81, takes 0.1)
 *
 * The largest volume is at tan 2 alpha = K/3: for K = 2 at 16.845 degrees. There is none at 90 degrees,
 * where ductile metals in fact lose 0.3 to 0.5 of the largest volume: valid at grazing to medium angles.
 * Equation, psi and K agree with the function object ParticleErosion of OpenFOAM. The wear of meshes as
 * in LIGGGHTS, by the contact force, is in law/contact_wear.h. */
#ifndef TS_LAW_EROSION_FINNIE_H
#define TS_LAW_EROSION_FINNIE_H

#include "law/erosion.h"

struct ts_erosion_finnie {
	double flow_stress;  /* p */
	double length_ratio; /* psi */
	double force_ratio;  /* K */
	double fraction;     /* c */
};

static inline double ts_erosion_finnie_volume(const struct ts_erosion_finnie *law,
					      const struct ts_erosion_impact *i)
{
	double k = law->force_ratio, n = i->normal, t = i->tangential;
	double scale = law->fraction * i->mass / (law->flow_stress * law->length_ratio * k);

	if (n <= 0)
		return 0;
	return scale * (6 * n > k * t ? k * t * t / 6 : 2 * n * t - 6 / k * n * n);
}

#endif
