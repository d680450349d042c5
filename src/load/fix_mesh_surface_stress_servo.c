/* Fix mesh/surface/stress/servo: a controller moves or rotates a mesh until particles exert a target force
 * or torque on it. */
#include "core/ranks.h"
#include "core/report.h"
#include "law/servo.h"
#include "mesh/mesh_load.h"
#include "mesh/mesh_motion.h"
#include "mesh/mesh_style.h"
#include "neigh/neigh.h"
#include "load/mesh_stress.h"
#include "load/servo_response.h"

#include <math.h>
#include <string.h>

#include "base/banned.h"

struct state {
	struct ts_mesh_surface surface;
	struct ts_mesh_words words;
	struct ts_mesh_stress stress;
	/* arguments */
	double com[3], axis[3], fastest, kp, ki, kd, ratio;
	struct ts_number wanted;
	int controlled, mode;

	int moves;	      /* START, or STOP by fix_modify */
	double unit[3];	      /* unit vector along the axis */
	double target;	      /* present target force or torque */
	double lever;	      /* for torque: distance of the farthest corner from the axis, length */
	double off;	      /* error after this step, relative to the target */
	int64_t flips, since; /* number of oscillations of the speed, in the last `since` steps */
	bool warned;	      /* the review before the run has reported an unstable gain */
	/* saved */
	double speed;	  /* for the next step, velocity: of the mesh, or of the farthest corner */
	double gone;	  /* displacement, length, or rotation, radian, so far */
	double sum, last; /* of the error: integral over time, value of the last step */
	double gain;	  /* kp if none is given; 0: not chosen yet */
};

enum { FORCE, TORQUE };
enum { PID, AUTO };
enum { START, STOP };
static const char *const controlled_names[] = { "force", "torque", NULL };
static const char *const mode_names[] = { "pid", "auto", NULL };
static const char *const moves_names[] = { "start", "stop", NULL };

/* ---- before a run ---- */

static double largest_lever(const struct state *s)
{
	double most = 0;

	for (size_t c = 0; c < 3 * s->surface.mesh.n; c++) {
		double arm[3], across[3];

		ts_sub(s->surface.mesh.x[c / 3][c % 3], s->com, arm);
		ts_cross(s->unit, arm, across);
		most = fmax(most, ts_norm(across));
	}
	return most;
}

static enum ts_status set_target(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	TS_TRY(ts_number_now(sim, &s->wanted, &self->where, &s->target));
	if (fabs(s->target) > 0)
		return TS_OK;
	return ts_fail(&sim->error, TS_RANGE, ts_instance_word(self, "target_val"),
		       "fix %s: target_val must not be 0: errors are relative to it", self->style->name);
}

static enum ts_status check_axis_and_target(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	double length = ts_norm(s->axis);

	if (!(length > 0))
		return ts_fail(&sim->error, TS_RANGE, ts_instance_word(self, "axis"),
			       "fix %s: the axis has no length", self->style->name);
	ts_scale(1 / length, s->axis, s->unit);
	TS_TRY(set_target(self, sim));
	if (s->mode == AUTO && !(s->ratio > 0))
		return ts_fail(&sim->error, TS_SYNTAX, ts_instance_word(self, "mode"),
			       "fix %s: mode auto needs `ratio`, > 0", self->style->name);
	return TS_OK;
}

/* ---- gains ---- */

/* Of the particles of all ranks; 0: there are none. */
static double smallest_radius(const struct tsim *sim)
{
	const struct ts_particles *p = sim->particles;
	double least = INFINITY;

	for (size_t i = 0; i < p->n; i++)
		least = fmin(least, p->radius[i]);
	least = -ts_ranks_most(sim, -least);
	return isfinite(least) ? least : 0;
}

/* Default of kp in LIGGGHTS, and the fraction of the largest stable kp that is used if that is smaller. */
static const double USUAL_GAIN = 0.01, SAFE_PART = 0.1;

static bool has_default_gain(const struct state *s)
{
	return isnan(s->kp) && !(s->ki > 0) && !(s->kd > 0);
}

static double present_kp(const struct state *s)
{
	return !isnan(s->kp) ? s->kp : s->gain > 0 ? s->gain : USUAL_GAIN;
}

