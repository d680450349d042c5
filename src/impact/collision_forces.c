#include "impact/collision_forces.h"

#include "base/banned.h"

/* ---- forces ---- */

double ts_colliding_overlap(const struct ts_colliding *o, double z)
{
	return o->power == 1 ? z : o->power == 2 ? z * z : z * z * z * z;
}

double ts_colliding_force_rate(const struct ts_colliding *o, const struct ts_colliding_forces *m)
{
	double stretch = o->damping > 0 ? o->damping * m->u * m->u / m->q : 0;

	return (1 + o->kappa) * m->n.kn * m->u + m->n.gamman * (stretch - m->n.force / o->touch->m_eff);
}

struct ts_friction_limit ts_colliding_limit(const struct ts_colliding *o, const struct ts_colliding_forces *m)
{
	double mu = o->sign * o->law->friction, b = o->damping - o->kappa, u = m->u;
	double over = b < 0 || b > 0 ? u / m->q : 0; /* u/q */
	double du = -m->n.force / o->touch->m_eff, ddu = -ts_colliding_force_rate(o, m) / o->touch->m_eff;

	return (struct ts_friction_limit){
		.force = mu * m->n.limit,
		.rate = mu * (m->n.kn * u + m->n.gamman * (b * u * over + du)),
		.bend = mu * (m->n.kn * du + m->n.gamman * (b * over * ((b - 1) * u * over + 3 * du) + ddu))
	};
}

struct ts_friction_turn ts_colliding_turn(const struct ts_colliding *o, const double *x, const double e[2],
					  const struct ts_colliding_forces *m)
{
	struct ts_friction_limit r = ts_colliding_limit(o, m);
	const double *w = x - o->d;
	double along = 0, across = 0, spin = 0, slides;
	double yields = 1 / o->touch->m_eff + m->lever * m->arm / o->inertia;
	double shortens = m->q > 0 ? -m->u * (o->touch->radius[0] - m->lever) / m->q : 0; /* l' */

	for (int k = 0; k < o->d; k++) {
		along += m->slip[k] * e[k];
		spin += w[k] * e[k];
	}
	for (int k = 0; k < o->d; k++)
		across += (m->slip[k] - along * e[k]) * (m->slip[k] - along * e[k]);
	slides = shortens * spin - r.force * yields + m->n.kt * across / fmax(r.force, o->least_limit) -
		 r.bend / m->n.kt;
	return (struct ts_friction_turn){ slides, slides - m->n.gammat * yields * along };
}

/* Tangential force in the present mode, and the rate of what describes the spring. `x`: that part of the state. */
static void tangential_force(const struct ts_colliding *o, const double *x, struct ts_colliding_forces *m)
{
	double limit = o->law->friction * o->sign * m->n.limit, speed, alpha = 0, e[2];

	if (o->model.tangential == TS_TANGENTIAL_NO_HISTORY) {
		speed = ts_colliding_length(m->slip, o->d);
		for (int k = 0; k < o->d; k++)
			m->force[k] = -m->slip[k] * (o->mode == TS_STICK ? m->n.gammat
						     : speed > 0	 ? limit / speed
									 : 0);
		return;
	}
	if (o->mode == TS_STICK) {
		for (int k = 0; k < o->d; k++) {
			m->force[k] = -m->n.kt * x[k] - m->n.gammat * m->slip[k];
			m->xi[k] = m->slip[k];
		}
		return;
	}
	ts_colliding_direction(o->d, x, e);
	if (o->d == 2)
		m->xi[0] = (m->slip[1] * e[0] - m->slip[0] * e[1]) * m->n.kt / fmax(limit, o->least_limit);
	if (o->mode == TS_FOLLOW) { /* s.e = r' */
		m->turn = ts_colliding_turn(o, x, e, m);
		alpha = m->turn.slides / (m->turn.slides - m->turn.sticks);
	}
	for (int k = 0; k < o->d; k++)
		m->force[k] = -limit * e[k] - alpha * m->n.gammat * m->slip[k];
}

void ts_colliding_evaluate(const struct ts_colliding *o, const double *y, struct ts_colliding_forces *m)
{
	const double *v = y + TS_AT_TANGENTIAL, *w = v + o->d, *x = w + o->d;
	struct ts_touch *t = o->touch;
	double none[TS_NORMAL_MEMORY] = { 0 };

	*m = (struct ts_colliding_forces){ .q = ts_colliding_overlap(o, y[TS_AT_Z]), .u = y[TS_AT_U] };
	m->rate = o->power == 1 ? 1 : o->power == 2 ? y[TS_AT_Z] : y[TS_AT_Z] * y[TS_AT_Z] * y[TS_AT_Z];
	t->overlap = m->q;
	t->distance = t->radius[0] - m->q;
	t->vn = -m->u;
	ts_normal_force(&o->model, o->law, t, none, &m->n);
	ts_granular_arms(&o->model, t);
	m->lever = t->lever[0];
	m->arm = t->arm[0];
	for (int k = 0; k < o->d; k++)
		m->slip[k] = v[k] + m->lever * w[k];
	if (o->d)
		tangential_force(o, x, m);
}

void ts_colliding_derivative(const double *y, double *dy, const void *context)
{
	const struct ts_colliding *o = context;
	double *v = dy + TS_AT_TANGENTIAL, *w = v + o->d, *x = w + o->d, *shift = x + o->d,
	       *sums = shift + o->d;
	struct ts_colliding_forces m;

	ts_colliding_evaluate(o, y, &m);
	dy[TS_AT_Z] = m.u / o->power;
	dy[TS_AT_U] = -m.n.force / o->touch->m_eff * m.rate;
	dy[TS_AT_TIME] = m.rate;
	for (int k = 0; k < o->d; k++) {
		v[k] = m.force[k] / o->touch->m_eff * m.rate;
		w[k] = m.arm * m.force[k] / o->inertia * m.rate;
		x[k] = m.xi[k] * m.rate;
		shift[k] = y[TS_AT_TANGENTIAL + k] * m.rate;
	}
	if (o->d) {
		sums[0] = ts_colliding_length(m.slip, o->d) * m.rate;
		sums[1] = -(m.force[0] * m.slip[0] + m.force[1] * m.slip[1]) * m.rate;
	}
}
