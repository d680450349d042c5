/* Fix move/mesh: prescribed rigid motion of meshes. */
#include <inttypes.h>
#include <math.h>
#include <string.h>

#include "box/domain.h"
#include "math/constants.h"
#include "mesh/mesh_motion.h"

#include "base/banned.h"

enum { MOST_TERMS = 30 };

struct term {
	double amplitude;    /* length or radian */
	double phase, omega; /* radian, radian/time */
};

/* Velocity, and angular velocity about the axis (radian/time). */
struct rate {
	double drift[3], spin;
};

struct state {
	struct ts_mesh_mover mover;
	int what, mode;
	double velocity[3], amplitude[3], axis[3], period, swing;
	struct ts_number rate[3], omega;
	int64_t nterms;
	struct ts_words amplitudes, phases, periods;
	struct term term[MOST_TERMS];
	double unit[3]; /* along the axis */
	/* saved: the time since the definition of the fix is base + steps dt; total displacement, angle
	 * (radian) */
	double base, dt, shift[3], angle;
	int64_t steps;
	/* The part of a motion of constant rate since this rate is another one, as a continuation from a restart file may give:
	 * the rate, and where it began. */
	struct leg {
		struct rate rate;
		double time, shift[3], angle;
	} leg;
};

/* The rate at the time t since the definition of the fix. */
typedef enum ts_status rate_fn(struct ts_instance *self, struct tsim *sim, double t, struct rate *r);

static enum ts_status linear_rate(struct ts_instance *self, struct tsim *sim, double t, struct rate *r)
{
	const struct state *s = self->state;

	(void)sim;
	(void)t;
	ts_scale(1, s->velocity, r->drift);
	return TS_OK;
}

static enum ts_status linear_variable_rate(struct ts_instance *self, struct tsim *sim, double t,
					   struct rate *r)
{
	struct state *s = self->state;

	(void)t;
	for (int k = 0; k < 3; k++)
		TS_TRY(ts_number_now(sim, &s->rate[k], &self->where, &r->drift[k]));
	return TS_OK;
}

static enum ts_status rotate_rate(struct ts_instance *self, struct tsim *sim, double t, struct rate *r)
{
	const struct state *s = self->state;

	(void)sim;
	(void)t;
	r->spin = 2 * TS_PI / s->period;
	return TS_OK;
}

static enum ts_status rotate_variable_rate(struct ts_instance *self, struct tsim *sim, double t,
					   struct rate *r)
{
	struct state *s = self->state;

	(void)t;
	return ts_number_now(sim, &s->omega, &self->where, &r->spin);
}

static enum ts_status wiggle_rate(struct ts_instance *self, struct tsim *sim, double t, struct rate *r)
{
	const struct state *s = self->state;
	double omega = 2 * TS_PI / s->period;

	(void)sim;
	ts_scale(omega * cos(omega * t), s->amplitude, r->drift);
	return TS_OK;
}

static enum ts_status riggle_rate(struct ts_instance *self, struct tsim *sim, double t, struct rate *r)
{
	const struct state *s = self->state;
	double omega = 2 * TS_PI / s->period;

	(void)sim;
	r->spin = s->swing * TS_PI / 180 * omega * cos(omega * t);
	return TS_OK;
}

static double vibration_velocity(const struct state *s, double t)
{
	double sum = 0;

	for (int64_t k = 0; k < s->nterms; k++) {
		const struct term *term = &s->term[k];

		sum -= term->amplitude * term->omega * sin(term->omega * t + term->phase);
	}
	return sum;
}

static enum ts_status viblin_rate(struct ts_instance *self, struct tsim *sim, double t, struct rate *r)
{
	const struct state *s = self->state;

	(void)sim;
	ts_scale(vibration_velocity(s, t), s->unit, r->drift);
	return TS_OK;
}

static enum ts_status vibrot_rate(struct ts_instance *self, struct tsim *sim, double t, struct rate *r)
{
	(void)sim;
	r->spin = vibration_velocity(self->state, t);
	return TS_OK;
}

