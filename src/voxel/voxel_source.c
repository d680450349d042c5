#include "voxel/voxel_source.h"

#include <inttypes.h>
#include <math.h>

#include "voxel/voxel_gaussian.h"
#include "voxel/voxel_image.h"
#include "voxel/voxel_self_affine.h"
#include "voxel/voxel_text.h"

#include "base/banned.h"

enum ts_status ts_voxel_source_read(struct ts_instance *self, struct tsim *sim,
				    const struct ts_voxel_source *source, struct ts_voxel_grid *grid)
{
	if (source->kind == TS_VOXEL_FILE)
		return ts_voxel_text_read(sim, ts_instance_word(self, source->file), source->file, grid);
	if (source->kind == TS_VOXEL_IMAGE)
		return ts_voxel_image_read(sim, ts_instance_word(self, source->file), source->file, grid);
	return TS_OK;
}

/* What fills the heights. */
struct filling {
	struct ts_instance *self;
	struct tsim *sim;
	const struct ts_voxel_source *source;
	const struct ts_voxel_grid *grid;
	struct ts_voxel_field *field;
};

static enum ts_status fill_constant(const struct filling *f)
{
	double *height = ts_voxel_heights(f->field);

	for (int64_t k = 0; k < f->field->n[0] * f->field->n[1]; k++)
		height[k] = f->source->height;
	return TS_OK;
}

static enum ts_status fill_file(const struct filling *f)
{
	double *height = ts_voxel_heights(f->field);

	for (int64_t k = 0; k < f->field->n[0] * f->field->n[1]; k++)
		height[k] = f->source->scale * f->grid->value[k];
	return TS_OK;
}

/* Grey values are fractions, 0 black and 1 white. */
static enum ts_status fill_image(const struct filling *f)
{
	double *height = ts_voxel_heights(f->field);

	for (int64_t k = 0; k < f->field->n[0] * f->field->n[1]; k++) {
		double white = f->grid->value[k];

		height[k] = (1 - white) * f->source->black + white * f->source->white;
	}
	return TS_OK;
}

enum { BATCH = 1024 /* columns at once */ };

/* Coordinate d of the centres of the columns from, from + 1, .. to - 1. */
static void fill_centres(const struct ts_voxel_field *field, int d, int64_t from, int64_t to, double *x)
{
	for (int64_t k = from; k < to; k++) {
		int64_t column = d ? k / field->n[0] : k % field->n[0];

		x[k - from] = field->origin[d] + ((double)column + 0.5) * field->width[d];
	}
}

/* At the centre of each column. */
static enum ts_status fill_formula(const struct filling *f)
{
	const struct ts_voxel_field *field = f->field;
	const struct ts_number *formula = &f->source->formula;
	const struct ts_place *where =
		ts_instance_word(f->self, formula->variable ? formula->variable : f->self->id);
	double centre[2][BATCH], *height = ts_voxel_heights(field);
	struct ts_script_rows set[2];
	size_t nset = 0;

	for (int d = 0; d < 2; d++)
		if (f->source->set[field->axis[d]])
			set[nset++] = (struct ts_script_rows){ f->source->set[field->axis[d]], centre[d] };
	for (int64_t k = 0, n = field->n[0] * field->n[1]; k < n; k += BATCH) {
		int64_t end = k + BATCH < n ? k + BATCH : n;

		if (f->sim->requests.stop)
			return ts_fail(&f->sim->error, TS_STOPPED, where,
				       "stopped on request while heights were computed");
		for (int d = 0; d < 2; d++)
			fill_centres(field, d, k, end, centre[d]);
		if (formula->variable)
			TS_TRY(f->sim->script_api->columns(f->sim->script_api_data, formula->variable, where,
							   set, nset, (size_t)(end - k), height + k));
		for (int64_t c = k; c < end && !formula->variable; c++)
			height[c] = formula->value;
	}
	return TS_OK;
}

struct lengths {
	double first, second;
};
static const struct ts_arg length_rows[] = {
	TS_REAL("first", struct lengths, first, .flags = TS_POSITIONAL, .range = TS_NOT_NEGATIVE),
	TS_REAL("second", struct lengths, second, .flags = TS_POSITIONAL, .range = TS_NOT_NEGATIVE),
	TS_ARGS_END,
};

/* One length is that along both axes. */
static enum ts_status read_correlation(const struct filling *f, double out[2])
{
	struct ts_words words = f->source->correlation;
	struct ts_word both[2] = { words.word[0], words.word[0] };
	struct lengths lengths;

	if (words.n == 1)
		words = (struct ts_words){ both, 2 };
	TS_TRY(ts_args_parse(f->sim, "fix surface/voxel: correlation", length_rows, words, &both[0].place,
			     &f->self->arena, &lengths));
	out[0] = lengths.first;
	out[1] = lengths.second;
	for (int d = 0; d < 2; d++) {
		double size = (double)f->field->n[d] * f->field->width[d];

		if (out[d] > 0.5 * size)
			return ts_fail(&f->sim->error, TS_RANGE, &both[0].place,
				       "fix surface/voxel: the correlation length %g is more than half of "
				       "the size %g of the field, which then has no such statistics",
				       out[d], size);
	}
	return TS_OK;
}

