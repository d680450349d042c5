/* Fix move: prescribed motion. */
#include "base/axes.h"
#include "core/sim.h"

#include "box/domain.h"
#include "core/deferred_loops.h"
#include "core/number_or_peratom.h"
#include "force/restraint.h"
#include "group/group_members.h"
#include "math/constants.h"
#include "math/vec3.h"
#include "particle/columns.h"
#include "particle/group_moments.h"
#include "particle/prescribed.h"
#include "particle/reference.h"
#include "region/region.h"

#include "base/banned.h"

enum { LINEAR, WIGGLE, ROTATE, TRANSROT, VARIABLE };

struct state {
	struct ts_prescribed_motion motion;
	int mode, units;
	/* NULL: this component is integrated freely */
	struct ts_number velocity[3], amplitude[3], shift[3], rate[3];
	double drift[3], point[3], axis[3], period;
	double unit[3]; /* unit vector along the axis */
	struct ts_number_or_peratom shift_now[3], rate_now[3];
	struct ts_reference start; /* unwrapped position of each particle at t = 0 */
	double origin;		   /* saved: simulation time when the fix was defined */
	int64_t started;	   /* saved */
};

/* Time since the fix was defined, and factors common to all particles. */
struct moment {
	double t, sine, cosine, omega;
};

/* Whether some component is integrated with the forces instead of prescribed. */
static bool any_component_free(const struct state *s)
{
	const struct ts_number *given = s->mode == LINEAR ? s->velocity : s->amplitude;
	bool any = false;

	for (int k = 0; k < 3 && (s->mode == LINEAR || s->mode == WIGGLE); k++)
		any |= given[k].null;
	for (int k = 0; k < 3 && s->mode == VARIABLE; k++)
		any |= s->shift[k].null && s->rate[k].null;
	return any;
}

static double length_scale(const struct state *s, const struct tsim *sim, int dim)
{
	return ts_domain_scale(sim, s->units, dim);
}

static struct moment moment_of(const struct state *s, const struct tsim *sim)
{
	struct moment m = { .t = ts_sim_time(sim) - s->origin };

	m.omega = s->mode == LINEAR || s->mode == VARIABLE ? 0 : 2 * TS_PI / s->period;
	m.sine = sin(m.omega * m.t);
	m.cosine = cos(m.omega * m.t);
	return m;
}

/* x = P + C + A cos(wt) + B sin(wt) + V t, where x0 - P = C + A, C parallel to the axis e, B = e x A. */
static void rotate_about_axis(const struct state *s, const struct tsim *sim, const struct moment *m,
			      const double x0[3], double x[3], double v[3])
{
	double point[3], a[3], b[3], along;

	for (int k = 0; k < 3; k++) {
		point[k] = length_scale(s, sim, k) * s->point[k];
		a[k] = x0[k] - point[k];
	}
	along = ts_dot(a, s->unit);
	for (int k = 0; k < 3; k++)
		a[k] -= along * s->unit[k];
	ts_cross(s->unit, a, b);
	for (int k = 0; k < 3; k++) {
		double drift = s->mode == TRANSROT ? length_scale(s, sim, k) * s->drift[k] : 0;

		x[k] = point[k] + along * s->unit[k] + m->cosine * a[k] + m->sine * b[k] + drift * m->t;
		v[k] = m->omega * (m->cosine * b[k] - m->sine * a[k]) + drift;
	}
}

/* Inverse motion: the position at t = 0 of a particle that is at its current position now. */
static void position_at_origin(const struct ts_instance *self, const struct tsim *sim, size_t i, double x[3])
{
	const struct state *s = self->state;
	struct moment m = moment_of(s, sim);
	double v[3];

	ts_unwrapped(sim, i, x);
	for (int k = 0; k < 3; k++) {
		double scale = length_scale(s, sim, k);

		if (s->mode == LINEAR && !s->velocity[k].null)
			x[k] -= scale * s->velocity[k].value * m.t;
		if (s->mode == WIGGLE && !s->amplitude[k].null)
			x[k] -= scale * s->amplitude[k].value * m.sine;
		if (s->mode == TRANSROT)
			x[k] -= scale * s->drift[k] * m.t;
	}
	if (s->mode == ROTATE || s->mode == TRANSROT) {
		m.sine = -m.sine;
		m.t = 0;
		rotate_about_axis(s, sim, &m, x, x, v);
	}
}

