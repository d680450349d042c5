/* Dump voxel/vtk: the tops of the columns of a height field, as legacy VTK (text). */
#include <string.h>

#include "core/sim.h"
#include "dump/dump.h"
#include "dump/dump_surface.h"
#include "voxel/voxel_surface.h"

#include "base/banned.h"

struct state {
	struct ts_dump_common common;
	const char *id;
	const struct ts_voxel_surface *surface;
	struct ts_dump_surface_inputs inputs;
};

static bool writes(const struct ts_instance *self, const struct ts_instance *by)
{
	return by->state == ((const struct state *)self->state)->surface;
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	struct ts_word id = { .text = s->id, .place = *ts_instance_word(self, s->id) };
	struct ts_voxel_surface *surface;

	if (!strchr(s->common.file, '*'))
		return ts_fail(&sim->error, TS_SYNTAX, ts_instance_word(self, s->common.file),
			       "dump voxel/vtk writes one file per frame: the name '%s' needs a `*` for the "
			       "step",
			       s->common.file);
	TS_TRY(ts_voxel_surface_require(sim, &id, &surface));
	s->surface = surface;
	return ts_dump_surface_find(self, sim, writes, &s->inputs);
}

static size_t count_columns(const struct ts_voxel_field *f)
{
	size_t n = 0;

	for (int64_t j = 0; j < f->n[1]; j++)
		for (int64_t i = 0; i < f->n[0]; i++)
			n += ts_voxel_top(f, i, j) > f->base;
	return n;
}

/* The corners of the top of a column in the order of a polygon. */
static void add_corners(struct ts_str *text, const struct ts_voxel_surface *s, int64_t i, int64_t j)
{
	static const int along[4][2] = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } };
	const struct ts_voxel_field *f = &s->field;

	for (int k = 0; k < 4; k++) {
		double x[3];

		x[f->axis[0]] = ts_voxel_border(f, 0, i + along[k][0]);
		x[f->axis[1]] = ts_voxel_border(f, 1, j + along[k][1]);
		x[f->axis[2]] = ts_voxel_top(f, i, j);
		ts_str_addf(text, "%.9g %.9g %.9g\n", x[0] + s->shift[0], x[1] + s->shift[1],
			    x[2] + s->shift[2]);
	}
}

static void add_points(struct ts_str *text, const struct ts_voxel_surface *s, size_t n)
{
	const struct ts_voxel_field *f = &s->field;

	ts_str_addf(text, "POINTS %zu double\n", 4 * n);
	for (int64_t j = 0; j < f->n[1]; j++)
		for (int64_t i = 0; i < f->n[0]; i++)
			if (ts_voxel_top(f, i, j) > f->base)
				add_corners(text, s, i, j);
	ts_str_addf(text, "POLYGONS %zu %zu\n", n, 5 * n);
	for (size_t k = 0; k < n; k++)
		ts_str_addf(text, "4 %zu %zu %zu %zu\n", 4 * k, 4 * k + 1, 4 * k + 2, 4 * k + 3);
}

/* `arrays`: number of arrays that follow the heights. */
static void add_heights(struct ts_str *text, const struct ts_voxel_field *f, size_t n, size_t arrays)
{
	ts_str_addf(text, "CELL_DATA %zu\nFIELD FieldData %zu\ncolumn 1 %zu int\n", n, 2 + arrays, n);
	for (int64_t j = 0; j < f->n[1]; j++)
		for (int64_t i = 0; i < f->n[0]; i++)
			if (ts_voxel_top(f, i, j) > f->base)
				ts_str_addf(text, "%lld\n", (long long)(j * f->n[0] + i));
	ts_str_addf(text, "height 1 %zu double\n", n);
	for (int64_t j = 0; j < f->n[1]; j++)
		for (int64_t i = 0; i < f->n[0]; i++)
			if (ts_voxel_top(f, i, j) > f->base)
				ts_str_addf(text, "%.17g\n", ts_voxel_top(f, i, j));
}

