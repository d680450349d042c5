#include "impact/exact_collision.h"

#include <math.h>
#include <string.h>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

#include "base/alloc.h"
#include "law/granular_force.h"
#include "law/granular_limit.h"

#include "base/banned.h"

/* The state, with d tangential dimensions: z, q', t; then d numbers each of v, w, xi, shift; slip path, work. While
 * the contact slides in two dimensions, xi is replaced by the angle of e; in one, by e = +-1. */
enum { Z, U, TIME, TANGENTIAL, MOST = TANGENTIAL + 4 * 2 + 2 };
enum mode { STICK, SLIDE };

/* Largest estimated error of a step, relative to the scale of each number: that of the embedded scheme of order 7, the
 * state of order 8 is better by some powers of ten; largest number of steps and of changes of mode. */
static const double TOLERANCE = 2e-10;
/* Friction below this part of the usual one has no effect on the motion, so the time in which its direction turns need
 * not be as short as the law has it. */
static const double NEGLIGIBLE = 1e-6;
/* Factor of the tolerance of slip path and work. */
static const double LESS_PRECISE = 1e4;
/* If stick and slide both end at once - the dashpot, which acts on contacts that stick alone, can bring that about -
 * the motion follows the limit between them. Then slide is left only when s.e is below r' by a margin, in units of the
 * speed of approach, which grows with the number of changes. */
static const double MARGIN = 1e-6, MARGIN_GROWS = 1.05;
enum { FEW_CHANGES = 10 };
/* Nodes and weights of Gauss' quadrature on (-1, 1) in each step. */
enum { NODES = 3 };
static const double gauss[NODES][2] = { { -0.77459666924148337704, 5.0 / 9 },
					{ 0, 8.0 / 9 },
					{ 0.77459666924148337704, 5.0 / 9 } };
/* Steps shorter than this part of z/(dz/dsigma) at the largest overlap have one node: where slip turns they are many. */
static const double SHORT = 0.002;
enum { STEPS_MOST = 20000, CHANGES_MOST = 200, HALVINGS = 60 };

struct ts_collision_solver {
	gsl_odeiv2_step *step[3]; /* by number of tangential dimensions */
};

struct motion {
	const struct ts_granular_pair *law;
	struct ts_granular_model model;
	struct ts_touch *touch; /* overlap, distance and speed are set by each evaluation */
	double inertia;		/* I */
	int power;		/* p: q = z^p */
	int d;			/* tangential dimensions */
	double kappa, damping;	/* k ~ q^kappa, gamma ~ q^damping */
	enum mode mode;
	double margin; /* velocity */
	double sign;   /* of F_n */
	double scale[MOST];
	double elongation;  /* scale of xi */
	double least_limit; /* of friction, in the rate at which its direction turns */
	double peak_force, peak_overlap;
	double slips; /* sign of the slip along the axis before it reverses */
	/* axes of the tangential dimensions, and the initial v and w along them */
	double axis[2][3];
};

/* Forces at one moment. */
struct moment {
	struct ts_normal n;
	double q, u, rate; /* rate: dt/dsigma */
	double lever, arm;
	double slip[2], force[2], xi[2]; /* force: F_t; xi: the derivative in time */
};

static size_t size_of(const struct motion *o)
{
	return TANGENTIAL + (o->d ? 4 * (size_t)o->d + 2 : 0);
}

const char *ts_collision_unsupported(const struct ts_granular_model *m)
{
	if (m->normal < TS_NORMAL_SPRING || m->normal > TS_NORMAL_HERTZ_STIFFNESS)
		return "the normal law must be hooke, hertz, hooke/stiffness or hertz/stiffness";
	if (m->tangential > TS_TANGENTIAL_NO_HISTORY)
		return "the tangential law must be off, no_history or history";
	if (m->cohesion != TS_COHESION_OFF)
		return "it has no cohesion";
	if (m->rolling != TS_ROLLING_OFF || m->twisting != TS_TWISTING_OFF)
		return "it has no rolling friction";
	if (m->viscous)
		return "the restitution must not depend on a fluid (viscous)";
	return m->multi ? "contacts must not influence each other (fix multicontact/halfspace)" : NULL;
}

