/* Fix deform: changes the box lengths during a run. */
#include "core/sim.h"

#include <math.h>
#include <string.h>

#include "box/domain.h"
#include "flow/flow.h"
#include "math/constants.h"
#include "particle/particles.h"
#include "region/region.h"

#include "base/banned.h"

enum { SHEAR_VEL, SHEAR_ERATE, SHEAR_WIGGLE };
enum { FINAL, DELTA, SCALE, VEL, ERATE, TRATE, VOLUME, WIGGLE, VARIABLE, NONE = -1 };
enum { REMAP_X, REMAP_V, REMAP_NONE };

struct side {
	int mode;
	double a, b;		       /* numeric arguments of the mode */
	struct ts_number length, rate; /* VARIABLE */
};

struct span {
	double lo, hi, rate; /* rate: of the length */
};

struct shear {
	int mode;
	double a, b;
};

struct state {
	int64_t every;
	struct side side[3];
	struct shear shear[3]; /* xy, xz, yz */
	int remap, units;
	bool flip;

	/* saved */
	int64_t started, begin; /* begin: first step of the run to which begin_lo, begin_hi belong */
	double origin;		/* time when the fix was defined */
	double made_lo[3], made_hi[3], begin_lo[3], begin_hi[3];
	double made_slide; /* displacement of sheared images when the fix was defined */

	/* the box as this fix has seen or made it last */
	bool seen;
	struct ts_box last;
};

static const char names[] = "xyz";

/* ---- xy, xz, yz: periodic images that slide */

static const int shear_flow[3] = { 0, 0, 1 }, shear_gradient[3] = { 1, 2, 2 };

/* Which of xy, xz, yz; -1: none, 3: more than one. */
static int sheared(const struct state *s)
{
	int which = -1;

	for (int k = 0; k < 3; k++)
		if (s->shear[k].mode != NONE)
			which = which < 0 ? k : 3;
	return which;
}

/* Fixes whose result does not depend on where periodic images are and how fast they move, but by contacts. */
static const char *const with_shear[] = {
	"adapt",
	"addforce",
	"ave/atom",
	"ave/chunk",
	"ave/correlate",
	"ave/error",
	"ave/histo",
	"ave/histo/weight",
	"ave/spatial",
	"ave/time",
	"aveforce",
	"balance",
	"check/timestep/bond",
	"check/timestep/gran",
	"controller",
	"deform",
	"enforce2d",
	"freeze",
	"gravity",
	"halt",
	"heat/gran",
	"langevin",
	"lineforce",
	"lubrication",
	"momentum",
	"nve",
	"nve/limit",
	"nve/noforce",
	"nve/sphere",
	"nve/symplectic",
	"planeforce",
	"print",
	"property/atom",
	"property/global",
	"scale/diameter",
	"setforce",
	"store/force",
	"store/state",
	"vector",
	"viscous",
	"viscous/sphere",
	"wall/gran",
	"wall/reflect",
};

/* Styles that find the images across periodic faces on their own do not know that these slide. */
static enum ts_status check_styles_with_shear(struct ts_instance *self, struct tsim *sim)
{
	const struct ts_instances *fixes = &sim->instances[TS_KIND_FIX];
	const struct ts_instance *bond = ts_sim_only(sim, TS_KIND_BOND);

	if (bond)
		return ts_fail(&sim->error, TS_STATE, &self->where,
			       "fix deform: xy, xz and yz cannot be used with bonds (bond_style, line %d)",
			       bond->where.line);
	for (size_t k = 0; k < fixes->n; k++) {
		const char *name = fixes->item[k]->style->name;
		bool known = false;

		for (size_t j = 0; j < sizeof with_shear / sizeof *with_shear; j++)
			known |= ts_streq(name, with_shear[j]);
		if (!known)
			return ts_fail(&sim->error, TS_STATE, &self->where,
				       "fix deform: xy, xz and yz cannot be used with fix %s (line %d)", name,
				       fixes->item[k]->where.line);
	}
	return TS_OK;
}

static enum ts_status check_shear(struct ts_instance *self, struct tsim *sim, int sides)
{
	const struct state *s = self->state;
	const struct ts_box *box = &sim->domain->box;
	int which = sheared(s);
	const char *wrong = sides			       ? "x, y or z"
			    : which == 3		       ? "another of xy, xz, yz"
			    : s->remap != REMAP_V	       ? "remap x or none (say `remap v`)"
			    : s->every != 1		       ? "N other than 1"
			    : which > 0 && sim->dimension == 2 ? "dimension 2"
							       : NULL;

