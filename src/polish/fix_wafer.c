/* Fix wafer: a rigid wafer on a ball joint, pressed onto a polishing pad. */
#include <math.h>

#include "box/domain.h"
#include "core/report.h"
#include "film/film_plane.h"
#include "math/constants.h"
#include "math/symmetric3.h"
#include "polish/balance.h"
#include "polish/wafer.h"
#include "voxel/voxel_surface.h"

#include "base/banned.h"

enum { SETTLED, DYNAMIC };

struct state {
	struct ts_film_plane plane; /* height and slopes, and their rates */
	const char *pad_id;
	int motion;
	struct ts_number pressure;
	double friction, arm, joint[2], mass, inertia[2], damping;
	double start[3]; /* NaN: not given */
	int64_t every;

	struct ts_wafer wafer;
	const struct ts_voxel_surface *pad;
	struct ts_wafer_column *column;
	size_t column_capacity;
	double area; /* of the face */
	struct ts_wafer_forces forces;
	struct ts_film_push push; /* of the film; 0 without one */
	double mean_gap;
	bool placed, told; /* told: the warning of warn_of_speeds */
	/* on a film: state a step ago, and the length of that step; 0: there is none */
	double last_pose[3], last_rate[3], last_step;
};

/* ---- the pad below the wafer ---- */

/* The part of a column along one axis: its centre, from the middle of the field, and its length. */
struct segment {
	double centre, length;
};

/* Column i of a field that has moved by `shift`: one segment, or two if it lies across the period. */
static int segments_of(const struct ts_voxel_field *f, int d, int64_t i, double shift, struct segment out[2])
{
	double size = (double)f->n[d] * f->width[d], from = (double)i * f->width[d], inside;

	if (f->periodic[d]) {
		shift = fmod(shift, size); /* exact: the field may have moved far */
		from += shift - floor((from + shift) / size) * size;
	}
	inside = fmin(size - from, f->width[d]);
	if (!(inside < f->width[d] * (1 - 1e-12))) {
		out[0] = (struct segment){ from + 0.5 * f->width[d] - 0.5 * size, f->width[d] };
		return 1;
	}
	out[0] = (struct segment){ 0.5 * size - 0.5 * inside, inside };
	out[1] = (struct segment){ 0.5 * (f->width[d] - inside) - 0.5 * size, f->width[d] - inside };
	return 2;
}

static enum ts_status list_columns(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	const struct ts_voxel_field *f = &s->pad->field;
	const double *shift = s->pad->shift;
	size_t n = 0;

	if (TS_GROW(s->column, s->column_capacity, (size_t)((f->n[0] + 1) * (f->n[1] + 1))) != TS_OK)
		return ts_nomem(&sim->error);
	for (int64_t j = 0; j < f->n[1]; j++) {
		struct segment row[2], part[2];
		int rows = segments_of(f, 1, j, shift[f->axis[1]], row);

		for (int64_t i = 0; i < f->n[0]; i++) {
			double height = ts_voxel_heights(f)[j * f->n[0] + i] + shift[f->axis[2]];
			int parts = segments_of(f, 0, i, shift[f->axis[0]], part);

			for (int a = 0; a < rows * parts; a++)
				s->column[n++] =
					(struct ts_wafer_column){ { part[a / rows].centre - s->joint[0],
								    row[a % rows].centre - s->joint[1] },
								  part[a / rows].length *
									  row[a % rows].length,
								  height };
		}
	}
	s->wafer.column = s->column;
	s->wafer.n = n;
	return TS_OK;
}

/* Load, and friction along the velocity of the pad. */
static enum ts_status find_load(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	const struct ts_voxel_field *f = &s->pad->field;
	double pressure, v[2], speed;

	TS_TRY(ts_number_now(sim, &s->pressure, &self->where, &pressure));
	if (!(pressure > 0 && isfinite(pressure)))
		return ts_fail(&sim->error, TS_RANGE, &self->where,
			       "fix wafer %s: the back pressure is %g, must be > 0", self->id, pressure);
	s->wafer.load = pressure * s->area;
	for (int d = 0; d < 2; d++)
		v[d] = s->pad->velocity[f->axis[d]];
	speed = hypot(v[0], v[1]);
	for (int d = 0; d < 2; d++)
		s->wafer.friction[d] = speed > 0 ? s->friction * s->arm * v[d] / speed : 0;
	return TS_OK;
}