struct ts_collision_solver *ts_collision_solver_new(void)
{
	struct ts_collision_solver *s = ts_alloc(1, sizeof *s);
	gsl_error_handler_t *handler = gsl_set_error_handler_off();
	bool good = s != NULL;

	for (int d = 0; good && d < 3; d++) {
		s->step[d] =
			gsl_odeiv2_step_alloc(gsl_odeiv2_step_rk8pd, size_of(&(struct motion){ .d = d }));
		good = s->step[d] != NULL;
	}
	gsl_set_error_handler(handler);
	if (good)
		return s;
	ts_collision_solver_free(s);
	return NULL;
}

void ts_collision_solver_free(struct ts_collision_solver *s)
{
	for (int d = 0; s && d < 3; d++)
		if (s->step[d])
			gsl_odeiv2_step_free(s->step[d]);
	ts_free(s);
}

/* ---- forces ---- */

static double overlap_of(const struct motion *o, double z)
{
	return o->power == 1 ? z : o->power == 2 ? z * z : z * z * z * z;
}

static double length2(const double a[2], int d)
{
	return d == 2 ? sqrt(a[0] * a[0] + a[1] * a[1]) : fabs(a[0]);
}

/* Tangential force in the present mode, and the rate of what describes the spring. `x`: that part of the state. */
static void tangential_force(const struct motion *o, const double *x, struct moment *m)
{
	double limit = o->law->friction * o->sign * m->n.limit, speed, e[2] = { x[0], 0 };

	if (o->model.tangential == TS_TANGENTIAL_NO_HISTORY) {
		speed = length2(m->slip, o->d);
		for (int k = 0; k < o->d; k++)
			m->force[k] = -m->slip[k] * (o->mode == STICK ? m->n.gammat
						     : speed > 0      ? limit / speed
								      : 0);
	} else if (o->mode == STICK) {
		for (int k = 0; k < o->d; k++) {
			m->force[k] = -m->n.kt * x[k] - m->n.gammat * m->slip[k];
			m->xi[k] = m->slip[k];
		}
	} else {
		if (o->d == 2) {
			e[0] = cos(x[0]);
			e[1] = sin(x[0]);
			m->xi[0] = (m->slip[1] * e[0] - m->slip[0] * e[1]) * m->n.kt /
				   fmax(limit, o->least_limit);
		}
		for (int k = 0; k < o->d; k++)
			m->force[k] = -limit * e[k];
	}
}

static void evaluate(const struct motion *o, const double *y, struct moment *m)
{
	const double *v = y + TANGENTIAL, *w = v + o->d, *x = w + o->d;
	struct ts_touch *t = o->touch;
	double none = 0;

	*m = (struct moment){ .q = overlap_of(o, y[Z]), .u = y[U] };
	m->rate = o->power == 1 ? 1 : o->power == 2 ? y[Z] : y[Z] * y[Z] * y[Z];
	t->overlap = m->q;
	t->distance = t->radius[0] - m->q;
	t->vn = -m->u;
	ts_normal_force(&o->model, o->law, t, false, &none, &m->n);
	ts_granular_arms(&o->model, t);
	m->lever = t->lever[0];
	m->arm = t->arm[0];
	for (int k = 0; k < o->d; k++)
		m->slip[k] = v[k] + m->lever * w[k];
	if (o->d)
		tangential_force(o, x, m);
}

static int derivative(double sigma, const double y[], double dy[], void *context)
{
	const struct motion *o = context;
	double *v = dy + TANGENTIAL, *w = v + o->d, *x = w + o->d, *shift = x + o->d, *sums = shift + o->d;
	struct moment m;

	(void)sigma;
	evaluate(o, y, &m);
	dy[Z] = m.u / o->power;
	dy[U] = -m.n.force / o->touch->m_eff * m.rate;
	dy[TIME] = m.rate;
	for (int k = 0; k < o->d; k++) {
		v[k] = m.force[k] / o->touch->m_eff * m.rate;
		w[k] = m.arm * m.force[k] / o->inertia * m.rate;
		x[k] = m.xi[k] * m.rate;
		shift[k] = y[TANGENTIAL + k] * m.rate;
	}
	if (o->d) {
		sums[0] = length2(m.slip, o->d) * m.rate;
		sums[1] = -(m.force[0] * m.slip[0] + m.force[1] * m.slip[1]) * m.rate;
	}
	return GSL_SUCCESS;
}

