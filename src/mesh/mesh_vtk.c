/* Legacy VTK files, https://docs.vtk.org/en/latest/design_documents/VTKFileFormats.html: DATASET POLYDATA
 * or UNSTRUCTURED_GRID, as text or binary (big-endian), with cells as before version 5
 * (a count before the corners of each) or after (arrays OFFSETS and CONNECTIVITY). Data on cells and
 * points, which come last, are not read. */
#include "mesh/mesh_vtk.h"

#include <inttypes.h>
#include <math.h>
#include <string.h>

#include "mesh/mesh_scan.h"

#include "base/banned.h"

struct vtk {
	struct ts_scan *s;
	struct ts_vtk_cells *c;
	bool binary, grid;
	int version; /* major version */
};

/* ---- numbers ---- */

enum form { SIGNED, UNSIGNED, FLOATING };
static const struct type {
	const char *name;
	size_t size;
	enum form form;
} types[] = {
	{ "float", 4, FLOATING },
	{ "double", 8, FLOATING },
	{ "int", 4, SIGNED },
	{ "vtktypeint64", 8, SIGNED },
	{ "vtkIdType", 4, SIGNED },
	{ "long", 8, SIGNED },
	{ "vtktypeint32", 4, SIGNED },
	{ "unsigned_int", 4, UNSIGNED },
	{ "unsigned_char", 1, UNSIGNED },
	{ "char", 1, SIGNED },
	{ "short", 2, SIGNED },
	{ "unsigned_short", 2, UNSIGNED },
	{ "unsigned_long", 8, UNSIGNED },
};

static enum ts_status read_type(struct vtk *v, const struct type **out)
{
	ts_scan_word(v->s);
	for (size_t k = 0; k < sizeof types / sizeof *types; k++) {
		*out = &types[k];
		if (ts_scan_is(v->s, types[k].name))
			return TS_OK;
	}
	return ts_scan_fail(v->s, TS_UNKNOWN, "%s is no type of numbers; known: float, double, int, ...",
			    ts_scan_found(v->s).text);
}

/* Starts a block of n numbers: binary ones begin at the next line. Fails if the rest of the file is too
 * short; a number as text takes at least two bytes. */
static enum ts_status begin_numbers(struct vtk *v, uint64_t n, const struct type *type)
{
	struct ts_scan *s = v->s;
	uint64_t size = v->binary ? type->size : 2;

	if (v->binary) {
		if (ts_scan_word_in_line(s))
			return ts_scan_fail(s, TS_SYNTAX, "%s is one word too many", ts_scan_found(s).text);
		s->at += s->at < s->n && s->bytes[s->at] == '\r';
		s->at += s->at < s->n && s->bytes[s->at] == '\n';
	}
	if (n <= (s->n - s->at + 1) / size)
		return TS_OK;
	return ts_scan_fail(s, TS_DAMAGED,
			    "there should follow %" PRIu64
			    " numbers, but the rest of the file is too short (%zu bytes)",
			    n, s->n - s->at);
}

static uint64_t read_bits(struct ts_scan *s, size_t size)
{
	uint64_t bits = 0;

	for (size_t k = 0; k < size && s->at < s->n; k++)
		bits = bits << 8 | (unsigned char)s->bytes[s->at++];
	return bits;
}

static int64_t as_int(uint64_t bits, const struct type *type)
{
	uint64_t sign = type->form == SIGNED ? (uint64_t)1 << (8 * type->size - 1) : 0;

	return (int64_t)((bits ^ sign) - sign);
}

static double as_real(uint64_t bits, const struct type *type)
{
	uint32_t low = (uint32_t)bits;
	double real;
	float f;

	if (type->form != FLOATING)
		return (double)as_int(bits, type);
	if (type->size == 4) {
		memcpy(&f, &low, sizeof f);
		return (double)f;
	}
	memcpy(&real, &bits, sizeof real);
	return real;
}

static enum ts_status next_real(struct vtk *v, const struct type *type, const char *what, double *out)
{
	TS_TRY(ts_scan_check_stop(v->s));
	if (!v->binary)
		return ts_scan_real(v->s, what, out);
	*out = as_real(read_bits(v->s, type->size), type);
	if (isfinite(*out))
		return TS_OK;
	return ts_scan_fail(v->s, TS_DAMAGED, "%s is no finite number", what);
}