/* Root mean square of the distance of the mesh from the axis, weighted by area. */
static double rms_arm(const struct state *s)
{
	const struct ts_mesh *m = &s->surface.mesh;
	double sum = 0, area = 0;

	for (size_t c = 0; c < 3 * m->n; c++) {
		double arm[3], across[3];

		ts_sub(m->x[c / 3][c % 3], s->com, arm);
		ts_cross(s->unit, arm, across);
		sum += m->area[c / 3] * ts_dot(across, across);
		area += m->area[c / 3];
	}
	return area > 0 ? sqrt(sum / area) : 0;
}

static struct ts_servo_mesh controlled_mesh(const struct state *s)
{
	struct ts_servo_mesh mesh = { .surface = &s->surface, .load = fabs(s->target) };

	ts_scale(1, s->unit, mesh.axis);
	if (s->controlled == TORQUE)
		mesh.lever = mesh.arm = s->lever;
	return mesh;
}

/* The factor by which the gains may be multiplied until the loop with these contacts becomes unstable. */
static double gain_margin(const struct state *s, const struct tsim *sim, const struct ts_servo_contacts *c)
{
	double unit = s->fastest / fabs(s->target);
	struct ts_servo_loop loop = { c->stiffness,
				      c->damping,
				      { unit * present_kp(s), unit * s->ki, unit * s->kd } };

	if (s->mode == AUTO) /* where the error is small */
		loop = (struct ts_servo_loop){ c->stiffness,
					       c->damping,
					       { 0.1 * s->ratio * smallest_radius(sim) / sim->clock.dt /
						 fabs(s->target) } };
	return c->n > 0 ? ts_servo_margin(&loop, sim->clock.dt) : INFINITY;
}

/* Chooses kp when a run begins, but not when it resumes: so a run cut in two has the same gain. */
static void choose_gain(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	struct ts_servo_mesh mesh = controlled_mesh(s);
	struct ts_servo_contacts most;

	if (s->mode == AUTO || !has_default_gain(s) || sim->run.resuming)
		return;
	s->gain = USUAL_GAIN;
	if (sim->legacy == TS_LEGACY_LIGGGHTS)
		return;
	most = ts_servo_contacts(sim, &mesh, ts_servo_most_contacts(sim, &mesh), true);
	s->gain = fmin(USUAL_GAIN, SAFE_PART * gain_margin(s, sim, &most) * USUAL_GAIN);
	if (s->gain < USUAL_GAIN && !sim->reading.explain)
		ts_log(&sim->log,
		       "fix %s: kp is %.4g, %g of the largest that is stable with %.0f contacts (stiffness "
		       "%.3g, damping %.3g by speed)\n",
		       self->id, s->gain, SAFE_PART, most.n, most.stiffness, most.damping);
}

/* Reports gains that are unstable with the present contacts, or with a single one: the number of contacts
 * later in the run is not known. */
static enum ts_status review(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	struct ts_servo_mesh mesh = controlled_mesh(s);
	size_t touching = ts_servo_touching(sim, &s->surface);
	struct ts_servo_contacts few;
	double part;

	s->warned = false;
	if (s->moves == STOP || (s->mode == PID && has_default_gain(s) && sim->legacy != TS_LEGACY_LIGGGHTS))
		return TS_OK;
	mesh.arm = mesh.lever > 0 ? rms_arm(s) : 0;
	few = ts_servo_contacts(sim, &mesh, fmax(1, (double)touching), false);
	part = gain_margin(s, sim, &few);
	s->warned = part < 1;
	if (!s->warned)
		return TS_OK;
	return ts_review_report(sim, "servo", &self->where,
				"the servo of mesh %s is unstable: with %g contact%s at the target "
				"(stiffness %.3g, damping coefficient %.3g) and the time step %g its "
				"stability limit is %.3g times its %s; reduce %s%.3g, vel_max or `timestep`",
				self->id, few.n, few.n > 1 ? "s" : "", few.stiffness, few.damping,
				sim->clock.dt, part, s->mode == AUTO ? "ratio" : "gains",
				s->mode == AUTO ? "the ratio below " : "kp below ",
				part * (s->mode == AUTO ? s->ratio : present_kp(s)));
}

/* The limit of vel_max is that of LIGGGHTS; it applies if the script gives a skin. */
static enum ts_status plan(struct ts_instance *self, struct tsim *sim, struct ts_plan_report *report)
{
	const struct state *s = self->state;
	double limit = sim->neigh->skin / (2 * sim->clock.dt);

