/* Compute bed/height: height and porosity of a bed. */
#include <math.h>

#include "bed/heap_surface.h"

#include "base/banned.h"

struct state {
	double up[3], column, part, base, area;
	struct ts_bed_surface surface;
	struct tsim *sim;
};

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	s->sim = sim;
	return ts_bed_frame_make(sim, self, s->up, &s->surface.frame);
}

static enum ts_status find_surface(struct ts_instance *self)
{
	struct state *s = self->state;

	TS_TRY(ts_bed_surface_find(s->sim, self->group, isnan(s->column) ? 0 : s->column, s->part,
				   &s->surface));
	if (!isnan(s->base))
		s->surface.base = s->base;
	return TS_OK;
}

static double height_of(const struct ts_bed_surface *surface, size_t k)
{
	return surface->grain[surface->top[k]].height - surface->base;
}

enum { MEAN, MAX, MIN, SCATTER, POROSITY, COLUMNS, NNUMBERS };
static const char *const numbers[] = { "mean", "max", "min", "scatter", "porosity", "columns", NULL };

static double porosity(const struct state *s, double mean)
{
	const struct ts_bed_surface *surface = &s->surface;
	double area =
		s->area > 0 ? s->area : (double)surface->ntops * pow(surface->column, surface->frame.sides);

	return area * mean > 0 ? 1 - surface->volume / (area * mean) : 0;
}

static enum ts_status eval_numbers(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct state *s = self->state;
	double n, squares = 0, *number = out->data;

	(void)sim;
	TS_TRY(find_surface(self));
	n = (double)s->surface.ntops;
	for (int k = 0; k < NNUMBERS; k++)
		number[k] = 0;
	for (size_t k = 0; k < s->surface.ntops; k++) {
		double h = height_of(&s->surface, k);

		number[MEAN] += h / n;
		number[MAX] = k ? fmax(number[MAX], h) : h;
		number[MIN] = k ? fmin(number[MIN], h) : h;
	}
	for (size_t k = 0; k < s->surface.ntops; k++) {
		double d = height_of(&s->surface, k) - number[MEAN];

		squares += d * d;
	}
	number[SCATTER] = n > 0 ? sqrt(squares / n) : 0;
	number[POROSITY] = porosity(s, number[MEAN]);
	number[COLUMNS] = n;
	return TS_OK;
}

static enum ts_status eval_mean(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	double number[NNUMBERS];
	struct ts_table all = { .data = number };

	TS_TRY(eval_numbers(self, sim, &all));
	out->data[0] = number[MEAN];
	return TS_OK;
}

static enum ts_status eval_columns(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct state *s = self->state;

	(void)sim;
	TS_TRY(find_surface(self));
	TS_TRY(ts_table_resize(out, s->surface.ntops, 3));
	for (size_t k = 0; k < s->surface.ntops; k++) {
		const struct ts_bed_grain *g = &s->surface.grain[s->surface.top[k]];

		for (int d = 0; d < 2; d++)
			out->data[3 * k + (size_t)d] =
				d < s->surface.frame.sides ? (g->cell[d] + 0.5) * s->surface.column : 0;
		out->data[3 * k + 2] = height_of(&s->surface, k);
	}
	return TS_OK;
}

static void fini(struct ts_instance *self)
{
	ts_bed_surface_release(&((struct state *)self->state)->surface);
}

static const char *const columns[] = { "side1", "side2", "height", NULL };
static const struct ts_value values[] = {
	{ "height", "length", "mean height of the columns with particles; 0 without particles", TS_SCALAR, 1,
	  NULL, eval_mean },
	{ "numbers", "",
	  "mean, largest, smallest height of the columns and its standard deviation [length]; porosity; "
	  "number of columns with particles",
	  TS_VECTOR, NNUMBERS, numbers, eval_numbers },
	{ "columns", "length", "a row for each column with particles: coordinates of its centre, height",
	  TS_ARRAY, 3, columns, eval_columns },
	{ .name = NULL },
};

static const struct ts_arg args[] = {
	TS_VEC3("up", struct state, up, .flags = TS_OPTIONAL,
		.help = "upward direction, of any length; default: 0 0 1, in two dimensions 0 1 0"),
	TS_REAL("column", struct state, column, .flags = TS_OPTIONAL, .range = TS_POSITIVE, .unit = "length",
		.help = "width of the square columns; default: twice the mean diameter"),
	TS_REAL("quantile", struct state, part, .fallback = "1", .range = TS_FRACTION,
		.help = "the height of a column is that which this part of its particles does not exceed"),
	TS_REAL("base", struct state, base, .flags = TS_OPTIONAL, .unit = "length",
		.help = "coordinate along `up` of the bottom of the bed; default: that below which 1 % of "
			"the particles reach"),
	TS_REAL("area", struct state, area, .flags = TS_OPTIONAL, .range = TS_POSITIVE, .unit = "length^2",
		.help = "cross-section of the bed, for the porosity (in two dimensions its width); default: "
			"that of the columns"),
	TS_ARGS_END,
};

TS_STYLE(compute, ts_style, ts_compute_bed_height)
const struct ts_style ts_compute_bed_height = {
	.name = "bed/height",
	.kind = TS_KIND_COMPUTE,
	.ranks = TS_RANKS_WHOLE | TS_RANKS_PARTICLES,
	.summary = "Height and porosity of a bed of particles",
	.doc = "The space is divided into square columns along the upward direction (strips in two "
	       "dimensions), which begin at the origin of the coordinates. The height of a column is that of "
	       "the uppermost point of the highest particle whose centre is in it, above the bottom of the "
	       "bed; with `quantile` less than 1 that of a lower one, so that a few particles that fly or "
	       "lie above the bed do not count (0.9: one in ten). Only columns with particles count, and all "
	       "count alike.\n\n"
	       "The porosity is 1 - V/(A h): V the volume of all particles of the group, h the mean height, "
	       "A the area of the columns with particles, or `area`. Columns at the rim are counted as whole "
	       "ones, which makes the porosity too large: give `area`, the cross-section of the vessel, if "
	       "there are not very many columns. In wide columns the highest particle stands above the mean "
	       "surface; narrow ones, of one to three diameters, follow it. Overlaps of particles count "
	       "twice.",
	.example = "compute h all bed/height\n"
		   "compute h all bed/height column 0.004 base 0 area 0.00785 quantile 0.95\n"
		   "thermo_style custom step atoms c_h c_h[2] c_h[5]",
	.args = args,
	.state_size = sizeof(struct state),
	.values = values,
	.init = init,
	.fini = fini,
};