static struct ts_wafer_pose pose_of(const struct state *s)
{
	const double *q = s->plane.pose;

	return (struct ts_wafer_pose){ q[0], { q[1], q[2] } };
}

static enum ts_status settle(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	struct ts_wafer_pose pose = pose_of(s);

	if (ts_wafer_settle(&s->wafer, &pose) != TS_OK)
		return ts_fail(&sim->error, TS_PHYSICS, &self->where,
			       "fix wafer %s: no equilibrium: the pad can carry at most %g of the load %g, "
			       "and friction moves the load by %g and %g from the joint, where the face "
			       "reaches %g and %g",
			       self->id, s->wafer.hardness * s->area, s->wafer.load, s->wafer.friction[0],
			       s->wafer.friction[1],
			       0.5 * (double)s->pad->field.n[0] * s->pad->field.width[0],
			       0.5 * (double)s->pad->field.n[1] * s->pad->field.width[1]);
	s->plane.pose[0] = pose.z;
	s->plane.pose[1] = pose.slope[0];
	s->plane.pose[2] = pose.slope[1];
	return TS_OK;
}

static void find_forces(struct state *s)
{
	struct ts_wafer_pose pose = pose_of(s);
	double gap = 0;

	ts_wafer_forces(&s->wafer, &pose, &s->forces);
	for (size_t k = 0; k < s->wafer.n; k++) {
		const struct ts_wafer_column *c = &s->wafer.column[k];

		gap += c->area *
		       fmax(pose.z + pose.slope[0] * c->x[0] + pose.slope[1] * c->x[1] - c->height, 0);
	}
	s->mean_gap = gap / s->area;
}

/* The place at the beginning, if one is given. */
static bool take_start(struct state *s)
{
	if (s->placed || isnan(s->start[0]))
		return false;
	for (int d = 0; d < 3; d++) {
		s->plane.pose[d] = isnan(s->start[d]) ? 0 : s->start[d];
		s->plane.rate[d] = 0;
	}
	s->placed = true;
	return true;
}

/* ---- the film below the wafer ---- */

struct floating {
	struct state *s;
	struct tsim *sim;
	struct ts_instance *flow;
	struct ts_film_flow *film;
	double half[2]; /* lengths of the face */
};

static enum ts_status forces_on_film(void *context, const double q[3], const double v[3], double out[3])
{
	struct floating *at = context;
	struct state *s = at->s;

	for (int d = 0; d < 3; d++) {
		s->plane.pose[d] = q[d];
		s->plane.rate[d] = v[d];
	}
	TS_TRY(at->film->solve(at->flow, at->sim));
	ts_film_plane_push(at->film, &s->push);
	find_forces(s);
	out[0] = s->forces.normal + s->push.normal - s->wafer.load;
	for (int d = 0; d < 2; d++)
		out[1 + d] = s->forces.moment[d] + s->forces.normal * s->wafer.friction[d] +
			     s->push.moment[d] + s->arm * s->push.along[d];
	for (int d = 0; d < 3 && s->motion == DYNAMIC; d++)
		out[d] -= s->damping * (d == 0 ? 1 : s->inertia[d - 1] / s->mass) * v[d];
	return TS_OK;
}

static enum ts_status slopes_on_film(void *context, double by_q[3][3], double by_v[3][3])
{
	struct floating *at = context;
	const struct state *s = at->s;

	TS_TRY(ts_film_plane_slopes(at->film, by_q, by_v, &at->sim->error));
	for (int a = 0; a < 3; a++) {
		for (int b = 0; b < 3; b++)
			by_q[a][b] -= s->forces.stiffness[a][b] +
				      (a > 0 ? s->wafer.friction[a - 1] * s->forces.stiffness[0][b] : 0);
		if (s->motion == DYNAMIC)
			by_v[a][a] -= s->damping * (a == 0 ? 1 : s->inertia[a - 1] / s->mass);
	}
	return TS_OK;
}

/* With a least gap the film follows the wafer into the pad: at most by the mean gap at once. Where nothing carries the wafer it
 * would sink without end. */
static double reach_on_film(void *context, const double change[3])
{
	const struct floating *at = context;
	double clearance = ts_film_plane_clearance(at->film), most = 0;

	for (int d = 0; d < 3; d++)
		most += fabs(change[d]) * (d == 0 ? 1 : at->half[d - 1]);
	if (clearance < 1e-9 * fmax(at->half[0], at->half[1]))
		return 0;
	return fmin(ts_film_plane_reach(at->film, change), fmax(at->s->mean_gap, clearance) / most);
}

