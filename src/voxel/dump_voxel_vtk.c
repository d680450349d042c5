/* Dump voxel/vtk: the tops of the columns of a height field, for ParaView. */
#include <string.h>

#include "core/sim.h"
#include "dump/dump_surface.h"
#include "dump/dump_vtk.h"
#include "voxel/voxel_surface.h"

#include "base/banned.h"

struct state {
	struct ts_dump_vtk vtk;
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

	if (ts_vtk_has_all_frames(s->vtk.common.file))
		TS_TRY(ts_dump_vtk_check_name(self, sim));
	else if (!strchr(s->vtk.common.file, '*'))
		return ts_fail(&sim->error, TS_SYNTAX, ts_instance_word(self, s->vtk.common.file),
			       "dump voxel/vtk writes one file per frame: the name '%s' needs a `*` for the "
			       "step",
			       s->vtk.common.file);
	TS_TRY(ts_voxel_surface_require(sim, &id, &surface));
	s->surface = surface;
	TS_TRY(ts_dump_surface_find(self, sim, writes, &s->inputs));
	if (!s->vtk.array)
		s->vtk.array = ts_arena_alloc(&self->arena, 2 + s->inputs.list.n, sizeof *s->vtk.array);
	return s->vtk.array ? TS_OK : ts_nomem(&sim->error);
}

static size_t count_columns(const struct ts_voxel_field *f)
{
	size_t n = 0;

	for (int64_t j = 0; j < f->n[1]; j++)
		for (int64_t i = 0; i < f->n[0]; i++)
			n += ts_voxel_top(f, i, j) > f->base;
	return n;
}

/* Corner k of the top of a column, in the order of a polygon. */
static void find_corner(const struct ts_voxel_surface *s, int64_t i, int64_t j, int k, double x[3])
{
	static const int along[4][2] = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } };
	const struct ts_voxel_field *f = &s->field;

	x[f->axis[0]] = ts_voxel_border(f, 0, i + along[k][0]);
	x[f->axis[1]] = ts_voxel_border(f, 1, j + along[k][1]);
	x[f->axis[2]] = ts_voxel_top(f, i, j);
	for (int d = 0; d < 3; d++)
		x[d] += s->shift[d];
}