	if (wrong)
		return ts_fail(&sim->error, TS_STATE, &self->where,
			       "fix deform: a sheared box (xy, xz or yz) cannot be used with %s", wrong);
	if (!ts_box_periodic(box, shear_flow[which]) || !ts_box_periodic(box, shear_gradient[which]))
		return ts_fail(&sim->error, TS_STATE, &self->where,
			       "fix deform: %c%c needs a box that is periodic in %c and %c",
			       names[shear_flow[which]], names[shear_gradient[which]],
			       names[shear_flow[which]], names[shear_gradient[which]]);
	if (box->shear.on &&
	    (box->shear.flow != shear_flow[which] || box->shear.gradient != shear_gradient[which]))
		return ts_fail(&sim->error, TS_STATE, &self->where,
			       "fix deform: the box is sheared in %c%c already", names[box->shear.flow],
			       names[box->shear.gradient]);
	return check_styles_with_shear(self, sim);
}

/* Sets displacement and velocity of the images across the sheared faces to those at this time. */
static void shear_box(struct ts_instance *self, struct tsim *sim)
{
	const struct state *s = self->state;
	int which = sheared(s), flow = shear_flow[which], gradient = shear_gradient[which];
	const struct shear *shear = &s->shear[which];
	struct ts_domain *domain = sim->domain;
	double t = ts_sim_time(sim) - s->origin, w = 2 * TS_PI / shear->b, slide, rate;

	if (shear->mode == SHEAR_WIGGLE) {
		slide = shear->a * ts_domain_scale(sim, s->units, flow) * sin(w * t);
		rate = shear->a * ts_domain_scale(sim, s->units, flow) * w * cos(w * t);
	} else {
		rate = shear->mode == SHEAR_ERATE ? shear->a * ts_box_length(&domain->box, gradient)
						  : shear->a * ts_domain_scale(sim, s->units, flow);
		slide = rate * t;
	}
	domain->drift_group = self->group;
	domain->shear_drift = rate;
	domain->box.shear.offset =
		s->made_slide + slide - (double)domain->box.shear.turns * ts_box_length(&domain->box, flow);
}

/* From now on the box is one whose images may slide. */
static void begin_shear(struct state *s, struct tsim *sim)
{
	struct ts_shear *shear = &sim->domain->box.shear;
	int which = sheared(s);

	if (which < 0)
		return;
	shear->on = true;
	shear->flow = shear_flow[which];
	shear->gradient = shear_gradient[which];
	if (!s->started)
		s->made_slide =
			shear->offset + (double)shear->turns * ts_box_length(&sim->domain->box, shear->flow);
}

/* Members would cross a face one after the other. */
static enum ts_status refuse_bodies(struct ts_instance *self, struct tsim *sim)
{
	const struct ts_instances *fixes = &sim->instances[TS_KIND_FIX];

	for (size_t k = 0; k < fixes->n; k++) {
		const char *name = fixes->item[k]->style->name;

		if (!strncmp(name, "rigid", 5) || ts_streq(name, "multisphere"))
			return ts_fail(&sim->error, TS_STATE, &self->where,
				       "fix deform: `remap v` cannot be used with fix %s (line %d): the "
				       "velocity of a body that crosses a face cannot change part by part; "
				       "take `remap x`, or none",
				       name, fixes->item[k]->where.line);
	}
	return TS_OK;
}

static enum ts_status check_arguments(struct ts_instance *self, struct tsim *sim)
{
	const struct state *s = self->state;
	const struct ts_instances *fixes = &sim->instances[TS_KIND_FIX];
	const struct ts_instance *flow = ts_sim_only(sim, TS_KIND_FLOW);
	unsigned changes = sheared(s) >= 0 ? 1 | 2 | 4 : 0;
	int sides = 0;