static double length_on_film(void *context)
{
	return ts_film_plane_clearance(((const struct floating *)context)->film);
}

static enum ts_status balance_on_film(struct ts_instance *self, struct floating *at, bool step)
{
	struct state *s = self->state;
	double dt = at->sim->clock.dt, old[2][3], speed[2][3], rest = 0;
	struct ts_balance b = { .context = at,
				.forces = forces_on_film,
				.slopes = slopes_on_film,
				.reach = reach_on_film,
				.length = length_on_film,
				.scale = { s->wafer.load, s->wafer.load * at->half[0],
					   s->wafer.load * at->half[1] } };
	enum ts_status status;

	for (int d = 0; d < 3; d++) {
		b.mass[d] = s->motion == DYNAMIC ? (d == 0 ? s->mass : s->inertia[d - 1]) : 0;
		old[0][d] = s->plane.pose[d];
		speed[0][d] = s->plane.rate[d];
		old[1][d] = s->last_pose[d];
		speed[1][d] = s->last_rate[d];
	}
	if (step)
		ts_balance_step(&b, dt, s->last_step, (const double(*)[3])old, (const double(*)[3])speed);
	status = ts_balance_solve(&b, s->plane.pose, &rest);
	if (status == TS_PHYSICS && at->sim->error.status == TS_OK)
		return ts_fail(&at->sim->error, TS_PHYSICS, &self->where,
			       "fix wafer %s: no place above the film where forces balance: of the load %g "
			       "the pad carries %g and the film %g at z = %g with slopes %g %g; the pad "
			       "carries at most %g. Expected a joint above which the film and the pad can "
			       "hold the wafer, or a `start` nearer to it%s",
			       self->id, s->wafer.load, s->forces.normal, s->push.normal, s->plane.pose[0],
			       s->plane.pose[1], s->plane.pose[2], s->wafer.hardness * s->area,
			       at->film->least > 0 ? ""
						   : "; columns of a pad reach the wafer only if the flow "
						     "style has a `least_gap`");
	TS_TRY(status);
	for (int d = 0; d < 3 && step; d++) {
		s->last_pose[d] = old[0][d];
		s->last_rate[d] = speed[0][d];
	}
	s->last_step = step ? dt : s->last_step;
	return TS_OK;
}

/* Before the first balance: so high that the gap is a thousandth of the length of the face, where no columns touch. */
static void place_above(struct state *s, const struct floating *at)
{
	double highest = -INFINITY;

	for (size_t c = 0; c < ts_film_cells(&at->film->film); c++)
		highest = fmax(highest, at->film->surface[0].z[c]);
	s->plane.pose[0] = highest + 2e-3 * fmax(at->half[0], at->half[1]);
	s->plane.pose[1] = s->plane.pose[2] = 0;
}

/* Forces where the wafer is. */
static enum ts_status stay_on_film(struct floating *at)
{
	double q[3], v[3], unused[3];

	for (int d = 0; d < 3; d++) {
		q[d] = at->s->plane.pose[d];
		v[d] = at->s->plane.rate[d];
	}
	return forces_on_film(at, q, v, unused);
}

/* The film covers the box, the wafer the pad. */
static enum ts_status check_film(struct ts_instance *self, struct tsim *sim)
{
	const struct state *s = self->state;
	const struct ts_voxel_field *f = &s->pad->field;
	const struct ts_box *box = &sim->domain->box;

	for (int d = 0; d < 2; d++) {
		double from = f->origin[d], to = ts_voxel_border(f, d, f->n[d]), length = to - from;

		if (f->axis[2] != 2 || !(fabs(from - box->lo[d]) <= 1e-9 * length) ||
		    !(fabs(to - box->hi[d]) <= 1e-9 * length))
			return ts_fail(&sim->error, TS_STATE, ts_instance_word(self, s->pad_id),
				       "fix wafer: the film below it covers the box, the wafer the pad %s; "
				       "expected a pad with normal z of the size of the box, from %g to %g "
				       "along %s",
				       s->pad_id, box->lo[d], box->hi[d], d ? "y" : "x");
	}
	return TS_OK;
}

