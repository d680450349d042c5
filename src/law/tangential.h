/* Tangential contact laws.
 *
 *   history      a spring along the slip xi since the first contact: F_t = -k_t xi - gamma_t v_t; at the
 *                Coulomb limit mu |F_n| the spring alone, shortened to the limit, without damping (P. A.
 *                Cundall, O. D. L. Strack, Geotechnique 29 (1979) 47)
 *   incremental  like history, but the spring force P is stored: P <- (P - (P.n) n) - k_t v_t h with the
 *                current k_t; if k_t increases with the overlap, loading adds more force than unloading
 *                removes (C. Thornton, S. J. Cummins, P. W. Cleary, Powder Technol. 210 (2011) 189)
 *   slider       like history, but the limit applies to spring and dashpot together, and the spring is
 *                shortened to the part that the dashpot leaves of it (L. E. Silbert et al., Phys. Rev. E
 *                64 (2001) 051302; LAMMPS)
 *   no_history   F_t = -min(gamma_t, mu |F_n|/|v_t|) v_t
 *   linear, mindlin ...  law/tangential_turning.h
 *
 * xi is advanced by v_t h in each step and projected onto the contact plane. */
#ifndef TS_LAW_TANGENTIAL_H
#define TS_LAW_TANGENTIAL_H

#include "law/tangential_turning.h"

TS_INLINE void ts_tangential_history(const struct ts_granular_pair *c, const struct ts_touch *t,
				     const struct ts_normal *n, double step, double xi[3], double force[3])
{
	double limit = c->friction * fabs(n->limit), spring, factor, gamma;
	bool slides;

	ts_axpy(step, t->slip, xi);
	if (step > 0)
		ts_project(t->n, xi);
	spring = n->kt * ts_norm(xi);
	/* free of branches, so that the loop over contacts is vectorised */
	slides = spring > limit;
	factor = slides ? limit / spring : 1;
	gamma = slides ? 0 : n->gammat;
	for (int k = 0; k < 3; k++) {
		force[k] = -n->kt * factor * xi[k] - gamma * t->slip[k];
		xi[k] *= step > 0 ? factor : 1;
	}
}

TS_INLINE void ts_tangential_incremental(const struct ts_granular_pair *c, const struct ts_touch *t,
					 const struct ts_normal *n, double step, double spring[3],
					 double force[3])
{
	double limit = c->friction * fabs(n->limit), size, factor, gamma;
	bool slides;

	if (step > 0)
		ts_project(t->n, spring);
	ts_axpy(-n->kt * step, t->slip, spring);
	size = ts_norm(spring);
	/* free of branches, so that the loop over contacts is vectorised */
	slides = size > limit;
	factor = slides ? limit / size : 1;
	gamma = slides ? 0 : n->gammat;
	for (int k = 0; k < 3; k++) {
		force[k] = factor * spring[k] - gamma * t->slip[k];
		spring[k] *= step > 0 ? factor : 1;
	}
}

TS_INLINE void ts_tangential_slider(const struct ts_granular_pair *c, const struct ts_touch *t,
				    const struct ts_normal *n, double step, double xi[3], double force[3])
{
	double limit = c->friction * fabs(n->limit), size, factor;
	bool fresh;

	ts_axpy(step, t->slip, xi);
	fresh = xi[0] == 0 && xi[1] == 0 && xi[2] == 0;
	if (step > 0)
		ts_project(t->n, xi);
	for (int k = 0; k < 3; k++)
		force[k] = -(n->kt * xi[k] + n->gammat * t->slip[k]);
	size = ts_norm(force);
	if (size <= limit)
		return;
	factor = fresh ? 0 : limit / size;
	ts_scale(factor, force, force);
	for (int k = 0; k < 3 && n->kt > 0 && !fresh; k++)
		xi[k] = -(force[k] + n->gammat * t->slip[k]) / n->kt;
}

TS_INLINE void ts_tangential_no_history(const struct ts_granular_pair *c, const struct ts_touch *t,
					const struct ts_normal *n, double force[3])
{
	double limit = c->friction * fabs(n->limit), speed = ts_norm(t->slip), gamma = n->gammat;

	if (gamma * speed > limit)
		gamma = limit / speed;
	ts_scale(-gamma, t->slip, force);
}

TS_INLINE bool ts_tangential_remembers(const struct ts_granular_model *m)
{
	return m->tangential != TS_TANGENTIAL_OFF && m->tangential != TS_TANGENTIAL_NO_HISTORY;
}

/* Tangential force on i. `step`: time by which the history advances, 0 in the set-up of a run; *last:
 * radius of the contact area in the last step. */
TS_INLINE void ts_tangential_force(const struct ts_granular_model *m, const struct ts_granular_pair *c,
				   const struct ts_touch *t, const struct ts_normal *n, double step,
				   double *xi, double *last, double force[3])
{
	if (m->tangential == TS_TANGENTIAL_HISTORY)
		ts_tangential_history(c, t, n, step, xi, force);
	else if (m->tangential == TS_TANGENTIAL_INCREMENTAL)
		ts_tangential_incremental(c, t, n, step, xi, force);
	else if (m->tangential == TS_TANGENTIAL_SLIDER)
		ts_tangential_slider(c, t, n, step, xi, force);
	else if (m->tangential == TS_TANGENTIAL_NO_HISTORY)
		ts_tangential_no_history(c, t, n, force);
	else if (m->tangential >= TS_TANGENTIAL_LINEAR)
		ts_tangential_turning(m, c, t, n, step, xi, last, force);
	else
		force[0] = force[1] = force[2] = 0;
}

#endif
