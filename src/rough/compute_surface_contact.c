/* Compute surface/contact: a rough surface pressed against a plane or another rough surface. */
#include <math.h>
#include <string.h>

#include "core/sim.h"
#include "rough/rough_contact.h"
#include "voxel/voxel_surface.h"

#include "base/banned.h"

enum { WINKLER, HALF_SPACE };

struct state {
	const char *surface_id, *counter_id;
	int model;
	double stiffness, young, poisson, counter_young, counter_poisson, hardness, tolerance;
	int64_t iterations;
	struct ts_number mean_pressure;

	struct tsim *sim;
	const struct ts_instance *by; /* the fix of the surface */
	const struct ts_voxel_field *field, *counter;
	/* the solution; arrays have a number for each column */
	size_t n;
	double *height, *pressure, *gap;
	struct ts_rough_result result;
	double solved_pressure; /* it belongs to this mean pressure and these heights */
	bool solved;
};

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
	struct state *s = self->state;

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
				       "need "
				       "the same number, width and axis of columns",
				       s->counter_id, s->surface_id);
	return TS_OK;
}

static bool periodic(const struct state *s)
{
	return s->field->periodic[0] && s->field->periodic[1];
}

static enum ts_status check_model(struct ts_instance *self, struct tsim *sim)
{
	const struct state *s = self->state;

	if (s->model == HALF_SPACE && s->field->periodic[0] != s->field->periodic[1])
		return ts_fail(&sim->error, TS_STATE, ts_instance_word(self, s->surface_id),
			       "compute surface/contact: %s is periodic along one axis only; model halfspace "
			       "needs "
			       "fields that are periodic along both axes or along none",
			       s->surface_id);
	return TS_OK;
}

static enum ts_status make_room(struct tsim *sim, struct state *s)
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

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	s->sim = sim;
	s->solved = false;
	TS_TRY(find_surfaces(self, sim));
	TS_TRY(check_model(self, sim));
	return make_room(sim, s);
}

static const struct ts_instance *surface_of(const struct ts_instance *self)
{
	return ((const struct state *)self->state)->by;
}

/* ---- solution ---- */

static double compliance(double young, double poisson)
{
	return isfinite(young) ? (1 - poisson * poisson) / young : 0;
}

/* Sum of the heights of both surfaces. Returns whether they have changed since the last solution. */
static bool take_heights(struct state *s)
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
	const struct state *s = self->state;
	struct ts_error *error = &s->sim->error;

	if (status == TS_RANGE)
		return ts_fail(error, TS_PHYSICS, &self->where,
			       "compute surface/contact %s: the mean pressure %g cannot be carried: where "
			       "all columns "
			       "yield it is the hardness %g",
			       self->id, p->mean_pressure, p->hardness);
	if (status == TS_PHYSICS)
		return ts_fail(error, TS_PHYSICS, &self->where,
			       "compute surface/contact %s: no solution within %g of the standard deviation "
			       "of the "
			       "heights after %d iterations, but within %g: give more `iterations` or a "
			       "larger "
			       "`tolerance`",
			       self->id, p->tolerance, p->iterations, s->result.residual);
	return ts_nomem(error);
}