/* In the order of `modes`. steady: constant rate, integrated exactly. */
static const struct kind {
	rate_fn *rate;
	bool steady, turns, vibrates;
} kinds[] = {
	{ linear_rate, true, false, false },  { linear_variable_rate, false, false, false },
	{ rotate_rate, true, true, false },   { rotate_variable_rate, false, true, false },
	{ wiggle_rate, false, false, false }, { riggle_rate, false, true, false },
	{ viblin_rate, false, false, true },  { vibrot_rate, false, true, true },
};
enum { NKINDS = sizeof kinds / sizeof *kinds };

static const struct kind *motion_kind(const struct state *s)
{
	return &kinds[s->mode % NKINDS];
}

static enum ts_status read_list(struct ts_instance *self, struct tsim *sim, const char *name,
				struct ts_words words, size_t offset)
{
	struct state *s = self->state;

	if (words.n != (size_t)s->nterms)
		return ts_fail(&sim->error, TS_SYNTAX, ts_instance_word(self, name),
			       "fix move/mesh: %s has %zu numbers, expected one for each of the %d terms of "
			       "`order`",
			       name, words.n, (int)s->nterms);
	for (size_t k = 0; k < words.n; k++) {
		double *out = (double *)(void *)((char *)&s->term[k] + offset);

		if (!ts_parse_real(words.word[k].text, out) || !isfinite(*out))
			return ts_fail(&sim->error, TS_SYNTAX, &words.word[k].place,
				       "fix move/mesh: %s: expected a number, found '%s'", name,
				       words.word[k].text);
	}
	return TS_OK;
}

static enum ts_status read_terms(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	TS_TRY(read_list(self, sim, "amplitude", s->amplitudes, offsetof(struct term, amplitude)));
	TS_TRY(read_list(self, sim, "phase", s->phases, offsetof(struct term, phase)));
	TS_TRY(read_list(self, sim, "period", s->periods, offsetof(struct term, omega)));
	for (int64_t k = 0; k < s->nterms; k++) {
		if (!(s->term[k].omega > 0))
			return ts_fail(&sim->error, TS_RANGE, &s->periods.word[k].place,
				       "fix move/mesh: a period must be > 0");
		s->term[k].omega = 2 * TS_PI / s->term[k].omega;
	}
	return TS_OK;
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	const struct kind *kind = motion_kind(s);
	double length = ts_norm(s->axis);

	s->mover.turns = kind->turns && kind->rate != rotate_variable_rate;
	if (kind->turns || kind->vibrates) {
		if (!(length > 0))
			return ts_fail(&sim->error, TS_RANGE, ts_instance_word(self, "axis"),
				       "fix move/mesh: the axis has no length");
		ts_scale(1 / length, s->axis, s->unit);
	}
	if (kind->rate == rotate_rate && s->period == 0)
		return ts_fail(&sim->error, TS_RANGE, ts_instance_word(self, "period"),
			       "fix move/mesh: the period is 0, must not be");
	for (int k = 0; k < 3 && !kind->turns; k++)
		s->mover.origin[k] = 0;
	if (kind->vibrates)
		TS_TRY(read_terms(self, sim));
	return ts_mesh_mover_check(self, sim);
}

static double elapsed_time(const struct state *s)
{
	return s->base + (double)s->steps * s->dt;
}

/* Counts steps rather than summing dt, so that a constant time step accumulates no rounding errors. */
static void advance_time(struct state *s, double dt)
{
	if (s->dt < dt || s->dt > dt) {
		s->base = elapsed_time(s);
		s->steps = 0;
		s->dt = dt;
	}
	s->steps++;
}

static bool is_rate_of_leg(const struct leg *leg, const struct rate *r)
{
	return memcmp(&leg->rate, r, sizeof *r) == 0;
}

static void begin_leg(struct state *s, const struct rate *r, double dt)
{
	s->leg.rate = *r;
	s->leg.time = elapsed_time(s) - dt;
	ts_scale(1, s->shift, s->leg.shift);
	s->leg.angle = s->angle;
}