static enum ts_status check_arguments(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	const struct ts_number *given = s->mode == LINEAR ? s->velocity : s->amplitude;
	double length = ts_norm(s->axis);

	for (int k = 0; k < 3; k++)
		if ((s->mode == LINEAR || s->mode == WIGGLE) && given[k].variable)
			return ts_fail(&sim->error, TS_SYNTAX, &self->where,
				       "fix move: v_%s: variables are only possible with the style "
				       "`variable`",
				       given[k].variable);
	if (s->mode != ROTATE && s->mode != TRANSROT)
		return TS_OK;
	if (!(length > 0))
		return ts_fail(&sim->error, TS_RANGE, &self->where, "fix move: the axis has no length");
	for (int k = 0; k < 3; k++)
		s->unit[k] = s->axis[k] / length;
	if (sim->dimension == 2 && (s->axis[0] != 0 || s->axis[1] != 0))
		return ts_fail(&sim->error, TS_RANGE, &self->where,
			       "fix move: in two dimensions the axis is along z");
	return TS_OK;
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	TS_TRY(check_arguments(self, sim));
	s->motion.free = any_component_free(s);
	ts_domain_units_said(sim, s->units, &self->where);
	if (!s->started)
		s->origin = ts_sim_time(sim);
	s->started = 1;
	if (s->mode == ROTATE || s->mode == TRANSROT)
		TS_TRY(ts_particles_need(sim, TS_NEED(OMEGA) | TS_NEED(TORQUE)));
	return ts_reference_init(self, sim, &s->start, position_at_origin);
}

static enum ts_status evaluate_variables(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	for (int k = 0; k < 3; k++) {
		if (!s->shift[k].null)
			TS_TRY(ts_number_or_peratom_now(sim, &s->shift[k], &self->where, &s->shift_now[k]));
		if (!s->rate[k].null)
			TS_TRY(ts_number_or_peratom_now(sim, &s->rate[k], &self->where, &s->rate_now[k]));
	}
	return TS_OK;
}

/* Whether component k is integrated with the forces. */
static bool component_is_free(const struct state *s, int k)
{
	return (s->mode == LINEAR && s->velocity[k].null) || (s->mode == WIGGLE && s->amplitude[k].null) ||
	       (s->mode == VARIABLE && s->shift[k].null && s->rate[k].null);
}

static void kick_free_components(const struct state *s, const struct tsim *sim, size_t i)
{
	struct ts_particles *p = sim->particles;

	for (int k = 0; k < 3; k++)
		if (component_is_free(s, k))
			p->v[i][k] += 0.5 * sim->clock.dt / p->mass[i] * p->f[i][k];
}

/* New unwrapped position and velocity of component k for linear motion, oscillation and variables. */
static void move_component(const struct state *s, const struct tsim *sim, const struct moment *m, size_t i,
			   int k, double start, double *x, double *v)
{
	double scale = length_scale(s, sim, k);

	if (s->mode == LINEAR && !s->velocity[k].null) {
		*v = scale * s->velocity[k].value;
		*x = start + *v * m->t;
	} else if (s->mode == WIGGLE && !s->amplitude[k].null) {
		*x = start + scale * s->amplitude[k].value * m->sine;
		*v = scale * s->amplitude[k].value * m->omega * m->cosine;
	} else {
		if (s->mode == VARIABLE && !s->rate[k].null)
			*v = scale * ts_number_or_peratom_of(&s->rate_now[k], i);
		if (s->mode == VARIABLE && !s->shift[k].null)
			*x = start + scale * ts_number_or_peratom_of(&s->shift_now[k], i);
		else
			*x += sim->clock.dt * *v;
	}
}

static void move_particle(const struct state *s, const struct tsim *sim, const struct moment *m, size_t i)
{
	struct ts_particles *p = sim->particles;
	const double *start = ts_reference_of(sim, &s->start, i);
	double x[3];

	ts_unwrapped(sim, i, x);
	kick_free_components(s, sim, i);
	if (s->mode == ROTATE || s->mode == TRANSROT)
		rotate_about_axis(s, sim, m, start, x, p->v[i]);
	for (int k = 0; k < 3; k++) {
		if (s->mode != ROTATE && s->mode != TRANSROT)
			move_component(s, sim, m, i, k, start[k], &x[k], &p->v[i][k]);
		else if (p->omega)
			p->omega[i][k] = m->omega * s->unit[k];
		p->x[i][k] = x[k] - p->image[i][k] * ts_box_length(&sim->domain->box, k);
	}
}

struct task {
	const struct state *s;
	const struct tsim *sim;
	struct moment m;
	int group;
};