	for (int k = 0; k < 3; k++) {
		const enum ts_face *face = sim->domain->box.face[k];

		if (s->side[k].mode == NONE)
			continue;
		sides++;
		changes |= 1u << k;
		if (k == 2 && sim->dimension == 2)
			return ts_fail(&sim->error, TS_STATE, &self->where,
				       "fix deform: z cannot change in two dimensions");
		for (int j = 0; j < 2; j++)
			if (face[j] == TS_FACE_SHRINK || face[j] == TS_FACE_MINIMUM)
				return ts_fail(&sim->error, TS_STATE, &self->where,
					       "fix deform: the faces of %c follow the particles, expected "
					       "boundary p or f",
					       names[k]);
	}
	if (flow && ts_flow_style_of(flow)->grid & changes)
		return ts_fail(&sim->error, TS_STATE, &self->where,
			       "fix deform: the grid of the fluid (flow_style, line %d) does not change with "
			       "the box: change the box before flow_style (`change_box`, or a run with this "
			       "fix and `unfix`), or use flow_style uniform",
			       flow->where.line);
	if (ts_sim_only(sim, TS_KIND_AUTOMATON))
		return ts_fail(&sim->error, TS_STATE, &self->where,
			       "fix deform: the lattice of the automaton (automaton_style, line %d) does not "
			       "change with the box: change the box before automaton_style",
			       ts_sim_only(sim, TS_KIND_AUTOMATON)->where.line);
	if (sheared(s) >= 0)
		return check_shear(self, sim, sides);
	if (s->remap == REMAP_V)
		TS_TRY(refuse_bodies(self, sim));
	if (!sides)
		return ts_fail(&sim->error, TS_SYNTAX, &self->where,
			       "fix deform: expected x, y, z, xy, xz or yz and its change");
	for (size_t k = 0; k < fixes->n; k++)
		if (fixes->item[k]->style == self->style && !ts_streq(fixes->item[k]->id, self->id))
			return ts_fail(&sim->error, TS_STATE, &self->where,
				       "fix deform: there is one already, %s", fixes->item[k]->id);
	return TS_OK;
}

/* Both faces move symmetrically: the centre of the box is kept. */
static struct span span_about_centre(double lo, double hi, double length, double rate)
{
	double half = 0.5 * (length - (hi - lo));

	return (struct span){ lo - half, hi + half, rate };
}

/* Faces that are to be reached at the end of the run. */
static void span_at_end_of_run(const struct state *s, const struct tsim *sim, int k, double *lo, double *hi)
{
	const struct side *side = &s->side[k];
	double scale = ts_domain_scale(sim, s->units, k), half;

	*lo = s->begin_lo[k];
	*hi = s->begin_hi[k];
	half = 0.5 * (side->a - 1) * (*hi - *lo);
	if (side->mode == FINAL) {
		*lo = scale * side->a;
		*hi = scale * side->b;
	} else if (side->mode == DELTA) {
		*lo += scale * side->a;
		*hi += scale * side->b;
	} else {
		*lo -= half;
		*hi += half;
	}
}

static struct span span_by_ramp(const struct state *s, const struct tsim *sim, int k)
{
	const struct ts_clock *c = &sim->clock;
	double steps = (double)(c->ramp_last - c->ramp_first), lo, hi;
	double part = steps > 0 ? (double)(c->step - c->ramp_first) / steps : 0;
	double dlo, dhi;

	span_at_end_of_run(s, sim, k, &lo, &hi);
	dlo = lo - s->begin_lo[k];
	dhi = hi - s->begin_hi[k];
	if (c->step == c->ramp_last) /* exact at the end, without rounding errors */
		return (struct span){ lo, hi, steps > 0 ? (dhi - dlo) / (steps * c->dt) : 0 };
	return (struct span){ s->begin_lo[k] + part * dlo, s->begin_hi[k] + part * dhi,
			      steps > 0 ? (dhi - dlo) / (steps * c->dt) : 0 };
}

/* Current target of the faces of dimension k, for all modes but VOLUME. */
static enum ts_status target_span(struct ts_instance *self, struct tsim *sim, int k, struct span *out)
{
	const struct state *s = self->state;
	const struct side *side = &s->side[k];
	double lo = s->made_lo[k], hi = s->made_hi[k], t = ts_sim_time(sim) - s->origin;
	double scale = ts_domain_scale(sim, s->units, k), w, length, rate;

