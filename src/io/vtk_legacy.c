/* Legacy VTK files (.vtk), the default of LIGGGHTS: text, or binary with the most significant byte first. */
#include "io/vtk_legacy.h"

#include <string.h>

#include "core/block_work.h"
#include "io/decimal.h"

#include "base/banned.h"

enum { IN_A_LINE = 9 };

/* Types of arrays: name in the file, digits of a number in text (0: integer), bytes in binary. */
struct type {
	const char *name;
	int digits;
	int bytes;
};
static const struct type reals = { "double", 11, 8 };
static const struct type singles = { "float", 6, 4 };
static const struct type wholes = { "int", 0, 4 };
static const struct type indices = { "vtktypeint64", 0, 8 };

/* Names may not contain blanks: they are replaced by `_`. */
static void add_name(struct ts_str *out, const char *name)
{
	for (; *name; name++)
		ts_str_add_n(out, strchr(" \t\r\n\"", *name) ? "_" : name, 1);
}

static void put_bytes(char *to, uint64_t bits, int n)
{
	for (int k = 0; k < n; k++)
		to[k] = (char)(bits >> 8 * (n - 1 - k));
}

static uint64_t bits_of(const struct type *type, double value)
{
	float single = (float)value;
	uint64_t bits;
	uint32_t half;

	if (!type->digits)
		return (uint64_t)(int64_t)value;
	memcpy(&bits, &value, sizeof bits);
	memcpy(&half, &single, sizeof half);
	return type->bytes == 8 ? bits : half;
}

/* A sequence of numbers of one type: a buffer of its text or bytes. */
struct numbers {
	const struct type *type;
	bool binary;
	size_t n;    /* numbers so far */
	size_t used; /* bytes of the buffer */
	char buffer[4096];
};
enum { LONGEST = TS_DECIMAL_SIZE + 2 /* bytes of a number */ };

static bool is_full(const struct numbers *s)
{
	return s->used > sizeof s->buffer - LONGEST;
}

static void add_number(struct numbers *s, double value)
{
	char *to = s->buffer + s->used;

	if (s->binary) {
		put_bytes(to, bits_of(s->type, value), s->type->bytes);
		s->used += (size_t)s->type->bytes;
		return;
	}
	s->used += s->type->digits ? ts_decimal_g(value, s->type->digits, to)
				   : ts_decimal_lld((long long)value, to);
	s->buffer[s->used++] = ' ';
	if (++s->n % IN_A_LINE == 0)
		s->buffer[s->used++] = '\n';
}

/* Numbers of an array from the beginning of a line on. */
static void convert_numbers(const void *context, const void *block, size_t n, struct ts_str *out)
{
	const struct numbers *of = context;
	struct numbers s = { .type = of->type, .binary = of->binary };
	const double *data = block;

	for (size_t k = 0; k < n / sizeof *data; k++) {
		add_number(&s, data[k]);
		if (!is_full(&s) && k + 1 < n / sizeof *data)
			continue;
		ts_str_add_n(out, s.buffer, s.used);
		s.used = 0;
	}
}

enum { LINES = 256, SENT = 64 /* lines of a block, blocks that a rank converts at once */ };

static enum ts_status add_array(struct tsim *sim, struct ts_str *out, const struct type *type,
				const double *data, size_t n, bool binary)
{
	const struct numbers numbers = { .type = type, .binary = binary };
	const struct ts_block_work work = { convert_numbers, &numbers, LINES * IN_A_LINE * sizeof *data,
					    SENT };
	uint64_t *length = ts_alloc(ts_block_work_blocks(&work, n * sizeof *data) + 1, sizeof *length);
	enum ts_status status = length ? ts_block_work(sim, &work, data, n * sizeof *data, out, length)
				       : ts_nomem(&sim->error);

	ts_str_add(out, "\n");
	ts_free(length);
	return status;
}

/* Adds the indices 0, step, 2 step ... */
static void add_indices(struct ts_str *out, const char *what, size_t n, size_t step, bool binary)
{
	struct numbers s = { .type = &indices, .binary = binary };

	ts_str_addf(out, "%s %s\n", what, indices.name);
	for (size_t k = 0; k < n; k++) {
		add_number(&s, (double)(k * step));
		if (!is_full(&s))
			continue;
		ts_str_add_n(out, s.buffer, s.used);
		s.used = 0;
	}
	ts_str_add_n(out, s.buffer, s.used);
	ts_str_add(out, "\n");
}

static void add_cells(struct ts_str *out, size_t n, size_t size, bool binary)
{
	static const char *const what[] = { "", "VERTICES", "LINES", "POLYGONS", "POLYGONS" };

	if (!n)
		return;
	ts_str_addf(out, "%s %zu %zu\n", what[size], n + 1, n * size);
	add_indices(out, "OFFSETS", n + 1, size, binary);
	add_indices(out, "CONNECTIVITY", n * size, 1, binary);
}

