#include "io/vtk.h"

#include <string.h>

#include "io/replace.h"
#include "io/series.h"
#include "io/textfile.h"
#include "io/vtk_legacy.h"
#include "io/vtk_xml.h"
#include "io/vtkhdf.h"

#include "base/banned.h"

/* Connectivity and offsets of n cells of `size` points each; points are not shared by cells. */
static enum ts_status add_cell_arrays(struct tsim *sim, struct ts_str *out, size_t n, size_t size)
{
	int64_t *number = ts_alloc(n * size, sizeof *number);
	enum ts_status status;

	if (!number)
		return ts_nomem(&sim->error);
	for (size_t k = 0; k < n * size; k++)
		number[k] = (int64_t)k;
	status = ts_vtk_add_array(sim, out, "connectivity", "Int64", 1, number, n * size);
	for (size_t k = 0; k < n; k++)
		number[k] = (int64_t)((k + 1) * size);
	if (status == TS_OK)
		status = ts_vtk_add_array(sim, out, "offsets", "Int64", 1, number, n);
	ts_free(number);
	return status;
}

static enum ts_status add_cells(struct tsim *sim, struct ts_str *out, const char *element, size_t n,
				size_t size)
{
	ts_str_addf(out, "<%s>\n", element);
	TS_TRY(add_cell_arrays(sim, out, n, size));
	ts_str_addf(out, "</%s>\n", element);
	return TS_OK;
}

static enum ts_status add_points(struct tsim *sim, struct ts_str *out, const struct ts_vtk_poly *poly)
{
	size_t ncells = poly->npoints / ts_vtk_cell_size(poly);

	TS_TRY(ts_vtk_add_data(sim, out, "PointData", poly->point_data, poly->npoint_data, poly->npoints));
	TS_TRY(ts_vtk_add_data(sim, out, "CellData", poly->cell_data, poly->ncell_data, ncells));
	ts_str_add(out, "<Points>\n");
	TS_TRY(ts_vtk_add_array(sim, out, "Points", "Float64", 3, poly->points, poly->npoints));
	ts_str_add(out, "</Points>\n");
	return TS_OK;
}

static enum ts_status add_poly(struct tsim *sim, struct ts_str *out, const struct ts_vtk_poly *poly)
{
	size_t size = ts_vtk_cell_size(poly), verts = size == 1 ? poly->npoints : 0;
	size_t polygons = poly->ntriangles + poly->nquads;

	ts_vtk_add_opening(out, "PolyData");
	ts_str_add(out, "<PolyData>\n");
	ts_vtk_add_time(out, poly->time);
	ts_str_addf(out,
		    "<Piece NumberOfPoints=\"%zu\" NumberOfVerts=\"%zu\" NumberOfLines=\"%zu\" "
		    "NumberOfStrips=\"0\" NumberOfPolys=\"%zu\">\n",
		    poly->npoints, verts, poly->nlines, polygons);
	TS_TRY(add_points(sim, out, poly));
	TS_TRY(add_cells(sim, out, "Verts", verts, 1));
	TS_TRY(add_cells(sim, out, "Lines", poly->nlines, 2));
	TS_TRY(add_cells(sim, out, "Polys", polygons, size));
	ts_str_add(out, "</Piece>\n</PolyData>\n</VTKFile>\n");
	return out->failed ? ts_nomem(&sim->error) : TS_OK;
}

static enum ts_status add_cell_types(struct tsim *sim, struct ts_str *out, size_t n, size_t size)
{
	static const unsigned char types[] = { 0, 1 /* vertex */, 3 /* line */, 5 /* triangle */,
					       9 /* quad */ };
	unsigned char *type = ts_alloc(n, 1);
	enum ts_status status;

	if (!type)
		return ts_nomem(&sim->error);
	for (size_t k = 0; k < n; k++)
		type[k] = types[size];
	ts_str_add(out, "<DataArray type=\"UInt8\" Name=\"types\" format=\"binary\">\n");
	status = ts_vtk_add_packed(sim, out, type, n);
	ts_str_add(out, "\n</DataArray>\n</Cells>\n");
	ts_free(type);
	return status;
}

static enum ts_status add_unstructured(struct tsim *sim, struct ts_str *out, const struct ts_vtk_poly *poly)
{
	size_t size = ts_vtk_cell_size(poly), n = poly->npoints / size;

	ts_vtk_add_opening(out, "UnstructuredGrid");
	ts_str_add(out, "<UnstructuredGrid>\n");
	ts_vtk_add_time(out, poly->time);
	ts_str_addf(out, "<Piece NumberOfPoints=\"%zu\" NumberOfCells=\"%zu\">\n", poly->npoints, n);
	TS_TRY(add_points(sim, out, poly));
	ts_str_add(out, "<Cells>\n");
	TS_TRY(add_cell_arrays(sim, out, n, size));
	TS_TRY(add_cell_types(sim, out, n, size));
	ts_str_add(out, "</Piece>\n</UnstructuredGrid>\n</VTKFile>\n");
	return out->failed ? ts_nomem(&sim->error) : TS_OK;
}

