#include "rough/pressed_surface.h"

#include <math.h>

#include "voxel/voxel_surface.h"

#include "base/banned.h"

/* ---- surfaces ---- */

static enum ts_status find_field(struct ts_instance *self, struct tsim *sim, const char *name,
				 const struct ts_voxel_field **out)
{
	struct ts_word id = { .text = name, .place = *ts_instance_word(self, name) };
	struct ts_voxel_surface *surface;

	TS_TRY(ts_voxel_surface_require(sim, &id, &surface));
	*out = &surface->field;
	return TS_OK;
}

static enum ts_status find_surfaces(struct ts_instance *self, struct tsim *sim)
{
	struct ts_pressed_surface *s = self->state;

	TS_TRY(find_field(self, sim, s->surface_id, &s->field));
	s->by = ts_sim_find(sim, TS_KIND_FIX, s->surface_id);
	if (!s->counter_id)
		return TS_OK;
	TS_TRY(find_field(self, sim, s->counter_id, &s->counter));
	for (int d = 0; d < 2; d++)
		if (s->counter->n[d] != s->field->n[d] || s->counter->axis[d] != s->field->axis[d] ||
		    !(fabs(s->counter->width[d] - s->field->width[d]) <= 1e-9 * s->field->width[d]))
			return ts_fail(&sim->error, TS_STATE, ts_instance_word(self, s->counter_id),
				       "compute surface/contact: the columns of %s are not those of %s: both "
				       "need the same number, width and axis of columns",
				       s->counter_id, s->surface_id);
	return TS_OK;
}

static bool periodic(const struct ts_pressed_surface *s)
{
	return s->field->periodic[0] && s->field->periodic[1];
}

static enum ts_status check_model(struct ts_instance *self, struct tsim *sim)
{
	const struct ts_pressed_surface *s = self->state;

	if (s->model == TS_PRESSED_HALF_SPACE && s->field->periodic[0] != s->field->periodic[1])
		return ts_fail(&sim->error, TS_STATE, ts_instance_word(self, s->surface_id),
			       "compute surface/contact: %s is periodic along one axis only; model halfspace "
			       "needs fields that are periodic along both axes or along none",
			       s->surface_id);
	return TS_OK;
}

static enum ts_status make_room(struct tsim *sim, struct ts_pressed_surface *s)
{
	size_t n = (size_t)(s->field->n[0] * s->field->n[1]);

	if (n == s->n)
		return TS_OK;
	ts_free(s->height);
	s->height = ts_alloc(n, 3 * sizeof *s->height);
	s->n = s->height ? n : 0;
	if (!s->height)
		return ts_nomem(&sim->error);
	s->pressure = s->height + n;
	s->gap = s->pressure + n;
	return TS_OK;
}

static enum ts_status refuse_pressure(struct ts_instance *self, double pressure, double hardness)
{
	const struct ts_pressed_surface *s = self->state;

	return ts_fail(&s->sim->error, TS_PHYSICS, &self->where,
		       "compute surface/contact %s: the mean pressure %g cannot be carried: where all "
		       "columns yield it is the hardness %g",
		       self->id, pressure, hardness);
}

enum ts_status ts_pressed_surface_init(struct ts_instance *self, struct tsim *sim)
{
	struct ts_pressed_surface *s = self->state;

	s->sim = sim;
	s->solved = false;
	TS_TRY(find_surfaces(self, sim));
	TS_TRY(check_model(self, sim));
	if (!s->mean_pressure.variable && s->mean_pressure.value >= s->hardness)
		return refuse_pressure(self, s->mean_pressure.value, s->hardness);
	return make_room(sim, s);
}

/* ---- solution ---- */

static double compliance(double young, double poisson)
{
	return isfinite(young) ? (1 - poisson * poisson) / young : 0;
}

/* Sum of the heights of both surfaces. Returns whether they have changed since the last solution. */
static bool take_heights(struct ts_pressed_surface *s)
{
	const double *height = ts_voxel_heights(s->field);
	bool changed = false;

	for (size_t k = 0; k < s->n; k++) {
		double sum = height[k] + (s->counter ? ts_voxel_heights(s->counter)[k] : 0);

		changed |= sum < s->height[k] || sum > s->height[k];
		s->height[k] = sum;
	}
	return changed;
}