static void integrate_motion(struct state *s, const struct rate *r, double dt)
{
	bool steady = motion_kind(s)->steady;
	double span = dt;

	if (steady && !is_rate_of_leg(&s->leg, r))
		begin_leg(s, r, dt);
	if (steady)
		span = elapsed_time(s) - s->leg.time;
	for (int k = 0; k < 3; k++)
		s->shift[k] = (steady ? s->leg.shift[k] : s->shift[k]) + span * r->drift[k];
	s->angle = (steady ? s->leg.angle : s->angle) + span * r->spin;
}

static enum ts_status initial_integrate(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	struct ts_mesh_motion m = { .now = ts_motion_none() };
	struct rate r = { 0 };

	advance_time(s, sim->clock.dt);
	TS_TRY(motion_kind(s)->rate(self, sim, elapsed_time(s), &r));
	integrate_motion(s, &r, sim->clock.dt);
	for (int k = 0; k < 3; k++) {
		m.now.shift[k] = s->shift[k];
		m.drift[k] = r.drift[k];
		if (motion_kind(s)->turns) {
			m.now.origin[k] = s->mover.origin[k];
			m.spin[k] = r.spin * s->unit[k];
		}
	}
	if (motion_kind(s)->turns)
		ts_motion_set_turn(&m.now, s->unit, s->angle);
	return ts_mesh_mover_move(self, sim, &m);
}

/* Whether no other fix moves the mesh: then this fix alone determines its path. */
static bool is_alone(const struct ts_instance *self, const struct tsim *sim)
{
	const struct state *s = self->state;
	const struct ts_instance *other;

	for (size_t k = 0; (other = ts_sim_next_of(sim, TS_KIND_FIX, TS_FAMILY_MESH_MOVER, &k));)
		if (other != self &&
		    ts_streq(((const struct ts_mesh_mover *)other->state)->mesh, s->mover.mesh))
			return false;
	return true;
}

/* Time until a point at x with the velocity v leaves the box through a fixed face; infinite: it does not. */
static double exit_time(const struct ts_box *box, const double x[3], const double v[3])
{
	double first = INFINITY;

	for (int d = 0; d < 3; d++) {
		if (v[d] > 0 && box->face[d][1] == TS_FACE_FIXED)
			first = fmin(first, (box->hi[d] - x[d]) / v[d]);
		if (v[d] < 0 && box->face[d][0] == TS_FACE_FIXED)
			first = fmin(first, (box->lo[d] - x[d]) / v[d]);
	}
	return first;
}

static enum ts_status review(struct ts_instance *self, struct tsim *sim)
{
	const struct state *s = self->state;
	const struct ts_mesh_surface *surface = ts_mesh_surface_find(sim, s->mover.mesh);
	double first = INFINITY, time = (double)sim->review.steps * sim->clock.dt;

	if (!surface || motion_kind(s)->rate != linear_rate || !is_alone(self, sim) || sim->review.stale ||
	    sim->run.in_pieces)
		return TS_OK;
	for (size_t t = 0; t < surface->mesh.n; t++)
		first = fmin(first, exit_time(&sim->domain->box, surface->mesh.centre[t], s->velocity));
	if (!(first < time))
		return TS_OK;
	return ts_review_report(sim, "mesh_leaves", &self->where,
				"mesh %s leaves the box in a time of %g, after %.0f of the %" PRId64
				" steps of this run, which stops there; shorten the run, enlarge the box, or "
				"use boundary `m`, which follows the mesh",
				s->mover.mesh, first, floor(first / sim->clock.dt + 1e-6), sim->review.steps);
}

#define VELOCITY_ROW                                                                            \
	TS_VEC3("velocity", struct state, velocity, .flags = TS_POSITIONAL, .unit = "velocity", \
		.help = "Vx Vy Vz")