enum ts_status ts_vtk_write_text(struct tsim *sim, const char *path, const struct ts_place *where,
				 const struct ts_str *text)
{
	struct ts_replace file = { 0 };

	if (text->failed)
		return ts_nomem(&sim->error);
	TS_TRY(ts_replace_begin(&file, sim, where, path));
	TS_TRY(ts_replace_write(&file, ts_str_text(text), text->length));
	return ts_replace_commit(&file, false);
}

static void declare_data(struct ts_str *out, const char *element, const struct ts_vtk_array *array,
			 size_t narrays)
{
	ts_str_addf(out, "<P%s>\n", element);
	for (size_t k = 0; k < narrays; k++) {
		ts_str_addf(out, "<PDataArray type=\"%s\" Name=\"", array[k].integer ? "Int64" : "Float64");
		ts_vtk_add_name(out, array[k].name);
		ts_str_addf(out, "\" NumberOfComponents=\"%zu\"/>\n", array[k].components);
	}
	ts_str_addf(out, "</P%s>\n", element);
}

/* File post/a100.pvtp lists its only piece, post/a100_0.vtp. */
static void add_list_of_pieces(struct ts_str *out, const struct ts_vtk_poly *poly, const char *type,
			       const char *piece)
{
	const char *slash = strrchr(piece, '/');

	ts_vtk_add_opening(out, type);
	ts_str_addf(out, "<%s GhostLevel=\"0\">\n", type);
	declare_data(out, "PointData", poly->point_data, poly->npoint_data);
	declare_data(out, "CellData", poly->cell_data, poly->ncell_data);
	ts_str_add(out, "<PPoints>\n<PDataArray type=\"Float64\" NumberOfComponents=\"3\"/>\n"
			"</PPoints>\n<Piece Source=\"");
	ts_vtk_add_name(out, slash ? slash + 1 : piece);
	ts_str_addf(out, "\"/>\n</%s>\n</VTKFile>\n", type);
}

typedef enum ts_status build_fn(struct tsim *sim, struct ts_str *out, const struct ts_vtk_poly *poly);

static enum ts_status add_legacy(struct tsim *sim, struct ts_str *out, const struct ts_vtk_poly *poly)
{
	if (poly->plain && !poly->binary)
		ts_vtk_legacy_plain(out, poly);
	else
		TS_TRY(ts_vtk_legacy_poly(sim, out, poly));
	return out->failed ? ts_nomem(&sim->error) : TS_OK;
}

static const struct format {
	const char *ending;
	build_fn *build;
	const char *pieces; /* VTK type of the list of pieces; NULL: a single file */
} formats[] = {
	{ ".vtp", add_poly, NULL },
	{ ".vtu", add_unstructured, NULL },
	{ ".vtk", add_legacy, NULL },
	{ ".pvtp", add_poly, "PPolyData" },
	{ ".pvtu", add_unstructured, "PUnstructuredGrid" },
};

static const struct format *format_of(const char *path)
{
	for (size_t k = 0; k < sizeof formats / sizeof *formats; k++)
		if (ts_ends_with(path, formats[k].ending))
			return &formats[k];
	return NULL;
}

bool ts_vtk_is_supported(const char *path)
{
	return format_of(path) != NULL || ts_vtk_has_all_frames(path);
}

bool ts_vtk_has_all_frames(const char *path)
{
	return ts_ends_with(path, ".vtkhdf");
}

static enum ts_status write_single_file(struct tsim *sim, const char *path, const struct ts_place *where,
					const struct ts_vtk_poly *poly, build_fn *build)
{
	struct ts_str text = { 0 };
	enum ts_status status = build(sim, &text, poly);

	if (status == TS_OK)
		status = ts_vtk_write_text(sim, path, where, &text);
	ts_str_release(&text);
	return status;
}

static enum ts_status write_pieces(struct tsim *sim, const char *path, const struct ts_place *where,
				   const struct ts_vtk_poly *poly, const struct format *format)
{
	struct ts_str piece = { 0 }, list = { 0 };
	enum ts_status status;

	ts_str_add_n(&piece, path, strlen(path) - strlen(format->ending));
	ts_str_addf(&piece, "_0.%s", format->ending + 2); /* without the p */
	status = piece.failed ? ts_nomem(&sim->error)
			      : write_single_file(sim, ts_str_text(&piece), where, poly, format->build);
	add_list_of_pieces(&list, poly, format->pieces, ts_str_text(&piece));
	if (status == TS_OK)
		status = ts_vtk_write_text(sim, path, where, &list);
	ts_str_release(&piece);
	ts_str_release(&list);
	return status;
}

