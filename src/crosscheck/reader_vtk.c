/* Reads frames from legacy VTK files in ASCII: points and their arrays, arrays of cells, coordinates of a
 * grid. The step is the number in the file name. */
#include <ctype.h>
#include <stdio.h>
#include <string.h>

#include "crosscheck/reader.h"

#include "base/banned.h"

/* Reads the next word of the file; NULL at the end. */
static enum ts_status next_word(struct ts_reader *r, const char **word)
{
	bool more = true;

	while (r->at >= r->lines.nwords && more) {
		TS_TRY(ts_lines_next_filled(&r->lines, &more));
		r->at = 0;
	}
	*word = more ? r->lines.word[r->at++] : NULL;
	return TS_OK;
}

static enum ts_status next_count(struct ts_reader *r, const char *what, size_t *out)
{
	const char *word;
	int64_t n;

	TS_TRY(next_word(r, &word));
	if (!word || !ts_parse_int(word, &n) || n < 0 || n > INT32_MAX)
		return ts_reader_damaged(r, what);
	*out = (size_t)n;
	return TS_OK;
}

static enum ts_status add_column(struct ts_reader *r, const char *name, size_t component, size_t of)
{
	char text[80];

	if (of > 1)
		snprintf(text, sizeof text, "%.60s[%zu]", name, component + 1);
	else
		snprintf(text, sizeof text, "%.60s", name);
	return ts_reader_add_name(r, &r->frame, text);
}

/* Reads `of` new columns and adds them to the rows. */
static enum ts_status read_columns(struct ts_reader *r, const char *name, size_t rows, size_t of)
{
	struct ts_frame *f = &r->frame;
	size_t before = f->columns, wide = before + of;
	const char *word;

	if (before && rows != f->rows)
		return ts_reader_damaged(r, "the number of values of an array differs from the number of "
					    "points");
	for (size_t k = 0; k < of; k++)
		TS_TRY(add_column(r, name, k, of));
	if (TS_GROW(f->cell, f->cell_capacity, rows * wide + 1) != TS_OK)
		return ts_nomem(r->err);
	for (size_t row = rows; row-- > 0;)
		memmove(f->cell + row * wide, f->cell + row * before, before * sizeof *f->cell);
	for (size_t row = 0; row < rows; row++)
		for (size_t k = 0; k < of; k++) {
			TS_TRY(next_word(r, &word));
			if (!word || !ts_printed_is_number(word))
				return ts_reader_damaged(r, "an array ends too early");
			f->cell[row * wide + before + k] = ts_printed(word);
		}
	f->rows = rows;
	return TS_OK;
}

/* FIELD name n, and n times: name components tuples type values */
static enum ts_status read_field(struct ts_reader *r)
{
	const char *word;
	size_t n, components, rows;
	char name[64];

	TS_TRY(next_word(r, &word));
	TS_TRY(next_count(r, "a number of arrays is missing", &n));
	for (size_t k = 0; k < n; k++) {
		TS_TRY(next_word(r, &word));
		if (!word)
			return ts_reader_damaged(r, "an array is missing");
		snprintf(name, sizeof name, "%.60s", word);
		TS_TRY(next_count(r, "a number of components is missing", &components));
		TS_TRY(next_count(r, "a number of values is missing", &rows));
		TS_TRY(next_word(r, &word));
		TS_TRY(read_columns(r, name, rows, components));
	}
	return TS_OK;
}

/* SCALARS name type [components] LOOKUP_TABLE table values; VECTORS name type values */
static enum ts_status read_attribute(struct ts_reader *r, bool vector)
{
	const char *word;
	int64_t n = vector ? 3 : 1;
	char name[64];

	TS_TRY(next_word(r, &word));
	snprintf(name, sizeof name, "%.60s", word ? word : "");
	TS_TRY(next_word(r, &word));
	if (!vector && r->at < r->lines.nwords && !ts_parse_int(r->lines.word[r->at++], &n))
		return ts_reader_damaged(r, "invalid number of components");
	for (int k = 0; k < 2 && !vector; k++)
		TS_TRY(next_word(r, &word));
	return read_columns(r, name, r->data_rows, (size_t)n);
}

/* Reads the data of a keyword; numbers of other keywords (cells and their corners) are skipped. *done: the
 * word begins another table, and will be read again. */
static enum ts_status read_keyword(struct ts_reader *r, const char *word, bool *done)
{
	static const char *const tables[] = { "POINTS", "X_COORDINATES", "Y_COORDINATES", "Z_COORDINATES",
					      "CELL_DATA" };
	size_t k = 0, n = sizeof tables / sizeof *tables, rows;

	if (ts_streq(word, "FIELD"))
		return read_field(r);
	if (ts_streq(word, "SCALARS") || ts_streq(word, "VECTORS"))
		return read_attribute(r, word[0] == 'V');
	if (ts_streq(word, "POINT_DATA"))
		return next_count(r, "the number of points is missing", &r->data_rows);
	while (k < n && !ts_streq(tables[k], word))
		k++;
	if (k == n)
		return TS_OK;
	*done = r->frame.columns > 0;
	if (*done) {
		r->at--;
		return TS_OK;
	}
	TS_TRY(next_count(r, "a number of values is missing", &rows));
	r->data_rows = rows;
	if (k == n - 1)
		return TS_OK;
	TS_TRY(next_word(r, &word)); /* the type */
	if (k == 0)
		return read_columns(r, "x", rows, 3);
	return read_columns(r, tables[k], rows, 1);
}

/* The last number in the file name. */
static int64_t number_in_name(const char *name)
{
	const char *end = name + strlen(name);
	char text[24] = "";
	int64_t step = 0;
	size_t n;

	while (end > name && !isdigit((unsigned char)end[-1]))
		end--;
	for (n = 0; end - n > name && isdigit((unsigned char)end[-1 - (ptrdiff_t)n]); n++)
		;
	snprintf(text, sizeof text, "%.*s", (int)n, end - n);
	return ts_parse_int(text, &step) ? step : 0;
}

enum ts_status ts_reader_next_vtk(struct ts_reader *r, bool *got)
{
	struct ts_frame *f = &r->frame;
	const char *word;
	bool done = false, first = r->line == 0;

	f->columns = f->rows = 0;
	f->step = number_in_name(r->file[-1]);
	if (r->line++ == 0) { /* the title */
		bool more;

		TS_TRY(ts_lines_next_filled(&r->lines, &more));
		r->at = r->lines.nwords;
	}
	while (!done) {
		TS_TRY(next_word(r, &word));
		if (!word)
			break;
		if (!ts_printed_is_number(word))
			TS_TRY(read_keyword(r, word, &done));
	}
	*got = f->columns > 0 || first; /* a file without tables is an empty frame */
	return TS_OK;
}
