#include "dump/dump_vtk.h"

#include <stdio.h>
#include <string.h>

#include "box/domain.h"
#include "io/h5out.h"
#include "io/series.h"

#include "base/banned.h"

/* A .vtkhdf file has all frames of one dump. */
static enum ts_status check_all_frames(struct ts_instance *self, struct tsim *sim)
{
	const struct ts_instances *dumps = &sim->instances[TS_KIND_DUMP];
	const char *file = ((const struct ts_dump_vtk *)self->state)->common.file;
	const struct ts_place *where = ts_instance_word(self, file);

	if (!ts_h5out_available())
		return ts_fail(&sim->error, TS_STATE, where,
			       "dump %s: this tsim was built without HDF5, which .vtkhdf needs (apt-get "
			       "install libhdf5-dev, then ./configure); .vtp needs no library",
			       self->style->name);
	if (strchr(file, '*'))
		return ts_fail(&sim->error, TS_SYNTAX, where,
			       "dump %s: a file .vtkhdf has all frames: leave out the `*` of '%s'",
			       self->style->name, file);
	for (size_t k = 0; k < dumps->n && dumps->item[k] != self; k++) {
		const struct ts_dump_vtk *other = dumps->item[k]->state;

		if (dumps->item[k]->style->archive == ts_dump_vtk_archive &&
		    ts_streq(other->common.file, file))
			return ts_fail(&sim->error, TS_STATE, where, "dump %s: dump %s writes '%s', too",
				       self->style->name, dumps->item[k]->id, file);
	}
	return TS_OK;
}

enum ts_status ts_dump_vtk_check_name(struct ts_instance *self, struct tsim *sim)
{
	const char *file = ((const struct ts_dump_vtk *)self->state)->common.file;

	if (!ts_vtk_is_supported(file))
		return ts_fail(&sim->error, TS_SYNTAX, ts_instance_word(self, file),
			       "dump %s: the name of the file must end in .vtk, .vtp, .vtu, .pvtp, .pvtu or "
			       ".vtkhdf, found '%s'",
			       self->style->name, file);
	((struct ts_dump_vtk *)self->state)->common.in_order = ts_vtk_has_all_frames(file);
	return ts_vtk_has_all_frames(file) ? check_all_frames(self, sim) : TS_OK;
}

/* Rank of a column in the order of arrays in files of LIGGGHTS; other columns come last. */
static int liggghts_rank(const struct ts_dump_column *c)
{
	static const char *const order[] = {
		"id",	    "mol",    "type",	"element", "mass", "xs",  "ys",	 "zs",
		"xu",	    "yu",     "zu",	"xsu",	   "ysu",  "zsu", "ix",	 "iy",
		"iz",	    "vx",     "vy",	"vz",	   "fx",   "fy",  "fz",	 "radius",
		"diameter", "omegax", "omegay", "omegaz",  "tqx",  "tqy", "tqz", "density",
	};
	enum { N = sizeof order / sizeof *order };
	int k = 0;

	while (k < N && !ts_streq(order[k], c->input.name))
		k++;
	return k;
}

/* Insertion sort, stable: columns of the same rank keep the order of the command. */
static void sort_columns(struct ts_dump_column *column, size_t n)
{
	for (size_t k = 1; k < n; k++) {
		struct ts_dump_column moved = column[k];
		size_t to = k;

		for (; to > 0 && liggghts_rank(&column[to - 1]) > liggghts_rank(&moved); to--)
			column[to] = column[to - 1];
		column[to] = moved;
	}
}

enum ts_status ts_dump_vtk_init(struct ts_instance *self, struct tsim *sim, bool local)
{
	struct ts_dump_vtk *s = self->state;

	TS_TRY(ts_dump_vtk_check_name(self, sim));
	TS_TRY(ts_dump_columns(self, sim, s->names, local));
	if (!local)
		sort_columns(s->common.column, s->common.ncolumns);
	if (!s->array)
		s->array = ts_arena_alloc(&self->arena, s->common.ncolumns, sizeof *s->array);
	return s->array ? TS_OK : ts_nomem(&sim->error);
}