	switch (side->mode) {
	case NONE:
		*out = (struct span){ sim->domain->box.lo[k], sim->domain->box.hi[k], 0 };
		return TS_OK;
	case VEL:
		*out = span_about_centre(lo, hi, hi - lo + scale * side->a * t, scale * side->a);
		return TS_OK;
	case ERATE:
		rate = side->a * (hi - lo);
		*out = span_about_centre(lo, hi, hi - lo + rate * t, rate);
		return TS_OK;
	case TRATE:
		length = (hi - lo) * exp(side->a * t);
		*out = span_about_centre(lo, hi, length, side->a * length);
		return TS_OK;
	case WIGGLE:
		w = 2 * TS_PI / side->b;
		*out = span_about_centre(lo, hi, hi - lo + scale * side->a * sin(w * t),
					 w * scale * side->a * cos(w * t));
		return TS_OK;
	case VARIABLE:
		TS_TRY(ts_number_now(sim, &side->length, &self->where, &length));
		TS_TRY(ts_number_now(sim, &side->rate, &self->where, &rate));
		*out = span_about_centre(lo, hi, hi - lo + length, rate);
		return TS_OK;
	default:
		*out = span_by_ramp(s, sim, k);
		return TS_OK;
	}
}

/* Dimensions of mode VOLUME: with n of them each length is multiplied by the n-th root of the volume
 * change of the others. */
static void keep_volume(const struct state *s, struct span span[3])
{
	double factor = 1, log_rate = 0;
	int n = 0;

	for (int k = 0; k < 3; k++) {
		double length = span[k].hi - span[k].lo;

		if (s->side[k].mode == VOLUME) {
			n++;
			continue;
		}
		factor *= (s->made_hi[k] - s->made_lo[k]) / length;
		log_rate -= span[k].rate / length;
	}
	if (n == 2)
		factor = sqrt(factor);
	for (int k = 0; k < 3; k++) {
		double lo = s->made_lo[k], hi = s->made_hi[k];

		if (s->side[k].mode == VOLUME)
			span[k] = span_about_centre(lo, hi, factor * (hi - lo),
						    log_rate / n * factor * (hi - lo));
	}
}

static enum ts_status target_spans(struct ts_instance *self, struct tsim *sim, struct span span[3])
{
	const struct state *s = self->state;

	for (int k = 0; k < 3; k++) {
		if (s->side[k].mode == VOLUME)
			continue;
		TS_TRY(target_span(self, sim, k, &span[k]));
		if (!(span[k].lo < span[k].hi))
			return ts_fail(&sim->error, TS_PHYSICS, &self->where,
				       "fix deform: the box would reach from %g to %g in %c at step %lld",
				       span[k].lo, span[k].hi, names[k], (long long)sim->clock.step);
	}
	keep_volume(s, span);
	return TS_OK;
}

static void set_image_velocities(struct ts_instance *self, struct tsim *sim, const struct span span[3])
{
	const struct state *s = self->state;

	sim->domain->drift_group = self->group;
	for (int k = 0; k < 3; k++)
		sim->domain->drift[k] = s->remap == REMAP_V ? span[k].rate : 0;
}

static bool any_ramp(const struct state *s)
{
	bool has = false;

	for (int k = 0; k < 3; k++)
		has |= s->side[k].mode >= FINAL && s->side[k].mode <= SCALE;
	return has;
}

/* Whether a command has changed the length of an axis that the fix changes. */
static bool box_has_changed(const struct state *s, const struct ts_box *box)
{
	bool has = false;

	for (int k = 0; k < 3 && s->seen; k++)
		has |= s->side[k].mode != NONE &&
		       !(box->lo[k] == s->last.lo[k] && box->hi[k] == s->last.hi[k]);
	return has;
}

/* Stores the box when the fix was defined and, for modes that refer to it, when this run began. */
static void store_reference_box(struct state *s, const struct tsim *sim)
{
	const struct ts_box *box = &sim->domain->box;
	bool begins = sim->clock.step == sim->clock.ramp_first;
	bool unseen = !s->started || s->begin != sim->clock.ramp_first;

	if (box_has_changed(s, box)) /* begins anew */
		s->started = 0;
	s->last = *box;
	s->seen = true;
	for (int k = 0; k < 3; k++) {
		if (!s->started) {
			s->made_lo[k] = box->lo[k];
			s->made_hi[k] = box->hi[k];
		}
		if (any_ramp(s) && (begins || unseen)) {
			s->begin_lo[k] = begins ? box->lo[k] : s->made_lo[k];
			s->begin_hi[k] = begins ? box->hi[k] : s->made_hi[k];
		}
	}
	if (!s->started)
		s->origin = ts_sim_time(sim);
	s->begin = any_ramp(s) ? sim->clock.ramp_first : 0;
	s->started = 1;
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct span span[3];

	TS_TRY(check_arguments(self, sim));
	sim->run.box_moves = true;
	begin_shear(self->state, sim);
	store_reference_box(self->state, sim);
	if (sheared(self->state) >= 0) {
		shear_box(self, sim);
		return TS_OK;
	}
	if (sim->reading.explain || ((struct state *)self->state)->remap != REMAP_V)
		return TS_OK;
	TS_TRY(target_spans(self, sim, span));
	set_image_velocities(self, sim, span);
	return TS_OK;
}