static enum ts_status solve(struct ts_instance *self)
{
	struct state *s = self->state;
	const struct ts_voxel_field *f = s->field;
	struct ts_rough_problem p = { .n = { (int)f->n[0], (int)f->n[1] },
				      .width = { f->width[0], f->width[1] },
				      .height = s->height,
				      .periodic = periodic(s),
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
	if (s->model == HALF_SPACE)
		p.modulus = 1 / (compliance(s->young, s->poisson) +
				 compliance(s->counter_young, s->counter_poisson));
	status = s->model == WINKLER ? ts_rough_winkler(&p, &s->result) : ts_rough_half_space(&p, &s->result);
	s->solved = status == TS_OK;
	s->solved_pressure = p.mean_pressure;
	return s->solved ? TS_OK : say_failure(self, &p, status);
}

static enum ts_status eval_area(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct state *s = self->state;

	(void)sim;
	TS_TRY(solve(self));
	out->data[0] = s->result.area;
	return TS_OK;
}

static const char *const figure_names[] = { "plane",	"area",		"smooth_area", "plastic_area",
					    "mean_gap", "max_pressure", "iterations",  "residual" };
enum { FIGURES = sizeof figure_names / sizeof *figure_names };

static enum ts_status eval_figures(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct ts_rough_result *r = &((struct state *)self->state)->result;

	(void)sim;
	TS_TRY(solve(self));
	memcpy(out->data,
	       (double[FIGURES]){ r->plane, r->area, r->smooth_area, r->plastic_area, r->mean_gap,
				  r->max_pressure, r->iterations, r->residual },
	       FIGURES * sizeof(double));
	return TS_OK;
}

static const char *const column_names[] = { "pressure", "gap" };

static enum ts_status eval_columns(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct state *s = self->state;

	(void)sim;
	TS_TRY(solve(self));
	TS_TRY(ts_table_resize(out, s->n, 2));
	for (size_t k = 0; k < s->n; k++) {
		out->data[2 * k] = s->pressure[k];
		out->data[2 * k + 1] = s->gap[k];
	}
	return TS_OK;
}

static const struct ts_value values[] = {
	{ "area", "-", "part of the area in contact", TS_SCALAR, 1, NULL, eval_area },
	{ "figures", "length, -, -, -, length, pressure, -, -",
	  "height of the plane, as heights of the surface; part of the area in contact; the same, corrected "
	  "for the "
	  "error of counting columns; part of the area that yields; mean gap; largest pressure; iterations; "
	  "residual",
	  TS_VECTOR, FIGURES, figure_names, eval_figures },
	{ "columns", "pressure, length",
	  "of each column: pressure and gap; negative gap: permanent indentation", TS_SURFACE, 2,
	  column_names, eval_columns },
	{ .name = NULL },
};

static void fini(struct ts_instance *self)
{
	ts_free(((struct state *)self->state)->height);
}

/* ---- arguments ---- */

static const struct ts_arg winkler_args[] = {
	TS_REAL("stiffness", struct state, stiffness, .flags = TS_POSITIONAL, .range = TS_POSITIVE,
		.unit = "pressure/length", .help = "pressure of a column over its compression"),
	TS_ARGS_END,
};
static const struct ts_arg half_space_args[] = {
	TS_REAL("young", struct state, young, .range = TS_POSITIVE, .unit = "pressure",
		.help = "Young's modulus of the surface"),
	TS_REAL("poisson", struct state, poisson, .range = TS_WITHIN, .lo = -1, .hi = 0.5,
		.help = "its Poisson ratio"),
	TS_REAL("counter_young", struct state, counter_young, .flags = TS_OPTIONAL, .range = TS_POSITIVE,
		.unit = "pressure", .help = "of the other solid; default: it is rigid"),
	TS_REAL("counter_poisson", struct state, counter_poisson, .fallback = "0.3", .range = TS_WITHIN,
		.lo = -1, .hi = 0.5, .help = "its Poisson ratio"),
	TS_REAL("tolerance", struct state, tolerance, .fallback = "1e-5", .range = TS_POSITIVE,
		.help = "largest gap in contacts, in units of the standard deviation of the heights"),
	TS_INT("iterations", struct state, iterations, .fallback = "10000", .range = TS_POSITIVE,
	       .help = "limit of the number of iterations"),
	TS_ARGS_END,
};
static const struct ts_mode models[] = {
	[WINKLER] = { "winkler", "each column is a spring of its own", winkler_args },
	[HALF_SPACE] = { "halfspace", "elastic half-space", half_space_args },
	{ .name = NULL },
};

static const struct ts_arg args[] = {
	TS_WORD("surface", struct state, surface_id, .flags = TS_POSITIONAL,
		.help = "ID of a fix surface/voxel"),
	TS_MODE("model", struct state, model, models, .help = "how columns give way"),
	TS_NUMBER("pressure", struct state, mean_pressure, .unit = "pressure",
		  .help = "load over the area of the field"),
	TS_REAL("hardness", struct state, hardness, .flags = TS_OPTIONAL, .range = TS_POSITIVE,
		.unit = "pressure", .help = "pressure at which columns yield; default: they are elastic"),
	TS_WORD("counter", struct state, counter_id, .flags = TS_OPTIONAL,
		.help = "ID of a fix surface/voxel, the other surface; default: a plane"),
	TS_ARGS_END,
};

static const char doc[] =
	"Frictionless contact of a height field with a plane that is pressed onto it along the axis of the "
	"heights: "
	"pressure and gap of each column such that\n\n"
	"  gap = plane - height + displacement >= 0, 0 <= pressure <= hardness, pressure = 0 where gap > "
	"0,\n\n"
	"with the mean pressure given. Pressure and heights are those at the time of the evaluation; "
	"particles take "
	"no part.\n\n"
	"Model winkler: displacement = pressure/stiffness of the column alone. The solution is exact.\n\n"
	"Model halfspace: both solids are elastic half-spaces with 1/E* = (1 - nu_1^2)/E_1 + (1 - "
	"nu_2^2)/E_2. Each "
	"column displaces all others by the integral of 1/(pi E* r) over its cross-section, or, in a field "
	"that is "
	"periodic along both axes, by 2/(E* q) for each wave number q /= 0; then heights and `plane` are "
	"relative to "
	"the mean displacement, which an infinite plane has none of. Sums are made by Fourier transforms, "
	"the "
	"contact is found by projected gradients, one sum in each iteration.\n\n"
	"Columns at the hardness yield: their pressure stays there, and the negative gap is their permanent "
	"indentation (rigid, ideally plastic; the displacement of the material is not modelled). The "
	"solution is "
	"that of a first loading: it does not depend on what was before.\n\n"
	"With `counter` the heights of both fields are added, as if the second lay upside down on the first, "
	"its "
	"columns opposite to those of the same index.\n\n"
	"Columns at the border of a contact count as a whole, so the area is too large by a part of their "
	"number. "
	"c_ID[3] is corrected for that by (pi - 1 + ln 2)/24 columns for each border between a column in "
	"contact and "
	"one that is not.\n\n"
	"Errors at 128 x 128 columns for a sphere with a contact radius of 38 columns: approach 2e-5, "
	"largest "
	"pressure 1.3e-4, area 0.6 %, corrected area 0.2 %.\n\n"
	"Related: fix surface/voxel, dump voxel/vtk.";

TS_STYLE(compute, ts_style, ts_compute_surface_contact)
const struct ts_style ts_compute_surface_contact = {
	.name = "surface/contact",
	.kind = TS_KIND_COMPUTE,
	.summary = "Contact of a rough surface with a plane: Winkler foundation or elastic half-space",
	.doc = doc,
	.example = "fix pad all surface/voxel gaussian deviation 4.7e-6 correlation 5e-6 seed 11 type 1 "
		   "cells 256 256\n"
		   "compute press all surface/contact pad halfspace young 5e7 poisson 0.2 pressure 4.1e4 "
		   "hardness 5e6\n"
		   "compute spring all surface/contact pad winkler 1e12 pressure v_load\n"
		   "thermo_style custom step c_press c_press[5] c_press[6]",
	.cite = "Y.-H. Dai, R. Fletcher, Math. Program. 106 (2006) 403; V. A. Yastrebov, G. Anciaux, J.-F. "
		"Molinari, Tribol. Int. 114 (2017) 161",
	.args = args,
	.state_size = sizeof(struct state),
	.values = values,
	.surface = surface_of,
	.init = init,
	.fini = fini,
};
