#include "sheet/sheet_read.h"

#include <string.h>

#include "sheet/internal.h"

#include "base/banned.h"

enum { FIRST_LINES = 2 };

/* The first lines with words. */
struct beginning {
	size_t words[FIRST_LINES], commas[FIRST_LINES];
	bool row[FIRST_LINES], log;
	int lines;
};

static size_t count_commas(const struct ts_lines *l)
{
	size_t n = 0;

	for (size_t k = 0; k < l->nwords; k++)
		for (const char *c = strchr(l->word[k], ','); c; c = strchr(c + 1, ','))
			n++;
	return n;
}

/* Keeps the first word of the second line that is no number, for the message. */
static void keep_word(struct ts_sheet_reader *r)
{
	const struct ts_lines *l = &r->lines;
	double number;

	for (size_t k = 0; k < l->nwords && !r->word; k++)
		if (!ts_sheet_number(l->word[k], &number)) {
			r->word = ts_pool_get(r->pool, l->word[k]);
			r->column = k + 1;
		}
}

static enum ts_status no_table(const struct ts_sheet_reader *r)
{
	struct ts_str about = { 0 };
	enum ts_status status;

	if (r->word)
		ts_str_addf(&about, "the second line has the word '%s' in column %zu; ", r->word, r->column);
	status = ts_fail(r->err, TS_SYNTAX, NULL,
			 "'%s' has no table: %sexpected a log, rows of numbers with names in a comment "
			 "above, or comma-separated values with names in the first line",
			 r->sheets->path, ts_str_text(&about));
	ts_str_release(&about);
	return status;
}

static enum ts_status look(struct ts_sheet_reader *r, struct beginning *b)
{
	struct ts_lines *l = &r->lines;
	bool more = true;

	while (b->lines < FIRST_LINES) {
		TS_TRY(ts_lines_next_filled(l, &more));
		if (!more)
			return TS_OK;
		if (ts_streq(l->word[0], "ITEM:"))
			return ts_lines_fail(l, TS_SYNTAX, 0,
					     "this is a dump, not a table: -plot shows logs, averages and "
					     "CSV files");
		if (!b->lines)
			b->log = ts_streq(l->word[0], "tsim") || ts_streq(l->word[0], "LAMMPS") ||
				 ts_streq(l->word[0], "LIGGGHTS") ||
				 (l->nwords > 1 && ts_streq(l->word[0], "Step")); /* of the command `log` */
		b->words[b->lines] = l->nwords;
		b->commas[b->lines] = count_commas(l);
		b->row[b->lines++] = ts_sheet_is_row(l);
		if (b->lines == 2 && l->nwords > 1 && l->nwords == b->words[0])
			keep_word(r);
	}
	return TS_OK;
}

static enum ts_sheet_kind kind_of(const struct beginning *b)
{
	if (b->log)
		return TS_SHEET_LOG;
	if (b->lines && b->commas[0] && (b->lines < 2 || b->commas[1]))
		return TS_SHEET_CSV;
	if (b->lines && (b->row[0] || (b->lines == 2 && b->row[1] && b->words[0] == b->words[1])))
		return TS_SHEET_ROWS;
	return TS_SHEET_LOG;
}

static enum ts_status open_lines(struct ts_sheet_reader *r)
{
	return ts_lines_open(&r->lines, r->files, r->err, r->pool, NULL, r->sheets->path);
}

static enum ts_status read_kind(struct ts_sheet_reader *r)
{
	struct beginning b = { 0 };
	enum ts_status status = open_lines(r);

	if (status == TS_OK)
		status = look(r, &b);
	ts_lines_close(&r->lines);
	TS_TRY(status);
	r->sheets->kind = kind_of(&b);
	if (r->sheets->kind == TS_SHEET_CSV)
		return ts_sheet_read_csv(r);
	status = open_lines(r);
	if (status == TS_OK)
		status = (r->sheets->kind == TS_SHEET_LOG ? ts_sheet_read_log : ts_sheet_read_rows)(r);
	ts_lines_close(&r->lines);
	return status;
}

enum ts_status ts_sheets_read(struct ts_sheets *t, struct ts_files *files, struct ts_error *err,
			      struct ts_pool *pool, const char *path)
{
	struct ts_sheet_reader r = { .sheets = t, .files = files, .err = err, .pool = pool };
	struct stat about;
	size_t rows = 0;

	t->path = ts_pool_get(pool, path);
	if (!t->path)
		return ts_nomem(err);
	if (ts_files_stat(files, path, &about) == 0 && !S_ISREG(about.st_mode)) /* is read twice */
		return ts_fail(err, TS_IO, NULL, "'%s' is not a regular file", path);
	TS_TRY(read_kind(&r));
	for (size_t k = 0; k < t->n; k++)
		rows += t->sheet[k].rows;
	return rows ? TS_OK : no_table(&r);
}