	TS_TRY(ts_mesh_surface_plan(self, sim, report));
	if (!report->limits_only)
		choose_gain(self, sim);
	if (!(sim->neigh->skin > 0) || s->fastest < limit)
		return TS_OK;
	return ts_fail(&sim->error, TS_RANGE, ts_instance_word(self, "vel_max"),
		       "fix %s: vel_max is %g, but must be below skin/(2 dt) = %g: in a step the mesh may "
		       "not pass the skin that `neighbor` gives; take a larger one or a smaller `timestep`",
		       self->style->name, s->fastest, limit);
}

/* Moves the mesh to its present displacement or rotation. */
static enum ts_status move_mesh(struct state *s, struct tsim *sim)
{
	struct ts_motion m = ts_motion_none();

	ts_scale(1, s->com, m.origin);
	if (s->controlled == FORCE)
		ts_scale(s->gone, s->unit, m.shift);
	else
		ts_motion_set_turn(&m, s->unit, s->gone);
	return ts_mesh_surface_set_motion(sim, &s->surface, &m);
}

static enum ts_status refuse_words(struct ts_instance *self, struct tsim *sim)
{
	const struct state *s = self->state;
	const struct ts_place *reference = ts_instance_word(self, "reference_point");

	if (s->words.surface_vel.n || s->words.surface_ang_vel.n)
		return ts_fail(&sim->error, TS_STATE,
			       ts_instance_word(self,
						s->words.surface_vel.n ? "surface_vel" : "surface_ang_vel"),
			       "fix %s: a servo moves, and its surface cannot move like a belt, too",
			       self->style->name);
	if (reference != &self->where)
		return ts_fail(&sim->error, TS_STATE, reference,
			       "fix %s: torques on a servo are about `com`, it has no reference_point",
			       self->style->name);
	return TS_OK;
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	bool first = !s->surface.mesh.n;

	TS_TRY(refuse_words(self, sim));
	if (first)
		ts_scale(1, s->com, s->stress.given);
	TS_TRY(ts_mesh_surface_init(self, sim, &s->words));
	TS_TRY(ts_mesh_stress_init(self, sim, &s->surface, &s->stress));
	s->stress.followed = true;
	TS_TRY(check_axis_and_target(self, sim));
	if (!first)
		return TS_OK;
	s->last = s->target > 0 ? 1 : -1;
	s->lever = largest_lever(s);
	return move_mesh(s, sim);
}

/* ---- the controller ---- */

/* Speed in mode auto: vel_max while no particle is near, else ratio R_min/h, times min(|e|, 1) g with g =
 * 0.1 for |e| <= 0.9, from there linear to 1 at |e| = 1. */
static double auto_speed(const struct ts_instance *self, const struct tsim *sim, double error)
{
	const struct state *s = self->state;
	double size = fmin(fabs(error), 1), gain = size <= 0.9 ? 0.1 : 0.1 + 9 * (size - 0.9);
	double speed = s->fastest;

	if (ts_ranks_most(sim, ts_surface_contacts_listed(sim, self)) > 0)
		speed = s->ratio * smallest_radius(sim) / sim->clock.dt;
	return copysign(size * gain, error) * speed;
}

/* Speed in mode pid. If the output exceeds its limit, the integral is set so that the proportional and the
 * integral term together give the opposite limit, as in LIGGGHTS (anti-windup). */
static double pid_speed(struct state *s, double error, double dt)
{
	double output;

	s->sum += error * dt;
	output = present_kp(s) * error + s->ki * s->sum + s->kd * (error - s->last) / dt;
	s->last = error;
	if (fabs(output) <= 1)
		return s->fastest * output;
	if (s->ki > 0)
		s->sum = (-copysign(1, output) - present_kp(s) * error) / s->ki;
	return s->fastest * copysign(1, output);
}

/* If the gain is too large for the time step, the speed oscillates between its limits, as elastic and
 * damping forces of the contacts follow the speed within a step. Sign changes are counted over WATCHED
 * steps; FLIPS of them are reported. */
enum { WATCHED = 200, FLIPS = 50 };