#define RATE_ROW(k, c)                                                                      \
	TS_NUMBER("V" c, struct state, rate[k], .flags = TS_POSITIONAL, .unit = "velocity", \
		  .help = c " velocity, usually a variable")
#define ORIGIN_ROW                                                                            \
	TS_VEC3("origin", struct state, mover.origin, .flags = TS_STATEFUL, .unit = "length", \
		.help = "a point of the axis")
#define AXIS_ROW(help_) TS_VEC3("axis", struct state, axis, .flags = TS_STATEFUL, .help = help_)
#define PERIOD_ROW                                                                    \
	TS_REAL("period", struct state, period, .range = TS_POSITIVE, .unit = "time", \
		.help = "time of one revolution or oscillation")
#define TERM_ROWS                                                                                        \
	TS_INT("order", struct state, nterms, .range = TS_WITHIN, .lo = 1, .hi = MOST_TERMS,             \
	       .help = "number of terms"),                                                               \
		TS_SOME_KEYWORD("amplitude", struct state, amplitudes, 0,                                \
				.help = "amplitude of each term: length, or radian"),                    \
		TS_SOME_KEYWORD("phase", struct state, phases, 0, .help = "phase of each term, radian"), \
		TS_SOME_KEYWORD("period", struct state, periods, 0, .help = "period of each term, time")

static const struct ts_arg linear_rows[] = { VELOCITY_ROW, TS_ARGS_END };
static const struct ts_arg linear_variable_rows[] = { RATE_ROW(0, "x"), RATE_ROW(1, "y"), RATE_ROW(2, "z"),
						      TS_ARGS_END };
static const struct ts_arg rotate_rows[] = {
	ORIGIN_ROW,
	AXIS_ROW("direction of the axis; rotation by the right-hand rule"),
	TS_REAL("period", struct state, period, .unit = "time",
		.help = "time of one revolution; below 0: the other way round"),
	TS_ARGS_END,
};
static const struct ts_arg rotate_variable_rows[] = {
	ORIGIN_ROW,
	AXIS_ROW("direction of the axis"),
	TS_NUMBER("omega", struct state, omega, .unit = "radian/time",
		  .help = "angular velocity, usually a variable"),
	TS_ARGS_END,
};
static const struct ts_arg wiggle_rows[] = {
	TS_VEC3("amplitude", struct state, amplitude, .unit = "length", .help = "Ax Ay Az"),
	PERIOD_ROW,
	TS_ARGS_END,
};
static const struct ts_arg riggle_rows[] = {
	ORIGIN_ROW,  AXIS_ROW("direction of the axis"),
	PERIOD_ROW,  TS_REAL("amplitude", struct state, swing, .unit = "degrees", .help = "largest angle"),
	TS_ARGS_END,
};
static const struct ts_arg viblin_rows[] = {
	AXIS_ROW("direction of the vibration"),
	TERM_ROWS,
	TS_ARGS_END,
};
static const struct ts_arg vibrot_rows[] = {
	ORIGIN_ROW,
	AXIS_ROW("direction of the axis"),
	TERM_ROWS,
	TS_ARGS_END,
};

#define MODES(ending)                                                                                 \
	{ "linear" ending, "at constant velocity", linear_rows },                                     \
		{ "linear/variable" ending, "with a velocity by variables", linear_variable_rows },   \
		{ "rotate" ending, "around an axis", rotate_rows },                                   \
		{ "rotate/variable" ending, "around an axis, with an angular velocity by a variable", \
		  rotate_variable_rows },                                                             \
		{ "wiggle" ending, "oscillation", wiggle_rows },                                      \
		{ "riggle" ending, "oscillation around an axis", riggle_rows },                       \
		{ "viblin" ending, "a sum of oscillations along a line", viblin_rows },               \
	{                                                                                             \
		"vibrot" ending, "a sum of oscillations around an axis", vibrot_rows                  \
	}
static const struct ts_mode modes[] = { MODES(""), MODES("/superposable"), { .name = NULL } };