/* A pad that slides below a film whose lower surface does not slide with it is probably forgotten. */
static void warn_of_speeds(struct ts_instance *self, struct tsim *sim, const struct ts_film_flow *film)
{
	struct state *s = self->state;
	const double *pad = s->pad->velocity, *low = film->surface[0].now;
	double speed = hypot(pad[0], pad[1]);

	if (s->told || !(hypot(pad[0] - low[0], pad[1] - low[1]) > 1e-9 * speed) || !(speed > 0))
		return;
	s->told = true;
	ts_warn(&sim->log, &self->where,
		"fix wafer: the pad %s slides with %g %g, the lower surface of the film with %g %g; expected "
		"the same: give flow_style reynolds `lower_voxel %s`, or `lower_velocity`",
		s->pad_id, pad[0], pad[1], low[0], low[1], s->pad_id);
}

static enum ts_status move(struct ts_instance *self, struct tsim *sim, struct ts_instance *flow,
			   enum ts_film_move how)
{
	struct state *s = self->state;
	const struct ts_voxel_field *f = &s->pad->field;
	struct floating at = { s, sim, flow, flow->state, { 0 } };
	bool due = s->motion == SETTLED && (how == TS_FILM_SETUP || sim->clock.step % s->every == 0), first;

	for (int d = 0; d < 2; d++)
		at.half[d] = 0.5 * (double)f->n[d] * f->width[d];
	TS_TRY(check_film(self, sim)); /* boxes may move */
	warn_of_speeds(self, sim, at.film);
	TS_TRY(list_columns(self, sim));
	TS_TRY(find_load(self, sim));
	first = !s->placed && !take_start(s);
	if (first)
		place_above(s, &at);
	s->placed = true;
	TS_TRY(stay_on_film(&at));
	if (first || (due && how != TS_FILM_KEEP))
		return balance_on_film(self, &at, false);
	return s->motion == DYNAMIC && how == TS_FILM_STEP ? balance_on_film(self, &at, true) : TS_OK;
}

/* ---- stages ---- */

static enum ts_status check_pad(struct ts_instance *self, struct tsim *sim)
{
	const struct state *s = self->state;
	const struct ts_voxel_field *f = &s->pad->field;

	for (int d = 0; d < 2; d++)
		if (fabs(s->pad->velocity[f->axis[d]]) > 0 && !f->periodic[d])
			return ts_fail(&sim->error, TS_STATE, ts_instance_word(self, s->pad_id),
				       "fix wafer: the pad %s slides along an axis along which it is not "
				       "periodic: it would leave the wafer",
				       s->pad_id);
	for (int d = 0; d < 2; d++)
		if (!(fabs(s->joint[d]) <= 0.5 * (double)f->n[d] * f->width[d]))
			return ts_fail(&sim->error, TS_RANGE, &self->where,
				       "fix wafer: the joint is %g from the middle of the wafer along axis "
				       "%d, expected at most half of its length, %g",
				       s->joint[d], d + 1, 0.5 * (double)f->n[d] * f->width[d]);
	return TS_OK;
}

/* Films with a memory need a beginning, and films without one a gap that does not change. */
static enum ts_status check_memory(struct ts_instance *self, struct tsim *sim,
				   const struct ts_film_flow *film)
{
	const struct state *s = self->state;

	if (film->transient && isnan(s->start[0]))
		return ts_fail(&sim->error, TS_STATE, &self->where,
			       "fix wafer: in a film with `transient yes` the wafer needs a height at the "
			       "beginning, when the gap is full: give `start` and a height");
	if (film->film.cavitation == TS_FILM_JFO && !film->transient && s->motion == DYNAMIC)
		return ts_fail(&sim->error, TS_STATE, ts_instance_word(self, "dynamic"),
			       "fix wafer dynamic: the gap changes; a film with cavitation jfo then needs "
			       "`transient yes`");
	return TS_OK;
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	struct ts_word id = { .text = s->pad_id, .place = *ts_instance_word(self, s->pad_id) };
	struct ts_voxel_surface *pad;
	struct ts_instance *flow;

	s->plane.move = NULL;
	TS_TRY(ts_voxel_surface_require(sim, &id, &pad));
	s->pad = pad;
	s->area = (double)(pad->field.n[0] * pad->field.n[1]) * pad->field.width[0] * pad->field.width[1];
	if (isnan(s->wafer.hardness))
		s->wafer.hardness = INFINITY;
	for (int d = 0; d < 2; d++)
		s->plane.place[d] =
			(pad->field.origin[d] + ts_voxel_border(&pad->field, d, pad->field.n[d])) / 2 +
			s->joint[d];
	TS_TRY(check_pad(self, sim));
	flow = ts_film_flow_below(sim, self);
	if (flow) {
		TS_TRY(check_memory(self, sim, flow->state));
		TS_TRY(check_film(self, sim));
	}
	s->plane.move = move;
	return TS_OK;
}