static void move_range(void *context, size_t from, size_t to)
{
	const struct task *t = context;
	const struct ts_particles *p = t->sim->particles;

	if (!ts_group_members(p, t->group, from, to))
		return;
	for (size_t i = from; i < to; i++)
		if (ts_in_group(p, i, t->group))
			move_particle(t->s, t->sim, &t->m, i);
}

static void kick_range(void *context, size_t from, size_t to)
{
	const struct task *t = context;

	for (size_t i = from; i < to; i++)
		if (ts_in_group(t->sim->particles, i, t->group))
			kick_free_components(t->s, t->sim, i);
}

static enum ts_status initial_integrate(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	struct task task = { s, sim, moment_of(s, sim), self->group };

	if (s->mode == VARIABLE) {
		ts_deferred_loops_run(sim); /* variables may read any particle data */
		TS_TRY(evaluate_variables(self, sim));
	}
	TS_DEFER_LOOP(sim, sim->particles->n, move_range, &task);
	return TS_OK;
}

static enum ts_status final_integrate(struct ts_instance *self, struct tsim *sim)
{
	const struct state *s = self->state;
	struct task task = { .s = s, .sim = sim, .group = self->group };

	if (s->motion.free)
		TS_DEFER_LOOP(sim, sim->particles->n, kick_range, &task);
	return TS_OK;
}

static void clear_prescribed_components(const struct ts_instance *self, const struct tsim *sim, size_t i,
					double f[3])
{
	(void)sim;
	(void)i;
	for (int k = 0; k < 3; k++)
		if (!component_is_free(self->state, k))
			f[k] = 0;
}

static const struct ts_restraint restraint = { NULL, clear_prescribed_components };

static enum ts_status add_new_particles(struct ts_instance *self, struct tsim *sim)
{
	const struct state *s = self->state;

	ts_reference_add(sim, &s->start);
	return TS_OK;
}

static enum ts_status archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *a)
{
	const struct state *s = self->state;

	return ts_reference_archive(a, sim, &s->start);
}

static enum ts_status eval_start(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct state *s = self->state;
	const struct ts_particles *p = sim->particles;

	TS_TRY(ts_table_resize(out, p->n, 3));
	for (size_t i = 0; i < p->n; i++)
		for (size_t k = 0; k < 3; k++)
			out->data[3 * i + k] =
				ts_in_group(p, i, self->group) ? ts_reference_of(sim, &s->start, i)[k] : 0;
	return TS_OK;
}

static void fini(struct ts_instance *self)
{
	struct state *s = self->state;

	for (int k = 0; k < 3; k++) {
		ts_number_or_peratom_release(&s->shift_now[k]);
		ts_number_or_peratom_release(&s->rate_now[k]);
	}
}

#define NUMBER(name_, field, unit_, more_, help_)                                                           \
	TS_NUMBER(name_, struct state, field, .flags = TS_POSITIONAL | TS_NULLABLE | TS_STATEFUL | (more_), \
		  .unit = unit_, .help = help_)
#define COMPONENT(name_, field, unit_, help_) NUMBER(name_, field, unit_, 0, help_)
#define CHOSEN(name_, field, unit_, help_) NUMBER(name_, field, unit_, TS_EACH, help_)
#define FREE "; NULL: this component is integrated with the forces"
static const struct ts_arg linear_args[] = {
	COMPONENT("Vx", velocity[0], "velocity", "x velocity" FREE),
	COMPONENT("Vy", velocity[1], "velocity", "y velocity"),
	COMPONENT("Vz", velocity[2], "velocity", "z velocity"),
	TS_ARGS_END,
};
#define PERIOD                                                                                              \
	TS_REAL("period", struct state, period, .flags = TS_POSITIONAL | TS_STATEFUL, .range = TS_POSITIVE, \
		.unit = "time", .help = "period of the oscillation or rotation")
static const struct ts_arg wiggle_args[] = {
	COMPONENT("Ax", amplitude[0], "length", "x amplitude" FREE),
	COMPONENT("Ay", amplitude[1], "length", "y amplitude"),
	COMPONENT("Az", amplitude[2], "length", "z amplitude"),
	PERIOD,
	TS_ARGS_END,
};
#define AXIS                                                                                          \
	TS_VEC3("point", struct state, point, .flags = TS_POSITIONAL | TS_STATEFUL, .unit = "length", \
		.help = "a point on the axis"),                                                       \
		TS_VEC3("axis", struct state, axis, .flags = TS_POSITIONAL | TS_STATEFUL,             \
			.help = "direction of the axis, of any length; right-handed rotation"),       \
		PERIOD