/* Affine mapping: positions relative to the faces are kept; members of bodies follow these. */
static void remap_positions(const struct ts_instance *self, struct tsim *sim, const struct span span[3])
{
	struct ts_particles *p = sim->particles;
	const struct ts_box *box = &sim->domain->box;

#pragma omp parallel for num_threads(ts_team(sim, p->n)) schedule(static)
	for (size_t i = 0; i < p->n; i++)
		for (int k = 0; ts_in_group(p, i, self->group) && !(p->body && p->body[i]) && k < 3; k++) {
			double factor = (span[k].hi - span[k].lo) / ts_box_length(box, k);

			if (((const struct state *)self->state)->side[k].mode != NONE)
				p->x[i][k] = span[k].lo + factor * (p->x[i][k] - box->lo[k]);
		}
}

/* Before forces: the images are where they belong at the time of the positions. */
static enum ts_status slide_images(struct ts_instance *self, struct tsim *sim)
{
	if (sheared(self->state) >= 0)
		shear_box(self, sim);
	return TS_OK;
}

static enum ts_status deform_box(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	struct ts_box *box = &sim->domain->box;
	struct span span[3];

	if (sim->clock.step % s->every != 0 || sheared(s) >= 0)
		return TS_OK;
	TS_TRY(target_spans(self, sim, span));
	if (s->remap == REMAP_X)
		remap_positions(self, sim, span);
	TS_TRY(sim->particles->bodies_change_box(sim, (double[]){ span[0].lo, span[1].lo, span[2].lo },
						 (double[]){ span[0].hi, span[1].hi, span[2].hi },
						 s->remap == REMAP_X, self->group));
	for (int k = 0; k < 3; k++) {
		box->lo[k] = span[k].lo;
		box->hi[k] = span[k].hi;
	}
	s->last = *box;
	set_image_velocities(self, sim, span);
	return TS_OK;
}

#define NUMBER_OF(part, k, field_, name_, unit_, help_, range_)                                           \
	TS_REAL(name_, struct state, part[k].field_, .flags = TS_POSITIONAL | TS_STATEFUL, .unit = unit_, \
		.help = help_, .range = (range_))