static enum ts_status add_data(struct tsim *sim, struct ts_str *out, const char *what,
			       const struct ts_vtk_array *array, size_t narrays, size_t n, bool binary)
{
	if (!narrays || !n)
		return TS_OK;
	ts_str_addf(out, "%s %zu\nFIELD FieldData %zu\n", what, n, narrays);
	for (size_t k = 0; k < narrays; k++) {
		const struct type *type = array[k].single ? &singles : array[k].integer ? &wholes : &reals;

		add_name(out, array[k].name);
		ts_str_addf(out, " %zu %zu %s\n", array[k].components, n, type->name);
		TS_TRY(add_array(sim, out, type, array[k].data, n * array[k].components, binary));
	}
	return TS_OK;
}

/* `title` NULL: the usual one. */
static void add_head(struct ts_str *out, const char *version, const char *title, double time, bool binary)
{
	ts_str_addf(out, "# vtk DataFile Version %s\n", version);
	if (title)
		ts_str_add(out, title);
	else
		ts_str_addf(out, "Generated by tsim, time %.17g", time);
	ts_str_addf(out, "\n%s\n", binary ? "BINARY" : "ASCII");
}

enum ts_status ts_vtk_legacy_poly(struct tsim *sim, struct ts_str *out, const struct ts_vtk_poly *poly)
{
	size_t size = ts_vtk_cell_size(poly), n = poly->npoints / size;
	const struct type *type = poly->single_points ? &singles : &reals;

	add_head(out, "5.1", poly->title, poly->time, poly->binary);
	ts_str_addf(out, "DATASET POLYDATA\nPOINTS %zu %s\n", poly->npoints, type->name);
	TS_TRY(add_array(sim, out, type, poly->points, 3 * poly->npoints, poly->binary));
	add_cells(out, n, size, poly->binary);
	TS_TRY(add_data(sim, out, "POINT_DATA", poly->point_data, poly->npoint_data, poly->npoints,
			poly->binary));
	return add_data(sim, out, "CELL_DATA", poly->cell_data, poly->ncell_data, n, poly->binary);
}

/* Adds n lines of `width` numbers. */
static void add_lines(struct ts_str *out, const struct type *type, const double *data, size_t n, size_t width)
{
	char number[TS_DECIMAL_SIZE];

	for (size_t k = 0; k < n * width; k++) {
		if (type == &singles)
			ts_str_addf(out, "%f", data[k]);
		else
			ts_str_add_n(out, number, ts_decimal_g(data[k], 11, number));
		ts_str_add_n(out, (k + 1) % width ? " " : "\n", 1);
	}
}

void ts_vtk_legacy_plain(struct ts_str *out, const struct ts_vtk_poly *poly)
{
	const struct type *type = poly->single_points ? &singles : &reals;
	size_t n = poly->npoints;

	add_head(out, "2.0", NULL, poly->time, false);
	ts_str_addf(out, "DATASET POLYDATA\nPOINTS %zu %s\n", n, type->name);
	add_lines(out, type, poly->points, n, 3);
	ts_str_addf(out, "VERTICES %zu %zu\n", n, 2 * n);
	for (size_t k = 0; k < n; k++)
		ts_str_addf(out, "1 %zu\n", k);
	ts_str_addf(out, "POINT_DATA %zu\n", n);
	for (size_t k = 0; k < poly->npoint_data; k++) {
		const struct ts_vtk_array *a = &poly->point_data[k];

		if (a->components == 3)
			ts_str_addf(out, "VECTORS %s %s\n", a->name, type->name);
		else if (a->components == 1)
			ts_str_addf(out, "SCALARS %s %s 1\nLOOKUP_TABLE default\n", a->name, type->name);
		else
			ts_str_addf(out, "FIELD FieldData 1\n%s %zu %zu %s\n", a->name, a->components, n,
				    type->name);
		add_lines(out, type, a->data, n, a->components);
	}
}

/* So few that they fit the buffer. */
static void add_few(struct ts_str *out, const double *data, size_t n, bool binary)
{
	struct numbers s = { .type = &reals, .binary = binary };

	for (size_t k = 0; k < n; k++)
		add_number(&s, data[k]);
	ts_str_add_n(out, s.buffer, s.used);
	ts_str_add(out, "\n");
}

void ts_vtk_legacy_box(struct ts_str *out, const double lo[3], const double hi[3], double time, bool binary)
{
	add_head(out, "5.1", NULL, time, binary);
	ts_str_add(out, "DATASET RECTILINEAR_GRID\nDIMENSIONS 2 2 2\n");
	for (int d = 0; d < 3; d++) {
		ts_str_addf(out, "%c_COORDINATES 2 %s\n", "XYZ"[d], reals.name);
		add_few(out, (const double[]){ lo[d], hi[d] }, 2, binary);
	}
}
