/* Liquid bridges between wet surfaces: an attractive capillary force along n, and viscous forces.
 *
 * Notation: l the liquid content, volume of liquid on a particle over the volume of the particle; V the
 * volume of a bridge; d >= 0 the gap between the surfaces (0 in contact); R* = R_i R_j/(R_i + R_j);
 * theta the contact angle in radians; sigma the surface tension.
 *
 * easo: V is the liquid on the caps that face each other (D. Shi, J. J. McCarthy, Powder Technol. 184
 * (2008) 64), the fraction 1/2 (1 - sqrt(1 - (R_other/(R_i + R_j))^2)) of the liquid of each partner;
 * half of it at a plane. The capillary force is (F. Soulie, F. Cherblanc, M. S. El Youssoufi, C. Saix,
 * Int. J. Numer. Anal. Methods Geomech. 30 (2006) 213), with the larger radius R and v = V/R^3,
 *
 *   pi sigma sqrt(R_i R_j) (exp(A d/R + B) + C),
 *   A = -1.1 v^-0.53, B = (-0.148 ln v - 0.96) theta^2 - 0.0082 ln v + 0.48, C = 0.0018 ln v + 0.078.
 *
 * washino: V is a given fraction of the liquid of both partners. The capillary force is (Y. I.
 * Rabinovich, M. S. Esayanur, B. M. Moudgil, Langmuir 21 (2005) 10992), with p = sqrt(1 + 2 V/(pi R*
 * d^2)) - 1 and alpha = sqrt(d p/R*),
 *
 *   2 pi R* sigma (cos theta p/(1 + p) + sin alpha sin(alpha + theta)),
 *
 * and in contact, as in LIGGGHTS, 2 pi R* sigma cos theta (1 + delta/sqrt(2 V/(pi R*))).
 *
 * Both rupture at d = (1 + theta/2) V^(1/3) (G. Lian, C. Thornton, M. J. Adams, J. Colloid Interface
 * Sci. 161 (1993) 138), or where the distance of the centres is the sum of the radii times a given
 * ratio, whichever is less. The viscous forces are (S. T. Nase, W. L. Vargas, A. A. Abatan, J. J.
 * McCarthy, Powder Technol. 116 (2001) 214), with g = d/R*, at least the given minimum,
 *
 *   6 pi mu R* v_n/g and 6 pi mu R* v_t (8/15 ln(1/g) + 0.9588).
 *
 * At a wall the partner has the radius of the particle, as in LIGGGHTS, and no liquid. */
#ifndef TS_LAW_CAPILLARY_H
#define TS_LAW_CAPILLARY_H

#include <math.h>

#include "law/granular.h"
#include "law/lens.h"
#include "law/touch.h"
#include "math/constants.h"

TS_INLINE double ts_sphere_volume(double radius)
{
	return 4.0 / 3.0 * TS_PI * radius * radius * radius;
}

/* Volume that a particle with the liquid content `liquid` contributes to a bridge to a partner of
 * radius `other`. */
TS_INLINE double ts_bridge_part(const struct ts_granular_model *m, const struct ts_granular_pair *c,
				double liquid, double radius, double other)
{
	double volume = ts_sphere_volume(radius) * liquid, s = other / (radius + other);

	if (m->cohesion == TS_COHESION_WASHINO)
		return c->bridge_share * volume;
	return volume * 0.5 * (1 - sqrt(1 - s * s));
}

/* Volume V of the bridge; at a wall the limit of an infinitely large partner without liquid. */
TS_INLINE double ts_bridge_volume(const struct ts_granular_model *m, const struct ts_granular_pair *c,
				  const double liquid[2], const double radius[2], bool wall)
{
	if (wall)
		return 0.5 * ts_sphere_volume(radius[0]) * liquid[0];
	return ts_bridge_part(m, c, liquid[0], radius[0], radius[1]) +
	       ts_bridge_part(m, c, liquid[1], radius[1], radius[0]);
}