static enum ts_status next_int(struct vtk *v, const struct type *type, const char *what, int64_t lo,
			       int64_t hi, int64_t *out)
{
	TS_TRY(ts_scan_check_stop(v->s));
	if (!v->binary)
		return ts_scan_int(v->s, what, lo, hi, out);
	*out = as_int(read_bits(v->s, type->size), type);
	if (*out >= lo && *out <= hi)
		return TS_OK;
	return ts_scan_fail(v->s, TS_RANGE,
			    "%s is %" PRId64 ", expected an integer from %" PRId64 " to %" PRId64, what, *out,
			    lo, hi);
}

/* ---- sections ---- */

static enum ts_status read_points(struct vtk *v)
{
	static const char *const what[] = { "x of the point", "y of the point", "z of the point" };
	const struct type *type;
	int64_t n;

	TS_TRY(ts_scan_int(v->s, "the number of points", 0, INT32_MAX, &n));
	TS_TRY(read_type(v, &type));
	TS_TRY(begin_numbers(v, (uint64_t)n * 3, type));
	if (TS_GROW(v->c->point, v->c->point_capacity, (size_t)n) != TS_OK)
		return ts_nomem(v->s->err);
	for (size_t k = 0; k < (size_t)n; k++)
		for (int d = 0; d < 3; d++)
			TS_TRY(next_real(v, type, what[d], &v->c->point[k][d]));
	v->c->npoints = (size_t)n;
	return TS_OK;
}

static enum ts_status add_cell(struct vtk *v, int type, int64_t end)
{
	struct ts_vtk_cells *c = v->c;
	size_t n = c->ncells;

	if (TS_GROW(c->offset, c->offset_capacity, n + 2) != TS_OK ||
	    TS_GROW(c->type, c->type_capacity, n + 1) != TS_OK ||
	    TS_GROW(c->line, c->line_capacity, n + 1) != TS_OK)
		return ts_nomem(v->s->err);
	c->offset[n + 1] = end;
	c->type[n] = type;
	c->line[n] = v->binary ? 0 : v->s->line;
	c->ncells++;
	return TS_OK;
}

static int64_t corners_so_far(const struct ts_vtk_cells *c)
{
	return c->ncells ? c->offset[c->ncells] : 0;
}

static enum ts_status read_corners(struct vtk *v, const struct type *type, int64_t from, int64_t n)
{
	struct ts_vtk_cells *c = v->c;

	if (TS_GROW(c->corner, c->corner_capacity, (size_t)(from + n)) != TS_OK)
		return ts_nomem(v->s->err);
	for (int64_t k = 0; k < n; k++)
		TS_TRY(next_int(v, type, "the number of a point", 0, (int64_t)c->npoints - 1,
				&c->corner[from + k]));
	return TS_OK;
}

/* Format before version 5: n cells in `size` numbers, the number of corners before the corners of each
 * cell. */
static enum ts_status read_counted(struct vtk *v, int64_t n, int64_t size, int shape)
{
	const struct type *type = &types[2];

	TS_TRY(begin_numbers(v, (uint64_t)size, type));
	for (int64_t k = 0; k < n; k++) {
		int64_t corners, from = corners_so_far(v->c);

		TS_TRY(next_int(v, type, "the number of corners", 0, size - (n - k), &corners));
		TS_TRY(read_corners(v, type, from, corners));
		TS_TRY(add_cell(v, shape, from + corners));
		size -= corners + 1;
	}
	return TS_OK;
}

/* Format of version 5: the offsets of n - 1 cells in the list of corners, then this list of `size`
 * corners. */
static enum ts_status read_offsets(struct vtk *v, int64_t n, int64_t size, int shape)
{
	const struct type *type;
	int64_t from = corners_so_far(v->c), last = 0;

	ts_scan_word(v->s);
	TS_TRY(read_type(v, &type));
	TS_TRY(begin_numbers(v, (uint64_t)n, type));
	for (int64_t k = 0; k < n; k++) {
		TS_TRY(next_int(v, type, "the offset", last, k ? size : 0, &last));
		if (k)
			TS_TRY(add_cell(v, shape, from + last));
	}
	if (last != size)
		return ts_scan_fail(v->s, TS_DAMAGED,
				    "the offsets end at %" PRId64 ", but there are %" PRId64 " corners", last,
				    size);
	TS_TRY(ts_scan_expect(v->s, "CONNECTIVITY"));
	TS_TRY(read_type(v, &type));
	TS_TRY(begin_numbers(v, (uint64_t)size, type));
	return read_corners(v, type, from, size);
}

static enum ts_status read_cells(struct vtk *v, int shape)
{
	struct ts_scan *s = v->s;
	int64_t n, size;

