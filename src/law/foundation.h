/* A sphere pressed on a point of a surface that yields along one axis, as the top of a column of a Winkler foundation: the
 * contact law and the spring k of the column in series. The point goes back by u >= 0, which the balance along the axis
 * gives:
 *
 *   k u = F(delta(u)) n_a(u),   d(u)^2 = r^2 + (h + u)^2,   delta = R - d,   n_a = (h + u)/d,
 *
 * F being the elastic force of the contact law, h and r the distances of the centre from the point at u = 0 along and across
 * the axis. So u minimises the energy U(delta(u)) + 1/2 k u^2, the force on the sphere is minus the gradient of this minimum,
 * and no energy is lost. On a top r = 0: delta + F/k is the overlap with the surface at u = 0. Without a component of the
 * normal along the axis, h <= 0, the point does not yield.
 *
 * There is one u > 0. It tends to 0 with h as long as F/r < k at h = 0; a softer column buckles under a particle at
 * its side, and the force has a jump there.
 *
 * The damping of the contact acts on the rate at which delta grows, d delta/dt = -(v_n + n_a du/dt); the rate du/dt follows
 * from the balance. */
#ifndef TS_LAW_FOUNDATION_H
#define TS_LAW_FOUNDATION_H

#include "law/granular_force.h"

/* Whether F is a function of delta alone, delta or delta^(3/2) times a constant of the contact. */
static inline bool ts_foundation_takes(const struct ts_granular_model *m)
{
	return m->normal >= TS_NORMAL_SPRING && m->normal <= TS_NORMAL_HERTZ_STIFFNESS && !m->multi &&
	       !m->located && m->cohesion == TS_COHESION_OFF;
}

struct ts_foundation {
	double stiffness;  /* k of the column, force/length */
	double h, r2, sum; /* h, r^2 and R of the sphere */
	/* at u */
	double u, distance, cosine; /* d, n_a */
	double force, slope;	    /* F; derivative of k u - F n_a by u */
	double contact;		    /* dF/d delta */
};

/* `t`: the contact at u = 0; its overlap and distance are overwritten. */
static inline double ts_foundation_at(struct ts_foundation *f, const struct ts_granular_model *m,
				      const struct ts_granular_pair *c, struct ts_touch *t, double u)
{
	bool hertz = m->normal == TS_NORMAL_HERTZ || m->normal == TS_NORMAL_HERTZ_STIFFNESS;
	double a = f->h + u, unused[TS_NORMAL_MEMORY] = { 0 };
	struct ts_normal n;

	f->u = u;
	f->distance = f->r2 > 0 ? sqrt(f->r2 + a * a) : a;
	f->cosine = a / f->distance;
	t->distance = f->distance;
	t->overlap = f->sum > f->distance ? f->sum - f->distance : 0;
	ts_normal_force(m, c, t, unused, &n);
	f->force = n.kn * t->overlap;
	f->contact = (hertz ? 1.5 : 1) * n.kn;
	f->slope = f->stiffness + f->contact * f->cosine * f->cosine -
		   f->force / f->distance * (1 - f->cosine * f->cosine);
	return f->stiffness * u - f->force * f->cosine;
}

/* Finds u by Newton's method in a bracket. `cosine` > 0: n_a at u = 0. */
static inline void ts_foundation_solve(struct ts_foundation *f, const struct ts_granular_model *m,
				       const struct ts_granular_pair *c, const struct ts_touch *touch,
				       double stiffness, double cosine)
{
	struct ts_touch t = *touch;
	double lo = 0, hi, u = 0;

	t.vn = 0;
	f->stiffness = stiffness;
	f->h = cosine * t.distance;
	f->r2 = cosine < 1 ? t.distance * t.distance * (1 - cosine * cosine) : 0;
	f->sum = t.distance + t.overlap;
	hi = sqrt(f->sum * f->sum - f->r2) - f->h;
	for (int k = 0; k < 100; k++) {
		double excess = ts_foundation_at(f, m, c, &t, u), next = u - excess / f->slope;

		if (fabs(next - u) <= 1e-14 * next)
			break;
		if (excess < 0)
			lo = u;
		else
			hi = u;
		u = next > lo && next < hi ? next : 0.5 * (lo + hi);
	}
}

/* du/dt of a sphere with the velocity v_n along the normal at u, and v_a along the axis, relative to the foundation. */
static inline double ts_foundation_rate(const struct ts_foundation *f, double vn, double va)
{
	double turn = f->force / f->distance * (va - f->cosine * vn);

	return f->slope > 0 ? (turn - f->contact * f->cosine * vn) / f->slope : 0;
}

#endif