static enum ts_status fill_gaussian(const struct filling *f)
{
	const struct ts_voxel_source *source = f->source;
	struct ts_voxel_gaussian g = { .n = { f->field->n[0], f->field->n[1] },
				       .width = { f->field->width[0], f->field->width[1] },
				       .mean = source->mean,
				       .deviation = source->deviation,
				       .seed = (uint64_t)source->seed,
				       .noise = (enum ts_voxel_noise_kind)source->noise,
				       .exact = source->exact };

	TS_TRY(read_correlation(f, g.correlation));
	if (source->exact && f->field->n[0] * f->field->n[1] < 2)
		return ts_fail(&f->sim->error, TS_RANGE, &f->self->where,
			       "fix surface/voxel: one column has no standard deviation");
	return ts_voxel_gaussian(&g, ts_voxel_heights(f->field)) == TS_OK ? TS_OK : ts_nomem(&f->sim->error);
}

/* The wavelengths of the spectrum, where none are given as wide as the grid permits. */
static void read_wavelengths(const struct filling *f, struct ts_voxel_self_affine *s)
{
	const struct ts_voxel_source *source = f->source;

	s->shortest = isnan(source->shortest) ? 2 * fmax(s->width[0], s->width[1]) : source->shortest;
	s->longest =
		isnan(source->longest) ? fmax(s->n[0] * s->width[0], s->n[1] * s->width[1]) : source->longest;
	s->roll = isnan(source->roll) ? s->longest : source->roll;
}

static enum ts_status fill_self_affine(const struct filling *f)
{
	const struct ts_voxel_source *source = f->source;
	struct ts_voxel_self_affine s = { .n = { (int)f->field->n[0], (int)f->field->n[1] },
					  .width = { f->field->width[0], f->field->width[1] },
					  .mean = source->mean,
					  .deviation = source->deviation,
					  .hurst = source->hurst,
					  .seed = (uint64_t)source->seed,
					  .noise = (enum ts_voxel_noise_kind)source->noise,
					  .exact = source->exact };
	enum ts_status status;

	read_wavelengths(f, &s);
	if (!(s.shortest <= s.roll && s.roll <= s.longest))
		return ts_fail(&f->sim->error, TS_RANGE, &f->self->where,
			       "fix surface/voxel: the wavelengths shortest %g, roll %g, longest %g are not "
			       "in this order",
			       s.shortest, s.roll, s.longest);
	if (s.shortest < 2 * fmin(s.width[0], s.width[1]) * (1 - 1e-9))
		return ts_fail(&f->sim->error, TS_RANGE, &f->self->where,
			       "fix surface/voxel: waves of length %g need columns of at most half this "
			       "width; the columns are %g x %g",
			       s.shortest, s.width[0], s.width[1]);
	status = ts_voxel_self_affine(&s, ts_voxel_heights(f->field));
	if (status == TS_RANGE)
		return ts_fail(&f->sim->error, TS_RANGE, &f->self->where,
			       "fix surface/voxel: no wave that is periodic in the field of %g x %g has a "
			       "length from %g to %g",
			       s.n[0] * s.width[0], s.n[1] * s.width[1], s.shortest, s.longest);
	return status == TS_OK ? TS_OK : ts_nomem(&f->sim->error);
}

static enum ts_status (*const fill[])(const struct filling *f) = {
	[TS_VOXEL_CONSTANT] = fill_constant, [TS_VOXEL_FILE] = fill_file,
	[TS_VOXEL_IMAGE] = fill_image,	     [TS_VOXEL_FORMULA] = fill_formula,
	[TS_VOXEL_GAUSSIAN] = fill_gaussian, [TS_VOXEL_SELF_AFFINE] = fill_self_affine,
};

enum ts_status ts_voxel_source_fill(struct ts_instance *self, struct tsim *sim,
				    const struct ts_voxel_source *source, const struct ts_voxel_grid *grid,
				    double datum, struct ts_voxel_field *field)
{
	struct filling f = { self, sim, source, grid, field };
	double *height = ts_voxel_heights(field);

	TS_TRY(fill[source->kind](&f));
	for (int64_t k = 0; k < field->n[0] * field->n[1]; k++) {
		if (!isfinite(height[k]))
			return ts_fail(&sim->error, TS_RANGE, &self->where,
				       "fix surface/voxel: the height of column %" PRId64 " %" PRId64
				       " is %g, which is not a finite number",
				       k % field->n[0] + 1, k / field->n[0] + 1, height[k]);
		height[k] = fmax(height[k], datum);
	}
	ts_voxel_field_update(field);
	return TS_OK;
}
