#include "io/vtk.h"

#include <string.h>
#include <zlib.h>

#include "io/replace.h"
#include "io/textfile.h"

#include "base/banned.h"

enum { BLOCK = 1 << 20 };

void ts_base64(struct ts_str *out, const unsigned char *bytes, size_t n)
{
	static const char digit[] =
		"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

	for (size_t i = 0; i < n; i += 3) {
		unsigned a = bytes[i], b = i + 1 < n ? bytes[i + 1] : 0,
			 c = i + 2 < n ? bytes[i + 2] : 0;
		char four[4] = { digit[a >> 2], digit[(a & 3) << 4 | b >> 4],
				 i + 1 < n ? digit[(b & 15) << 2 | c >> 6] : '=',
				 i + 2 < n ? digit[c & 63] : '=' };

		ts_str_add_n(out, four, 4);
	}
}

/* Header {blocks, size of a block, size of a partial last block, compressed sizes...}, then all
 * blocks; each of the two in base64. */
static enum ts_status add_packed(struct tsim *sim, struct ts_str *out, const void *data, size_t n)
{
	size_t blocks = (n + BLOCK - 1) / BLOCK, used = 0;
	uint64_t *head = ts_alloc(3 + blocks, sizeof *head);
	unsigned char *packed = ts_alloc(blocks, (size_t)compressBound(BLOCK));
	bool ok = head && packed;

	for (size_t k = 0; ok && k < blocks; k++) {
		size_t size = n - k * BLOCK < BLOCK ? n - k * BLOCK : BLOCK;
		uLongf length = compressBound(BLOCK);

		ok = compress2(packed + used, &length, (const Bytef *)data + k * BLOCK, (uLong)size,
			       Z_BEST_SPEED) == Z_OK;
		head[3 + k] = length;
		used += length;
	}
	if (ok) {
		head[0] = blocks;
		head[1] = BLOCK;
		head[2] = n % BLOCK;
		ts_base64(out, (const unsigned char *)head, (3 + blocks) * sizeof *head);
		ts_base64(out, packed, used);
	}
	ts_free(head);
	ts_free(packed);
	return ok && !out->failed ? TS_OK : ts_nomem(&sim->error);
}

/* Names come from scripts: only characters that need no escape in XML. */
static void add_name(struct ts_str *out, const char *name)
{
	for (; *name; name++)
		ts_str_add_n(out, strchr("<>&\"'", *name) ? "_" : name, 1);
}

static enum ts_status add_array(struct tsim *sim, struct ts_str *out, const char *name,
				const char *type, size_t components, const void *data, size_t n)
{
	ts_str_addf(out, "<DataArray type=\"%s\" Name=\"", type);
	add_name(out, name);
	ts_str_addf(out, "\" NumberOfComponents=\"%zu\" format=\"binary\">\n", components);
	TS_TRY(add_packed(sim, out, data, n * components * 8));
	ts_str_add(out, "\n</DataArray>\n");
	return TS_OK;
}

static enum ts_status add_integers(struct tsim *sim, struct ts_str *out,
				   const struct ts_vtk_array *array, size_t n)
{
	int64_t *whole = ts_alloc(n * array->components, sizeof *whole);
	enum ts_status status;

	if (!whole)
		return ts_nomem(&sim->error);
	for (size_t k = 0; k < n * array->components; k++)
		whole[k] = (int64_t)array->data[k];
	status = add_array(sim, out, array->name, "Int64", array->components, whole, n);
	ts_free(whole);
	return status;
}

static enum ts_status add_data(struct tsim *sim, struct ts_str *out, const char *element,
			       const struct ts_vtk_array *array, size_t narrays, size_t n)
{
	ts_str_addf(out, "<%s>\n", element);
	for (size_t k = 0; k < narrays; k++)
		if (array[k].integer)
			TS_TRY(add_integers(sim, out, &array[k], n));
		else
			TS_TRY(add_array(sim, out, array[k].name, "Float64", array[k].components,
					 array[k].data, n));
	ts_str_addf(out, "</%s>\n", element);
	return TS_OK;
}

/* n cells of `size` points each, numbered through. */
static enum ts_status add_cells(struct tsim *sim, struct ts_str *out, const char *element, size_t n,
				size_t size)
{
	int64_t *number = ts_alloc(n * size, sizeof *number);
	enum ts_status status;

	if (!number)
		return ts_nomem(&sim->error);
	for (size_t k = 0; k < n * size; k++)
		number[k] = (int64_t)k;
	ts_str_addf(out, "<%s>\n", element);
	status = add_array(sim, out, "connectivity", "Int64", 1, number, n * size);
	for (size_t k = 0; k < n; k++)
		number[k] = (int64_t)((k + 1) * size);
	if (status == TS_OK)
		status = add_array(sim, out, "offsets", "Int64", 1, number, n);
	ts_str_addf(out, "</%s>\n", element);
	ts_free(number);
	return status;
}

