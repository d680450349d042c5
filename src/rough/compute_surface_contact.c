/* Compute surface/contact: a rough surface pressed against a plane or another rough surface. */
#include <string.h>

#include "rough/pressed_surface.h"

#include "base/banned.h"

static const struct ts_instance *surface_of(const struct ts_instance *self)
{
	return ((const struct ts_pressed_surface *)self->state)->by;
}

static enum ts_status eval_area(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct ts_pressed_surface *s = self->state;

	(void)sim;
	TS_TRY(ts_pressed_surface_solve(self));
	out->data[0] = s->result.area;
	return TS_OK;
}

static const char *const figure_names[] = { "plane",	"area",		"smooth_area", "plastic_area",
					    "mean_gap", "max_pressure", "iterations",  "residual" };
enum { FIGURES = sizeof figure_names / sizeof *figure_names };

static enum ts_status eval_figures(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct ts_rough_result *r = &((struct ts_pressed_surface *)self->state)->result;

	(void)sim;
	TS_TRY(ts_pressed_surface_solve(self));
	memcpy(out->data,
	       (double[FIGURES]){ r->plane, r->area, r->smooth_area, r->plastic_area, r->mean_gap,
				  r->max_pressure, r->iterations, r->residual },
	       FIGURES * sizeof(double));
	return TS_OK;
}

static const char *const column_names[] = { "pressure", "gap" };

static enum ts_status eval_columns(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct ts_pressed_surface *s = self->state;

	(void)sim;
	TS_TRY(ts_pressed_surface_solve(self));
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
	  "for the error of counting columns; part of the area that yields; mean gap; largest pressure; "
	  "iterations; residual",
	  TS_VECTOR, FIGURES, figure_names, eval_figures },
	{ "columns", "pressure, length",
	  "of each column: pressure and gap; negative gap: permanent indentation", TS_SURFACE, 2,
	  column_names, eval_columns },
	{ .name = NULL },
};

static void fini(struct ts_instance *self)
{
	ts_pressed_surface_release(self->state);
}

/* ---- arguments ---- */

static const struct ts_arg winkler_args[] = {
	TS_REAL("stiffness", struct ts_pressed_surface, stiffness, .flags = TS_POSITIONAL,
		.range = TS_POSITIVE, .unit = "pressure/length",
		.help = "pressure of a column over its compression"),
	TS_ARGS_END,
};
static const struct ts_arg half_space_args[] = {
	TS_REAL("young", struct ts_pressed_surface, young, .range = TS_POSITIVE, .unit = "pressure",
		.help = "Young's modulus of the surface"),
	TS_REAL("poisson", struct ts_pressed_surface, poisson, .range = TS_WITHIN, .lo = -1, .hi = 0.5,
		.help = "its Poisson ratio"),
	TS_REAL("counter_young", struct ts_pressed_surface, counter_young, .flags = TS_OPTIONAL,
		.range = TS_POSITIVE, .unit = "pressure", .help = "of the other solid; default: it is rigid"),
	TS_REAL("counter_poisson", struct ts_pressed_surface, counter_poisson, .fallback = "0.3",
		.range = TS_WITHIN, .lo = -1, .hi = 0.5, .help = "its Poisson ratio"),
	TS_REAL("tolerance", struct ts_pressed_surface, tolerance, .fallback = "1e-5", .range = TS_POSITIVE,
		.help = "largest gap in contacts, in units of the standard deviation of the heights"),
	TS_INT("iterations", struct ts_pressed_surface, iterations, .fallback = "10000", .range = TS_POSITIVE,
	       .help = "limit of the number of iterations"),
	TS_ARGS_END,
};
static const struct ts_mode models[] = {
	[TS_PRESSED_WINKLER] = { "winkler", "each column is a spring of its own", winkler_args },
	[TS_PRESSED_HALF_SPACE] = { "halfspace", "elastic half-space", half_space_args },
	{ .name = NULL },
};

static const struct ts_arg args[] = {
	TS_WORD("surface", struct ts_pressed_surface, surface_id, .flags = TS_POSITIONAL,
		.help = "ID of a fix surface/voxel"),
	TS_MODE("model", struct ts_pressed_surface, model, models, .help = "how columns give way"),
	TS_NUMBER("pressure", struct ts_pressed_surface, mean_pressure, .range = TS_POSITIVE,
		  .unit = "pressure", .help = "load over the area of the field"),
	TS_REAL("hardness", struct ts_pressed_surface, hardness, .flags = TS_OPTIONAL, .range = TS_POSITIVE,
		.unit = "pressure", .help = "pressure at which columns yield; default: they are elastic"),
	TS_WORD("counter", struct ts_pressed_surface, counter_id, .flags = TS_OPTIONAL,
		.help = "ID of a fix surface/voxel, the other surface; default: a plane"),
	TS_ARGS_END,
};

static const char doc[] =
	"Frictionless contact of a height field with a plane that is pressed onto it along the axis of the "
	"heights: pressure and gap of each column such that\n\n"
	"  gap = plane - height + displacement >= 0, 0 <= pressure <= hardness, pressure = 0 where gap > "
	"0,\n\n"
	"with the mean pressure given. Pressure and heights are those at the time of the evaluation; "
	"particles take no part.\n\n"
	"Model winkler: displacement = pressure/stiffness of the column alone. The solution is exact.\n\n"
	"Model halfspace: both solids are elastic half-spaces with 1/E* = (1 - nu_1^2)/E_1 + (1 - "
	"nu_2^2)/E_2. Each column displaces all others by the integral of 1/(pi E* r) over its "
	"cross-section, or, in a field that is periodic along both axes, by 2/(E* q) for each wave number q "
	"/= 0; then heights and `plane` are relative to the mean displacement, which an infinite plane has "
	"none of. Sums are made by Fourier transforms, the contact is found by projected gradients, one sum "
	"in each iteration.\n\n"
	"Columns at the hardness yield: their pressure stays there, and the negative gap is their permanent "
	"indentation (rigid, ideally plastic; the displacement of the material is not modelled). The "
	"solution is that of a first loading: it does not depend on what was before.\n\n"
	"With `counter` the heights of both fields are added, as if the second lay upside down on the first, "
	"its columns opposite to those of the same index.\n\n"
	"Columns at the border of a contact count as a whole, so the area is too large by a part of their "
	"number. c_ID[3] is corrected for that by (pi - 1 + ln 2)/24 columns for each border between a "
	"column in contact and one that is not.\n\n"
	"With model winkler a column is in contact or not by its own height: c_ID[2] is meant.\n\n"
	"Errors at 128 x 128 columns for a sphere with a contact radius of 38 columns: approach 2e-5, "
	"largest pressure 1.3e-4, area 0.6 %, corrected area 0.2 %.\n\n"
	"Equations typeset, assumptions, order and limits: doc/theory-rough.md.\n\n"
	"Related: fix surface/voxel, dump voxel/vtk.";

TS_STYLE(compute, ts_style, ts_compute_surface_contact)
const struct ts_style ts_compute_surface_contact = {
	.name = "surface/contact",
	.kind = TS_KIND_COMPUTE,
	.ranks = TS_RANKS_WHOLE | TS_RANKS_PARTICLES,
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
	.state_size = sizeof(struct ts_pressed_surface),
	.values = values,
	.surface = surface_of,
	.family = TS_FAMILY_PRESSED,
	.init = ts_pressed_surface_init,
	.fini = fini,
};