static enum ts_status add_input(struct state *s, struct tsim *sim, size_t k, size_t n)
{
	const struct ts_voxel_field *f = &s->surface->field;
	struct ts_str *text = &s->common.text;

	TS_TRY(ts_dump_surface_begin_array(sim, &s->inputs, k, (size_t)(f->n[0] * f->n[1]), n, text));
	for (int64_t j = 0; j < f->n[1]; j++)
		for (int64_t i = 0; i < f->n[0]; i++)
			if (ts_voxel_top(f, i, j) > f->base)
				ts_str_addf(text, "%.11g\n", s->inputs.values.data[j * f->n[0] + i]);
	return TS_OK;
}

static enum ts_status output(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	struct ts_str *text = &s->common.text;
	size_t n;
	bool due;

	TS_TRY(ts_dump_due(self, sim, &due));
	if (!due)
		return TS_OK;
	TS_TRY(ts_dump_open(self, sim));
	n = count_columns(&s->surface->field);
	ts_str_add(text, "# vtk DataFile Version 3.0\nheight field\nASCII\nDATASET POLYDATA\n");
	add_points(text, s->surface, n);
	add_heights(text, &s->surface->field, n, s->inputs.list.n);
	for (size_t k = 0; k < s->inputs.list.n; k++)
		TS_TRY(add_input(s, sim, k, n));
	if (text->failed)
		return ts_nomem(&sim->error);
	TS_TRY(ts_textfile_write(&s->common.out, ts_str_text(text), text->length));
	return ts_dump_frame_done(&s->common, sim);
}

static enum ts_status plan(struct ts_instance *self, struct tsim *sim, struct ts_plan_report *report)
{
	const struct state *s = self->state;
	const struct ts_voxel_field *f = &s->surface->field;
	double column = 170 + 12 * (double)s->inputs.list.n;

	return ts_dump_price_frame(self, sim, 200 + column * (double)(f->n[0] * f->n[1]), report);
}

static void fini(struct ts_instance *self)
{
	struct state *s = self->state;

	ts_dump_surface_release(&s->inputs);
	ts_dump_fini(self);
}

static const struct ts_arg args[] = {
	TS_DUMP_ARGS(struct state),
	TS_WORD("surface", struct state, id, .flags = TS_POSITIONAL, .help = "ID of a fix surface/voxel"),
	TS_REST_OPTIONAL("outputs", struct state, inputs.names,
			 .help = "f_ID[k] or f_ID[*]: columns of outputs that have a row for each column of "
				 "the surface, as of the fixes wear/..."),
	TS_ARGS_END,
};

static const struct ts_saved saved[] = { TS_DUMP_SAVED(struct state), TS_SAVED_ROWS_END };

TS_STYLE(dump, ts_style, ts_dump_voxel_vtk)
const struct ts_style ts_dump_voxel_vtk = {
	.name = "voxel/vtk",
	.kind = TS_KIND_DUMP,
	.summary = "The tops of the columns of a height field, as legacy VTK for ParaView",
	.doc = "Writes one file per frame, PolyData of version 3.0 as text: a square for the top of each "
	       "column at its present position; empty columns are left out. Cell data:\n\n"
	       "  column   number of the column, from 0; the first index varies fastest\n"
	       "  height   height of the column, without the displacement of the field\n"
	       "  f_ID[k]  of the column, by an output of a fix about this surface\n\n"
	       "Related: fix surface/voxel, fix wear/finnie, dump mesh/vtk.",
	.example = "dump scar all voxel/vtk 1000 post/scar*.vtk rough f_worn[8]",
	.args = args,
	.state_size = sizeof(struct state),
	.saved = saved,
	.init = init,
	.plan = plan,
	.hook[TS_STAGE_OUTPUT] = output,
	.fini = fini,
};
