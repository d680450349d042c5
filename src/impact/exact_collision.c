#include "impact/exact_collision.h"

#include <math.h>
#include <string.h>

#include "base/alloc.h"
#include "impact/collision_forces.h"
#include "law/granular_limit.h"

#include "base/banned.h"

/* Largest estimated error of a step, relative to the scale of each number: that of the embedded scheme of order 7, the
 * state of order 8 is better by some powers of ten; largest number of steps and of changes of mode. */
static const double TOLERANCE = 2e-10;
/* Friction below this part of the usual one has no effect on the motion, so the time in which its direction turns need
 * not be as short as the law has it. */
static const double NEGLIGIBLE = 1e-6;
/* Factor of the tolerance of slip path and work. */
static const double LESS_PRECISE = 1e4;
/* Nodes and weights of Gauss' quadrature on (-1, 1) in each step. */
enum { NODES = 3 };
static const double gauss[NODES][2] = { { -0.77459666924148337704, 5.0 / 9 },
					{ 0, 8.0 / 9 },
					{ 0.77459666924148337704, 5.0 / 9 } };
/* Steps shorter than this part of z/(dz/dsigma) at the largest overlap have one node: where slip turns they are many. */
static const double SHORT = 0.002;
enum { STEPS_MOST = 20000, CHANGES_MOST = 200, HALVINGS = 60 };

static size_t size_of(const struct ts_colliding *o)
{
	return TS_AT_TANGENTIAL + (o->d ? 4 * (size_t)o->d + 2 : 0);
}