static enum ts_status detect_oscillation(struct ts_instance *self, struct tsim *sim, double before,
					 double error)
{
	struct state *s = self->state;
	bool at_limits = fabs(before) >= 0.999 * s->fastest && fabs(s->speed) >= 0.999 * s->fastest;
	bool far_off = fmin(fabs(error), fabs(s->off)) > 0.5 && error * s->off < 0;

	s->off = error;
	s->flips += (at_limits || far_off) && before * s->speed < 0;
	if (++s->since < WATCHED)
		return TS_OK;
	if (s->flips >= FLIPS && !s->warned)
		TS_TRY(ts_review_report(sim, "servo", &self->where,
					"the servo of mesh %s oscillated %d times in %d steps, with its "
					"largest speed or by more than half of the target: its gain is too "
					"large for the stiffness and damping of the contacts; reduce %s (now "
					"%g), vel_max (now %g) or `timestep`",
					self->id, (int)s->flips, WATCHED, s->mode == AUTO ? "ratio" : "kp",
					s->mode == AUTO ? s->ratio : present_kp(s), s->fastest));
	s->flips = s->since = 0;
	return TS_OK;
}

static void set_velocities(struct state *s, double speed)
{
	const struct ts_mesh *m = &s->surface.mesh;

	for (size_t c = 0; c < 3 * m->n; c++) {
		double *v = s->surface.v[c / 3][c % 3], arm[3];

		ts_scale(speed, s->unit, v);
		if (s->controlled == FORCE)
			continue;
		ts_sub(m->x[c / 3][c % 3], s->com, arm);
		ts_cross(s->unit, arm, v);
		ts_scale(speed / s->lever, v, v);
	}
}

static enum ts_status final_integrate(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	double met, error, before = s->speed;

	TS_TRY(ts_mesh_stress_settle(self, sim));
	if (s->moves == STOP)
		return TS_OK;
	if (s->wanted.variable)
		TS_TRY(set_target(self, sim));
	met = -ts_dot(s->stress.sum[s->controlled == TORQUE], s->unit);
	error = (s->target - met) / fabs(s->target);
	s->speed = s->mode == AUTO ? auto_speed(self, sim, error) : pid_speed(s, error, sim->clock.dt);
	set_velocities(s, s->speed);
	return detect_oscillation(self, sim, before, error);
}

static enum ts_status initial_integrate(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	if (s->moves == STOP)
		return TS_OK;
	s->gone += (s->controlled == FORCE ? s->speed : s->speed / s->lever) * sim->clock.dt;
	return move_mesh(s, sim);
}

/* ---- fix_modify ---- */

static const struct ts_arg gain_rows[] = {
	TS_REAL("kp", struct state, kp, .flags = TS_POSITIONAL, .range = TS_NOT_NEGATIVE, .help = "kp"),
	TS_REAL("ki", struct state, ki, .flags = TS_POSITIONAL, .range = TS_NOT_NEGATIVE, .help = "ki"),
	TS_REAL("kd", struct state, kd, .flags = TS_POSITIONAL, .range = TS_NOT_NEGATIVE, .help = "kd"),
	TS_ARGS_END,
};
static const struct ts_arg target_rows[] = {
	TS_NUMBER("target_val", struct state, wanted, .flags = TS_POSITIONAL, .help = "target"),
	TS_ARGS_END,
};
static const struct ts_arg fastest_rows[] = {
	TS_REAL("vel_max", struct state, fastest, .flags = TS_POSITIONAL, .range = TS_POSITIVE,
		.help = "largest speed"),
	TS_ARGS_END,
};
static const struct ts_arg integrate_rows[] = {
	TS_ENUM("integrate", struct state, moves, moves_names, .flags = TS_POSITIONAL,
		.help = "start or stop"),
	TS_ARGS_END,
};

/* After a change of target or gains: converts the error of the last step to the new target, and sets the
 * integral to 0. */
static void reset_controller(struct state *s, double before)
{
	double met = before - s->last * fabs(before);

	s->last = (s->target - met) / fabs(s->target);
	s->sum = 0;
}

static const struct modifier {
	const char *name;
	size_t nwords;
	const struct ts_arg *rows;
} modifiers[] = {
	{ "servo/integrate", 1, integrate_rows },
	{ "servo/target_val", 1, target_rows },
	{ "servo/vel_max", 1, fastest_rows },
	{ "servo/ctrlParam", 3, gain_rows },
};

/* LIGGGHTS reads the names with and without the prefix. */
static bool is_modifier(const struct modifier *m, const char *word)
{
	return ts_streq(m->name, word) || ts_streq(m->name + strlen("servo/"), word);
}

static enum ts_status modify(struct ts_instance *self, struct tsim *sim, struct ts_words words, size_t *used)
{
	struct ts_words rest = ts_words_from(words, 1);
	struct state *s = self->state;
	double target = s->target;