/* The pad has moved; the wafer settles, or forces are those at its new place. On a film, the film has done it. */
static enum ts_status post_force(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	bool due = s->motion == SETTLED && sim->clock.step % s->every == 0;

	if (ts_film_flow_below(sim, self))
		return TS_OK;
	TS_TRY(list_columns(self, sim));
	TS_TRY(find_load(self, sim));
	if (!take_start(s) && (due || !s->placed))
		TS_TRY(settle(self, sim));
	s->placed = true;
	find_forces(s);
	return TS_OK;
}

/* Half a step of the rates: z and slopes are generalized coordinates with mass and moments of inertia. */
static void kick(struct state *s, double half)
{
	const double mass[3] = { s->mass, s->inertia[0], s->inertia[1] };
	const double force[3] = { s->forces.normal - s->wafer.load,
				  s->forces.moment[0] + s->forces.normal * s->wafer.friction[0],
				  s->forces.moment[1] + s->forces.normal * s->wafer.friction[1] };

	for (int d = 0; d < 3; d++)
		s->plane.rate[d] += half * (force[d] / mass[d] - s->damping / s->mass * s->plane.rate[d]);
}

static enum ts_status initial_integrate(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	if (s->motion == SETTLED || ts_film_flow_below(sim, self))
		return TS_OK;
	kick(s, 0.5 * sim->clock.dt);
	for (int d = 0; d < 3; d++)
		s->plane.pose[d] += sim->clock.dt * s->plane.rate[d];
	return TS_OK;
}

static enum ts_status final_integrate(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	if (s->motion == DYNAMIC && !ts_film_flow_below(sim, self))
		kick(s, 0.5 * sim->clock.dt);
	return TS_OK;
}

static void report_film(const struct ts_instance *self, const struct tsim *sim, struct ts_plan_report *report)
{
	const struct state *s = self->state;
	const struct ts_instance *flow = ts_film_flow_below(sim, self);

	if (!flow)
		return;
	ts_report_line(report, "wafer", "fix %s floats on the film, %s", self->id,
		       s->motion == DYNAMIC
			       ? "moved by an implicit method of second order, stable with any time step"
		       : ((const struct ts_film_flow *)flow->state)->transient
			       ? "without mass: its weight squeezes the film, by an implicit method of first "
				 "order"
			       : "in equilibrium at all times: no motion of its own squeezes the film");
}

/* Largest omega^2 of K q = omega^2 M q, with all columns in elastic contact: the stiffest pad. About the joint at j,
 * K = k A [[1, -j_1, -j_2], [.., L_1^2/12 + j_1^2, j_1 j_2], [.., .., L_2^2/12 + j_2^2]]. */
static double largest_rate(const struct state *s)
{
	const struct ts_voxel_field *f = &s->pad->field;
	const double *j = s->joint, k = s->wafer.stiffness * s->area;
	double size[2], rate[3], modes[3][3];

	for (int d = 0; d < 2; d++)
		size[d] = (double)f->n[d] * f->width[d];
	ts_symmetric3_eigen((double[]){ k / s->mass,
					k * (size[0] * size[0] / 12 + j[0] * j[0]) / s->inertia[0],
					k * (size[1] * size[1] / 12 + j[1] * j[1]) / s->inertia[1],
					-k * j[0] / sqrt(s->mass * s->inertia[0]),
					-k * j[1] / sqrt(s->mass * s->inertia[1]),
					k * j[0] * j[1] / sqrt(s->inertia[0] * s->inertia[1]) },
			    rate, modes);
	return fmax(rate[0], fmax(rate[1], rate[2]));
}

/* Both kicks are explicit: with y = c h/(2 m) and b = (2 m omega/c)^2 the two eigenvalues of a step have the product (1 - y)^2
 * and a modulus below 1 while y < 2 and g(y) = 8 - 8 y + 4 y^2 - b y^2 (2 - y) > 0. Returns the first y beyond. */