const char *ts_collision_unsupported(const struct ts_granular_model *m)
{
	if (m->normal < TS_NORMAL_SPRING || m->normal > TS_NORMAL_HERTZ_STIFFNESS)
		return "the normal law must be hooke, hertz, hooke/stiffness, hooke/modulus or "
		       "hertz/stiffness";
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

/* ---- functions of the state whose sign changes from - to + are located */

typedef double event_fn(const struct ts_colliding *o, const double *y);

static double parts(const struct ts_colliding *o, const double *y)
{
	(void)o;
	return -y[TS_AT_Z];
}

static double turns_back(const struct ts_colliding *o, const double *y)
{
	(void)o;
	return -y[TS_AT_U];
}

static double changes_sign(const struct ts_colliding *o, const double *y)
{
	struct ts_colliding_forces m;

	ts_colliding_evaluate(o, y, &m);
	return -o->sign * m.n.force;
}

static double force_falls(const struct ts_colliding *o, const double *y)
{
	struct ts_colliding_forces m;

	ts_colliding_evaluate(o, y, &m);
	return m.q > 0 || !(o->damping > 0) ? -ts_colliding_force_rate(o, &m) : -1;
}

/* In one dimension. */
static double slip_reverses(const struct ts_colliding *o, const double *y)
{
	struct ts_colliding_forces m;

	ts_colliding_evaluate(o, y, &m);
	return -o->slips * m.slip[0];
}

/* Direction of the spring. */
static void direction(const struct ts_colliding *o, const double *x, double e[2])
{
	double l = ts_colliding_length(x, o->d);

	if (o->mode != TS_STICK) {
		ts_colliding_direction(o->d, x, e);
		return;
	}
	e[0] = x[0] / l;
	e[1] = o->d == 2 ? x[1] / l : 0;
}

/* Leaves the present mode of the tangential force. With history: |xi| > r, or r' > s.e. */
static double changes_mode(const struct ts_colliding *o, const double *y)
{
	const double *x = y + TS_AT_TANGENTIAL + 2 * (ptrdiff_t)o->d;
	struct ts_friction_limit r;
	struct ts_colliding_forces m;
	double e[2];

	ts_colliding_evaluate(o, y, &m);
	if (o->mode == TS_FOLLOW)
		return fmax(m.turn.slides, -m.turn.sticks);
	r = ts_colliding_limit(o, &m);
	if (o->model.tangential == TS_TANGENTIAL_NO_HISTORY)
		return (o->mode == TS_STICK ? 1 : -1) *
		       (m.n.gammat * ts_colliding_length(m.slip, o->d) - r.force);
	if (o->mode == TS_STICK)
		return ts_colliding_length(x, o->d) - r.force / m.n.kt;
	direction(o, x, e);
	return r.rate / m.n.kt - m.slip[0] * e[0] - m.slip[1] * e[1];
}

/* The rate of changes_mode, with history, changes from growth to decay. */
static double change_recedes(const struct ts_colliding *o, const double *y)
{
	const double *x = y + TS_AT_TANGENTIAL + 2 * (ptrdiff_t)o->d;
	struct ts_colliding_forces m;
	double e[2];

	ts_colliding_evaluate(o, y, &m);
	direction(o, x, e);
	return o->mode == TS_STICK
		       ? ts_colliding_limit(o, &m).rate / m.n.kt - m.slip[0] * e[0] - m.slip[1] * e[1]
		       : ts_colliding_turn(o, x, e, &m).slides;
}

/* ---- steps ---- */

struct stepper {
	struct ts_colliding *o;
	struct ts_prince_dormand scheme; /* starts from the present state */
};

/* The state `to` after a step sigma from the present one; returns the largest relative error. */
static double make_step(struct stepper *s, double sigma, double *to)
{
	double error[TS_COLLIDING_MOST], worst = 0;

	ts_prince_dormand_step(&s->scheme, sigma, to, error);
	for (size_t k = 0; k < s->scheme.n; k++) {
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
static void locate(struct stepper *s, event_fn *event, double precision, double *sigma, double *to)
{
	double lo = 0, hi = *sigma, f = event(s->o, s->scheme.y), g = event(s->o, to), y[TS_COLLIDING_MOST];
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
		make_step(s, at, y);
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

static void record_peaks(struct stepper *s, double sigma, const double *to)
{
	/* the maximum is flat: its error is the square of that of the time */
	static const double PRECISION = 1e-5;
	struct ts_colliding *o = s->o;
	const double *from = s->scheme.y;
	double y[TS_COLLIDING_MOST], part = sigma;
	struct ts_colliding_forces m;

	ts_colliding_evaluate(o, to, &m);
	o->peak_force = fmax(o->peak_force, m.n.force);
	o->peak_overlap = fmax(o->peak_overlap, m.q);
	if (turns_back(o, from) < 0 && turns_back(o, to) >= 0) {
		memcpy(y, to, sizeof y);
		locate(s, turns_back, PRECISION, &part, y);
		o->peak_overlap = fmax(o->peak_overlap, ts_colliding_overlap(o, y[TS_AT_Z]));
	}
	if (force_falls(o, from) < 0 && force_falls(o, to) >= 0) {
		memcpy(y, to, sizeof y);
		part = sigma;
		locate(s, force_falls, PRECISION, &part, y);
		ts_colliding_evaluate(o, y, &m);
		o->peak_force = fmax(o->peak_force, m.n.force);
	}
}

/* ---- modes ---- */

/* Shortly after F_n has been 0, the spring being xi = s tau: whether it would exceed the limit. */
static void choose_mode(struct ts_colliding *o, const double *y, double tau)
{
	double early[TS_COLLIDING_MOST], *x = early + TS_AT_TANGENTIAL + 2 * (ptrdiff_t)o->d;
	struct ts_colliding_forces m;

	memcpy(early, y, sizeof early);
	o->mode = TS_STICK;
	ts_colliding_evaluate(o, y, &m);
	for (int k = 0; k < o->d; k++)
		x[k] = m.slip[k] * tau;
	o->mode = changes_mode(o, early) > 0 ? TS_SLIDE : TS_STICK;
}

/* Scales of the errors of the numbers that describe the spring, which depend on the mode. */
static void scale_spring(struct ts_colliding *o)
{
	for (int k = 0; k < o->d; k++)
		o->scale[TS_AT_TANGENTIAL + 2 * o->d + k] = o->mode == TS_STICK ? o->elongation : 1;
}

/* Replaces the description of the spring by that of the mode; e: direction of the spring. */
static void set_direction(const struct ts_colliding *o, double *x, const double e[2])
{
	x[0] = o->d == 2 ? atan2(e[1], e[0]) : e[0] < 0 ? -1 : 1;
	if (o->d == 2)
		x[1] = 0;
}

/* The mode after the present one, which ends in the state y. Where slide ends the contact sticks, unless stick would end
 * at once too: then it follows the limit between them. */
static enum ts_friction_mode next_mode(struct ts_colliding *o, const double *y)
{
	struct ts_colliding_forces m;

	if (o->mode == TS_STICK || o->model.tangential == TS_TANGENTIAL_NO_HISTORY)
		return o->mode == TS_STICK ? TS_SLIDE : TS_STICK;
	o->mode = TS_FOLLOW;
	ts_colliding_evaluate(o, y, &m);
	return m.turn.sticks <= 0 ? TS_STICK : m.turn.slides >= 0 ? TS_SLIDE : TS_FOLLOW;
}

static void enter_next_mode(struct ts_colliding *o, double *y)
{
	double *x = y + TS_AT_TANGENTIAL + 2 * (ptrdiff_t)o->d, e[2], r;
	enum ts_friction_mode before = o->mode;
	struct ts_colliding_forces m;

	o->mode = next_mode(o, y);
	if (o->model.tangential == TS_TANGENTIAL_NO_HISTORY)
		return;
	if (before == TS_STICK)
		set_direction(o, x, (double[2]){ x[0], o->d == 2 ? x[1] : 0 });
	if (o->mode != TS_STICK)
		return;
	ts_colliding_evaluate(o, y, &m);
	r = m.n.kt > 0 ? o->law->friction * o->sign * m.n.limit / m.n.kt : 0;
	ts_colliding_direction(o->d, x, e);
	for (int k = 0; k < o->d; k++)
		x[k] = r * e[k];
}

/* The normal force has become a pull, for a law that does not limit it: the spring, which friction has shortened to
 * nothing, begins anew. r' changes its sign; if it was the slip along e, then -e is the direction of the new spring, and
 * all three modes may go on. Where both stick and slide can, small steps take either; here the contact sticks. */
static void begin_pull(struct ts_colliding *o, double *y)
{
	double *x = y + TS_AT_TANGENTIAL + 2 * (ptrdiff_t)o->d, early[TS_COLLIDING_MOST],
	       tau = 1e-6 * o->scale[TS_AT_TIME];
	struct ts_colliding_forces m;

	o->sign = -1;
	for (int k = 0; k < o->d; k++)
		x[k] = 0;
	if (!o->d)
		return;
	ts_colliding_evaluate(o, y, &m);
	if (o->mode == TS_FOLLOW) {
		set_direction(o, x, m.slip);
		o->mode = next_mode(o, y);
	} else {
		memcpy(early, y, sizeof early);
		early[TS_AT_Z] =
			pow(fmax(ts_colliding_overlap(o, y[TS_AT_Z]) + tau * y[TS_AT_U], 0), 1.0 / o->power);
		choose_mode(o, early, tau);
		if (o->mode != TS_STICK && o->model.tangential == TS_TANGENTIAL_HISTORY)
			set_direction(o, x, m.slip);
	}
	if (o->mode == TS_STICK)
		x[0] = 0;
}

/* Velocity, spin and displacement along the surface in the state y. */
static void find_motion(const struct ts_colliding *o, const struct ts_collision *c, const double *start,
			const double *y, double velocity[3], double omega[3], double shift[3])
{
	const double *v = y + TS_AT_TANGENTIAL, *w = v + o->d, *moved = w + 2 * (ptrdiff_t)o->d;

	ts_scale(1, c->velocity, velocity);
	ts_axpy(start[TS_AT_U] - y[TS_AT_U], c->n, velocity);
	ts_scale(1, c->omega, omega);
	ts_scale(y[TS_AT_TIME], c->velocity, shift);
	ts_project(c->n, shift);
	for (int k = 0; k < o->d; k++) {
		double torque[3];

		/* w = n x omega, so omega changes by w x n */
		ts_axpy(v[k] - start[TS_AT_TANGENTIAL + k], o->axis[k], velocity);
		ts_cross(o->axis[k], c->n, torque);
		ts_axpy(w[k] - start[TS_AT_TANGENTIAL + o->d + k], torque, omega);
		ts_axpy(moved[k] - y[TS_AT_TIME] * start[TS_AT_TANGENTIAL + k], o->axis[k], shift);
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
static void add_nodes(struct stepper *s, struct record *r, double lo, double hi, bool is_short)
{
	struct ts_contact_nodes *nodes = r->c->nodes;
	double half = 0.5 * (hi - lo);

	if (TS_GROW(nodes->item, nodes->capacity, nodes->n + NODES) != TS_OK) {
		r->full = true;
		return;
	}
	for (int k = is_short ? NODES / 2 : 0; k < (is_short ? NODES / 2 + 1 : NODES); k++) {
		struct ts_contact_node *to = &nodes->item[nodes->n];
		struct ts_colliding_forces m;
		double y[TS_COLLIDING_MOST];

		make_step(s, lo + half * (1 + gauss[k][0]), y);
		ts_colliding_evaluate(s->o, y, &m);
		if (!(m.rate > 0))
			continue;
		*to = (struct ts_contact_node){ .time = y[TS_AT_TIME],
						.duration = (is_short ? 2 : gauss[k][1]) * half * m.rate,
						.overlap = m.q };
		find_motion(s->o, r->c, r->start, y, to->velocity, to->omega, to->shift);
		ts_scale(m.n.force, r->c->n, to->force);
		for (int d = 0; d < s->o->d; d++)
			ts_axpy(m.force[d], s->o->axis[d], to->force);
		nodes->n++;
	}
}

/* Nodes in the step sigma to `to`: before and after a reversal of the slip. */
static void record_nodes(struct stepper *s, struct record *r, double sigma, const double *to)
{
	const double *from = s->scheme.y;
	bool is_short = sigma < SHORT * s->o->power * s->o->scale[TS_AT_Z] / s->o->scale[TS_AT_U];
	double y[TS_COLLIDING_MOST], at = sigma;

	s->o->slips = 1;
	if (s->o->d == 1 && slip_reverses(s->o, from) * slip_reverses(s->o, to) < 0) {
		s->o->slips = slip_reverses(s->o, from) < 0 ? 1 : -1;
		memcpy(y, to, sizeof y);
		locate(s, slip_reverses, 1e-8, &at, y);
	}
	add_nodes(s, r, 0, at, is_short);
	if (at < sigma && !r->full)
		add_nodes(s, r, at, sigma, is_short);
}

/* ---- the whole collision ---- */

/* Directions along the surface: that of the slip and, if the velocity of the centre and the rotation are not along it
 * both and the lever arms change, a second one. */
static void choose_axes(struct ts_colliding *o, const struct ts_collision *c, double *y)
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
		y[TS_AT_TANGENTIAL + k] = v[k];
		y[TS_AT_TANGENTIAL + o->d + k] = w[k];
	}
}

static double speed_of_slip(const struct ts_colliding *o, const struct ts_collision *c, const double *y)
{
	double slip[2] = { 0, 0 };

	for (int k = 0; k < o->d; k++)
		slip[k] = y[TS_AT_TANGENTIAL + k] + c->radius * y[TS_AT_TANGENTIAL + o->d + k];
	return ts_colliding_length(slip, o->d);
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
static void begin(struct ts_colliding *o, struct ts_touch *touch, const struct ts_collision *c, double *y)
{
	double u = -ts_dot(c->velocity, c->n), depth, speed, speeds, root;
	struct ts_normal n;

	*o = (struct ts_colliding){ .law = c->law, .model = *c->model, .touch = touch, .sign = 1 };
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
	ts_normal_force(&o->model, c->law, o->touch, (double[TS_NORMAL_MEMORY]){ 0 }, &n);
	if (ts_granular_stiffens(&o->model)) {
		depth = ts_granular_impact_overlap(&o->model, c->law, c->r_eff, c->mass, u);
		o->kappa = 0.5;
		o->damping = o->model.normal == TS_NORMAL_HERTZ ? 0.25 : o->model.absolute_damping ? 0 : 0.5;
		o->power = o->model.normal == TS_NORMAL_HERTZ && n.gamman > 0 ? 4 : 2;
	} else {
		depth = u * sqrt(c->mass / n.kn);
		o->power = 1;
	}
	memset(y, 0, TS_COLLIDING_MOST * sizeof *y);
	y[TS_AT_U] = u;
	choose_axes(o, c, y);
	root = o->power == 1 ? depth : pow(depth, 1.0 / o->power);
	speed = ts_norm(c->velocity) + c->radius * ts_norm(c->omega);
	speeds = fmax(speed, u);
	o->scale[TS_AT_Z] = root;
	o->scale[TS_AT_U] = u;
	o->scale[TS_AT_TIME] = depth / u;
	for (int k = 0; k < o->d; k++) {
		double *at = o->scale + TS_AT_TANGENTIAL + k;

		at[0] = speeds;
		at[o->d] = speeds / c->radius;
		at[3 * o->d] = speeds * depth / u;
	}
	o->elongation = speeds * depth / u;
	if (o->d) {
		o->least_limit = negligible(c->law->friction * u / (speed_of_slip(o, c, y) + u)) *
				 c->law->friction * c->mass * u * u / depth;
		/* nothing depends on these sums; |s| has a kink where slip reverses */
		o->scale[TS_AT_TANGENTIAL + 4 * o->d] = LESS_PRECISE * speeds * depth / u;
		o->scale[TS_AT_TANGENTIAL + 4 * o->d + 1] = LESS_PRECISE * c->mass * speeds * speeds;
	}
}

static void choose_first_mode(struct ts_colliding *o, double *y)
{
	static const double EARLY = 1e-9; /* of the largest overlap */
	double at[TS_COLLIDING_MOST], depth = EARLY * ts_colliding_overlap(o, o->scale[TS_AT_Z]);
	struct ts_colliding_forces m;

	ts_colliding_evaluate(o, y, &m);
	o->peak_force = m.n.force; /* a linear dashpot may be strongest at the touch */
	if (!o->d)
		return;
	memcpy(at, y, sizeof at);
	at[TS_AT_Z] = o->power == 1 ? depth : pow(depth, 1.0 / o->power);
	choose_mode(o, at, depth / y[TS_AT_U]);
	if (o->mode == TS_SLIDE && o->model.tangential == TS_TANGENTIAL_HISTORY)
		set_direction(o, y + TS_AT_TANGENTIAL + 2 * (ptrdiff_t)o->d, m.slip);
}

/* What a step has led to. */
enum outcome { GOES_ON, CHANGES_MODE, PULLS, PARTS };

/* Whether the mode changes and changes back within the step *sigma to `to`; these then become the time and the state
 * between. As changes_mode has a maximum there, its tangents at both ends meet above 0. */
static bool changes_twice(struct stepper *s, double *sigma, double *to)
{
	static const double PRECISION = 1e-5;
	const struct ts_colliding *o = s->o;
	const double *from = s->scheme.y;
	double time = to[TS_AT_TIME] - from[TS_AT_TIME], at = *sigma, y[TS_COLLIDING_MOST];
	double grows, decays, meet;

	if (o->mode == TS_FOLLOW || o->model.tangential != TS_TANGENTIAL_HISTORY)
		return false;
	grows = -change_recedes(o, from);
	decays = -change_recedes(o, to);
	if (!(grows > 0 && decays < 0))
		return false;
	meet = (changes_mode(o, to) - changes_mode(o, from) - decays * time) / (grows - decays);
	if (!(changes_mode(o, from) + grows * meet > 0))
		return false;
	memcpy(y, to, sizeof y);
	locate(s, change_recedes, PRECISION, &at, y);
	if (!(changes_mode(o, y) > 0))
		return false;
	*sigma = at;
	memcpy(to, y, sizeof y);
	return true;
}

/* Cuts the step *sigma to `to` at the first event in it. */
static enum outcome cut_step(struct stepper *s, double *sigma, double *to)
{
	/* other events are looked for up to shortly before the surfaces part, where all forces are 0 */
	static const double SHORTLY = 1e-7;
	const struct ts_colliding *o = s->o;
	enum outcome outcome = GOES_ON;
	double cut = *sigma, seen[TS_COLLIDING_MOST];

	if (to[TS_AT_Z] <= 0) {
		outcome = PARTS;
		locate(s, parts, 1e-12, sigma, to);
		cut = (1 - SHORTLY) * *sigma;
		make_step(s, cut, seen);
	} else {
		memcpy(seen, to, sizeof seen);
	}
	if (o->sign > 0 && seen[TS_AT_U] < 0 && changes_sign(o, seen) >= 0) {
		outcome = PULLS;
		locate(s, changes_sign, 1e-12, &cut, seen);
	}
	if (o->d && (changes_mode(o, seen) > 0 || changes_twice(s, &cut, seen))) {
		outcome = CHANGES_MODE;
		locate(s, changes_mode, 1e-12, &cut, seen);
	}
	if (outcome == PULLS || outcome == CHANGES_MODE) {
		*sigma = cut;
		memcpy(to, seen, sizeof seen);
	}
	return outcome;
}

/* Free flight until the surfaces part, as no force pulls. */
static void fly(struct ts_colliding *o, double *y)
{
	double *v = y + TS_AT_TANGENTIAL, *sums = v + 4 * (ptrdiff_t)o->d, time, there[TS_COLLIDING_MOST];
	struct ts_colliding_forces from, to;

	ts_colliding_evaluate(o, y, &from);
	time = from.q / -y[TS_AT_U];
	memcpy(there, y, sizeof there);
	there[TS_AT_Z] = 0;
	ts_colliding_evaluate(o, there, &to);
	y[TS_AT_Z] = 0;
	y[TS_AT_TIME] += time;
	for (int k = 0; k < o->d; k++)
		v[3 * o->d + k] += time * v[k];
	if (o->d)
		sums[0] += 0.5 * time *
			   (ts_colliding_length(from.slip, o->d) + ts_colliding_length(to.slip, o->d));
}

/* The next steps start from y, in the present mode. */
static void start_steps(struct stepper *s, const double *y)
{
	scale_spring(s->o);
	ts_prince_dormand_start(&s->scheme, y);
}

static enum ts_collision_end advance(struct stepper *s, double *y, struct record *record)
{
	const struct ts_collision *c = record->c;
	struct ts_colliding *o = s->o;
	double sigma = 0.1 * o->power * o->scale[TS_AT_Z] / o->scale[TS_AT_U], to[TS_COLLIDING_MOST];
	int changes = 0;

	start_steps(s, y);
	for (int steps = 0; steps < STEPS_MOST && changes < CHANGES_MOST; steps++) {
		double error, factor, made = sigma;
		enum outcome outcome;

		error = make_step(s, sigma, to);
		factor = error > 0 ? 0.8 * pow(TOLERANCE / error, 0.125) : 5;

		sigma *= factor < 0.2 ? 0.2 : factor < 5 ? factor : isnan(factor) ? 0.2 : 5;
		if (!(error <= TOLERANCE))
			continue;
		outcome = cut_step(s, &made, to);
		record_peaks(s, made, to);
		if (c->nodes)
			record_nodes(s, record, made, to);
		if (record->full)
			return TS_COLLISION_NOMEM;
		memcpy(y, to, sizeof to);
		if (outcome == CHANGES_MODE) {
			enter_next_mode(o, y);
			changes++;
		} else if (outcome == PULLS && c->model->no_tension) {
			fly(o, y);
			outcome = PARTS;
		} else if (outcome == PULLS) {
			begin_pull(o, y);
		}
		if (outcome == PARTS)
			return y[TS_AT_TIME] <= c->longest ? TS_COLLISION_PARTS : TS_COLLISION_STAYS;
		if (!(y[TS_AT_TIME] <= c->longest))
			return TS_COLLISION_STAYS;
		start_steps(s, y);
	}
	return TS_COLLISION_FAILS;
}

static void store_result(const struct ts_colliding *o, const struct ts_collision *c, const double *start,
			 const double *y, struct ts_collision_result *out)
{
	const double *sums = y + TS_AT_TANGENTIAL + 4 * (ptrdiff_t)o->d;

	*out = (struct ts_collision_result){ .duration = y[TS_AT_TIME],
					     .peak_force = o->peak_force,
					     .peak_overlap = o->peak_overlap,
					     .impulse = c->mass * (start[TS_AT_U] - y[TS_AT_U]),
					     .slip = o->d ? sums[0] : 0,
					     .work = o->d ? sums[1] : 0 };
	find_motion(o, c, start, y, out->velocity, out->omega, out->shift);
}

enum ts_collision_end ts_collision_compute(const struct ts_collision *c, struct ts_collision_result *out)
{
	double start[TS_COLLIDING_MOST], y[TS_COLLIDING_MOST];
	struct record record = { c, start, false };
	size_t nodes = c->nodes ? c->nodes->n : 0;
	struct stepper s;
	enum ts_collision_end end;
	struct ts_touch touch;
	struct ts_colliding o;

	begin(&o, &touch, c, start);
	if (!(start[TS_AT_U] > 0) || !isfinite(o.scale[TS_AT_Z]))
		return TS_COLLISION_STAYS;
	memcpy(y, start, sizeof y);
	s.o = &o;
	s.scheme.derivative = ts_colliding_derivative;
	s.scheme.context = &o;
	s.scheme.n = size_of(&o);
	choose_first_mode(&o, y);
	end = advance(&s, y, &record);
	if (end == TS_COLLISION_PARTS)
		store_result(&o, c, start, y, out);
	else if (c->nodes)
		c->nodes->n = nodes;
	return end;
}
