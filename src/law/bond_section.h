/* Stiffness, damping and strength of a bond with a circular section of radius R = lambda min(R_a, R_b):
 *
 *   A = pi R^2,  I = pi R^4/4,  J = pi R^4/2
 *
 * D. O. Potyondy, P. A. Cundall, Int. J. Rock Mech. Min. Sci. 41 (2004) 1329, eqs. 10-18. */
#ifndef TS_LAW_BOND_SECTION_H
#define TS_LAW_BOND_SECTION_H

#include <math.h>

#include "law/bond_element.h"
#include "math/constants.h"
#include "math/rng.h"

/* How strengths differ from bond to bond. */
enum ts_bond_scatter { TS_BOND_SAME, TS_BOND_GAUSS, TS_BOND_WEIBULL };

struct ts_bond_strength {
	double tension, shear, compression; /* mean strengths, stress; NaN: never breaks in this mode */
	int scatter;			    /* enum ts_bond_scatter */
	double deviation;		    /* normal: standard deviation/mean; tension and shear */
	double shape;			    /* Weibull: modulus */
	int64_t seed;
};

/* Distance of the section from the first centre, divided by the length: half way between the two surfaces. */
static inline double ts_bond_fraction(double length, const double radius[2])
{
	return fmin(fmax(0.5 * (length + radius[0] - radius[1]) / length, 0), 1);
}

/* kn, ks: stiffness per area, stress/length. */
static inline void ts_bond_section_parallel(double radius, double kn, double ks, struct ts_bond_element *e)
{
	const double r2 = radius * radius, area = TS_PI * r2;

	e->k[TS_BOND_NORMAL] = kn * area;
	e->k[TS_BOND_SHEAR] = ks * area;
	e->k[TS_BOND_BENDING] = kn * area * r2 / 4;
	e->k[TS_BOND_TWIST] = ks * area * r2 / 2;
}

/* Stresses: moment times radius/I and radius/J, both times beta. */
static inline void ts_bond_section_stress(double radius, double beta, struct ts_bond_element *e)
{
	const double area = TS_PI * radius * radius;

	e->per_area = 1 / area;
	e->per_moment = beta * 4 / (area * radius);
	e->per_torque = beta * 2 / (area * radius);
}

/* Fractions of the critical damping of each mode: 2 sqrt(k m) with the reduced mass, or moment of inertia. */
static inline void ts_bond_section_damping(const double ratio[TS_BOND_MODES], const double mass[2],
					   const double inertia[2], struct ts_bond_element *e)
{
	for (int m = 0; m < TS_BOND_MODES; m++) {
		const double *of = m < TS_BOND_BENDING ? mass : inertia;

		e->c[m] = 2 * ratio[m] * sqrt(e->k[m] * (of[0] * of[1] / (of[0] + of[1])));
	}
}

/* A factor with mean 1 (the normal distribution is cut off at 0). */
static inline double ts_bond_scatter_factor(const struct ts_bond_strength *s, struct ts_rng *rng)
{
	double factor = 1;

	if (s->scatter == TS_BOND_WEIBULL)
		return pow(-log(ts_rng_uniform(rng)), 1 / s->shape) / tgamma(1 + 1 / s->shape);
	if (s->scatter == TS_BOND_GAUSS)
		do
			factor = 1 + s->deviation * ts_rng_normal(rng);
		while (factor <= 0);
	return factor;
}

/* Strengths of the bond of two particles: functions of the seed and the two identities, whatever their order
 * in memory. */
static inline void ts_bond_section_strength(const struct ts_bond_strength *s, const int32_t tag[2],
					    struct ts_bond_element *e)
{
	struct ts_rng rng =
		ts_rng_start((uint64_t)s->seed, (uint64_t)(uint32_t)tag[0] << 32 | (uint32_t)tag[1]);
	double tension = ts_bond_scatter_factor(s, &rng), shear = ts_bond_scatter_factor(s, &rng);

	e->tension = isnan(s->tension) ? INFINITY : s->tension * tension;
	e->shear = isnan(s->shear) ? INFINITY : s->shear * shear;
	e->compression = isnan(s->compression) ? INFINITY : s->compression;
}

#endif
