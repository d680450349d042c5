/* Normal contact laws: F_n = k_n delta - gamma_n v_n along n, > 0 repulsive.
 *
 *   hertz   s = sqrt(R* delta), S_n = 2 Y* s, S_t = 8 G* s; k_n = 4/3 Y* s, k_t = S_t, gamma = -2
 *           sqrt(5/6) beta sqrt(S m*) (H. Hertz, J. reine angew. Math. 92 (1881) 156; damping: Y. Tsuji,
 *           T. Tanaka, T. Ishida, Powder Technol. 71 (1992) 239)
 *   hooke   k_n = 16/15 sqrt(R*) Y* (15 m* V^2/(16 sqrt(R*) Y*))^(1/5), k_t = k_n, gamma = sqrt(4 m*
 *           k_n/(1 + (pi/ln e)^2)): the linear spring with the largest overlap of hertz at the impact
 *           velocity V
 *   spring  k_n and gamma_n as given, or gamma_n by restitution (law/spring_dashpot.h); no tangential
 *           force
 *   hooke/stiffness, hertz/stiffness  k as given, gamma as given times m* (unless absolute_damping);
 *                                     hertz/stiffness: both times sqrt(R* delta)
 *   hooke/modulus     springs 4 R_i E_c of both grains in series, k_n = 4 E_c R*, k_t = k_n/kappa, gamma of hooke
 *                     (D. O. Potyondy, P. A. Cundall, Int. J. Rock Mech. Min. Sci. 41 (2004) 1329)
 *   edinburgh         elasto-plastic, with adhesion: law/edinburgh.h
 *   hooke/hysteresis  loading k_1 (k_n of hooke), unloading k_2 up to k_2max, adhesion k_c (O. R.
 *                     Walton, R. L. Braun, J. Rheol. 30 (1986) 949; S. Luding, Granul. Matter 10 (2008)
 *                     235) */
#ifndef TS_LAW_NORMAL_H
#define TS_LAW_NORMAL_H

#include <math.h>

#include "law/edinburgh.h"
#include "law/granular.h"
#include "law/lens.h"
#include "law/normal_area.h"
#include "law/touch.h"
#include "math/constants.h"
#include "math/power_fifth.h"

#define TS_SQRT_5_6 0.91287092917527685576

TS_INLINE double ts_hertz_root(const struct ts_granular_model *m, const struct ts_touch *t)
{
	return m->rooted && !t->wall ? t->solved : sqrt(t->r_eff * t->overlap);
}

TS_INLINE void ts_normal_hertz(const struct ts_granular_model *m, const struct ts_granular_pair *c,
			       const struct ts_touch *t, struct ts_normal *f)
{
	double s = ts_hertz_root(m, t), sn = 2 * c->young * s, st = 8 * c->shear * s;

	f->kn = 4.0 / 3.0 * c->young * s;
	f->kt = st;
	f->gamman = -2 * TS_SQRT_5_6 * c->damping * sqrt(sn * t->m_eff);
	/* sqrt(S_t/S_n) is constant for a pair of materials: the compiler moves it out of the loop */
	f->gammat = 2 * sqrt(c->shear / c->young) * f->gamman;
}

TS_INLINE double ts_hooke_stiffness(const struct ts_granular_pair *c, const struct ts_touch *t)
{
	double a = sqrt(t->r_eff) * c->young;

	return 16.0 / 15.0 * a * ts_power_fifth(15.0 / 16.0 * t->m_eff * c->velocity * c->velocity / a);
}

TS_INLINE double ts_hooke_damping(double kn, double mass, double log_restitution)
{
	double l2 = log_restitution * log_restitution;

	return sqrt(4 * mass * kn * l2 / (l2 + TS_PI * TS_PI));
}

/* Restitution of immersed particles by the Stokes number St: ln e = ln e_max + St_c/St (J. A. Simeonov,
 * J. Calantoni, Granul. Matter 14 (2012) 1). Bounded, as particles that touch may be at rest: e = 0 then. */
TS_INLINE double ts_viscous_log_restitution(const struct ts_granular_pair *c, const struct ts_touch *t)
{
	double stokes = t->m_eff * t->vn / (6 * TS_PI * c->viscosity * t->r_eff * t->r_eff);

	return fmax(-1e8, fmin(log(c->largest_restitution) + c->critical_stokes / stokes, 1e8));
}

TS_INLINE void ts_normal_hooke(const struct ts_granular_model *m, const struct ts_granular_pair *c,
			       const struct ts_touch *t, struct ts_normal *f)
{
	double log_e = m->viscous ? ts_viscous_log_restitution(c, t) : c->log_restitution;

	f->kn = m->solved ? t->solved : ts_hooke_stiffness(c, t);
	f->kt = m->tangential_stiffness_2_7 ? 0.285714286 * f->kn : f->kn;
	f->gamman = f->gammat = ts_hooke_damping(f->kn, t->m_eff, log_e);
}

TS_INLINE void ts_normal_given(const struct ts_granular_model *m, const struct ts_granular_pair *c,
			       const struct ts_touch *t, double factor, struct ts_normal *f)
{
	double damping = m->absolute_damping ? 1 : factor * t->m_eff;

	f->kn = factor * c->kn;
	f->kt = factor * c->kt;
	f->gamman = damping * c->gamman;
	f->gammat = damping * c->gammat;
}