/* dF_n/dt of F_n = k q + gamma u: (1 + kappa) k u + gamma (damping u^2/q + u'), u' = -F_n/m. */
static double force_rate(const struct motion *o, const struct moment *m)
{
	double stretch = o->damping > 0 ? o->damping * m->u * m->u / m->q : 0;

	return (1 + o->kappa) * m->n.kn * m->u + m->n.gamman * (stretch - m->n.force / o->touch->m_eff);
}

/* ---- functions of the state whose sign changes from - to + are located */

typedef double event_fn(const struct motion *o, const double *y);

static double parts(const struct motion *o, const double *y)
{
	(void)o;
	return -y[Z];
}

static double turns_back(const struct motion *o, const double *y)
{
	(void)o;
	return -y[U];
}

static double changes_sign(const struct motion *o, const double *y)
{
	struct moment m;

	evaluate(o, y, &m);
	return -o->sign * m.n.force;
}

static double force_falls(const struct motion *o, const double *y)
{
	struct moment m;

	evaluate(o, y, &m);
	return m.q > 0 || !(o->damping > 0) ? -force_rate(o, &m) : -1;
}

/* In one dimension. */
static double slip_reverses(const struct motion *o, const double *y)
{
	struct moment m;

	evaluate(o, y, &m);
	return -o->slips * m.slip[0];
}

/* Leaves the present mode of the tangential force. k_t r' = mu |F_n|' - mu |F_n| kappa u/q. */
static double changes_mode(const struct motion *o, const double *y)
{
	const double *x = y + TANGENTIAL + 2 * (ptrdiff_t)o->d;
	double limit, along, grows;
	struct moment m;

	evaluate(o, y, &m);
	limit = o->law->friction * o->sign * m.n.limit;
	if (o->model.tangential == TS_TANGENTIAL_NO_HISTORY)
		return (o->mode == STICK ? 1 : -1) * (m.n.gammat * length2(m.slip, o->d) - limit);
	if (o->mode == STICK)
		return m.n.kt * length2(x, o->d) - limit;
	along = o->d == 2 ? m.slip[0] * cos(x[0]) + m.slip[1] * sin(x[0]) : m.slip[0] * x[0];
	grows = o->law->friction * o->sign * force_rate(o, &m);
	return grows - (o->kappa > 0 ? limit * o->kappa * m.u / m.q : 0) - m.n.kt * (along + o->margin);
}

/* ---- steps ---- */

struct stepper {
	struct motion *o;
	gsl_odeiv2_step *step;
	gsl_odeiv2_system system;
};

/* The state `to` after a step sigma from `from`; returns the largest relative error. */
static double make_step(const struct stepper *s, const double *from, double sigma, double *to)
{
	double error[MOST], worst = 0;
	size_t n = size_of(s->o);

	memcpy(to, from, n * sizeof *to);
	if (gsl_odeiv2_step_apply(s->step, 0, sigma, to, error, NULL, NULL, &s->system) != GSL_SUCCESS)
		return INFINITY;
	for (size_t k = 0; k < n; k++) {
		double e = fabs(error[k]) / s->o->scale[k];

		worst = e <= worst ? worst : e;
	}
	return worst;
}

/* The factor by which regula falsi reduces the value at the end of the interval that stays, if the root is found on the
 * same side of it twice: N. Anderson, A. Bjorck, BIT 13 (1973) 253. */
static double reduction(double now, double before)
{
	double factor = 1 - now / before;

	return factor > 0 ? factor : 0.5;
}

/* The step up to which `event` changes its sign within the step *sigma; `to` becomes the state there, where event >= 0.
 * `precision`: of the step, relative. */
