#include "io/csv_read.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

#include "base/banned.h"

enum ts_status ts_csv_open(struct ts_csv *csv, struct ts_files *files, struct ts_error *err, const char *path)
{
	FILE *file = ts_files_open(files, path, "r");
	char bytes[4096];
	size_t n;
	bool bad;

	*csv = (struct ts_csv){ .err = err, .where = { .file = path } };
	if (!file)
		return ts_fail(err, TS_IO, NULL, "cannot read '%s': %s", path, ts_files_why(files));
	ts_str_add(&csv->text, "");
	errno = 0;
	while ((n = fread(bytes, 1, sizeof bytes, file)) > 0)
		ts_str_add_n(&csv->text, bytes, n);
	bad = ferror(file) != 0;
	if (bad)
		ts_fail(err, TS_IO, NULL, "reading '%s' failed: %s", path, strerror(errno));
	fclose(file);
	if (bad)
		return TS_IO;
	csv->line = csv->text.text;
	if (!csv->text.failed && strncmp(csv->line, "\xef\xbb\xbf", 3) == 0) /* byte order mark */
		csv->line += 3;
	return csv->text.failed ? ts_nomem(err) : TS_OK;
}

/* Takes a cell off the line, without its quotes. */
static char *next_cell(struct ts_csv *csv)
{
	char *begin = csv->at, *to = begin, *from = begin;
	bool quoted = *from == '"';

	from += quoted;
	begin = to = from;
	while (*from && (quoted || *from != ',')) {
		if (quoted && *from == '"' && *++from != '"') {
			quoted = false;
			continue;
		}
		*to++ = *from++;
	}
	csv->at = *from == ',' ? from + 1 : NULL;
	*to = '\0';
	return begin;
}

enum ts_status ts_csv_next(struct ts_csv *csv, bool *more)
{
	char *end;

	do {
		*more = *csv->line;
		if (!*more)
			return TS_OK;
		csv->where.line++;
		csv->at = csv->line;
		end = csv->line + strcspn(csv->line, "\n");
		csv->line = *end ? end + 1 : end;
		*end = '\0';
		if (end > csv->at && end[-1] == '\r')
			end[-1] = '\0';
	} while (!*csv->at);
	for (csv->cells = 0; csv->at; csv->cells++) {
		if (TS_GROW(csv->cell, csv->capacity, csv->cells + 1) != TS_OK)
			return ts_nomem(csv->err);
		csv->cell[csv->cells] = next_cell(csv);
	}
	return TS_OK;
}

void ts_csv_close(struct ts_csv *csv)
{
	ts_free(csv->cell);
	ts_str_release(&csv->text);
	*csv = (struct ts_csv){ 0 };
}
