/* Contacts of one grain that know of each other: the load on one place of its surface displaces the
 * others as that on an elastic half space does.
 *
 * A force F along e on the surface of a half space of modulus Y and Poisson's ratio nu displaces
 * the place at d u from it, |u| = 1, by (J. Boussinesq; K. L. Johnson, Contact Mechanics, 1985,
 * ch. 3.2)
 *
 *   (1 + nu) F/(2 pi Y d) [(e.u) u + (3 - 4 nu) e - (1 - 2 nu) (e + u)/(1 + e.u)]
 *
 * Of this the part along the normal of the other contact counts: there the surface stands out by
 * -gamma times it, gamma a factor near 1 for a grain in place of a half space (N. Brodu, J. A.
 * Dijksman, R. P. Behringer, Phys. Rev. E 91 (2015) 032201). */
#ifndef TS_LAW_HALFSPACE_H
#define TS_LAW_HALFSPACE_H

#include <math.h>

#include "law/lens.h"
#include "math/constants.h"
#include "math/vec3.h"

/* Surfaces that stand out by more than this part of their radius are beyond the theory, and beyond
 * what is listed. */
#define TS_BULGE_MOST 0.1

struct ts_halfspace_load {
	double e[3];	 /* unit vector into the grain */
	double point[3]; /* from its centre */
	double force;	 /* along e */
	double within;	 /* radius of the area that is loaded */
};

/* gamma (1 + nu)/(2 pi Y) */
static inline double ts_halfspace_compliance(double young, double poisson, double prefactor)
{
	return prefactor * (1 + poisson) / (2 * TS_PI * young);
}

/* By how much the surface stands out at a place where `e` points into the grain. */
static inline double ts_halfspace_bulge(const struct ts_halfspace_load *load, const double e[3],
					const double point[3], double compliance, double poisson)
{
	double u[3], sum[3], d, along, both;

	ts_sub(point, load->point, u);
	d = ts_norm(u);
	if (!(d > 0))
		return 0;
	ts_scale(1 / d, u, u);
	ts_add(load->e, u, sum);
	along = ts_dot(load->e, u);
	both = along * ts_dot(e, u) + (3 - 4 * poisson) * ts_dot(load->e, e) -
	       (1 - 2 * poisson) * ts_dot(sum, e) / (1 + along);
	return -compliance * load->force / fmax(d, load->within) * both;
}

#endif
