#include "io/csv.h"

#include <math.h>
#include <string.h>
#include <zlib.h>

#include "io/decimal.h"

#include "base/banned.h"

enum { SHOWN = 200 };			  /* characters of a line in messages */
static const double LARGEST_WHOLE = 1e15; /* larger numbers are written with an exponent */

bool ts_csv_is(const char *path)
{
	return path && (ts_ends_with(path, ".csv") || ts_ends_with(path, ".csv.gz"));
}

static void begin_cell(struct ts_str *row)
{
	if (row->length && row->text[row->length - 1] != '\n')
		ts_str_add_n(row, ",", 1);
}

void ts_csv_add_cell(struct ts_str *out, const char *text)
{
	size_t n = strlen(text);

	if (!strpbrk(text, ",\"\r\n") && text[0] != ' ' && !(n && text[n - 1] == ' ')) {
		ts_str_add_n(out, text, n);
		return;
	}
	ts_str_add_n(out, "\"", 1);
	for (; *text; text++)
		ts_str_add(out, *text == '"'			 ? "\"\""
				: *text == '\n' || *text == '\r' ? " "
								 : (const char[]){ *text, 0 });
	ts_str_add_n(out, "\"", 1);
}

void ts_csv_text(struct ts_str *row, const char *text)
{
	begin_cell(row);
	if (*text)
		ts_csv_add_cell(row, text);
	else
		ts_str_add(row, "\"\"");
}

void ts_csv_int(struct ts_str *row, int64_t value)
{
	char text[TS_DECIMAL_SIZE];
	size_t n = ts_decimal_lld(value, text);

	begin_cell(row);
	ts_str_add_n(row, text, n);
}

/* The fewest digits, from 15 on, that give the same number again: 17 always do. */
static void add_digits(struct ts_str *row, double value)
{
	char text[TS_DECIMAL_SIZE];

	ts_str_add_n(row, text, ts_decimal_shortest(value, text));
}

void ts_csv_real(struct ts_str *row, double value)
{
	bool whole = value == trunc(value) && fabs(value) < LARGEST_WHOLE && !(value == 0 && signbit(value));

	if (whole) {
		ts_csv_int(row, (int64_t)value);
		return;
	}
	begin_cell(row);
	if (isnan(value))
		ts_str_add(row, "nan");
	else
		add_digits(row, value);
}

void ts_csv_names(struct ts_str *row, const char *const *name, size_t n)
{
	for (size_t k = 0; k < n; k++)
		ts_csv_text(row, name[k]);
}

void ts_csv_end(struct ts_str *row)
{
	ts_str_add_n(row, "\n", 1);
}

/* Whether the file begins with the names. */
static enum ts_status compare_names(const struct ts_textfile *file, struct tsim *sim,
				    const struct ts_str *names)
{
	size_t most = names->length > SHOWN ? names->length : SHOWN;
	char *old = ts_alloc(most + 1, 1);
	gzFile in = old ? ts_files_open_gz(&sim->files, file->path) : NULL;
	int got = in ? gzread(in, old, (unsigned)most) : 0;
	enum ts_status status = old ? TS_OK : ts_nomem(&sim->error);

	if (in)
		gzclose(in);
	if (status == TS_OK && (got < (int)names->length || memcmp(old, names->text, names->length) != 0))
		status = ts_fail(&sim->error, TS_STATE, &file->where,
				 "cannot append to '%s', which begins with '%.*s': the columns would be "
				 "'%.*s'",
				 file->path, (int)strcspn(old, "\n"), old, (int)names->length - 1,
				 names->text);
	ts_free(old);
	return status;
}

enum ts_status ts_csv_begin(struct ts_textfile *file, struct tsim *sim, struct ts_str *names)
{
	enum ts_status status = names->failed ? ts_nomem(&sim->error) : TS_OK;

	if (status == TS_OK && file->whole > 0)
		status = compare_names(file, sim, names);
	else if (status == TS_OK)
		status = ts_textfile_write(file, ts_str_text(names), names->length);
	ts_str_release(names);
	return status;
}

enum ts_status ts_csv_write(struct ts_textfile *file, struct tsim *sim, struct ts_str *rows)
{
	enum ts_status status = rows->failed ? ts_nomem(&sim->error) : TS_OK;

	if (status == TS_OK)
		status = ts_textfile_write(file, ts_str_text(rows), rows->length);
	if (status == TS_OK)
		status = ts_textfile_flush(file);
	ts_str_release(rows);
	return status;
}
