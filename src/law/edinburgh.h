/* Elasto-plastic adhesive contact of cohesive powders, the Edinburgh model (S. C. Thakur, J. P. Morrissey, J. Sun, J. F. Chen,
 * J. Y. Ooi, Granul. Matter 16 (2014) 383), with the adhesion and the unloading of LIGGGHTS 3.8. With the overlap d, its
 * largest value d_max so far, and d_p^n = (1 - k_1/k_2) d_max^n,
 *
 *   F = f_0 + k_1 d^n              where k_2 (d^n - d_p^n) is at least as large,
 *           + k_2 (d^n - d_p^n)    where this is above -k_a d^chi,
 *           - k_a d^chi            else.
 *
 * k_1 = 4/3 Y* sqrt(R*), for n = 1 2 R* Y*. k_a follows from the pull-off force f = 3/2 pi w a, with the surface energy w and
 * the radius a of the circle in which the spheres intersect at the overlap d_p, at most k_2 d_p^n/2: the branches meet at it,
 * at d^n = d_p^n - f/k_2, or at d_p/2 where f is limited. Where a contact is loaded again from the last branch, d_max becomes
 * that of which the second one begins there. */
#ifndef TS_LAW_EDINBURGH_H
#define TS_LAW_EDINBURGH_H

#include <math.h>

#include "law/granular.h"
#include "law/lens.h"
#include "law/touch.h"
#include "math/constants.h"

/* History of a contact. */
enum { TS_EDINBURGH_LARGEST, TS_EDINBURGH_LAST, TS_EDINBURGH_MEMORY }; /* d_max; d in the last step */

/* k_1, force/length^n */
TS_INLINE double ts_edinburgh_stiffness(const struct ts_granular_pair *c, const struct ts_touch *t)
{
	return c->overlap_exponent == 1 ? 2 * t->r_eff * c->young : 4.0 / 3.0 * c->young * sqrt(t->r_eff);
}

/* Radius of the circle of intersection at this overlap. */
static inline double ts_edinburgh_radius(const struct ts_touch *t, double overlap)
{
	const double area = t->wall ? ts_lens_of_plane(t->radius[0] - overlap, t->radius[0])
				    : ts_lens_of_spheres(t->radius[0] + t->radius[1] - overlap, t->radius[0],
							 t->radius[1]);

	return sqrt(fmax(area, 0) / TS_PI);
}

/* k_a, force/length^chi; `yielded`: d_p^n. */
static inline double ts_edinburgh_adhesion(const struct ts_granular_pair *c, const struct ts_touch *t,
					   double k2, double yielded)
{
	const double dp = pow(yielded, 1 / c->overlap_exponent), most = 0.5 * k2 * yielded;
	const double f = 1.5 * TS_PI * c->surface_energy * ts_edinburgh_radius(t, dp);

	if (!(yielded > 0))
		return 0;
	if (most < f)
		return most / pow(0.5 * dp, c->adhesion_exponent);
	return f / pow(yielded - f / k2, c->adhesion_exponent / c->overlap_exponent);
}

/* Loading again from the branch of adhesion lowers d_max; each time a smaller pull-off force may be the limit again. */
enum { TS_EDINBURGH_SWEEPS = 100 };

/* The force without f_0 and damping. */
static inline double ts_edinburgh_force(const struct ts_granular_pair *c, const struct ts_touch *t, double k1,
					double memory[TS_EDINBURGH_MEMORY])
{
	const double n = c->overlap_exponent, chi = c->adhesion_exponent, d = t->overlap, dn = pow(d, n);
	const double k2 = c->unloading * k1, yields = 1 - 1 / c->unloading, last = memory[TS_EDINBURGH_LAST];
	double largest = fmax(memory[TS_EDINBURGH_LARGEST], d), force = 0;

	for (int sweep = 0; sweep <= TS_EDINBURGH_SWEEPS; sweep++) {
		const double yielded = yields * pow(largest, n);
		double adhesion;

		force = k2 * (dn - yielded);
		if (force >= k1 * dn) {
			force = k1 * dn;
			break;
		}
		adhesion = ts_edinburgh_adhesion(c, t, k2, yielded);
		if (force > -adhesion * pow(d, chi))
			break;
		force = -adhesion * pow(d, chi);
		if (d <= last)
			break;
		largest = pow((pow(last, n) + adhesion / k2 * pow(last, chi)) / yields, 1 / n);
	}
	memory[TS_EDINBURGH_LARGEST] = largest;
	memory[TS_EDINBURGH_LAST] = d;
	return force;
}

#endif