/* Gap at which the bridge ruptures, length; 0 between dry surfaces. */
TS_INLINE double ts_bridge_reach(const struct ts_granular_model *m, const struct ts_granular_pair *c,
				 const double liquid[2], const double radius[2], bool wall)
{
	double sum = radius[0] + radius[!wall]; /* a wall counts as a particle of the same radius */

	return fmin((1 + 0.5 * c->contact_angle) * cbrt(ts_bridge_volume(m, c, liquid, radius, wall)),
		    (c->most_gap - 1) * sum);
}

TS_INLINE double ts_bridge_gap(const struct ts_touch *t)
{
	return fmax(-t->overlap, 0);
}

TS_INLINE double ts_easo_pull(const struct ts_granular_pair *c, const struct ts_touch *t, double volume)
{
	double larger = fmax(t->radius[0], t->radius[1]), theta = c->contact_angle;
	double v = volume / (larger * larger * larger), l = log(v);
	double a = -1.1 * pow(v, -0.53), b = (-0.148 * l - 0.96) * theta * theta - 0.0082 * l + 0.48;

	return TS_PI * c->surface_tension * sqrt(t->radius[0] * (t->wall ? t->radius[0] : t->radius[1])) *
	       (exp(a * ts_bridge_gap(t) / larger + b) + 0.0018 * l + 0.078);
}

TS_INLINE double ts_washino_pull(const struct ts_granular_pair *c, const struct ts_touch *t, double volume)
{
	double d = ts_bridge_gap(t), theta = c->contact_angle,
	       scale = 2 * TS_PI * t->r_eff * c->surface_tension;
	double wide = 2 * volume / (TS_PI * t->r_eff); /* d p -> sqrt(wide) for d -> 0 */
	double dp = wide / (sqrt(d * d + wide) + d), alpha = sqrt(dp / t->r_eff);

	if (t->overlap > 0)
		return scale * cos(theta) * (1 + t->overlap / sqrt(wide));
	return scale * (cos(theta) * dp / (d + dp) + sin(alpha) * sin(alpha + theta));
}

/* Magnitude of the capillary force, > 0. */
TS_INLINE double ts_capillary_pull(const struct ts_granular_model *m, const struct ts_granular_pair *c,
				   const struct ts_touch *t)
{
	double volume = ts_bridge_volume(m, c, t->liquid, t->radius, t->wall);

	return m->cohesion == TS_COHESION_WASHINO ? ts_washino_pull(c, t, volume)
						  : ts_easo_pull(c, t, volume);
}

/* Viscous force over velocity, normal and tangential, at the gap `relative` times R*. */
TS_INLINE double ts_bridge_normal_drag(const struct ts_granular_pair *c, double r_eff, double relative)
{
	return 6 * TS_PI * c->liquid_viscosity * r_eff / fmax(c->least_gap, relative);
}

TS_INLINE double ts_bridge_tangential_drag(const struct ts_granular_pair *c, double r_eff, double relative)
{
	double shape = 0.9588 - 8.0 / 15.0 * log(fmax(c->least_gap, relative));

	return 6 * TS_PI * c->liquid_viscosity * r_eff * fmax(shape, 0);
}

/* R* in the viscous forces. */
TS_INLINE double ts_bridge_radius(const struct ts_touch *t)
{
	return t->wall ? 0.5 * t->radius[0] : t->r_eff;
}

TS_INLINE bool ts_bridge_wet(const struct ts_touch *t)
{
	return t->liquid[0] + t->liquid[1] > 0;
}

/* Contribution of the bridge to F_n. */
TS_INLINE double ts_bridge_force(const struct ts_granular_model *m, const struct ts_granular_pair *c,
				 const struct ts_touch *t)
{
	double r = ts_bridge_radius(t);

	if (!ts_bridge_wet(t))
		return 0;
	return -ts_capillary_pull(m, c, t) - ts_bridge_normal_drag(c, r, ts_bridge_gap(t) / r) * t->vn;
}

/* Adds the tangential viscous force of the bridge to `force`. */
TS_INLINE void ts_bridge_slip(const struct ts_granular_pair *c, const struct ts_touch *t, double force[3])
{
	double r = ts_bridge_radius(t);

	if (ts_bridge_wet(t))
		ts_axpy(-ts_bridge_tangential_drag(c, r, ts_bridge_gap(t) / r), t->slip, force);
}

#endif
