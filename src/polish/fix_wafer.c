/* Fix wafer: a rigid wafer on a ball joint, pressed onto a polishing pad. */
#include <math.h>

#include "core/report.h"
#include "math/constants.h"
#include "polish/wafer.h"
#include "voxel/voxel_surface.h"

#include "base/banned.h"

enum { SETTLED, DYNAMIC };

struct state {
	const char *pad_id;
	int motion;
	struct ts_number pressure;
	double friction, arm, mass, inertia[2], damping;
	int64_t every;

	struct ts_wafer wafer;
	const struct ts_voxel_surface *pad;
	struct ts_wafer_column *column;
	size_t column_capacity;
	double area; /* of the face */
	struct ts_wafer_forces forces;
	double mean_gap;
	/* saved */
	double pose[3], rate[3]; /* z and slopes, and their rates */
	bool placed;
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

	if (f->periodic[d])
		from += shift - floor((from + shift) / size) * size;
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
				s->column[n++] = (struct ts_wafer_column){
					{ part[a / rows].centre, row[a % rows].centre },
					part[a / rows].length * row[a % rows].length,
					height
				};
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
	return (struct ts_wafer_pose){ s->pose[0], { s->pose[1], s->pose[2] } };
}

static enum ts_status settle(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	struct ts_wafer_pose pose = pose_of(s);

	if (ts_wafer_settle(&s->wafer, &pose) != TS_OK)
		return ts_fail(&sim->error, TS_PHYSICS, &self->where,
			       "fix wafer %s: no equilibrium: the pad can carry at most %g of the load %g, "
			       "and friction "
			       "moves the load by %g and %g from the joint, where the face reaches %g and %g",
			       self->id, s->wafer.hardness * s->area, s->wafer.load, s->wafer.friction[0],
			       s->wafer.friction[1],
			       0.5 * (double)s->pad->field.n[0] * s->pad->field.width[0],
			       0.5 * (double)s->pad->field.n[1] * s->pad->field.width[1]);
	s->pose[0] = pose.z;
	s->pose[1] = pose.slope[0];
	s->pose[2] = pose.slope[1];
	s->placed = true;
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

/* ---- stages ---- */

static enum ts_status check_pad(struct ts_instance *self, struct tsim *sim)
{
	const struct state *s = self->state;
	const struct ts_voxel_field *f = &s->pad->field;

	for (int d = 0; d < 2; d++)
		if (fabs(s->pad->velocity[f->axis[d]]) > 0 && !f->periodic[d])
			return ts_fail(&sim->error, TS_STATE, ts_instance_word(self, s->pad_id),
				       "fix wafer: the pad %s slides along an axis along which it is not "
				       "periodic: it "
				       "would leave the wafer",
				       s->pad_id);
	if (s->motion == DYNAMIC && !(s->mass > 0 && s->inertia[0] > 0 && s->inertia[1] > 0))
		return ts_fail(&sim->error, TS_SYNTAX, &self->where,
			       "fix wafer dynamic: mass and both moments of inertia must be > 0");
	return TS_OK;
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	struct ts_word id = { .text = s->pad_id, .place = *ts_instance_word(self, s->pad_id) };
	struct ts_voxel_surface *pad;

	TS_TRY(ts_voxel_surface_require(sim, &id, &pad));
	s->pad = pad;
	s->area = (double)(pad->field.n[0] * pad->field.n[1]) * pad->field.width[0] * pad->field.width[1];
	if (isnan(s->wafer.hardness))
		s->wafer.hardness = INFINITY;
	return check_pad(self, sim);
}

/* The pad has moved; the wafer settles, or forces are those at its new place. */
static enum ts_status post_force(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	bool due = s->motion == SETTLED && sim->clock.step % s->every == 0;

	TS_TRY(list_columns(self, sim));
	TS_TRY(find_load(self, sim));
	if (due || !s->placed)
		TS_TRY(settle(self, sim));
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
		s->rate[d] += half * (force[d] / mass[d] - s->damping / s->mass * s->rate[d]);
}

static enum ts_status initial_integrate(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	if (s->motion == SETTLED)
		return TS_OK;
	kick(s, 0.5 * sim->clock.dt);
	for (int d = 0; d < 3; d++)
		s->pose[d] += sim->clock.dt * s->rate[d];
	return TS_OK;
}

static enum ts_status final_integrate(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	if (s->motion == DYNAMIC)
		kick(s, 0.5 * sim->clock.dt);
	return TS_OK;
}

/* All columns in elastic contact: the stiffest pad. */
static enum ts_status plan(struct ts_instance *self, struct tsim *sim, struct ts_plan_report *report)
{
	const struct state *s = self->state;
	const struct ts_voxel_field *f = &s->pad->field;
	double rate = s->wafer.stiffness * s->area / s->mass;

	(void)sim;
	if (s->motion == SETTLED)
		return TS_OK;
	for (int d = 0; d < 2; d++) {
		double size = (double)f->n[d] * f->width[d];

		rate = fmax(rate, s->wafer.stiffness * s->area * size * size / 12 / s->inertia[d]);
	}
	return ts_report_limit(report, 2 / sqrt(rate), true, &self->where,
			       "fix wafer, 2/omega with all columns of the pad in contact");
}

/* ---- outputs ---- */

static enum ts_status eval_tilt(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct state *s = self->state;

	(void)sim;
	out->data[0] = atan(hypot(s->pose[1], s->pose[2])) * 180 / TS_PI;
	return TS_OK;
}

static const char *const names[] = { "z", "slope_1", "slope_2", "load", "area", "mean_gap", "energy" };
enum { OUTPUTS = sizeof names / sizeof *names };

static enum ts_status eval_vector(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct state *s = self->state;
	const double value[OUTPUTS] = {
		s->pose[0],  s->pose[1],      s->pose[2], s->forces.normal, s->forces.area / s->area,
		s->mean_gap, s->forces.energy
	};

	(void)sim;
	for (int k = 0; k < OUTPUTS; k++)
		out->data[k] = value[k];
	return TS_OK;
}

static const struct ts_value values[] = {
	{ "tilt", "degrees", "angle between wafer and pad", TS_SCALAR, 1, NULL, eval_tilt },
	{ "wafer", "length, -, -, force, -, length, energy",
	  "height of the face below the joint, its slopes along the first and second axis of the pad, force "
	  "of the pad, "
	  "part of the area in contact, mean gap, energy of the springs",
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
	TS_NUMBER("pressure", struct state, pressure, .unit = "pressure", .help = "on the back of the wafer"),
	TS_REAL("friction", struct state, friction, .fallback = "0", .range = TS_NOT_NEGATIVE,
		.help = "coefficient of friction of pad and wafer"),
	TS_REAL("arm", struct state, arm, .fallback = "0", .range = TS_NOT_NEGATIVE, .unit = "length",
		.help = "distance of the joint from the face of the wafer"),
	TS_ARGS_END,
};

static const struct ts_saved saved[] = {
	TS_SAVE_F64(struct state, pose[0]),
	TS_SAVE_F64(struct state, pose[1]),
	TS_SAVE_F64(struct state, pose[2]),
	TS_SAVE_F64(struct state, rate[0]),
	TS_SAVE_F64(struct state, rate[1]),
	TS_SAVE_F64(struct state, rate[2]),
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

static const char doc[] = "A rigid, smooth wafer over the whole of a pad, a height field, is free to rise "
			  "and to tilt about a ball joint above "
			  "the middle of the field; slopes are small. Each column of the pad is a spring, "
			  "pressed by its depth in the wafer, up to "
			  "the hardness:\n\n"
			  "  p = min(stiffness (h - z - s_1 x_1 - s_2 x_2), hardness) >= 0\n\n"
			  "The back pressure presses on the whole area. The pad slides below the wafer with "
			  "the velocity of its fix (`move`); "
			  "friction, mu times the force of the pad, acts on the face along that velocity at "
			  "the distance `arm` below the joint, "
			  "and presses the leading edge, which the pad meets first, into the pad. The depth "
			  "in a column that yields is not kept: "
			  "the springs have no history.\n\n"
			  "settled: at each step, or each `every` steps, the wafer is in the equilibrium of "
			  "these forces. Their energy is convex, "
			  "so there is only one; it is found by Newton's method. The run ends with a message "
			  "if the pad cannot carry the load or "
			  "the moment of friction.\n\n"
			  "dynamic: height and slopes follow m z'' = N - P A - c z' and the same for the "
			  "tilt. The motion begins in "
			  "equilibrium. The largest stable time step is 2/omega, with omega^2 the largest of "
			  "k A/m and k A L_d^2/(12 I_d).\n\n"
			  "The pad must be periodic along the axes along which it slides. Wafer and "
			  "particles do not act on each other.\n\n"
			  "Related: fix surface/voxel, compute surface/contact, fix ave/time.";

TS_STYLE(fix, ts_style, ts_fix_wafer)
const struct ts_style ts_fix_wafer = {
	.name = "wafer",
	.kind = TS_KIND_FIX,
	.summary = "A wafer on a ball joint, pressed onto a polishing pad of springs",
	.doc = doc,
	.example = "fix pad all surface/voxel gaussian mean 5.31e-6 deviation 4.34e-6 correlation 0 seed 5 "
		   "type 1 cells 31 31 datum "
		   "1e-9 move linear 0.1 0.0 0.0\n"
		   "fix wafer all wafer pad settled stiffness 1e12 pressure 137895 friction 0.3 arm 20e-6\n"
		   "fix tilt all ave/time 1 1000 1000 f_wafer f_wafer[2] file tilt.txt\n"
		   "fix wafer all wafer pad dynamic mass 1e-9 inertia_1 2e-19 inertia_2 2e-19 damping 1e-3 "
		   "stiffness 1e12 pressure "
		   "137895",
	.args = args,
	.state_size = sizeof(struct state),
	.saved = saved,
	.values = values,
	.init = init,
	.hook = { [TS_STAGE_INITIAL_INTEGRATE] = initial_integrate,
		  [TS_STAGE_POST_FORCE] = post_force,
		  [TS_STAGE_FINAL_INTEGRATE] = final_integrate },
	.plan = plan,
	.fini = fini,
};