static void locate(const struct stepper *s, event_fn *event, const double *from, double precision,
		   double *sigma, double *to)
{
	double lo = 0, hi = *sigma, f = event(s->o, from), g = event(s->o, to), y[MOST];
	double least = 0.5 * precision * hi;
	int side = 0; /* of the root, of the last state: -1 before, 1 beyond */

	if (!(f < 0) || isinf(f))
		f = -g;
	for (int k = 0; k < HALVINGS && hi - lo > 2 * least; k++) {
		double at = lo + (hi - lo) * f / (f - g), held;

		/* one end stays as the other converges; a step across the root closes the interval */
		if (!(at >= lo + least))
			at = lo + least;
		if (at > hi - least)
			at = hi - least;
		make_step(s, from, at, y);
		held = event(s->o, y);
		if (held >= 0) {
			f *= side > 0 ? reduction(held, g) : 1;
			hi = at;
			g = held;
			memcpy(to, y, sizeof y);
		} else {
			g *= side < 0 ? reduction(held, f) : 1;
			lo = at;
			f = held;
		}
		side = held >= 0 ? 1 : -1;
		if (held == 0)
			break;
	}
	*sigma = hi;
}

static void record_peaks(const struct stepper *s, const double *from, double sigma, const double *to)
{
	/* the maximum is flat: its error is the square of that of the time */
	static const double PRECISION = 1e-5;
	struct motion *o = s->o;
	double y[MOST], part = sigma;
	struct moment m;

	evaluate(o, to, &m);
	o->peak_force = fmax(o->peak_force, m.n.force);
	o->peak_overlap = fmax(o->peak_overlap, m.q);
	if (turns_back(o, from) < 0 && turns_back(o, to) >= 0) {
		memcpy(y, to, sizeof y);
		locate(s, turns_back, from, PRECISION, &part, y);
		o->peak_overlap = fmax(o->peak_overlap, overlap_of(o, y[Z]));
	}
	if (force_falls(o, from) < 0 && force_falls(o, to) >= 0) {
		memcpy(y, to, sizeof y);
		part = sigma;
		locate(s, force_falls, from, PRECISION, &part, y);
		evaluate(o, y, &m);
		o->peak_force = fmax(o->peak_force, m.n.force);
	}
}

/* ---- modes ---- */

/* Shortly after F_n has been 0, the spring being xi = s tau: whether it would exceed the limit. */
static void choose_mode(struct motion *o, const double *y, double tau)
{
	double early[MOST], *x = early + TANGENTIAL + 2 * (ptrdiff_t)o->d;
	struct moment m;

	memcpy(early, y, sizeof early);
	o->mode = STICK;
	evaluate(o, y, &m);
	for (int k = 0; k < o->d; k++)
		x[k] = m.slip[k] * tau;
	o->mode = changes_mode(o, early) > 0 ? SLIDE : STICK;
}

/* Scales of the errors of the numbers that describe the spring, which depend on the mode. */
static void scale_spring(struct motion *o)
{
	for (int k = 0; k < o->d; k++)
		o->scale[TANGENTIAL + 2 * o->d + k] = o->mode == SLIDE ? 1 : o->elongation;
}

/* Replaces the description of the spring by that of the mode; e: direction of the spring. */
static void set_direction(const struct motion *o, double *x, const double e[2])
{
	x[0] = o->d == 2 ? atan2(e[1], e[0]) : e[0] < 0 ? -1 : 1;
	if (o->d == 2)
		x[1] = 0;
}

static void enter_other_mode(struct motion *o, double *y)
{
	double *x = y + TANGENTIAL + 2 * (ptrdiff_t)o->d, e[2], r;
	struct moment m;

	evaluate(o, y, &m);
	o->mode = o->mode == STICK ? SLIDE : STICK;
	if (o->model.tangential == TS_TANGENTIAL_NO_HISTORY)
		return;
	if (o->mode == SLIDE) {
		set_direction(o, x, (double[2]){ x[0], o->d == 2 ? x[1] : 0 });
		return;
	}
	r = m.n.kt > 0 ? o->law->friction * o->sign * m.n.limit / m.n.kt : 0;
	e[0] = o->d == 2 ? cos(x[0]) : x[0];
	e[1] = sin(x[0]);
	for (int k = 0; k < o->d; k++)
		x[k] = r * e[k];
}

