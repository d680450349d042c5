/* Interaction of the contacts of one particle: the load on one contact displaces the surface at the
 * other contacts, as on an elastic half-space.
 *
 * A force F along e on the surface of a half-space of modulus Y and Poisson's ratio nu causes at the
 * distance d in the direction u, |u| = 1, the displacement (J. Boussinesq; K. L. Johnson, Contact
 * Mechanics, 1985, ch. 3.2)
 *
 *   (1 + nu) F/(2 pi Y d) [(e.u) u + (3 - 4 nu) e - (1 - 2 nu) (e + u)/(1 + e.u)]
 *
 * Its component along the normal of the other contact, times -gamma, displaces the surface there
 * outwards; gamma is a factor near 1 for a particle in place of a half-space (N. Brodu, J. A. Dijksman,
 * R. P. Behringer, Phys. Rev. E 91 (2015) 032201). */
#ifndef TS_LAW_HALFSPACE_H
#define TS_LAW_HALFSPACE_H

#include <math.h>

#include "law/lens.h"
#include "math/constants.h"
#include "math/vec3.h"

/* Largest surface displacement over radius: larger ones are beyond the theory and beyond the range of
 * the neighbour search. */
#define TS_BULGE_MOST 0.1

struct ts_halfspace_load {
	double e[3];	 /* unit vector into the particle */
	double point[3]; /* relative to its centre */
	double force;	 /* along e */
	double within;	 /* radius of the loaded area */
};

/* gamma (1 + nu)/(2 pi Y) */
static inline double ts_halfspace_compliance(double young, double poisson, double prefactor)
{
	return prefactor * (1 + poisson) / (2 * TS_PI * young);
}

/* Outward displacement of the surface at `point`, where `e` points into the particle. */
static inline double ts_halfspace_bulge(const struct ts_halfspace_load *load, const double e[3],
					const double point[3], double compliance, double poisson)
{
	double u[3], sum[3], d, along, above, displacement;

	ts_sub(point, load->point, u);
	d = ts_norm(u);
	if (!(d > 0))
		return 0;
	ts_scale(1 / d, u, u);
	ts_add(load->e, u, sum);
	along = ts_dot(load->e, u);
	/* Points above the surface of the half-space, which the depth of a contact may cause, are taken to be on
	 * it: the formula diverges where u = -e. */
	above = fmin(along, 0);
	displacement = along * ts_dot(e, u) + (3 - 4 * poisson) * ts_dot(load->e, e) -
		       (1 - 2 * poisson) * ts_dot(sum, e) / (1 + along - above);
	return -compliance * load->force / fmax(d, load->within) * displacement;
}

#endif