	*used = 0;
	for (size_t k = 0; k < sizeof modifiers / sizeof *modifiers; k++) {
		const struct modifier *m = &modifiers[k];

		if (!is_modifier(m, words.word[0].text))
			continue;
		*used = 1 + (rest.n < m->nwords ? rest.n : m->nwords);
		rest.n = *used - 1;
		TS_TRY(ts_args_parse(sim, m->name, m->rows, rest, &words.word[0].place, &self->arena, s));
		TS_TRY(check_axis_and_target(self, sim));
		if (m->rows == target_rows || m->rows == gain_rows)
			reset_controller(s, target);
		return TS_OK;
	}
	return TS_OK;
}

/* ---- the style ---- */

static const struct ts_arg args[] = {
	TS_MESH_ARGS(struct state, words, surface),
	TS_MESH_STRESS_ARGS(struct state, stress),
	TS_VEC3("com", struct state, com, .unit = "length",
		.help = "reference point of torque and rotation, on the mesh as it is placed"),
	TS_ENUM("ctrlPV", struct state, controlled, controlled_names, .flags = TS_STATEFUL,
		.help = "controlled quantity: force (the mesh moves along the axis) or torque (it rotates "
			"about it)"),
	TS_VEC3("axis", struct state, axis, .flags = TS_STATEFUL, .help = "direction of the axis"),
	TS_NUMBER("target_val", struct state, wanted, .unit = "force or torque",
		  .help = "force or torque that the mesh shall exert on particles along the axis; a variable "
			  "is evaluated in each step"),
	TS_REAL("vel_max", struct state, fastest, .range = TS_POSITIVE, .unit = "velocity",
		.help = "largest speed of the mesh; with torque, of its corner farthest from the axis"),
	TS_REAL("kp", struct state, kp, .flags = TS_OPTIONAL, .range = TS_NOT_NEGATIVE, .unit = "",
		.help = "proportional gain; default 0.01, or, if ki and kd are not given either, a tenth of "
			"the largest stable gain if that is smaller"),
	TS_REAL("ki", struct state, ki, .fallback = "0", .range = TS_NOT_NEGATIVE, .unit = "1/time",
		.help = "integral gain"),
	TS_REAL("kd", struct state, kd, .fallback = "0", .range = TS_NOT_NEGATIVE, .unit = "time",
		.help = "derivative gain"),
	TS_ENUM("mode", struct state, mode, mode_names, .fallback = "pid",
		.help = "pid: PID controller; auto: speed by `ratio`"),
	TS_REAL("ratio", struct state, ratio, .fallback = "0", .range = TS_NOT_NEGATIVE, .unit = "",
		.help = "mode auto: largest displacement of the mesh in a step, in smallest radii"),
	TS_ARGS_END,
};

enum { NUMBERS = 12 };
static const char *const number_names[NUMBERS] = { TS_MESH_STRESS_NAMES, "xcm", "ycm", "zcm" };

/* The last three: the point `com`, which moves with the mesh. */
static enum ts_status eval_numbers(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct state *s = self->state;

	TS_TRY(ts_mesh_stress_eval(self, sim, out));
	for (int k = 0; k < 3; k++)
		out->data[9 + k] = s->com[k] + (s->controlled == FORCE ? s->gone * s->unit[k] : 0);
	return TS_OK;
}

static const struct ts_value values[] = {
	{ "stress", "force, torque, length",
	  "force on the mesh and torque about the reference point in the last step, that point, and the "
	  "centre `com`",
	  TS_VECTOR, NUMBERS, number_names, eval_numbers },
	TS_MESH_STRESS_TRIANGLES,
	{ .name = NULL },
};

static const struct ts_saved saved[] = {
	TS_SAVE_F64(struct state, speed),
	TS_SAVE_F64(struct state, gone),
	TS_SAVE_F64(struct state, lever),
	TS_SAVE_F64(struct state, sum),
	TS_SAVE_F64(struct state, last),
	TS_SAVE_F64(struct state, gain),
	TS_SAVED_ROWS_END,
};

static const struct ts_arg_group groups[] = {
	{ NULL, "com ctrlPV axis target_val vel_max" },
	{ "The controller", "kp ki kd mode ratio" },
	TS_MESH_STRESS_GROUP,
	TS_MESH_GROUPS,
	{ .words = NULL },
};

