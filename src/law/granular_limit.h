/* Stability limits of the time step for contacts.
 *
 * Near an overlap delta a contact is a damped oscillator with the stiffness k = dF_n/d delta, the
 * dashpot gamma_n and the mass m*. Slip including rotation is an oscillator with k_t, gamma_t and the
 * mass m_t,
 *
 *   1/m_t = sum over the partners of (1/m + R^2/I) = (1 + m R^2/I)/m*,  I = 2/5 m R^2 (discs 1/2 m R^2).
 *
 * Leapfrog-like schemes (velocity Verlet and symplectic Euler, damping force with the velocity of the
 * half step) are stable for |z| <= 1, where z^2 - (2 - w^2 h^2 - 2 g h) z + 1 - 2 g h = 0, w^2 = k/m, g
 * = gamma/(2 m): that is for h <= 2 (sqrt(w^2 + g^2) - g)/w^2 = 2/(sqrt(w^2 + g^2) + g). Explicit
 * Euler, z^2 - (2 - 2 g h) z + 1 - 2 g h + w^2 h^2, is stable for h < 2 g/w^2 = gamma/k only.
 *
 * Also the usual reference times of DEM: the Rayleigh time, in which a surface wave travels along a
 * sphere (J. W. S. Rayleigh; C. O'Sullivan, J. D. Bray, Eng. Comput. 21 (2004) 278), and the duration
 * of an elastic Hertz collision (K. L. Johnson, Contact Mechanics, 1985, 11.4). */
#ifndef TS_LAW_GRANULAR_LIMIT_H
#define TS_LAW_GRANULAR_LIMIT_H

#include "law/capillary.h"
#include "law/normal.h"
#include "math/constants.h"

static inline double ts_oscillator_limit(double stiffness, double damping, double mass, bool explicit_euler)
{
	double w2 = stiffness / mass, g = damping / (2 * mass);

	if (explicit_euler)
		return w2 > 0 ? 2 * g / w2 : INFINITY;
	return w2 > 0 || g > 0 ? 2 / (sqrt(w2 + g * g) + g) : INFINITY;
}

/* Whether the stiffness increases with the overlap. */
static inline bool ts_granular_stiffens(const struct ts_granular_model *m)
{
	return m->normal == TS_NORMAL_HERTZ || m->normal == TS_NORMAL_HERTZ_STIFFNESS ||
	       m->normal == TS_NORMAL_EDINBURGH || m->normal > TS_NORMAL_AREA_HOOKE;
}

/* Stiffness and damping of a contact at rest at this overlap. */
static inline struct ts_normal ts_granular_constants_at(const struct ts_granular_model *m,
							const struct ts_granular_pair *c, double r_eff,
							double m_eff, double overlap)
{
	struct ts_touch t = { .r_eff = r_eff, .m_eff = m_eff, .overlap = overlap };
	struct ts_granular_model dry = *m;
	struct ts_normal f = { 0 };
	double memory[TS_NORMAL_MEMORY] = { 0 };

	dry.viscous = false;
	if (m->normal != TS_NORMAL_OFF)
		ts_normal_force(&dry, c, &t, memory, &f);
	if (m->normal == TS_NORMAL_HOOKE_HYSTERESIS || m->normal == TS_NORMAL_EDINBURGH)
		f.kn *= fmax(c->unloading, 1);
	if (m->normal == TS_NORMAL_EDINBURGH)
		f.kn *= fmax(c->overlap_exponent, 1); /* F ~ delta^n */
	else if (ts_granular_stiffens(m))
		f.kn *= 1.5; /* F ~ delta^(3/2) */
	if (ts_cohesion_bridges(m)) {
		f.gamman += ts_bridge_normal_drag(c, r_eff, 0);
		f.gammat += ts_bridge_tangential_drag(c, r_eff, 0);
	}
	if (m->viscous) /* slow collisions are critically damped */
		f.gamman = f.gammat = 2 * sqrt(m_eff * f.kn);
	return f;
}

/* Limit of the normal motion. */
static inline double ts_granular_limit(const struct ts_granular_model *m, const struct ts_granular_pair *c,
				       double r_eff, double m_eff, double overlap, bool explicit_euler)
{
	struct ts_normal f = ts_granular_constants_at(m, c, r_eff, m_eff, overlap);

	return ts_oscillator_limit(f.kn, f.gamman, m_eff, explicit_euler);
}

/* Limit of the tangential motion; `inertia` is I/(m R^2). Above it friction keeps the forces bounded. */
static inline double ts_granular_slip_limit(const struct ts_granular_model *m,
					    const struct ts_granular_pair *c, double r_eff, double m_eff,
					    double overlap, double inertia, bool explicit_euler)
{
	struct ts_normal f = ts_granular_constants_at(m, c, r_eff, m_eff, overlap);
	double mass = m_eff / (1 + 1 / inertia);

	if (m->tangential == TS_TANGENTIAL_OFF || !(c->friction > 0))
		return INFINITY;
	return ts_oscillator_limit(m->tangential == TS_TANGENTIAL_NO_HISTORY ? 0 : f.kt, f.gammat, mass,
				   explicit_euler);
}

/* Largest overlap of an elastic collision at this speed for laws with F = K delta^(3/2): m* v^2/2 = 2/5
 * K delta^(5/2). */
static inline double ts_granular_impact_overlap(const struct ts_granular_model *m,
						const struct ts_granular_pair *c, double r_eff, double m_eff,
						double speed)
{
	/* F = K delta^(3/2): at delta = 1 the tangent is 3/2 K */
	double stiffness = ts_granular_constants_at(m, c, r_eff, m_eff, 1).kn / 1.5;

	return pow(1.25 * m_eff * speed * speed / stiffness, 0.4);
}

/* Rayleigh time; shear modulus and Poisson's ratio of the material of the sphere. */
static inline double ts_rayleigh_time(double radius, double density, double shear, double nu)
{
	return TS_PI * radius * sqrt(density / shear) / (0.1631 * nu + 0.8766);
}

/* Duration of an elastic Hertz collision; young: Y* of both partners. */
static inline double ts_hertz_time(double r_eff, double m_eff, double young, double speed)
{
	return 2.87 * pow(m_eff * m_eff / (r_eff * young * young * speed), 0.2);
}

#endif