/* The normal force has become a pull, for a law that does not limit it: the spring, which friction has shortened to
 * nothing, begins anew. */
static void begin_pull(struct motion *o, double *y)
{
	double *x = y + TANGENTIAL + 2 * (ptrdiff_t)o->d, early[MOST], tau = 1e-6 * o->scale[TIME];
	struct moment m;

	o->sign = -1;
	for (int k = 0; k < o->d; k++)
		x[k] = 0;
	if (!o->d)
		return;
	memcpy(early, y, sizeof early);
	early[Z] = pow(fmax(overlap_of(o, y[Z]) + tau * y[U], 0), 1.0 / o->power);
	choose_mode(o, early, tau);
	evaluate(o, y, &m);
	if (o->mode == SLIDE && o->model.tangential == TS_TANGENTIAL_HISTORY)
		set_direction(o, x, m.slip);
}

/* Velocity, spin and displacement along the surface in the state y. */
static void find_motion(const struct motion *o, const struct ts_collision *c, const double *start,
			const double *y, double velocity[3], double omega[3], double shift[3])
{
	const double *v = y + TANGENTIAL, *w = v + o->d, *moved = w + 2 * (ptrdiff_t)o->d;

	ts_scale(1, c->velocity, velocity);
	ts_axpy(start[U] - y[U], c->n, velocity);
	ts_scale(1, c->omega, omega);
	ts_scale(y[TIME], c->velocity, shift);
	ts_project(c->n, shift);
	for (int k = 0; k < o->d; k++) {
		double torque[3];

		/* w = n x omega, so omega changes by w x n */
		ts_axpy(v[k] - start[TANGENTIAL + k], o->axis[k], velocity);
		ts_cross(o->axis[k], c->n, torque);
		ts_axpy(w[k] - start[TANGENTIAL + o->d + k], torque, omega);
		ts_axpy(moved[k] - y[TIME] * start[TANGENTIAL + k], o->axis[k], shift);
	}
}

/* ---- quadrature over the collision ---- */

/* What the nodes are computed from. */
struct record {
	const struct ts_collision *c;
	const double *start;
	bool full; /* no memory */
};

/* Nodes in the part of a step from sigma = lo to hi. */
static void add_nodes(const struct stepper *s, struct record *r, const double *from, double lo, double hi,
		      bool is_short)
{
	struct ts_contact_nodes *nodes = r->c->nodes;
	double half = 0.5 * (hi - lo);

	if (TS_GROW(nodes->item, nodes->capacity, nodes->n + NODES) != TS_OK) {
		r->full = true;
		return;
	}
	for (int k = is_short ? NODES / 2 : 0; k < (is_short ? NODES / 2 + 1 : NODES); k++) {
		struct ts_contact_node *to = &nodes->item[nodes->n];
		struct moment m;
		double y[MOST];

		make_step(s, from, lo + half * (1 + gauss[k][0]), y);
		evaluate(s->o, y, &m);
		if (!(m.rate > 0))
			continue;
		*to = (struct ts_contact_node){ .time = y[TIME],
						.duration = (is_short ? 2 : gauss[k][1]) * half * m.rate,
						.overlap = m.q };
		find_motion(s->o, r->c, r->start, y, to->velocity, to->omega, to->shift);
		ts_scale(m.n.force, r->c->n, to->force);
		for (int d = 0; d < s->o->d; d++)
			ts_axpy(m.force[d], s->o->axis[d], to->force);
		nodes->n++;
	}
}

