/* Normal contact laws based on the radius a of the contact area; R the effective radius R*, m the
 * effective mass:
 *
 *   hooke  F_e = k delta,               k_a = k
 *   hertz  F_e = k a delta,             k_a = k a, a = sqrt(R delta); k = 4/3 E for elastic spheres
 *   dmt    F_e = k a delta - 4 pi w R,  k_a = k a, w the surface energy per area (B. V. Derjaguin, V. M.
 *          Muller, Y. P. Toporov, J. Colloid Interface Sci. 53 (1975) 314)
 *   jkr    F_e = 4 E a^3/(3 R) - 2 pi a^2 sqrt(4 w E/(pi a)),  k_a = k a,  delta = a^2/R - 2 sqrt(pi w
 *          a/E): after the first contact surfaces attract beyond touch, down to delta = -3/4 (pi^2 w^2
 *          R/E^2)^(1/3) 3^(1/3) (K. L. Johnson, K. Kendall, A. D. Roberts, Proc. R. Soc. Lond. A 324
 *          (1971) 301)
 *
 * Dashpots gamma_n = gamma_0 f, gamma_t = x gamma_n:
 *
 *   velocity           f = 1
 *   mass_velocity      f = m
 *   viscoelastic       f = a m (N. V. Brilliantov et al., Phys. Rev. E 53 (1996) 5382)
 *   tsuji              f = sqrt(m k_a), gamma_0 a polynomial of the restitution (Y. Tsuji, T. Tanaka, T.
 *                      Ishida, Powder Technol. 71 (1992) 239)
 *   coeff_restitution  f = sqrt(m k_a), gamma_0 = 2 beta for hooke, sqrt(5) beta for hertz, beta = -ln
 *                      e/sqrt(ln^2 e + pi^2): the restitution is e (D. Antypov, J. A. Elliott, EPL 94
 *                      (2011) 50004)
 *
 * k_t as given, or times a for the laws of Mindlin and those of LIGGGHTS. The friction of adhesive
 * surfaces is limited by F_e + 2 F_p, F_p the pull-off force, 4 pi w R (dmt) and 3 pi w R (jkr) (C.
 * Thornton, J. Phys. D 24 (1991) 1942). */
#ifndef TS_LAW_NORMAL_AREA_H
#define TS_LAW_NORMAL_AREA_H

#include <math.h>

#include "law/granular.h"
#include "law/lens.h"
#include "law/touch.h"
#include "math/constants.h"

struct ts_normal {
	double kn, kt, gamman, gammat;
	double force; /* F_n: elastic and damping part */
	double limit; /* normal force that limits friction */
	double area;  /* radius of the contact area, for laws based on it */
};

TS_INLINE bool ts_normal_by_area(const struct ts_granular_model *m)
{
	return m->normal >= TS_NORMAL_AREA_HOOKE;
}

/* Whether surfaces that have been in contact attract beyond touch. */
TS_INLINE bool ts_normal_sticks(const struct ts_granular_model *m)
{
	return m->normal == TS_NORMAL_AREA_JKR;
}

TS_INLINE double ts_pull_off_force(const struct ts_granular_model *m, const struct ts_granular_pair *c,
				   double r_eff)
{
	return (m->normal == TS_NORMAL_AREA_JKR ? 3 : 4) * TS_PI * c->surface_energy * r_eff;
}

/* E, where k = 4/3 E. */
TS_INLINE double ts_jkr_modulus(const struct ts_granular_pair *c)
{
	return 0.75 * c->kn;
}

/* Gap at which adhesive surfaces part: -delta at the smallest possible delta, where a^3 = 9/4 pi w
 * R^2/E. */
TS_INLINE double ts_jkr_reach(const struct ts_granular_pair *c, double r_eff)
{
	double q = TS_PI * c->surface_energy / ts_jkr_modulus(c), a = cbrt(2.25 * q * r_eff * r_eff);

	return 2 * sqrt(q * a) - a * a / r_eff;
}