static void add_corners(struct ts_str *text, const struct ts_voxel_surface *s, int64_t i, int64_t j)
{
	for (int k = 0; k < 4; k++) {
		double x[3];

		find_corner(s, i, j, k, x);
		ts_str_addf(text, "%.9g %.9g %.9g\n", x[0], x[1], x[2]);
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
	struct ts_str *text = &s->vtk.common.text;

	TS_TRY(ts_dump_surface_eval(sim, &s->inputs, k, (size_t)(f->n[0] * f->n[1])));
	ts_str_addf(text, "%s 1 %zu double\n", s->inputs.list.item[k].name, n);
	for (int64_t j = 0; j < f->n[1]; j++)
		for (int64_t i = 0; i < f->n[0]; i++)
			if (ts_voxel_top(f, i, j) > f->base)
				ts_str_addf(text, "%.11g\n", s->inputs.values.data[j * f->n[0] + i]);
	return TS_OK;
}

/* Legacy text of version 3.0. */
static enum ts_status build_text(struct state *s, struct tsim *sim, size_t n)
{
	struct ts_str *text = &s->vtk.common.text;

	ts_str_clear(text);
	ts_str_add(text, "# vtk DataFile Version 3.0\nheight field\nASCII\nDATASET POLYDATA\n");
	add_points(text, s->surface, n);
	add_heights(text, &s->surface->field, n, s->inputs.list.n);
	for (size_t k = 0; k < s->inputs.list.n; k++)
		TS_TRY(add_input(s, sim, k, n));
	return text->failed ? ts_nomem(&sim->error) : TS_OK;
}

/* Names other than of the formats of io/vtk.h, such as NAME.vtk.gz. */
static enum ts_status write_other(struct ts_instance *self, struct tsim *sim, size_t n)
{
	struct state *s = self->state;
	struct ts_dump_common *d = &s->vtk.common;

	TS_TRY(ts_dump_open(self, sim));
	TS_TRY(build_text(s, sim, n));
	TS_TRY(ts_textfile_write(&d->out, ts_str_text(&d->text), d->text.length));
	return ts_dump_frame_done(d, sim);
}

static enum ts_status write_text(struct ts_instance *self, struct tsim *sim, size_t n)
{
	struct state *s = self->state;

	TS_TRY(build_text(s, sim, n));
	TS_TRY(ts_dump_vtk_path(&s->vtk.common, sim));
	TS_TRY(ts_vtk_write_text(sim, ts_str_text(&s->vtk.common.path), &self->where, &s->vtk.common.text));
	return ts_dump_vtk_list(self, sim);
}

/* Values of the columns that are not empty: their numbers, heights, those of the outputs. */
static enum ts_status fill_arrays(struct state *s, struct tsim *sim, size_t n)
{
	const struct ts_voxel_field *f = &s->surface->field;
	struct ts_dump_vtk *v = &s->vtk;
	double *to = v->merged.data;

	v->array[0] = (struct ts_vtk_array){ .name = "column", .components = 1, .integer = true };
	v->array[1] = (struct ts_vtk_array){ .name = "height", .components = 1 };
	for (size_t k = 2; k < v->narrays; k++)
		v->array[k] =
			(struct ts_vtk_array){ .name = s->inputs.list.item[k - 2].name, .components = 1 };
	for (size_t k = 0; k < v->narrays; k++) {
		v->array[k].data = to + k * n;
		if (k >= 2)
			TS_TRY(ts_dump_surface_eval(sim, &s->inputs, k - 2, (size_t)(f->n[0] * f->n[1])));
		for (int64_t c = 0, row = 0; c < f->n[0] * f->n[1]; c++) {
			double top = ts_voxel_top(f, c % f->n[0], c / f->n[0]);

			if (top > f->base)
				to[k * n + (size_t)row++] = k == 0   ? (double)c
							    : k == 1 ? top
								     : s->inputs.values.data[c];
		}
	}
	return TS_OK;
}

static void fill_points(struct state *s)
{
	const struct ts_voxel_field *f = &s->surface->field;
	double *to = s->vtk.points.data;

	for (int64_t j = 0; j < f->n[1]; j++)
		for (int64_t i = 0; i < f->n[0]; i++)
			for (int k = 0; k < 4 && ts_voxel_top(f, i, j) > f->base; k++, to += 3)
				find_corner(s->surface, i, j, k, to);
}

static enum ts_status write_squares(struct ts_instance *self, struct tsim *sim, size_t n)
{
	struct state *s = self->state;
	struct ts_dump_vtk *v = &s->vtk;
	struct ts_vtk_poly poly = { .nquads = n, .npoints = 4 * n };

	v->narrays = 2 + s->inputs.list.n;
	if (ts_table_resize(&v->points, 4 * n, 3) != TS_OK ||
	    ts_table_resize(&v->merged, n, v->narrays) != TS_OK)
		return ts_nomem(&sim->error);
	fill_points(s);
	TS_TRY(fill_arrays(s, sim, n));
	poly.points = v->points.data;
	poly.cell_data = v->array;
	poly.ncell_data = v->narrays;
	return ts_dump_vtk_write(self, sim, &poly);
}

static enum ts_status output(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	const struct ts_dump_common *d = &s->vtk.common;
	size_t n;
	bool due;

	TS_TRY(ts_dump_due(self, sim, &due));
	if (!due)
		return TS_OK;
	n = count_columns(&s->surface->field);
	if (!ts_vtk_is_supported(d->file))
		return write_other(self, sim, n);
	return ts_ends_with(d->file, ".vtk") && !d->binary ? write_text(self, sim, n)
							   : write_squares(self, sim, n);
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
	ts_dump_vtk_fini(self);
}

static const struct ts_arg args[] = {
	TS_DUMP_VTK_FILE_ARGS(struct state),
	TS_WORD("surface", struct state, id, .flags = TS_POSITIONAL, .help = "ID of a fix surface/voxel"),
	TS_REST_OPTIONAL("outputs", struct state, inputs.names,
			 .help = "f_ID[k] or f_ID[*]: columns of outputs that have a row for each column of "
				 "the surface, as of the fixes wear/..."),
	TS_ARGS_END,
};

static const struct ts_saved saved[] = { TS_DUMP_VTK_SAVED(struct state), TS_SAVED_ROWS_END };

TS_STYLE(dump, ts_style, ts_dump_voxel_vtk)
const struct ts_style ts_dump_voxel_vtk = {
	.name = "voxel/vtk",
	.kind = TS_KIND_DUMP,
	.dump_words = "binary append",
	.ranks = TS_RANKS_WHOLE,
	.due = ts_dump_may_be_due,
	.names = ts_dump_names,
	.summary = "The tops of the columns of a height field, for ParaView",
	.doc = "Writes one file per frame: a square for the top of each column at its present position; "
	       "empty columns are left out. The ending of the name selects the format, as for dump "
	       "custom/vtk: .vtp and .vtu are compressed VTK XML, .vtk is the legacy format as text (version "
	       "3.0), with `dump_modify binary yes` as binary (version 5.1); .vtkhdf: all frames in one "
	       "file; any "
	       "other name: as text. The "
	       "collection NAME.pvd, for .vtk NAME.vtk.series, lists the frames with their times: open this "
	       "file in ParaView. Cell data:\n\n"
	       "  column   number of the column, from 0; the first index varies fastest\n"
	       "  height   height of the column, without the displacement of the field\n"
	       "  f_ID[k]  of the column, by an output of a fix about this surface\n\n"
	       "Related: fix surface/voxel, fix wear/finnie, dump mesh/vtk.",
	.example = "dump scar all voxel/vtk 1000 post/scar*.vtk rough f_worn[8]",
	.args = args,
	.state_size = sizeof(struct state),
	.saved = saved,
	.archive = ts_dump_vtk_archive,
	.init = init,
	.plan = plan,
	.hook[TS_STAGE_OUTPUT] = output,
	.fini = fini,
};