#define NUMBER(k, field_, name_, unit_, help_, range_) NUMBER_OF(side, k, field_, name_, unit_, help_, range_)
#define SIDE_ROWS(k)                                                                                        \
	static const struct ts_arg final_##k[] = {                                                          \
		NUMBER(k, a, "lo", "length", "low face at the end of the run", TS_ANY),                     \
		NUMBER(k, b, "hi", "length", "high face at the end of the run", TS_ANY), TS_ARGS_END        \
	};                                                                                                  \
	static const struct ts_arg delta_##k[] = {                                                          \
		NUMBER(k, a, "dlo", "length", "displacement of the low face over the run", TS_ANY),         \
		NUMBER(k, b, "dhi", "length", "displacement of the high face over the run", TS_ANY),        \
		TS_ARGS_END                                                                                 \
	};                                                                                                  \
	static const struct ts_arg scale_##k[] = {                                                          \
		NUMBER(k, a, "factor", "", "factor of the length over the run", TS_POSITIVE), TS_ARGS_END   \
	};                                                                                                  \
	static const struct ts_arg vel_##k[] = {                                                            \
		NUMBER(k, a, "V", "velocity", "rate of change of the length", TS_ANY), TS_ARGS_END          \
	};                                                                                                  \
	static const struct ts_arg rate_##k[] = { NUMBER(k, a, "R", "1/time", "strain rate", TS_ANY),       \
						  TS_ARGS_END };                                            \
	static const struct ts_arg wiggle_##k[] = {                                                         \
		NUMBER(k, a, "A", "length", "amplitude of the length", TS_ANY),                             \
		NUMBER(k, b, "period", "time", "period of the oscillation", TS_POSITIVE), TS_ARGS_END       \
	};                                                                                                  \
	static const struct ts_arg variable_##k[] = {                                                       \
		TS_NUMBER("length", struct state, side[k].length, .flags = TS_POSITIONAL, .unit = "length", \
			  .help = "v_NAME: change of the length"),                                          \
		TS_NUMBER("rate", struct state, side[k].rate, .flags = TS_POSITIONAL, .unit = "velocity",   \
			  .help = "v_NAME: rate of change of the length"),                                  \
		TS_ARGS_END                                                                                 \
	};                                                                                                  \
	static const struct ts_mode modes_##k[] = {                                                         \
		[FINAL] = { "final", "given faces at the end of the run", final_##k },                      \
		[DELTA] = { "delta", "given displacements of the faces over the run", delta_##k },          \
		[SCALE] = { "scale", "given factor of the length over the run", scale_##k },                \
		[VEL] = { "vel", "constant rate of the length: L = L0 + V t", vel_##k },                    \
		[ERATE] = { "erate", "engineering strain rate: L = L0 (1 + R t)", rate_##k },               \
		[TRATE] = { "trate", "true strain rate: L = L0 exp(R t)", rate_##k },                       \
		[VOLUME] = { "volume", "constant volume", NULL },                                           \
		[WIGGLE] = { "wiggle", "L = L0 + A sin(2 pi t/period)", wiggle_##k },                       \
		[VARIABLE] = { "variable", "length and rate by variables", variable_##k },                  \
		{ .name = NULL },                                                                           \
	};
#define SHEAR_ROWS(k)                                                                                       \
	static const struct ts_arg shear_vel_##k[] = {                                                      \
		NUMBER_OF(shear, k, a, "V", "velocity", "velocity of the images", TS_ANY), TS_ARGS_END      \
	};                                                                                                  \
	static const struct ts_arg shear_rate_##k[] = {                                                     \
		NUMBER_OF(shear, k, a, "R", "1/time", "shear rate", TS_ANY), TS_ARGS_END                    \
	};                                                                                                  \
	static const struct ts_arg shear_wiggle_##k[] = {                                                   \
		NUMBER_OF(shear, k, a, "A", "length", "amplitude of the displacement", TS_ANY),             \
		NUMBER_OF(shear, k, b, "period", "time", "period of the oscillation", TS_POSITIVE),         \
		TS_ARGS_END                                                                                 \
	};                                                                                                  \
	static const struct ts_mode shears_##k[] = {                                                        \
		[SHEAR_VEL] = { "vel", "images across the faces slide with this velocity", shear_vel_##k }, \
		[SHEAR_ERATE] = { "erate", "shear rate: the velocity is R times the length of the box",     \
				  shear_rate_##k },                                                         \
		[SHEAR_WIGGLE] = { "wiggle", "displacement A sin(2 pi t/period)", shear_wiggle_##k },       \
		{ .name = NULL },                                                                           \
	};
SHEAR_ROWS(0)
SHEAR_ROWS(1)
SHEAR_ROWS(2)
SIDE_ROWS(0)
SIDE_ROWS(1)
SIDE_ROWS(2)

#define SIDE(k, name_)                                                                     \
	{                                                                                  \
		.name = name_, .type = TS_ARG_MODE, .flags = TS_OPTIONAL | TS_STATEFUL,    \
		.offset = TS_FIELD(struct state, side[k].mode, int *), .modes = modes_##k, \
		.help = "how the box changes in this direction"                            \
	}
#define SHEAR(k, name_, help_)                                                                             \
	{                                                                                                  \
		.name = name_, .type = TS_ARG_MODE, .flags = TS_OPTIONAL | TS_STATEFUL,                    \
		.offset = TS_FIELD(struct state, shear[k].mode, int *), .modes = shears_##k, .help = help_ \
	}

static const char *const remaps[] = { [REMAP_X] = "x", [REMAP_V] = "v", [REMAP_NONE] = "none", NULL };

static const struct ts_arg args[] = {
	TS_INT("N", struct state, every, .flags = TS_POSITIONAL, .range = TS_WITHIN, .lo = 1, .hi = 1e15,
	       .help = "number of time steps between changes of the box"),
	SIDE(0, "x"),
	SIDE(1, "y"),
	SIDE(2, "z"),
	SHEAR(0, "xy", "simple shear: the images across the y faces slide along x"),
	SHEAR(1, "xz", "simple shear: the images across the z faces slide along x"),
	SHEAR(2, "yz", "simple shear: the images across the z faces slide along y"),
	TS_ENUM("remap", struct state, remap, remaps, .fallback = "x",
		.help = "x: positions of the group are mapped with the box; v: velocities change by the rate "
			"of the length when particles cross a periodic face; none"),
	TS_ENUM("units", struct state, units, ts_region_units, .flags = TS_OPTIONAL,
		.help = "lengths in lattice spacings (lattice) or in the units of the script (box)"),
	TS_BOOL("flip", struct state, flip, .fallback = "yes", .help = "no effect"),
	TS_ARGS_END,
};

static bool moves_by_time(const struct ts_instance *self)
{
	(void)self;
	return true;
}

static const struct ts_saved saved[] = {
	TS_SAVE_I64(struct state, started),
	TS_SAVE_I64(struct state, begin),
	TS_SAVE_F64(struct state, origin),
	TS_SAVE_F64(struct state, made_lo),
	TS_SAVE_F64(struct state, made_hi),
	TS_SAVE_F64(struct state, begin_lo),
	TS_SAVE_F64(struct state, begin_hi),
	TS_SAVE_F64(struct state, made_slide),
	TS_SAVED_ROWS_END,
};

TS_STYLE(fix, ts_style, ts_fix_deform)
const struct ts_style ts_fix_deform = {
	.name = "deform",
	.kind = TS_KIND_FIX,
	.ranks = TS_RANKS_OWN | TS_RANKS_OUTPUTS,
	.summary = "Changes the lengths of the box during a run, or shears it",
	.doc = "The faces move at the end of each time step that is a multiple of N. The targets of "
	       "`final`, `delta` and `scale` are approached linearly and reached at the end of each run (see "
	       "`run N start S stop E` to treat several runs as one). For all other styles the time t and "
	       "the initial length L0 are counted from the definition of the fix, over any number of runs. "
	       "The centre of the box is kept, except with `final` and `delta`. One or two dimensions with "
	       "`volume` change so that the volume is that when the fix was defined. Where a command between "
	       "two runs has changed the box along one of these axes (change_box, replicate), the fix begins "
	       "anew with it.\n\n"
	       "With `remap x` the positions of the particles of the group are mapped affinely with the box, "
	       "and velocities do not change. With `remap v` positions are not mapped, and the velocity of a "
	       "particle of the group that crosses a periodic face changes by the rate of that box length; "
	       "contacts and bonds across the face use the same relative velocity. Rigid bodies and clumps "
	       "are mapped by their centres of mass (`remap x`), and refused with `remap v`.\n\n"
	       "`xy`, `xz` and `yz` with `remap v` (and N 1) give a homogeneous simple shear of a box that "
	       "is periodic in both dimensions. The box stays orthogonal; instead the periodic images across "
	       "the faces of the second dimension slide along the first, the upper ones with the velocity V "
	       "and the lower ones with -V (Lees and Edwards). V is R times the length of the box for the "
	       "shear rate R. A particle of the group that crosses such a face is displaced along the first "
	       "dimension, and its velocity changes by V. Particles start with the profile of the flow by "
	       "`velocity all ramp`. A box in LAMMPS with the tilt xy = V t has the same images. Unwrapped "
	       "positions include the displacements. The displacement remains after `unfix`. Bonds and fixes "
	       "that find periodic images on their own (rigid bodies, meshes, prescribed motion, fluids, "
	       "insertion, ledger) are refused.\n\n"
	       "This fix cannot be used with a resolved fluid (flow_style projection), nor along x and y "
	       "with a film (flow_style reynolds), whose grids do not change with the box during a run. "
	       "change_box before a run does change the grid.",
	.example = "fix squeeze all deform 1 z erate -0.02 x volume y volume remap x\n"
		   "fix shake all deform 10 x wiggle 0.001 0.1 remap v units box\n"
		   "fix shear all deform 1 xy erate 250 remap v",
	.cite = "A. W. Lees, S. F. Edwards, J. Phys. C 5 (1972) 1921",
	.args = args,
	.state_size = sizeof(struct state),
	.saved = saved,
	.init = init,
	.hook = {
		[TS_STAGE_POST_INTEGRATE] = slide_images,
		[TS_STAGE_END_OF_STEP] = deform_box,
	},
	.moves_by_time = moves_by_time,
};