TS_INLINE void ts_normal_modulus(const struct ts_granular_pair *c, const struct ts_touch *t,
				 struct ts_normal *f)
{
	f->kn = c->kn * t->r_eff;
	f->kt = c->kt * t->r_eff;
	f->gamman = f->gammat = ts_hooke_damping(f->kn, t->m_eff, c->log_restitution);
}

/* k_1 d^(n-1), the slope of the line to the loading branch. The damping of the model is that of a spring k_1 whatever n is,
 * in SI units. */
TS_INLINE void ts_normal_edinburgh(const struct ts_granular_pair *c, const struct ts_touch *t, double k1,
				   struct ts_normal *f)
{
	const double n = c->overlap_exponent, s = sqrt(t->r_eff * t->overlap);

	f->kn = k1 * pow(t->overlap, n - 1);
	f->kt = n == 1 ? 2 * c->young * s : 8 * c->shear * s;
	f->gamman = f->gammat = ts_hooke_damping(k1 * pow(c->metre, n - 1), t->m_eff, c->log_restitution);
}

/* Numbers that a normal law keeps in the history of a contact. */
enum { TS_NORMAL_MEMORY = TS_EDINBURGH_MEMORY }; /* at most */
TS_INLINE int ts_normal_memory(const struct ts_granular_model *m)
{
	return m->normal == TS_NORMAL_EDINBURGH ? (int)TS_EDINBURGH_MEMORY
						: m->normal == TS_NORMAL_HOOKE_HYSTERESIS;
}

/* Elastic force of hooke/hysteresis. *deepest: largest overlap so far. */
TS_INLINE double ts_hysteretic_force(const struct ts_granular_pair *c, const struct ts_touch *t, double k1,
				     double *deepest)
{
	double k2max = c->unloading * k1, kc = c->adhesion * k1, delta = t->overlap;
	double softening = k2max / (k2max - k1), deepest_now = *deepest > delta ? *deepest : delta, k2, force,
	       loading;
	double depth = softening * c->plasticity * 2 * t->r_eff; /* overlap from which on k_2 = k_2max */
	double full = k2max * (delta - depth) + k1 * depth, adhesion = -kc * delta;
	double faded = 0.5 * (delta + sqrt(delta * delta + 4 * (k1 + kc) * delta * depth / (k2max - k1)));

	/* free of branches, so that the loop over contacts is vectorised */
	k2 = k1 + (k2max - k1) * deepest_now / depth;
	force = k2 * (delta - deepest_now) + k1 * deepest_now;
	loading = k1 * delta;
	force = force < loading ? force : loading;
	force = deepest_now >= depth ? full : force;
	deepest_now = force < adhesion
			      ? faded
			      : deepest_now; /* on the adhesive branch the stored overlap decreases */
	force = force < adhesion ? adhesion : force;
	*deepest = deepest_now;
	return force;
}

/* `memory`: the TS_NORMAL_MEMORY numbers of the history, of which the law uses ts_normal_memory. */
TS_INLINE void ts_normal_force(const struct ts_granular_model *m, const struct ts_granular_pair *c,
			       const struct ts_touch *t, double *memory, struct ts_normal *f)
{
	double elastic;

	*f = (struct ts_normal){ 0 };
	switch (m->normal) {
	case TS_NORMAL_SPRING:
		*f = (struct ts_normal){ .kn = c->kn, .gamman = c->gamman };
		if (c->gamman_root != 0)
			f->gamman = c->gamman_root * sqrt(t->m_eff);
		if (m->fades)
			f->gamman *= 1 - pow(t->distance / (t->distance + t->overlap), 8);
		break;
	case TS_NORMAL_HERTZ:
		ts_normal_hertz(m, c, t, f);
		break;
	case TS_NORMAL_HOOKE:
	case TS_NORMAL_HOOKE_HYSTERESIS:
		ts_normal_hooke(m, c, t, f);
		break;
	case TS_NORMAL_HOOKE_STIFFNESS:
		ts_normal_given(m, c, t, 1, f);
		break;
	case TS_NORMAL_HOOKE_MODULUS:
		ts_normal_modulus(c, t, f);
		break;
	case TS_NORMAL_HERTZ_STIFFNESS:
		ts_normal_given(m, c, t, ts_hertz_root(m, t), f);
		break;
	case TS_NORMAL_EDINBURGH:
		ts_normal_edinburgh(c, t, ts_edinburgh_stiffness(c, t), f);
		break;
	case TS_NORMAL_AREA_HOOKE:
	case TS_NORMAL_AREA_HERTZ:
	case TS_NORMAL_AREA_DMT:
	case TS_NORMAL_AREA_JKR:
		ts_normal_area(m, c, t, f);
		break;
	default:
		break;
	}
	if (m->no_tangential_damping)
		f->gammat = 0;
	elastic = f->kn * t->overlap;
	if (m->normal == TS_NORMAL_HOOKE_HYSTERESIS)
		elastic = ts_hysteretic_force(c, t, f->kn, memory);
	if (m->normal == TS_NORMAL_EDINBURGH)
		elastic = c->pull_off + ts_edinburgh_force(c, t, ts_edinburgh_stiffness(c, t), memory);
	if (ts_normal_by_area(m))
		elastic = ts_normal_area_force(m, c, t, f);
	f->force = elastic - f->gamman * t->vn;
	if (m->no_tension)
		f->force = f->force > 0 ? f->force : 0;
	f->limit = f->force;
	if (m->normal == TS_NORMAL_AREA_DMT || m->normal == TS_NORMAL_AREA_JKR)
		f->limit = elastic + 2 * ts_pull_off_force(m, c, t->r_eff);
}

#endif