/* Nodes in the step sigma from `from` to `to`: before and after a reversal of the slip. */
static void record_nodes(const struct stepper *s, struct record *r, const double *from, double sigma,
			 const double *to)
{
	bool is_short = sigma < SHORT * s->o->power * s->o->scale[Z] / s->o->scale[U];
	double y[MOST], at = sigma;

	s->o->slips = 1;
	if (s->o->d == 1 && slip_reverses(s->o, from) * slip_reverses(s->o, to) < 0) {
		s->o->slips = slip_reverses(s->o, from) < 0 ? 1 : -1;
		memcpy(y, to, sizeof y);
		locate(s, slip_reverses, from, 1e-8, &at, y);
	}
	add_nodes(s, r, from, 0, at, is_short);
	if (at < sigma && !r->full)
		add_nodes(s, r, from, at, sigma, is_short);
}

/* ---- the whole collision ---- */

/* Directions along the surface: that of the slip and, if the velocity of the centre and the rotation are not along it
 * both and the lever arms change, a second one. */
static void choose_axes(struct motion *o, const struct ts_collision *c, double *y)
{
	double along[3], turn[3], slip[3], speed, rim, v[2], w[2];

	ts_scale(1, c->velocity, along);
	ts_project(c->n, along);
	ts_cross(c->n, c->omega, turn);
	ts_scale(1, along, slip);
	ts_axpy(c->radius, turn, slip);
	speed = ts_norm(slip);
	rim = c->radius * ts_norm(turn);
	o->d = 0;
	if (o->model.tangential == TS_TANGENTIAL_OFF || !(c->law->friction > 0) || !(speed + rim > 0))
		return;
	if (!(speed > 1e-15 * rim)) { /* it rolls: slip begins as the lever arm changes */
		ts_scale(1, turn, slip);
		speed = ts_norm(slip);
	}
	ts_scale(1 / speed, slip, o->axis[0]);
	ts_cross(c->n, o->axis[0], o->axis[1]);
	o->d = o->model.full_slip || fabs(ts_dot(turn, o->axis[1])) * c->radius <= 1e-13 * speed ? 1 : 2;
	for (int k = 0; k < o->d; k++) {
		w[k] = ts_dot(turn, o->axis[k]);
		v[k] = ts_dot(along, o->axis[k]);
		y[TANGENTIAL + k] = v[k];
		y[TANGENTIAL + o->d + k] = w[k];
	}
}

static double speed_of_slip(const struct motion *o, const struct ts_collision *c, const double *y)
{
	double slip[2] = { 0, 0 };

	for (int k = 0; k < o->d; k++)
		slip[k] = y[TANGENTIAL + k] + c->radius * y[TANGENTIAL + o->d + k];
	return length2(slip, o->d);
}

/* Part e of the usual friction below which its direction may follow that of the slip more slowly than by the law. Fast
 * slip along a slow collision would else need many steps: x being friction times normal over tangential speed, the
 * direction follows within the part x q of the collision at the overlap q, relative to the largest. The slip turns at
 * the rate x F, F ~ q^(3/2) being the relative force, so friction of F = e is wrong by e (x e) (x e^(2/3)); it lasts
 * for e^(2/3) and has x of the momentum along the surface, which is wrong by x^3 e^(10/3). For e > 1, slower throughout:
 * x^3 e. This stays below SMALL. */
static double negligible(double x)
{
	static const double SMALL = 1e-13;
	double part = SMALL / (x * x * x);

	return fmax(part < 1 ? pow(part, 0.3) : part, NEGLIGIBLE);
}