static const char *const movable[] = { "mesh", NULL };
static const struct ts_arg args[] = {
	TS_ENUM("what", struct state, what, movable, .flags = TS_POSITIONAL, .help = "what moves"),
	TS_WORD("mesh-ID", struct state, mover.mesh, .flags = TS_POSITIONAL,
		.help = "ID of a fix mesh/surface"),
	{ .name = "style",
	  .type = TS_ARG_MODE,
	  .flags = TS_POSITIONAL | TS_STATEFUL,
	  .offset = TS_FIELD(struct state, mode, int *),
	  .modes = modes,
	  .help = "kind of motion" },
	TS_ARGS_END,
};

static const struct ts_saved saved[] = {
	TS_SAVE_I64(struct state, mover.serial),
	TS_SAVE_F64(struct state, base),
	TS_SAVE_F64(struct state, dt),
	TS_SAVE_F64(struct state, shift),
	TS_SAVE_F64(struct state, angle),
	TS_SAVE_I64(struct state, steps),
	TS_SAVED_ROWS_END,
};

static enum ts_status archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *a)
{
	struct state *s = self->state;

	(void)sim;
	if (!ts_archive_writing(a) && !ts_archive_has(a, "leg")) /* older files have none */
		return TS_OK;
	return ts_archive_fixed(a, "leg", TS_SAVED_F64, &s->leg, sizeof s->leg / sizeof(double));
}

TS_STYLE(fix, ts_style, ts_fix_move_mesh)
const struct ts_style ts_fix_move_mesh = {
	.name = "move/mesh",
	.kind = TS_KIND_FIX,
	.ranks = TS_RANKS_OWN | TS_RANKS_OUTPUTS | TS_RANKS_REVIEW | TS_RANKS_ROWLESS,
	.summary = "Prescribed motion of a mesh",
	.doc = "Moves the mesh of a `fix mesh/surface` as a rigid body. With the time t since the definition "
	       "of the fix and w = 2 pi/period:\n\n"
	       "  linear            x = x0 + V t\n"
	       "  rotate            rotation about the axis by the angle w t\n"
	       "  wiggle            velocity A w cos(w t)\n"
	       "  riggle            angular velocity A w cos(w t)\n"
	       "  viblin            velocity along the axis -sum_n C_n w_n sin(w_n t + phase_n)\n"
	       "  vibrot            angular velocity about the axis, the same sum\n"
	       "  linear/variable   velocity by variables\n"
	       "  rotate/variable   angular velocity by a variable\n\n"
	       "linear and rotate are exact at any time. The others advance the mesh in each step by the "
	       "velocity at its end times the time step, as LIGGGHTS does, so that wiggle differs from A "
	       "sin(w t) in the order of the time step. Contact laws use the velocity of the surface at the "
	       "contact point; in the forces before the first step the mesh is at rest, as in LIGGGHTS.\n\n"
	       "Several fixes may move one mesh: they act one after the other in each step, and each of them "
	       "also moves the origins of those after it (in LIGGGHTS not those of riggle and vibrot). If a "
	       "fix is deleted, the mesh stays where it is, and goes on from there if a script that "
	       "continues from a restart file gives another velocity or period; origin, axis and kind of "
	       "motion stay. A mesh with surface_vel or surface_ang_vel cannot move.\n\n"
	       "Related: fix mesh/surface, fix move/mesh/free, fix mesh/surface/stress/servo.",
	.example = "fix lift all move/mesh mesh cad linear 0 0 0.1\n"
		   "fix spin all move/mesh mesh cad rotate origin 0 0 0 axis 0 0 1 period 2.385\n"
		   "fix shake all move/mesh mesh cad viblin axis 0 0 1 order 2 amplitude 0.01 0.002 phase 0 "
		   "1.3 period 0.1 0.031",
	.args = args,
	.family = TS_FAMILY_MESH_MOVER,
	.state_size = sizeof(struct state),
	.saved = saved,
	.archive = archive,
	.init = init,
	.review = review,
	.hook = { [TS_STAGE_INITIAL_INTEGRATE] = initial_integrate },
};