static double largest_damped_step(double b)
{
	const double bend = 8 - 4 * b; /* g' = 3 b y^2 + bend y - 8 */
	double low = 0, high = fmin(2, (sqrt(bend * bend + 96 * b) - bend) / (6 * b));

	if (8 - 8 * high + 4 * high * high - b * high * high * (2 - high) > 0)
		return 2;
	for (int k = 0; k < 60; k++) {
		const double y = (low + high) / 2;

		*(8 - 8 * y + 4 * y * y - b * y * y * (2 - y) > 0 ? &low : &high) = y;
	}
	return low;
}

static enum ts_status plan(struct ts_instance *self, struct tsim *sim, struct ts_plan_report *report)
{
	const struct state *s = self->state;
	double rate, damping, limit;

	report_film(self, sim, report);
	if (s->motion == SETTLED || ts_film_flow_below(sim, self))
		return TS_OK;
	rate = largest_rate(s);
	limit = 2 / sqrt(rate);
	damping = s->damping / (2 * s->mass);
	if (damping > 0)
		limit = fmin(limit, largest_damped_step(rate / (damping * damping)) / damping);
	return ts_report_limit(report, limit, true, &self->where,
			       "fix wafer%s, with all columns of the pad in contact",
			       damping > 0 ? " and its damping" : ", 2/omega");
}

/* ---- outputs ---- */

static enum ts_status eval_tilt(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct state *s = self->state;

	(void)sim;
	out->data[0] = atan(hypot(s->plane.pose[1], s->plane.pose[2])) * 180 / TS_PI;
	return TS_OK;
}

static const char *const names[] = { "z",	 "slope_1", "slope_2",	 "load",   "area",
				     "mean_gap", "energy",  "film",	 "film_1", "film_2",
				     "along_1",	 "along_2", "asperities" };
enum { OUTPUTS = sizeof names / sizeof *names };

static enum ts_status eval_vector(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct state *s = self->state;
	const double value[] = { s->plane.pose[0],  s->plane.pose[1],	      s->plane.pose[2],
				 s->forces.normal,  s->forces.area / s->area, s->mean_gap,
				 s->forces.energy,  s->push.normal,	      s->push.moment[0],
				 s->push.moment[1], s->push.along[0],	      s->push.along[1],
				 s->push.touch };

	(void)sim;
	_Static_assert(sizeof value == OUTPUTS * sizeof *value, "a value for each name");
	for (int k = 0; k < OUTPUTS; k++)
		out->data[k] = value[k];
	return TS_OK;
}

static const struct ts_value values[] = {
	{ "tilt", "degrees", "angle between wafer and pad", TS_SCALAR, 1, NULL, eval_tilt },
	{ "wafer", "length, -, -, force, -, length, energy, force, torque, torque, force, force, force",
	  "height of the face below the joint, its slopes along the first and second axis of the pad, force "
	  "of the pad, part of the area in contact, mean gap, energy of the springs; of the film its force, "
	  "moments about the joint for both slopes, forces along both axes, and the part of its asperities",
	  TS_VECTOR, OUTPUTS, names, eval_vector },
	{ .name = NULL },
};

static void fini(struct ts_instance *self)
{
	ts_free(((struct state *)self->state)->column);
}

/* ---- arguments ---- */

static const struct ts_arg settled_args[] = {
	TS_INT("every", struct state, every, .fallback = "1", .range = TS_POSITIVE,
	       .help = "steps between two solutions"),
	TS_ARGS_END,
};
static const struct ts_arg dynamic_args[] = {
	TS_REAL("mass", struct state, mass, .range = TS_POSITIVE, .unit = "mass", .help = "of the wafer"),
	TS_REAL("inertia_1", struct state, inertia[0], .range = TS_POSITIVE, .unit = "mass length^2",
		.help = "moment of inertia about the joint, for the slope along the first axis"),
	TS_REAL("inertia_2", struct state, inertia[1], .range = TS_POSITIVE, .unit = "mass length^2",
		.help = "the same along the second axis"),
	TS_REAL("damping", struct state, damping, .fallback = "0", .range = TS_NOT_NEGATIVE,
		.unit = "force/velocity",
		.help = "force over velocity of the wafer; tilting is damped at the same rate"),
	TS_ARGS_END,
};
static const struct ts_mode motions[] = {
	[SETTLED] = { "settled", "the wafer is in equilibrium at all times", settled_args },
	[DYNAMIC] = { "dynamic", "it moves by its mass", dynamic_args },
	{ .name = NULL },
};