static void add_opening(struct ts_str *out, const char *type)
{
	const uint16_t one = 1;

	ts_str_addf(out,
		    "<?xml version=\"1.0\"?>\n<VTKFile type=\"%s\" version=\"1.0\" "
		    "byte_order=\"%s\" header_type=\"UInt64\" "
		    "compressor=\"vtkZLibDataCompressor\">\n",
		    type, *(const unsigned char *)&one ? "LittleEndian" : "BigEndian");
}

static enum ts_status add_poly(struct tsim *sim, struct ts_str *out, const struct ts_vtk_poly *poly)
{
	size_t verts = poly->nlines ? 0 : poly->npoints;
	size_t ncells = poly->nlines ? poly->nlines : verts;

	add_opening(out, "PolyData");
	ts_str_add(out, "<PolyData>\n<FieldData>\n<DataArray type=\"Float64\" Name=\"TimeValue\" "
			"NumberOfTuples=\"1\" format=\"ascii\">\n");
	ts_str_addf(out, "%.17g\n</DataArray>\n</FieldData>\n", poly->time);
	ts_str_addf(out,
		    "<Piece NumberOfPoints=\"%zu\" NumberOfVerts=\"%zu\" NumberOfLines=\"%zu\" "
		    "NumberOfStrips=\"0\" NumberOfPolys=\"0\">\n",
		    poly->npoints, verts, poly->nlines);
	TS_TRY(add_data(sim, out, "PointData", poly->point_data, poly->npoint_data, poly->npoints));
	TS_TRY(add_data(sim, out, "CellData", poly->cell_data, poly->ncell_data, ncells));
	ts_str_add(out, "<Points>\n");
	TS_TRY(add_array(sim, out, "Points", "Float64", 3, poly->points, poly->npoints));
	ts_str_add(out, "</Points>\n");
	TS_TRY(add_cells(sim, out, "Verts", verts, 1));
	TS_TRY(add_cells(sim, out, "Lines", poly->nlines, 2));
	ts_str_add(out, "</Piece>\n</PolyData>\n</VTKFile>\n");
	return out->failed ? ts_nomem(&sim->error) : TS_OK;
}

static enum ts_status put_file(struct tsim *sim, const char *path, const struct ts_place *where,
			       const struct ts_str *text)
{
	struct ts_replace file = { 0 };

	TS_TRY(ts_replace_begin(&file, sim, where, path));
	TS_TRY(ts_replace_write(&file, ts_str_text(text), text->length));
	return ts_replace_commit(&file, false);
}

enum ts_status ts_vtk_write_poly(struct tsim *sim, const char *path, const struct ts_place *where,
				 const struct ts_vtk_poly *poly)
{
	struct ts_str text = { 0 };
	enum ts_status status = add_poly(sim, &text, poly);

	if (status == TS_OK)
		status = put_file(sim, path, where, &text);
	ts_str_release(&text);
	return status;
}

enum ts_status ts_vtk_series_add(struct tsim *sim, struct ts_vtk_series *s, int64_t step,
				 double time)
{
	if (TS_GROW(s->step, s->step_capacity, s->n + 1) != TS_OK ||
	    TS_GROW(s->time, s->time_capacity, s->n + 1) != TS_OK)
		return ts_nomem(&sim->error);
	s->step[s->n] = step;
	s->time[s->n++] = time;
	return TS_OK;
}

/* post/rock*.vtp -> post/rock.pvd */
static void add_collection_path(struct ts_str *out, const char *pattern)
{
	const char *star = strchr(pattern, '*'), *dot = strrchr(pattern, '.');

	ts_str_add_n(out, pattern, (size_t)(star - pattern));
	if (dot > star)
		ts_str_add_n(out, star + 1, (size_t)(dot - star - 1));
	ts_str_add(out, ".pvd");
}

enum ts_status ts_vtk_series_write(struct tsim *sim, const struct ts_vtk_series *series,
				   const char *pattern, int pad, const struct ts_place *where)
{
	const char *slash = strrchr(pattern, '/'), *base = slash ? slash + 1 : pattern;
	struct ts_str text = { 0 }, path = { 0 };
	enum ts_status status;

	add_opening(&text, "Collection");
	ts_str_add(&text, "<Collection>\n");
	for (size_t k = 0; k < series->n; k++) {
		ts_step_path(&path, base, (long long)series->step[k], pad);
		ts_str_addf(&text, "<DataSet timestep=\"%.17g\" part=\"0\" file=\"",
			    series->time[k]);
		add_name(&text, ts_str_text(&path));
		ts_str_add(&text, "\"/>\n");
	}
	ts_str_add(&text, "</Collection>\n</VTKFile>\n");
	ts_str_clear(&path);
	add_collection_path(&path, pattern);
	if (text.failed || path.failed)
		status = ts_nomem(&sim->error);
	else
		status = put_file(sim, ts_str_text(&path), where, &text);
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

void ts_vtk_series_release(struct ts_vtk_series *series)
{
	ts_free(series->step);
	ts_free(series->time);
	*series = (struct ts_vtk_series){ 0 };
}
