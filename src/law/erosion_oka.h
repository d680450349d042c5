/* Erosion by hard particles, fitted to experiments (Y. I. Oka, K. Okamura, T. Yoshida, Wear 259 (2005)
 * 95; Y. I. Oka, T. Yoshida, ibid. 102): volume removed by a unit of mass at the impact speed V, diameter
 * D and angle alpha,
 *
 *   E = g E90,  E90 = K Hv^k1 (V/V')^k2 (D/D')^k3,  k2 = k2s Hv^k2q
 *   g = sin(alpha)^n1 (1 + Hv (1 - sin(alpha)))^n2,  n1 = s1 Hv^q1,  n2 = s2 Hv^q2
 *
 * with Hv, the Vickers hardness of the surface, in GPa, V in m/s, D in um, and E in mm^3/kg. The
 * functions take and return SI numbers: hardness in Pa, V in m/s, D in m, mass in kg, volume in m^3.
 *
 * The papers write (a Hv)^(k1 b) for Hv^k1, with the load relaxation (a Hv)^b of each metal measured. Its
 * inverse W = (a Hv)^-b may be given: 3 for carbon steel, 10 for stainless steel, 1000 for aluminium
 * (manual of EDEM). Without it a = b = 1.
 *
 * g is largest at sin(alpha) = n1 (1 + Hv)/(Hv (n1 + n2)), or at 90 degrees if that is not below 1.
 * Fitted to metals at speeds and sizes about V' and D': an extrapolation for plastics, ceramics, and
 * particles much smaller than D'.
 *
 * Compared with other programs: K, k1, k2, k3, V' and D' of the three sets agree with gemini_model
 * (erosion/correlation/OKA.py); K, s1, s2, q2, k1 to k3, V' and D' of SiO2 with the manual of EDEM, V',
 * D', k2 and k3 with that of Fluent for Hv = 1.8 GPa. s1, q1, s2, q2 of SiC and glass and q1 of SiO2 were
 * not found elsewhere. */
#ifndef TS_LAW_EROSION_OKA_H
#define TS_LAW_EROSION_OKA_H

#include "law/erosion.h"

/* Numbers of one kind of particle, in the units of the papers. */
struct ts_erosion_oka_set {
	double k;
	double k1, k2s, k2q, k3;
	double s1, q1, s2, q2;
	double velocity, diameter; /* V', D' */
};

enum ts_erosion_oka_particle { TS_OKA_SIO2, TS_OKA_SIC, TS_OKA_GLASS, TS_OKA_PARTICLES };

/* Angular silica sand, angular silicon carbide, glass beads. */
static inline struct ts_erosion_oka_set ts_erosion_oka_set_of(enum ts_erosion_oka_particle particle)
{
	static const struct ts_erosion_oka_set set[TS_OKA_PARTICLES] = {
		[TS_OKA_SIO2] = { 65, -0.12, 2.3, 0.038, 0.19, 0.71, 0.14, 2.4, -0.94, 104, 326 },
		[TS_OKA_SIC] = { 45, -0.05, 3.0, 0.085, 0.19, 0.71, 0.14, 2.8, -1.00, 99, 326 },
		[TS_OKA_GLASS] = { 27, -0.16, 2.1, 0, 0.19, 2.8, 0.41, 2.6, -1.46, 100, 200 },
	};

	return set[particle];
}

/* A set for one hardness, in SI units. */
struct ts_erosion_oka {
	double normal_rate; /* E90 at V' and D', m^3/kg */
	double hardness;    /* GPa */
	double n1, n2, k2, k3;
	double velocity, diameter; /* V', m/s; D', m */
};

/* hardness: Pa; relaxation: W, 0 for that of a = b = 1. */
static inline struct ts_erosion_oka ts_erosion_oka_of(const struct ts_erosion_oka_set *set, double hardness,
						      double relaxation)
{
	double hv = 1e-9 * hardness, load = relaxation > 0 ? 1 / relaxation : hv;

	return (struct ts_erosion_oka){ .normal_rate = 1e-9 * set->k * pow(load, set->k1),
					.hardness = hv,
					.n1 = set->s1 * pow(hv, set->q1),
					.n2 = set->s2 * pow(hv, set->q2),
					.k2 = set->k2s * pow(hv, set->k2q),
					.k3 = set->k3,
					.velocity = set->velocity,
					.diameter = 1e-6 * set->diameter };
}

/* g; s: sine of the impact angle. */
static inline double ts_erosion_oka_angle(const struct ts_erosion_oka *law, double s)
{
	return pow(s, law->n1) * pow(1 + law->hardness * (1 - s), law->n2);
}

/* Sine of the angle of the largest g. */
static inline double ts_erosion_oka_peak(const struct ts_erosion_oka *law)
{
	return fmin(law->n1 * (1 + law->hardness) / (law->hardness * (law->n1 + law->n2)), 1);
}

static inline double ts_erosion_oka_volume(const struct ts_erosion_oka *law,
					   const struct ts_erosion_impact *i)
{
	double speed = hypot(i->normal, i->tangential);

	if (i->normal <= 0)
		return 0;
	return i->mass * law->normal_rate * pow(speed / law->velocity, law->k2) *
	       pow(i->diameter / law->diameter, law->k3) * ts_erosion_oka_angle(law, i->normal / speed);
}

#endif