static const struct ts_arg args[] = {
	TS_WORD("pad", struct state, pad_id, .flags = TS_POSITIONAL | TS_STATEFUL,
		.help = "ID of a fix surface/voxel"),
	TS_MODE("motion", struct state, motion, motions, .help = "how the wafer moves"),
	TS_REAL("stiffness", struct state, wafer.stiffness, .range = TS_POSITIVE, .unit = "pressure/length",
		.help = "pressure of a column of the pad over its compression"),
	TS_REAL("hardness", struct state, wafer.hardness, .flags = TS_OPTIONAL, .range = TS_POSITIVE,
		.unit = "pressure", .help = "pressure at which columns yield; default: they are elastic"),
	TS_NUMBER("pressure", struct state, pressure, .range = TS_POSITIVE, .unit = "pressure",
		  .help = "on the back of the wafer"),
	TS_REAL("friction", struct state, friction, .fallback = "0", .range = TS_NOT_NEGATIVE,
		.help = "coefficient of friction of pad and wafer"),
	TS_REAL("arm", struct state, arm, .fallback = "0", .unit = "length",
		.help = "height of the joint above the face of the wafer; negative: below it, a virtual "
			"joint"),
	TS_REAL("joint_1", struct state, joint[0], .fallback = "0", .unit = "length",
		.help = "place of the joint along the first axis, from the middle of the wafer"),
	TS_REAL("joint_2", struct state, joint[1], .fallback = "0", .unit = "length",
		.help = "the same along the second axis"),
	TS_REAL("start", struct state, start[0], .flags = TS_OPTIONAL, .unit = "length",
		.help = "height of the face below the joint at the beginning; default: in equilibrium"),
	TS_REAL("start_1", struct state, start[1], .flags = TS_OPTIONAL,
		.help = "slope along the first axis at the beginning; default with `start`: 0"),
	TS_REAL("start_2", struct state, start[2], .flags = TS_OPTIONAL,
		.help = "the same along the second axis"),
	TS_ARGS_END,
};

static const struct ts_saved saved[] = {
	TS_SAVE_F64(struct state, plane.pose[0]),
	TS_SAVE_F64(struct state, plane.pose[1]),
	TS_SAVE_F64(struct state, plane.pose[2]),
	TS_SAVE_F64(struct state, plane.rate[0]),
	TS_SAVE_F64(struct state, last_pose[0]),
	TS_SAVE_F64(struct state, last_rate[0]),
	TS_SAVE_F64(struct state, plane.rate[1]),
	TS_SAVE_F64(struct state, last_pose[1]),
	TS_SAVE_F64(struct state, last_rate[1]),
	TS_SAVE_F64(struct state, plane.rate[2]),
	TS_SAVE_F64(struct state, last_pose[2]),
	TS_SAVE_F64(struct state, last_rate[2]),
	TS_SAVE_F64(struct state, last_step),
	TS_SAVE_U8(struct state, placed),
	/* forces of the last step: a run that is continued does not compute them again */
	TS_SAVE_F64(struct state, forces.normal),
	TS_SAVE_F64(struct state, forces.moment[0]),
	TS_SAVE_F64(struct state, forces.moment[1]),
	TS_SAVE_F64(struct state, forces.area),
	TS_SAVE_F64(struct state, forces.energy),
	TS_SAVE_F64(struct state, mean_gap),
	TS_SAVE_F64(struct state, wafer.load),
	TS_SAVE_F64(struct state, wafer.friction[0]),
	TS_SAVE_F64(struct state, wafer.friction[1]),
	TS_SAVED_ROWS_END,
};