/* "vx", "vy", "vz" -> "v"; "c_a[2]", "c_a[3]", "c_a[4]" -> "c_a[2-4]". */
static bool vector_name(const struct ts_dump_column *c, char *out, size_t size)
{
	size_t n = strlen(c[0].input.name);
	const char *bracket = strchr(c[0].input.name, '[');
	size_t stem = bracket ? (size_t)(bracket - c[0].input.name) + 1 : n - 1;
	int64_t index[3];
	char digits[16];

	for (int k = 0; k < 3; k++) {
		const char *name = c[k].input.name, *rest;

		if (strlen(name) <= stem || strncmp(name, c[0].input.name, stem) != 0)
			return false;
		rest = name + stem;
		if (!bracket) {
			if (rest[0] != "xyz"[k] || rest[1] || !c[k].input.quantity)
				return false;
			continue;
		}
		snprintf(digits, sizeof digits, "%.*s", (int)strcspn(rest, "]"), rest);
		if (!ts_parse_int(digits, &index[k]) || index[k] != index[0] + k)
			return false;
	}
	if (bracket)
		snprintf(out, size, "%.*s%lld-%lld]", (int)stem, c[0].input.name, (long long)index[0],
			 (long long)index[2]);
	else
		snprintf(out, size, "%.*s", (int)stem, c[0].input.name);
	return true;
}

static bool is_position(const struct ts_dump_column *c)
{
	return c->input.quantity && strchr("xyz", c->input.name[0]) && !c->input.name[1];
}

/* Columns named twice are written once: scripts often have `id type type x y z`. */
static bool is_repeated(const struct ts_dump_common *d, size_t k)
{
	for (size_t before = 0; before < k; before++)
		if (ts_streq(d->column[before].input.name, d->column[k].input.name))
			return true;
	return false;
}

static void copy_columns(const struct ts_dump_common *d, size_t first, size_t count, double *to)
{
	for (size_t row = 0; row < d->nrows; row++)
		for (size_t k = 0; k < count; k++)
			*to++ = d->column[first + k].values.data[d->order[row]];
}

/* A variable v_NAME is written as NAME, unless a previous array has that name. */
static const char *array_name(const struct ts_dump_vtk *s, const char *column)
{
	bool variable = strncmp(column, "v_", 2) == 0;

	for (size_t k = 0; variable && k < s->narrays; k++)
		variable = !ts_streq(s->array[k].name, column + 2);
	return variable ? column + 2 : column;
}

/* Adds column k, or the vector of columns k to k + 2, as an array. Returns the number of columns used. */
static size_t add_array(struct ts_instance *self, size_t k, bool vectors, double *to)
{
	struct ts_dump_vtk *s = self->state;
	const struct ts_dump_common *d = &s->common;
	struct ts_vtk_array *a = &s->array[s->narrays];
	char name[256];
	bool vector = vectors && k + 2 < d->ncolumns && vector_name(&d->column[k], name, sizeof name);

	if (!vector)
		snprintf(name, sizeof name, "%s", array_name(s, d->column[k].input.name));
	if (!a->name || !ts_streq(a->name, name))
		a->name = ts_arena_strdup(&self->arena, name);
	a->components = vector ? 3 : 1;
	a->integer = d->column[k].integer;
	a->data = to;
	copy_columns(d, k, a->components, to);
	s->narrays++;
	return a->components;
}

/* Fills `array` with the columns, rows in the order of writing. */
static enum ts_status merge_columns(struct ts_instance *self, struct tsim *sim, bool vectors)
{
	struct ts_dump_vtk *s = self->state;
	const struct ts_dump_common *d = &s->common;
	double *to;

	if (ts_table_resize(&s->merged, d->nrows, d->ncolumns) != TS_OK)
		return ts_nomem(&sim->error);
	to = s->merged.data;
	s->narrays = 0;
	for (size_t k = 0; k < d->ncolumns;) {
		size_t taken = 1;

		if (!is_position(&d->column[k]) && !is_repeated(d, k)) {
			taken = add_array(self, k, vectors, to);
			if (!s->array[s->narrays - 1].name)
				return ts_nomem(&sim->error);
			to += taken * d->nrows;
		}
		k += taken;
	}
	return TS_OK;
}