enum ts_status ts_vtk_write_poly(struct tsim *sim, const char *path, const struct ts_place *where,
				 const struct ts_vtk_poly *poly)
{
	const struct format *format = format_of(path);

	if (ts_vtk_has_all_frames(path))
		return ts_vtkhdf_append(sim, path, where, poly, poly->first);
	if (!format)
		return ts_fail(&sim->error, TS_SYNTAX, where,
			       "'%s': the name of a VTK file ends in .vtk, .vtp, .vtu, .pvtp, .pvtu or "
			       ".vtkhdf",
			       path);
	return format->pieces ? write_pieces(sim, path, where, poly, format)
			      : write_single_file(sim, path, where, poly, format->build);
}

enum ts_status ts_vtk_series_add(struct tsim *sim, struct ts_vtk_series *s, int64_t step, double time)
{
	for (size_t k = 0; k < s->n; k++)
		if (s->step[k] == step) { /* the file is written again, after reset_timestep */
			s->time[k] = time;
			return TS_OK;
		}
	if (TS_GROW(s->step, s->step_capacity, s->n + 1) != TS_OK ||
	    TS_GROW(s->time, s->time_capacity, s->n + 1) != TS_OK)
		return ts_nomem(&sim->error);
	s->step[s->n] = step;
	s->time[s->n++] = time;
	return TS_OK;
}

/* Name of the collection: post/rock*.vtp, post/rock.*.vtp -> post/rock.pvd; post/ *.vtp -> post/frames.pvd */
static void add_collection_path(struct ts_str *out, const char *pattern, const char *ending)
{
	const char *star = strchr(pattern, '*'), *dot = strrchr(pattern, '.');

	ts_str_add_n(out, pattern, (size_t)(star - pattern));
	if (dot > star)
		ts_str_add_n(out, star + 1, (size_t)(dot - star - 1));
	if (!out->failed && out->length && out->text[out->length - 1] == '.')
		out->text[--out->length] = 0;
	if (!out->failed && (!out->length || out->text[out->length - 1] == '/'))
		ts_str_add(out, "frames");
	ts_str_add(out, ending);
}

/* Adds name and time of the frames, in XML, for legacy files in JSON. */
static void add_frames(struct ts_str *out, const struct ts_vtk_series *series, const char *base, int pad,
		       bool legacy)
{
	struct ts_str path = { 0 };

	for (size_t k = 0; k < series->n; k++) {
		ts_series_path(&path, base, (long long)series->step[k], pad);
		if (legacy)
			ts_str_add(out, k ? ",\n{ \"name\": \"" : "{ \"name\": \"");
		else
			ts_str_addf(out, "<DataSet timestep=\"%.17g\" part=\"0\" file=\"", series->time[k]);
		ts_vtk_add_name(out, ts_str_text(&path));
		if (legacy)
			ts_str_addf(out, "\", \"time\": %.17g }", series->time[k]);
		else
			ts_str_add(out, "\"/>\n");
	}
	out->failed |= path.failed;
	ts_str_release(&path);
}

enum ts_status ts_vtk_series_write(struct tsim *sim, const struct ts_vtk_series *series, const char *pattern,
				   int pad, const struct ts_place *where)
{
	const char *slash = strrchr(pattern, '/'), *base = slash ? slash + 1 : pattern;
	bool legacy = ts_ends_with(pattern, ".vtk");
	struct ts_str text = { 0 }, path = { 0 };
	enum ts_status status;

	if (legacy) {
		ts_str_add(&text, "{ \"file-series-version\": \"1.0\", \"files\": [\n");
	} else {
		ts_vtk_add_opening(&text, "Collection");
		ts_str_add(&text, "<Collection>\n");
	}
	add_frames(&text, series, base, pad, legacy);
	ts_str_add(&text, legacy ? "\n] }\n" : "</Collection>\n</VTKFile>\n");
	add_collection_path(&path, pattern, legacy ? ".vtk.series" : ".pvd");
	status = path.failed ? ts_nomem(&sim->error)
			     : ts_vtk_write_text(sim, ts_str_text(&path), where, &text);
	ts_str_release(&text);
	ts_str_release(&path);
	return status;
}

enum ts_status ts_vtk_series_archive(struct ts_archive *archive, struct ts_vtk_series *series)
{
	size_t n = series->n;

	TS_TRY(ts_archive_array(archive, "frame_step", TS_SAVED_I64, (void **)&series->step,
				&series->step_capacity, &n));
	TS_TRY(ts_archive_array(archive, "frame_time", TS_SAVED_F64, (void **)&series->time,
				&series->time_capacity, &series->n));
	if (n < series->n)
		series->n = n;
	return TS_OK;
}

void ts_vtk_series_keep(struct ts_vtk_series *series, size_t n)
{
	size_t gone = series->n > n ? series->n - n : 0;

	if (!gone)
		return;
	series->n = n;
	memmove(series->step, series->step + gone, n * sizeof *series->step);
	memmove(series->time, series->time + gone, n * sizeof *series->time);
}

void ts_vtk_series_release(struct ts_vtk_series *series)
{
	ts_free(series->step);
	ts_free(series->time);
	*series = (struct ts_vtk_series){ 0 };
}