static const char doc[] =
	"A rigid, smooth wafer over the whole of a pad, a height field, is free to rise and to tilt about a "
	"ball joint above the middle of the field; slopes are small. Each column of the pad is a spring, "
	"pressed by its depth in the wafer, up to the hardness:\n\n"
	"  p = min(stiffness (h - z - s_1 x_1 - s_2 x_2), hardness) >= 0\n\n"
	"The back pressure presses on the whole area. The pad slides below the wafer with the velocity of "
	"its fix (`move`); friction, mu times the force of the pad, acts on the face along that velocity at "
	"the distance `arm` below the joint, and presses the leading edge, which the pad meets first, into "
	"the pad; with a negative `arm`, a virtual joint below the face, it lifts it. The depth in a column "
	"that yields is not kept: the springs have no history.\n\n"
	"settled: at each step, or each `every` steps, the wafer is in the equilibrium of these forces. "
	"Their energy is convex, so there is only one; it is found by Newton's method. The run ends with a "
	"message if the pad cannot carry the load or the moment of friction.\n\n"
	"dynamic: height and slopes follow m z'' = N - P A - c z' and the same for the tilt. The motion "
	"begins in equilibrium. The largest stable time step is 2/omega, with omega^2 the largest "
	"eigenvalue of M^-1 K for a pad of which all columns are in contact, M = diag(m, I_1, I_2) and\n\n"
	"  K = k A [[1, -j_1, -j_2], [-j_1, L_1^2/12 + j_1^2, j_1 j_2], [-j_2, j_1 j_2, L_2^2/12 + "
	"j_2^2]],\n\n"
	"L_d the lengths of the wafer and j_d the place of the joint: the largest of k A/m and k A L_d^2/(12 "
	"I_d) with the joint in the middle. With `damping` it is smaller, at most 4 m/c: damping is "
	"explicit. A run with a larger step is refused.\n\n"
	"The pad must be periodic along the axes along which it slides. Wafer and particles do not act on "
	"each other.\n\n"
	"On a film: where `upper_wafer` of flow_style reynolds names the fix, the pressure p of the film "
	"acts on the face, too: the forces on z and the slopes are\n\n"
	"  N + sum (p - ambient) A - P A,   M_d + mu N arm u_d + sum (p - ambient) A x_d + arm F_d,\n\n"
	"F the force of the film along the face: shear, and the pressure on the slope. The load acts at the "
	"joint. The film covers the box, which has the size of the pad; its lower surface usually is the pad "
	"(`lower_voxel`). Springs and film share the load where columns reach the wafer: `least_gap` or "
	"`touching solid` of the flow style says what the film is there. Define the fix before the flow "
	"style.\n\n"
	"settled: equilibrium with the film of a wafer at rest above the pad that slides, by Newton's "
	"method; with `transient yes` of the film its weight squeezes the film. dynamic: the rates of height "
	"and slopes squeeze the film; the motion and the film are solved together by backward differences of "
	"second order, stable with any time step. The motion begins at rest, in equilibrium or at `start`. "
	"An equilibrium exists only if the joint is above a place where the film can carry the load: a plane "
	"wafer above a smooth pad needs a joint behind its middle, as a pivoted bearing. The run ends with a "
	"message if there is none.\n\n"
	"Related: fix surface/voxel, flow_style reynolds, compute surface/contact, fix ave/time.";

/* Older files do not have what the film has pushed. */
static enum ts_status archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *a)
{
	struct state *s = self->state;

	(void)sim;
	if (!ts_archive_writing(a) && !ts_archive_has(a, "push"))
		return TS_OK;
	return ts_archive_fixed(a, "push", TS_SAVED_F64, &s->push, sizeof s->push / sizeof(double));
}

TS_STYLE(fix, ts_style, ts_fix_wafer)
const struct ts_style ts_fix_wafer = {
	.name = "wafer",
	.kind = TS_KIND_FIX,
	.ranks = TS_RANKS_OWN | TS_RANKS_OUTPUTS,
	.family = TS_FAMILY_FILM_PLANE,
	.summary = "A wafer on a ball joint, pressed onto a polishing pad of springs",
	.doc = doc,
	.example = "fix pad all surface/voxel gaussian mean 5.31e-6 deviation 4.34e-6 correlation 0 seed 5 "
		   "type 1 cells 31 31 datum 1e-9 move linear 0.1 0.0 0.0\n"
		   "fix wafer all wafer pad settled stiffness 1e12 pressure 137895 friction 0.3 arm 20e-6\n"
		   "fix tilt all ave/time 1 1000 1000 f_wafer f_wafer[2] file tilt.txt\n"
		   "fix wafer all wafer pad dynamic mass 1e-9 inertia_1 2e-19 inertia_2 2e-19 damping 1e-3 "
		   "stiffness 1e12 pressure 137895",
	.args = args,
	.state_size = sizeof(struct state),
	.saved = saved,
	.archive = archive,
	.values = values,
	.init = init,
	.hook = { [TS_STAGE_INITIAL_INTEGRATE] = initial_integrate,
		  [TS_STAGE_POST_FORCE] = post_force,
		  [TS_STAGE_FINAL_INTEGRATE] = final_integrate },
	.plan = plan,
	.fini = fini,
};