/* Sets model, constants, scales of all numbers and the state at the touch. `touch`: memory. */
static void begin(struct motion *o, struct ts_touch *touch, const struct ts_collision *c, double *y)
{
	double u = -ts_dot(c->velocity, c->n), depth, speed, speeds, root;
	struct ts_normal n;

	*o = (struct motion){ .law = c->law, .model = *c->model, .touch = touch, .sign = 1 };
	o->model.no_tension = false;
	*o->touch = (struct ts_touch){ .wall = true,
				       .radius = { c->radius },
				       .mass = { c->mass },
				       .r_eff = c->r_eff,
				       .m_eff = c->mass,
				       .overlap = c->radius };
	if (o->model.normal == TS_NORMAL_HOOKE) {
		o->touch->solved = ts_hooke_stiffness(c->law, o->touch);
		o->model.solved = true;
	}
	o->inertia = c->inertia * c->mass * c->radius * c->radius;
	ts_normal_force(&o->model, c->law, o->touch, false, &(double){ 0 }, &n);
	if (ts_granular_stiffens(&o->model)) {
		depth = ts_granular_impact_overlap(&o->model, c->law, c->r_eff, c->mass, u);
		o->kappa = 0.5;
		o->damping = o->model.normal == TS_NORMAL_HERTZ ? 0.25 : o->model.absolute_damping ? 0 : 0.5;
		o->power = o->model.normal == TS_NORMAL_HERTZ && n.gamman > 0 ? 4 : 2;
	} else {
		depth = u * sqrt(c->mass / n.kn);
		o->power = 1;
	}
	memset(y, 0, MOST * sizeof *y);
	y[U] = u;
	choose_axes(o, c, y);
	root = o->power == 1 ? depth : pow(depth, 1.0 / o->power);
	speed = ts_norm(c->velocity) + c->radius * ts_norm(c->omega);
	speeds = fmax(speed, u);
	o->scale[Z] = root;
	o->scale[U] = u;
	o->scale[TIME] = depth / u;
	for (int k = 0; k < o->d; k++) {
		double *at = o->scale + TANGENTIAL + k;

		at[0] = speeds;
		at[o->d] = speeds / c->radius;
		at[3 * o->d] = speeds * depth / u;
	}
	o->elongation = speeds * depth / u;
	if (o->d) {
		o->least_limit = negligible(c->law->friction * u / (speed_of_slip(o, c, y) + u)) *
				 c->law->friction * c->mass * u * u / depth;
		/* nothing depends on these sums; |s| has a kink where slip reverses */
		o->scale[TANGENTIAL + 4 * o->d] = LESS_PRECISE * speeds * depth / u;
		o->scale[TANGENTIAL + 4 * o->d + 1] = LESS_PRECISE * c->mass * speeds * speeds;
	}
}

static void choose_first_mode(struct motion *o, double *y)
{
	static const double EARLY = 1e-9; /* of the largest overlap */
	double at[MOST], depth = EARLY * overlap_of(o, o->scale[Z]);
	struct moment m;

	evaluate(o, y, &m);
	o->peak_force = m.n.force; /* a linear dashpot may be strongest at the touch */
	if (!o->d)
		return;
	memcpy(at, y, sizeof at);
	at[Z] = o->power == 1 ? depth : pow(depth, 1.0 / o->power);
	choose_mode(o, at, depth / y[U]);
	if (o->mode == SLIDE && o->model.tangential == TS_TANGENTIAL_HISTORY)
		set_direction(o, y + TANGENTIAL + 2 * (ptrdiff_t)o->d, m.slip);
}

/* What a step has led to. */
enum outcome { GOES_ON, CHANGES_MODE, PULLS, PARTS };

/* Cuts the step *sigma from `y` to `to` at the first event in it. */
static enum outcome cut_step(const struct stepper *s, const double *y, double *sigma, double *to)
{
	/* other events are looked for up to shortly before the surfaces part, where all forces are 0 */
	static const double SHORTLY = 1e-7;
	const struct motion *o = s->o;
	enum outcome outcome = GOES_ON;
	double cut = *sigma, seen[MOST];

	if (to[Z] <= 0) {
		outcome = PARTS;
		locate(s, parts, y, 1e-12, sigma, to);
		cut = (1 - SHORTLY) * *sigma;
		make_step(s, y, cut, seen);
	} else {
		memcpy(seen, to, sizeof seen);
	}
	if (o->sign > 0 && seen[U] < 0 && changes_sign(o, seen) >= 0) {
		outcome = PULLS;
		locate(s, changes_sign, y, 1e-12, &cut, seen);
	}
	if (o->d && changes_mode(o, seen) > 0) {
		outcome = CHANGES_MODE;
		locate(s, changes_mode, y, 1e-12, &cut, seen);
	}
	if (outcome == PULLS || outcome == CHANGES_MODE) {
		*sigma = cut;
		memcpy(to, seen, sizeof seen);
	}
	return outcome;
}