static enum ts_status say_failure(struct ts_instance *self, const struct ts_rough_problem *p,
				  enum ts_status status)
{
	const struct ts_pressed_surface *s = self->state;
	struct ts_error *error = &s->sim->error;

	if (status == TS_RANGE && p->mean_pressure < p->hardness)
		return ts_fail(error, TS_RANGE, &self->where,
			       "compute surface/contact %s: the mean pressure %g and the displacements by it "
			       "are too large or too small for the arithmetic: check pressure, %s and units",
			       self->id, p->mean_pressure,
			       s->model == TS_PRESSED_WINKLER ? "stiffness" : "young");
	if (status == TS_RANGE)
		return refuse_pressure(self, p->mean_pressure, p->hardness);
	if (status == TS_PHYSICS)
		return ts_fail(error, TS_PHYSICS, &self->where,
			       "compute surface/contact %s: no solution within %g of the standard deviation "
			       "of the heights after %d iterations, but within %g: give more `iterations` or "
			       "a larger `tolerance`",
			       self->id, p->tolerance, p->iterations, s->result.residual);
	return ts_nomem(error);
}

static enum ts_status solve(struct ts_instance *self)
{
	struct ts_pressed_surface *s = self->state;
	const struct ts_voxel_field *f = s->field;
	struct ts_rough_problem p = { .n = { (int)f->n[0], (int)f->n[1] },
				      .width = { f->width[0], f->width[1] },
				      .height = s->height,
				      .periodic = periodic(s),
				      .half_space = &s->half_space,
				      .stiffness = s->stiffness,
				      .hardness = isnan(s->hardness) ? INFINITY : s->hardness,
				      .tolerance = s->tolerance,
				      .iterations = (int)s->iterations,
				      .threads = ts_team(s->sim, s->n) };
	enum ts_status status;
	bool changed = take_heights(s);

	TS_TRY(ts_number_now(s->sim, &s->mean_pressure, &self->where, &p.mean_pressure));
	if (!(p.mean_pressure > 0 && isfinite(p.mean_pressure)))
		return ts_fail(&s->sim->error, TS_RANGE, &self->where,
			       "compute surface/contact %s: the mean pressure is %g, must be > 0", self->id,
			       p.mean_pressure);
	if (s->solved && !changed && !(s->solved_pressure < p.mean_pressure) &&
	    !(s->solved_pressure > p.mean_pressure))
		return TS_OK;
	s->result = (struct ts_rough_result){ .pressure = s->pressure, .gap = s->gap };
	if (s->model == TS_PRESSED_HALF_SPACE)
		p.modulus = 1 / (compliance(s->young, s->poisson) +
				 compliance(s->counter_young, s->counter_poisson));
	status = s->model == TS_PRESSED_WINKLER ? ts_rough_winkler(&p, &s->result)
						: ts_rough_half_space(&p, &s->result);
	s->solved = status == TS_OK;
	s->solved_pressure = p.mean_pressure;
	return s->solved ? TS_OK : say_failure(self, &p, status);
}

enum ts_status ts_pressed_surface_solve(struct ts_instance *self)
{
	struct ts_pressed_surface *s = self->state;

	TS_TRY(ts_value_find_again(self, s->sim)); /* whoever reads it: its surfaces may have been deleted */
	return solve(self);
}

void ts_pressed_surface_release(struct ts_pressed_surface *s)
{
	ts_half_space_release(&s->half_space);
	ts_free(s->height);
}

/* ---- by name ---- */

enum ts_status ts_pressed_surface_require(struct tsim *sim, const struct ts_word *id,
					  struct ts_instance **out)
{
	struct ts_suggest suggest = ts_suggest_start(id->text);
	struct ts_instance *other;

	*out = ts_sim_find(sim, TS_KIND_COMPUTE, id->text);
	if (*out && (*out)->style->family && ts_streq((*out)->style->family, TS_FAMILY_PRESSED))
		return TS_OK;
	if (*out)
		return ts_fail(&sim->error, TS_STATE, &id->place,
			       "compute %s is of style %s: expected a compute surface/contact", id->text,
			       (*out)->style->name);
	for (size_t k = 0; (other = ts_sim_next_of(sim, TS_KIND_COMPUTE, TS_FAMILY_PRESSED, &k));)
		ts_suggest_try(&suggest, other->id);
	return ts_fail(&sim->error, TS_UNKNOWN, &id->place, "there is no compute surface/contact '%s'%s",
		       id->text, ts_suggest_text(&suggest));
}