/* The larger root a of delta = a^2/R - 2 sqrt(pi w a/E). s = sqrt(a) is a root of the convex function
 * s^4 - c s - R delta; Newton's method from above converges monotonically. */
struct ts_jkr_root {
	double slope, target; /* c, R delta */
	double s;
};

TS_INLINE double ts_jkr_slope(const struct ts_granular_pair *c, double r_eff)
{
	return 2 * r_eff * sqrt(TS_PI * c->surface_energy / ts_jkr_modulus(c));
}

/* Start value above the root; `root`: the cube root of c. */
TS_INLINE void ts_jkr_start(struct ts_jkr_root *r, double slope, double root, double target)
{
	*r = (struct ts_jkr_root){ slope, target, root + sqrt(sqrt(target > 0 ? target : 0)) };
}

/* One Newton step; returns whether it reduced s. Free of branches, so that the loop over contacts is
 * vectorised. */
TS_INLINE bool ts_jkr_step(struct ts_jkr_root *r)
{
	double s = r->s, s3 = s * s * s, steep = 4 * s3 - r->slope;
	double next = s - (s3 * s - r->slope * s - r->target) / steep;
	bool nearer = (steep > 0) & (next < s);

	r->s = nearer ? next : s;
	return nearer;
}

enum { TS_JKR_STEPS = 100 }; /* never reached */
TS_INLINE double ts_jkr_radius(const struct ts_granular_pair *c, double r_eff, double delta)
{
	double slope = ts_jkr_slope(c, r_eff);
	struct ts_jkr_root r;

	ts_jkr_start(&r, slope, cbrt(slope), r_eff * delta);
	for (int k = 0; k < TS_JKR_STEPS && ts_jkr_step(&r); k++)
		;
	return r.s * r.s;
}

TS_INLINE double ts_damping_factor(const struct ts_granular_model *m, const struct ts_touch *t,
				   const struct ts_normal *f)
{
	double root = sqrt(t->m_eff * f->kn);

	/* free of branches, so that the loop over contacts is vectorised */
	return m->damping == TS_DAMPING_MASS_VELOCITY  ? t->m_eff
	       : m->damping == TS_DAMPING_VISCOELASTIC ? f->area * t->m_eff
	       : m->damping >= TS_DAMPING_TSUJI	       ? root
						       : 1;
}

TS_INLINE void ts_normal_area(const struct ts_granular_model *m, const struct ts_granular_pair *c,
			      const struct ts_touch *t, struct ts_normal *f)
{
	*f = (struct ts_normal){ .kn = c->kn, .kt = c->kt };
	if (m->normal == TS_NORMAL_AREA_JKR)
		f->area = m->solved ? t->solved : ts_jkr_radius(c, t->r_eff, t->overlap);
	else
		f->area = sqrt(t->r_eff * t->overlap);
	if (m->normal != TS_NORMAL_AREA_HOOKE)
		f->kn *= f->area;
	if (m->tangential >= TS_TANGENTIAL_MINDLIN || m->tangential == TS_TANGENTIAL_HISTORY ||
	    m->tangential == TS_TANGENTIAL_INCREMENTAL)
		f->kt *= f->area;
	f->gamman = c->gamman * ts_damping_factor(m, t, f);
	f->gammat = c->gammat * f->gamman;
}

TS_INLINE double ts_normal_area_force(const struct ts_granular_model *m, const struct ts_granular_pair *c,
				      const struct ts_touch *t, const struct ts_normal *f)
{
	double a2 = f->area * f->area;

	if (m->normal == TS_NORMAL_AREA_JKR)
		return f->kn * a2 / t->r_eff -
		       2 * TS_PI * a2 * sqrt(4 * c->surface_energy * ts_jkr_modulus(c) / (TS_PI * f->area));
	if (m->normal == TS_NORMAL_AREA_DMT)
		return f->kn * t->overlap - ts_pull_off_force(m, c, t->r_eff);
	return f->kn * t->overlap;
}

#endif