	TS_TRY(ts_scan_int(s, "the number of cells", 0, INT32_MAX, &n));
	TS_TRY(ts_scan_int(s, "the number of numbers", 0, INT32_MAX, &size));
	if (v->version >= 5)
		return n ? read_offsets(v, n, size, shape) : TS_OK;
	if (size < n)
		return ts_scan_fail(s, TS_DAMAGED, "%" PRId64 " cells need more than %" PRId64 " numbers", n,
				    size);
	return read_counted(v, n, size, shape);
}

static enum ts_status read_shapes(struct vtk *v)
{
	int64_t n, shape;

	TS_TRY(ts_scan_int(v->s, "the number of cells", 0, INT32_MAX, &n));
	if ((uint64_t)n != v->c->ncells)
		return ts_scan_fail(v->s, TS_DAMAGED, "there are %zu cells, but %" PRId64 " types of cells",
				    v->c->ncells, n);
	TS_TRY(begin_numbers(v, (uint64_t)n, &types[2]));
	for (int64_t k = 0; k < n; k++) {
		TS_TRY(next_int(v, &types[2], "the type of a cell", 0, 255, &shape));
		v->c->type[k] = (int)shape;
	}
	return TS_OK;
}

/* Skips arrays of the data set: FIELD name n, then n times: name components tuples type numbers. */
static enum ts_status skip_field(struct vtk *v)
{
	int64_t n, components, tuples, whole;
	double real;

	ts_scan_word(v->s);
	TS_TRY(ts_scan_int(v->s, "the number of arrays", 0, INT32_MAX, &n));
	for (int64_t k = 0; k < n; k++) {
		const struct type *type;

		ts_scan_word(v->s);
		TS_TRY(ts_scan_int(v->s, "the number of components", 0, INT16_MAX, &components));
		TS_TRY(ts_scan_int(v->s, "the number of tuples", 0, INT32_MAX, &tuples));
		TS_TRY(read_type(v, &type));
		TS_TRY(begin_numbers(v, (uint64_t)(components * tuples), type));
		for (int64_t m = 0; m < components * tuples; m++)
			TS_TRY(type->form == FLOATING
				       ? next_real(v, type, "the number", &real)
				       : next_int(v, type, "the number", INT64_MIN, INT64_MAX, &whole));
	}
	return TS_OK;
}

/* Skips meta data, which ends with an empty line. */
static enum ts_status skip_metadata(struct vtk *v)
{
	struct ts_scan *s = v->s;
	int last;

	do
		last = s->line;
	while (ts_scan_word(s) && s->line <= last + 1);
	if (s->length)
		s->at -= s->length;
	return TS_OK;
}

/* VTK cell types. */
enum { VERTICES = 2, POLYLINE = 4, TRIANGLE = 5, STRIP = 6, POLYGON = 7, PIXEL = 8, QUAD = 9 };

static const struct section {
	const char *name;
	enum ts_status (*read)(struct vtk *v);
	int shape; /* VTK cell type; 0: given by CELL_TYPES */
} sections[] = {
	{ "POINTS", read_points, 0 },	    { "CELLS", NULL, 0 },
	{ "CELL_TYPES", read_shapes, 0 },   { "POLYGONS", NULL, POLYGON },
	{ "TRIANGLE_STRIPS", NULL, STRIP }, { "VERTICES", NULL, VERTICES },
	{ "LINES", NULL, POLYLINE },	    { "FIELD", skip_field, 0 },
	{ "METADATA", skip_metadata, 0 },
};

static enum ts_status read_section(struct vtk *v)
{
	for (size_t k = 0; k < sizeof sections / sizeof *sections; k++)
		if (ts_scan_is(v->s, sections[k].name))
			return sections[k].read ? sections[k].read(v) : read_cells(v, sections[k].shape);
	return ts_scan_fail(v->s, TS_UNKNOWN,
			    "%s is no part of a file of cells; known: POINTS, CELLS, CELL_TYPES, POLYGONS, "
			    "TRIANGLE_STRIPS, CELL_DATA, POINT_DATA",
			    ts_scan_found(v->s).text);
}

/* Four lines: "# vtk DataFile Version 3.0", a title, ASCII or BINARY, and DATASET with its type. */
static enum ts_status read_head(struct vtk *v)
{
	struct ts_scan *s = v->s;
	double version;