enum ts_status ts_dump_vtk_path(struct ts_dump_common *d, struct tsim *sim)
{
	ts_series_path(&d->path, d->file, (long long)sim->clock.step, (int)d->pad);
	return d->path.failed ? ts_nomem(&sim->error) : TS_OK;
}

enum ts_status ts_dump_vtk_list(struct ts_instance *self, struct tsim *sim)
{
	struct ts_dump_vtk *s = self->state;
	struct ts_dump_common *d = &s->common;

	if (ts_vtk_has_all_frames(d->file))
		return TS_OK;
	if (!strchr(d->file, '*')) { /* there is one frame, the last */
		if (d->frames == 2)
			ts_warn(&sim->log, ts_instance_word(self, d->file),
				"dump %s writes one file per frame: without a `*` for the step in '%s' each "
				"frame replaces the one before",
				self->style->name, d->file);
		return TS_OK;
	}
	TS_TRY(ts_vtk_series_add(sim, &s->series, sim->clock.step, ts_sim_time(sim)));
	if (d->nold) {
		TS_TRY(ts_dump_keep_latest(d, sim));
		ts_vtk_series_keep(&s->series, (size_t)d->nold);
	}
	return ts_vtk_series_write(sim, &s->series, d->file, (int)d->pad, &self->where);
}

void ts_dump_vtk_line(const struct tsim *sim, const double a[3], const double b[3], double to[6])
{
	double apart[3];

	for (int d = 0; d < 3; d++)
		apart[d] = b[d] - a[d];
	ts_box_nearest(&sim->domain->box, apart);
	for (int d = 0; d < 3; d++) {
		to[d] = a[d];
		to[3 + d] = a[d] + apart[d];
	}
}

enum ts_status ts_dump_vtk_write(struct ts_instance *self, struct tsim *sim, struct ts_vtk_poly *poly)
{
	struct ts_dump_common *d = self->state;

	poly->time = ts_sim_time(sim);
	poly->binary = d->binary;
	poly->first = d->frames == 1 && !d->append;
	poly->single_points |= sim->legacy == TS_LEGACY_LIGGGHTS;
	TS_TRY(ts_dump_vtk_path(d, sim));
	TS_TRY(ts_vtk_write_poly(sim, ts_str_text(&d->path), &self->where, poly));
	return ts_dump_vtk_list(self, sim);
}

enum ts_status ts_dump_vtk_frame(struct ts_instance *self, struct tsim *sim, bool local,
				 ts_dump_vtk_points_fn *fill_points)
{
	struct ts_dump_vtk *s = self->state;
	struct ts_vtk_poly poly = { 0 };
	bool due;

	TS_TRY(ts_dump_due(self, sim, &due));
	if (!due)
		return TS_OK;
	TS_TRY(ts_dump_gather(self, sim, local));
	TS_TRY(fill_points(self, sim));
	TS_TRY(merge_columns(self, sim, !local));
	poly.points = s->points.data;
	if (local) {
		poly.nlines = s->common.nrows;
		poly.npoints = 2 * poly.nlines;
		poly.cell_data = s->array;
		poly.ncell_data = s->narrays;
	} else {
		poly.npoints = s->common.nrows;
		poly.point_data = s->array;
		poly.npoint_data = s->narrays;
	}
	return ts_dump_vtk_write(self, sim, &poly);
}

enum ts_status ts_dump_vtk_archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *archive)
{
	struct ts_dump_vtk *s = self->state;

	TS_TRY(ts_dump_archive(self, sim, archive));
	return ts_vtk_series_archive(archive, &s->series);
}

void ts_dump_vtk_fini(struct ts_instance *self)
{
	struct ts_dump_vtk *s = self->state;

	ts_vtk_series_release(&s->series);
	ts_table_release(&s->merged);
	ts_table_release(&s->points);
	ts_dump_fini(self);
}