static const struct ts_arg rotate_args[] = { AXIS, TS_ARGS_END };
static const struct ts_arg transrot_args[] = {
	TS_VEC3("drift", struct state, drift, .flags = TS_POSITIONAL | TS_STATEFUL, .unit = "velocity",
		.help = "translational velocity of the axis"),
	AXIS,
	TS_ARGS_END,
};
static const struct ts_arg variable_args[] = {
	CHOSEN("dx", shift[0], "length", "x displacement from the initial position: v_NAME or NULL"),
	CHOSEN("dy", shift[1], "length", "y displacement"),
	CHOSEN("dz", shift[2], "length", "z displacement"),
	CHOSEN("vx", rate[0], "velocity",
	       "x velocity: v_NAME or NULL; if dx and vx are NULL the component is integrated with the "
	       "forces"),
	CHOSEN("vy", rate[1], "velocity", "y velocity"),
	CHOSEN("vz", rate[2], "velocity", "z velocity"),
	TS_ARGS_END,
};

static const struct ts_mode modes[] = {
	[LINEAR] = { "linear", "constant velocity", linear_args },
	[WIGGLE] = { "wiggle", "oscillation: x = x0 + A sin(2 pi t / period)", wiggle_args },
	[ROTATE] = { "rotate", "rotation about an axis", rotate_args },
	[TRANSROT] = { "transrot", "rotation about an axis that moves at constant velocity", transrot_args },
	[VARIABLE] = { "variable", "displacement or velocity by variables", variable_args },
	{ .name = NULL },
};

static bool moves_by_time(const struct ts_instance *self)
{
	(void)self;
	return true;
}

static const struct ts_arg args[] = {
	TS_MODE("style", struct state, mode, modes, .help = "kind of motion"),
	TS_ENUM("units", struct state, units, ts_region_units, .flags = TS_OPTIONAL,
		.help = "lengths in lattice spacings (lattice) or in the units of the script (box)"),
	TS_ARGS_END,
};

static const struct ts_value values[] = {
	{ "start", "length",
	  "unwrapped position of each particle when the fix was defined, 0 outside the group", TS_PERATOM, 3,
	  ts_axis_names, eval_start },
	{ .name = NULL },
};

static const struct ts_saved saved[] = {
	TS_SAVE_F64(struct state, origin),
	TS_SAVE_I64(struct state, started),
	TS_SAVED_ROWS_END,
};

TS_STYLE(fix, ts_style, ts_fix_move)
const struct ts_style ts_fix_move = {
	.name = "move",
	.kind = TS_KIND_FIX,
	.ranks = TS_RANKS_OWN | TS_RANKS_OUTPUTS,
	.summary = "prescribes the motion of particles",
	.doc = "Replaces the time integration for the particles of the group: their position is a function of "
	       "the time t since the fix was defined, independent of the forces on them. With the position x0 "
	       "at t = 0\n\n"
	       "    linear    x = x0 + V t\n"
	       "    wiggle    x = x0 + A sin(2 pi t/period)\n"
	       "    rotate    x = P + C + A cos(wt) + B sin(wt), x0 - P = C + A, C along the axis e, B = e x "
	       "A\n"
	       "    transrot  the same + V t\n"
	       "    variable  x = x0 + (dx, dy, dz), or x += h (vx, vy, vz) where no displacement is "
	       "given\n\n"
	       "with the time step h and w = 2 pi/period. Velocities are the time derivatives; with rotate "
	       "and transrot the angular velocity of the particles is set to w e. With `variable` "
	       "displacement and velocity should be consistent, which is not checked. Particles that are "
	       "created later start from their position at that time.",
	.example = "fix shake floor move wiggle NULL NULL 0.001 0.02\n"
		   "fix stir blade move rotate 0 0 0 0 0 1 2.385",
	.args = args,
	.state_size = sizeof(struct state),
	.saved = saved,
	.archive = archive,
	.values = values,
	.init = init,
	.family = TS_FAMILY_PRESCRIBED,
	.integrates = TS_MOVES | TS_TURNS,
	.hook = {
		[TS_STAGE_INITIAL_INTEGRATE] = initial_integrate,
		[TS_STAGE_POST_BUILD] = add_new_particles,
		[TS_STAGE_FINAL_INTEGRATE] = final_integrate,
	},
	.defers = TS_DEFERS(INITIAL_INTEGRATE) | TS_DEFERS(FINAL_INTEGRATE),
	.moves_by_time = moves_by_time,
	.restraint = &restraint,
	.fini = fini,
};