	for (int k = 0; k < 4; k++) /* # vtk DataFile Version */
		ts_scan_word(s);
	TS_TRY(ts_scan_real(s, "the version of the format", &version));
	v->version = version < 5 ? 4 : 5;
	for (int k = 0; k < 2; k++) {
		ts_scan_rest(s);
		s->at += s->at < s->n && s->bytes[s->at] == '\r';
		s->at += s->at < s->n;
		s->line++;
		s->line_start = s->at;
	}
	ts_scan_word(s);
	v->binary = ts_scan_is(s, "BINARY");
	s->binary = v->binary;
	if (!v->binary && !ts_scan_is(s, "ASCII"))
		return ts_scan_fail(s, TS_SYNTAX, "expected ASCII or BINARY, but here is %s",
				    ts_scan_found(s).text);
	TS_TRY(ts_scan_expect(s, "DATASET"));
	ts_scan_word(s);
	v->grid = ts_scan_is(s, "UNSTRUCTURED_GRID");
	if (v->grid || ts_scan_is(s, "POLYDATA"))
		return TS_OK;
	return ts_scan_fail(s, TS_SYNTAX, "expected POLYDATA or UNSTRUCTURED_GRID, but here is %s",
			    ts_scan_found(s).text);
}

enum ts_status ts_vtk_read(struct ts_scan *s, struct ts_vtk_cells *cells)
{
	struct vtk v = { .s = s, .c = cells };

	cells->file = s->file;
	TS_TRY(read_head(&v));
	while (ts_scan_word(s) && !ts_scan_is(s, "CELL_DATA") && !ts_scan_is(s, "POINT_DATA"))
		TS_TRY(read_section(&v));
	for (size_t k = 0; k < cells->ncells; k++)
		if (!cells->type[k])
			return ts_scan_refuse(s, TS_DAMAGED,
					      "'%s' has cells, but no CELL_TYPES that say what they are",
					      s->file);
	return TS_OK;
}

void ts_vtk_cells_release(struct ts_vtk_cells *c)
{
	ts_free(c->point);
	ts_free(c->offset);
	ts_free(c->corner);
	ts_free(c->type);
	ts_free(c->line);
	*c = (struct ts_vtk_cells){ 0 };
}

/* ---- triangles ---- */

static enum ts_status add_triangle(struct ts_scan *s, const struct ts_vtk_cells *c, int line,
				   struct ts_triangles *soup, const int64_t corner[3])
{
	struct ts_triangle t = { .solid = "", .line = line };

	for (int k = 0; k < 3; k++)
		memcpy(t.v[k], c->point[corner[k]], sizeof t.v[k]);
	return ts_triangles_add(soup, &t) == TS_OK ? TS_OK : ts_nomem(s->err);
}

/* Splits a surface cell into triangles. In a strip the orientation alternates from triangle to triangle;
 * all other cells are split into triangles that share their first corner. */
static enum ts_status split_cell(struct ts_scan *s, const struct ts_vtk_cells *c, size_t k,
				 struct ts_triangles *soup)
{
	const int64_t *at = c->corner + c->offset[k];
	int64_t n = c->offset[k + 1] - c->offset[k];
	int64_t pixel[4];
	bool strip = c->type[k] == STRIP;

	if (n < 3 || (c->type[k] == TRIANGLE && n != 3) ||
	    ((c->type[k] == PIXEL || c->type[k] == QUAD) && n != 4))
		return ts_scan_refuse(s, TS_DAMAGED,
				      "'%s': cell %zu has %" PRId64
				      " corners, which does not fit its type %d",
				      s->file, k + 1, n, c->type[k]);
	if (c->type[k] == PIXEL) {
		memcpy(pixel, (int64_t[]){ at[0], at[1], at[3], at[2] }, sizeof pixel);
		at = pixel;
	}
	for (int64_t m = 0; m + 2 < n; m++) {
		int64_t turn = strip && m % 2;

		TS_TRY(add_triangle(s, c, c->line[k], soup,
				    (int64_t[]){ at[strip ? m : 0], at[m + 1 + turn], at[m + 2 - turn] }));
	}
	return TS_OK;
}

static enum ts_status split_cells(struct ts_scan *s, const struct ts_vtk_cells *c, struct ts_triangles *soup)
{
	for (size_t k = 0; k < c->ncells; k++) {
		if (c->type[k] < TRIANGLE) /* points and lines */
			continue;
		if (c->type[k] > QUAD)
			return ts_scan_refuse(s, TS_RANGE,
					      "'%s': cell %zu is of type %d, which is no plane surface "
					      "(triangles are type 5, quadrilaterals 9)",
					      s->file, k + 1, c->type[k]);
		TS_TRY(split_cell(s, c, k, soup));
	}
	return TS_OK;
}

enum ts_status ts_vtk_triangles(struct ts_scan *s, struct ts_triangles *soup)
{
	struct ts_vtk_cells cells = { 0 };
	enum ts_status status = ts_vtk_read(s, &cells);

	if (status == TS_OK)
		status = split_cells(s, &cells, soup);
	ts_vtk_cells_release(&cells);
	return status;
}
