/* Number of abrasive particles that are active in chemical-mechanical polishing: pressed between pad and wafer. Of a
 * pad under a wafer of nominal area A_nom they take the area of real contact A_real, the volume of the gap, and the
 * volume of the asperities in contact; of the slurry the volume fraction phi and the mean radius a of the particles,
 * V_p = 4/3 pi a^3.
 *
 * Particle mono-layer (Y. Zhao, L. Chang, Wear 252 (2002) 220): the particles next to the wafer are eligible, active
 * those in the real contacts:
 *   N_all = phi V_gap/V_p,  lambda = (phi/V_p)^(1/3),  N_elig = lambda^2 A_nom,  N_act = lambda^2 A_real.
 *
 * Particle indentation (J. Luo, D. A. Dornfeld, IEEE Trans. Semicond. Manuf. 14 (2001) 112): the particles in the volume
 * of the asperities that touch are eligible; active those larger than the distance t between wafer and asperity, which
 * the largest particle, a_max, keeps apart. Its diameter is normally distributed with standard deviation s:
 *   N_all = phi V_gap/V_p,  N_elig = phi V_asp/V_p,  N_act = N_elig (1 - F(t)),  t = 2 a_max - D_wafer - D_pad.
 * The load on it is the pressure in the real contacts p on pi a_max^2; each solid yields under it at its hardness H over
 * the area 2 pi a_max D, so that D = p a_max/(2 H). The largest particle is 3 s larger in diameter than the mean. */
#ifndef TS_LAW_ACTIVE_PARTICLES_H
#define TS_LAW_ACTIVE_PARTICLES_H

#include <math.h>

#include "math/constants.h"

struct ts_slurry {
	double radius;	  /* mean of the particles, length */
	double deviation; /* standard deviation of their diameters, length */
	double fraction;  /* volume of particles per volume */
};

struct ts_polish_contact {
	double nominal_area, real_area; /* length^2 */
	double gap_volume;		/* between pad and wafer, length^3 */
	double asperity_volume;		/* that asperities in contact take of the slurry, length^3 */
	double pressure;		/* in the real contacts */
	double pad_hardness, wafer_hardness;
};

struct ts_active_particles {
	double all, eligible, active;
};

/* Particles per volume. */
static inline double ts_slurry_density(const struct ts_slurry *s)
{
	return s->fraction / (4.0 / 3 * TS_PI * s->radius * s->radius * s->radius);
}

static inline struct ts_active_particles ts_active_monolayer(const struct ts_slurry *s,
							     const struct ts_polish_contact *c)
{
	double density = ts_slurry_density(s), layer = cbrt(density) * cbrt(density);

	return (struct ts_active_particles){ density * c->gap_volume, layer * c->nominal_area,
					     layer * c->real_area };
}

/* Distance t between wafer and asperities. */
static inline double ts_active_distance(const struct ts_slurry *s, const struct ts_polish_contact *c)
{
	double largest = s->radius + 1.5 * s->deviation;

	return largest * (2 - c->pressure / (2 * c->wafer_hardness) - c->pressure / (2 * c->pad_hardness));
}

/* Part of the particles with a diameter > t. */
static inline double ts_active_part(const struct ts_slurry *s, double t)
{
	double excess = t - 2 * s->radius;

	return s->deviation > 0 ? 0.5 * erfc(excess / (sqrt(2) * s->deviation)) : excess < 0 ? 1 : 0;
}

static inline struct ts_active_particles ts_active_indentation(const struct ts_slurry *s,
							       const struct ts_polish_contact *c)
{
	double density = ts_slurry_density(s), eligible = density * c->asperity_volume;

	return (struct ts_active_particles){ density * c->gap_volume, eligible,
					     eligible * ts_active_part(s, ts_active_distance(s, c)) };
}

#endif