/* Free flight until the surfaces part, as no force pulls. */
static void fly(struct motion *o, double *y)
{
	double *v = y + TANGENTIAL, *sums = v + 4 * (ptrdiff_t)o->d, time, there[MOST];
	struct moment from, to;

	evaluate(o, y, &from);
	time = from.q / -y[U];
	memcpy(there, y, sizeof there);
	there[Z] = 0;
	evaluate(o, there, &to);
	y[Z] = 0;
	y[TIME] += time;
	for (int k = 0; k < o->d; k++)
		v[3 * o->d + k] += time * v[k];
	if (o->d)
		sums[0] += 0.5 * time * (length2(from.slip, o->d) + length2(to.slip, o->d));
}

static enum ts_collision_end advance(const struct stepper *s, double *y, struct record *record)
{
	const struct ts_collision *c = record->c;
	struct motion *o = s->o;
	double sigma = 0.1 * o->power * o->scale[Z] / o->scale[U], to[MOST];
	int changes = 0;

	for (int steps = 0; steps < STEPS_MOST && changes < CHANGES_MOST; steps++) {
		double error, factor, made = sigma;
		enum outcome outcome;

		scale_spring(o);
		error = make_step(s, y, sigma, to);
		factor = error > 0 ? 0.8 * pow(TOLERANCE / error, 0.125) : 5;

		sigma *= factor < 0.2 ? 0.2 : factor < 5 ? factor : isnan(factor) ? 0.2 : 5;
		if (!(error <= TOLERANCE))
			continue;
		outcome = cut_step(s, y, &made, to);
		record_peaks(s, y, made, to);
		if (c->nodes)
			record_nodes(s, record, y, made, to);
		if (record->full)
			return TS_COLLISION_NOMEM;
		memcpy(y, to, sizeof to);
		if (outcome == CHANGES_MODE) {
			enter_other_mode(o, y);
			if (++changes > FEW_CHANGES)
				o->margin = MARGIN * pow(MARGIN_GROWS, changes) * o->scale[U];
		} else if (outcome == PULLS && c->model->no_tension) {
			fly(o, y);
			outcome = PARTS;
		} else if (outcome == PULLS) {
			begin_pull(o, y);
		}
		if (outcome == PARTS)
			return y[TIME] <= c->longest ? TS_COLLISION_PARTS : TS_COLLISION_STAYS;
		if (!(y[TIME] <= c->longest))
			return TS_COLLISION_STAYS;
	}
	return TS_COLLISION_FAILS;
}

static void store_result(const struct motion *o, const struct ts_collision *c, const double *start,
			 const double *y, struct ts_collision_result *out)
{
	const double *sums = y + TANGENTIAL + 4 * (ptrdiff_t)o->d;

	*out = (struct ts_collision_result){ .duration = y[TIME],
					     .peak_force = o->peak_force,
					     .peak_overlap = o->peak_overlap,
					     .impulse = c->mass * (start[U] - y[U]),
					     .slip = o->d ? sums[0] : 0,
					     .work = o->d ? sums[1] : 0 };
	find_motion(o, c, start, y, out->velocity, out->omega, out->shift);
}

enum ts_collision_end ts_collision_compute(struct ts_collision_solver *solver, const struct ts_collision *c,
					   struct ts_collision_result *out)
{
	double start[MOST], y[MOST];
	struct record record = { c, start, false };
	size_t nodes = c->nodes ? c->nodes->n : 0;
	struct stepper s;
	enum ts_collision_end end;
	struct ts_touch touch;
	struct motion o;

	begin(&o, &touch, c, start);
	if (!(start[U] > 0) || !isfinite(o.scale[Z]))
		return TS_COLLISION_STAYS;
	memcpy(y, start, sizeof y);
	s = (struct stepper){ &o, solver->step[o.d], { derivative, NULL, size_of(&o), &o } };
	choose_first_mode(&o, y);
	end = advance(&s, y, &record);
	if (end == TS_COLLISION_PARTS)
		store_result(&o, c, start, y, out);
	else if (c->nodes)
		c->nodes->n = nodes;
	return end;
}