TS_STYLE(fix, ts_style, ts_fix_mesh_surface_stress_servo)
const struct ts_style ts_fix_mesh_surface_stress_servo = {
	.name = "mesh/surface/stress/servo",
	.kind = TS_KIND_FIX,
	.ranks = TS_RANKS_OWN | TS_RANKS_OUTPUTS,
	.join = ts_mesh_stress_join,
	.summary = "A mesh that moves or rotates until particles exert a given force or torque on it",
	.purpose = "A punch, a lid or a blade that moves until grains press on it with a given force or "
		   "torque: compaction, shear cells, drill bits.",
	.doc = "A mesh as with fix mesh/surface/stress, with com as its reference point, that moves along "
	       "the axis (ctrlPV force) or rotates about the axis through com (ctrlPV torque). After each "
	       "step the controller computes the relative error\n\n"
	       "  e = (target_val - P)/|target_val|,\n\n"
	       "P being the force or torque that the mesh exerts on particles along the axis, the opposite "
	       "of f_ID[1..3] or f_ID[4..6]. In the next step the speed is vel_max o, with\n\n"
	       "  o = kp e + ki sum(e h) + kd (e - e_last)/h,  |o| <= 1,\n\n"
	       "h being the time step. Where o exceeds its limit, sum(e h) is set so that kp e + ki sum(e h) "
	       "equals the opposite limit, as in LIGGGHTS. With ctrlPV torque this is the speed of the "
	       "corner farthest from the axis.\n\n"
	       "`mode auto`: the speed is vel_max while no particle is listed near the mesh; else it is "
	       "ratio R_min/h, R_min being the smallest radius, times min(|e|, 1) g, with g = 0.1 up to |e| "
	       "= 0.9 and from there linear to 1.\n\n"
	       "Stability: the force follows the speed within a step. Contacts with the total stiffness K "
	       "and damping C give P = K x + C v. With kp alone this is stable below\n\n"
	       "  kp_max = 2 |target_val| / (vel_max (K h + 2 C)),\n\n"
	       "with ki and kd if the zeros of the characteristic polynomial of the loop are in the unit "
	       "circle (law/servo.h). With ctrlPV torque K and C are those of the torque as a function of "
	       "the displacement of the farthest corner.\n\n"
	       "Default gain: if the script gives no gain, kp is 0.01, as in LIGGGHTS, or kp_max/10 if that "
	       "is smaller. It is chosen when a run begins, and printed in the log. K and C are then those "
	       "of N contacts with the smallest particles (existing or to be inserted) under the load "
	       "target_val/N, with N = A/(4 R^2), R being their radius and A the area of the mesh projected "
	       "along the axis; N is at most the number of particles if none are inserted. If target_val is "
	       "a variable, its value at that time counts. With `legacy yes` kp is always 0.01.\n\n"
	       "Gains in the script are used as they are. If they exceed the limit for the present contacts, "
	       "or for a single contact, a warning is printed before the run; so is one during the run if "
	       "the speed oscillates (doc/review.md, servo).\n\n"
	       "vel_max must be below skin/(2 h). A fix move/mesh cannot move a servo. Between runs, "
	       "`fix_modify ID servo/integrate stop` stops the mesh and the controller (particles still feel "
	       "the velocity it had, as with LIGGGHTS), `start` continues; `servo/target_val T`, "
	       "`servo/vel_max V` and `servo/ctrlParam kp ki kd` change their values.\n\n"
	       "Related: fix mesh/surface/stress, fix wall/gran.",
	.example = "fix lid all mesh/surface/stress/servo file lid.stl type 1 com 0 0 0.1 ctrlPV force axis "
		   "0 0 -1 target_val 10 vel_max 0.1",
	.args = args,
	.groups = groups,
	.family = TS_FAMILY_MESH,
	.state_size = sizeof(struct state),
	.saved = saved,
	.archive = ts_mesh_stress_archive,
	.fingerprint = ts_mesh_surface_fingerprint,
	.extent = ts_mesh_surface_extent,
	.values = values,
	.surface = ts_mesh_stress_surface,
	.observes = TS_OBSERVES_CONTACTS,
	.init = init,
	.modify = modify,
	.plan = plan,
	.review = review,
	.late = { [TS_LATE_CONTACTS] = ts_mesh_stress_sum },
	.hook = { [TS_STAGE_INITIAL_INTEGRATE] = initial_integrate,
		  [TS_STAGE_POST_BUILD] = ts_mesh_stress_post_build,
		  [TS_STAGE_FINAL_INTEGRATE] = final_integrate },
	.fini = ts_mesh_stress_fini,
};
