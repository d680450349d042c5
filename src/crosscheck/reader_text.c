/* Reads frames from the text files of LIGGGHTS, LAMMPS and tsim. */
#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#include "crosscheck/meaning.h"
#include "crosscheck/reader.h"

#include "base/banned.h"

static enum ts_status set_names(struct ts_reader *r, struct ts_frame *f, char *const *word, size_t n)
{
	f->columns = 0;
	for (size_t k = 0; k < n; k++)
		TS_TRY(ts_reader_add_name(r, f, word[k]));
	return TS_OK;
}

/* Reads the words of the comment as names of columns. */
static enum ts_status set_names_from_comment(struct ts_reader *r, struct ts_frame *f)
{
	const char *c = r->lines.comment;

	f->columns = 0;
	while (*c) {
		size_t n = strcspn(c, " \t,");
		struct ts_str word = { 0 };
		enum ts_status status;

		ts_str_add_n(&word, c, n);
		status = n && !word.failed ? ts_reader_add_name(r, f, ts_str_text(&word)) : TS_OK;
		status = word.failed ? ts_nomem(r->err) : status;
		ts_str_release(&word);
		TS_TRY(status);
		c += n + (c[n] != '\0');
	}
	return TS_OK;
}

/* Adds the words of the line, from index `from` on, as a row. */
static enum ts_status add_row(struct ts_reader *r, size_t from)
{
	struct ts_frame *f = &r->frame;
	size_t n = f->columns;

	if (TS_GROW(f->cell, f->cell_capacity, (f->rows + 1) * n) != TS_OK)
		return ts_nomem(r->err);
	for (size_t k = 0; k < n; k++)
		f->cell[f->rows * n + k] = ts_printed(r->lines.word[from + k]);
	f->rows++;
	return TS_OK;
}

static bool is_numeric(const struct ts_lines *l)
{
	for (size_t k = 0; k < l->nwords; k++)
		if (!ts_printed_is_number(l->word[k]))
			return false;
	return l->nwords > 0;
}

/* Whether the words may be the titles of a table. */
static bool is_heading(const struct ts_lines *l)
{
	if (l->nwords < 2)
		return false;
	for (size_t k = 0; k < l->nwords; k++) {
		const char *w = l->word[k];

		if (strcspn(w, "=:") < strlen(w) || (k == 0 && ts_printed_is_number(w)))
			return false;
	}
	return true;
}

/* Sets the step of a frame of one row: from a column with the step, otherwise `number`. */
static void set_step(struct ts_reader *r, int64_t number)
{
	static const char *const names[] = { "Step", "TimeStep", "Timestep" };

	r->frame.step = number;
	r->frame.line = true;
	for (size_t n = 0; n < sizeof names / sizeof *names; n++)
		for (size_t k = 0; k < r->frame.columns && r->frame.line; k++) {
			if (!ts_streq(r->frame.name[k], names[n]))
				continue;
			r->frame.step = (int64_t)r->frame.cell[k].value;
			r->frame.line = false;
		}
}

/* LAMMPS writes c_rotation where LIGGGHTS and tsim write the first eight letters of what follows c_. */
static enum ts_status add_thermo_title(struct ts_reader *r, const char *title)
{
	char name[32];
	bool prefix = title[0] && strchr("cfv", title[0]) && title[1] == '_';

	snprintf(name, sizeof name, prefix ? "%.8s" : "%.31s", prefix ? title + 2 : title);
	return ts_reader_add_name(r, &r->frame, name);
}

/* A table begins with a line of titles followed by a line of numbers, and ends with the loop time; other
 * lines within are skipped. */
static enum ts_status next_thermo(struct ts_reader *r, bool *got)
{
	struct ts_lines *l = &r->lines;
	bool more;

	for (;;) {
		TS_TRY(ts_lines_next_filled(l, &more));
		if (!more)
			return TS_OK;
		if (l->nwords > 2 && ts_streq(l->word[0], "Loop") && ts_streq(l->word[1], "time"))
			r->table = false;
		if (!r->table && r->title.columns == l->nwords && is_numeric(l)) {
			r->table = true;
			r->frame.columns = 0;
			for (size_t k = 0; k < r->title.columns; k++)
				TS_TRY(add_thermo_title(r, r->title.name[k]));
		}
		if (r->table && l->nwords == r->frame.columns && is_numeric(l))
			break;
		r->title.columns = 0;
		if (!r->table && is_heading(l))
			TS_TRY(set_names(r, &r->title, l->word, l->nwords));
	}
	r->title.columns = 0;
	r->frame.rows = 0;
	TS_TRY(add_row(r, 0));
	set_step(r, ++r->line);
	*got = true;
	return TS_OK;
}

static enum ts_status read_dump_rows(struct ts_reader *r, int64_t n)
{
	struct ts_lines *l = &r->lines;
	bool more;

	TS_TRY(set_names(r, &r->frame, l->word + 2, l->nwords - 2));
	r->frame.entries = ts_streq(l->word[1], "ENTRIES");
	r->frame.rows = 0;
	for (int64_t row = 0; row < n; row++) {
		TS_TRY(ts_lines_next_filled(l, &more));
		if (!more || l->nwords != r->frame.columns)
			return ts_reader_damaged(r,
						 "the number of words in the dump differs from its header");
		TS_TRY(add_row(r, 0));
	}
	return TS_OK;
}

/* Lines of other items are skipped; of TIMESTEP and NUMBER the first number is read. */
static enum ts_status next_dump(struct ts_reader *r, bool *got)
{
	struct ts_lines *l = &r->lines;
	int64_t n = 0;
	bool more = true;

	while (!*got) {
		bool step, count;

		TS_TRY(ts_lines_next_filled(l, &more));
		if (!more)
			return TS_OK;
		if (l->nwords < 2 || !ts_streq(l->word[0], "ITEM:"))
			continue;
		if (ts_streq(l->word[1], "ATOMS") || ts_streq(l->word[1], "ENTRIES")) {
			TS_TRY(read_dump_rows(r, n));
			*got = true;
		}
		step = ts_streq(l->word[1], "TIMESTEP");
		count = ts_streq(l->word[1], "NUMBER");
		if (!*got && (step || count)) {
			TS_TRY(ts_lines_next_filled(l, &more));
			TS_TRY(ts_lines_int(l, 0, "the count", 0, INT64_MAX, step ? &r->frame.step : &n));
		}
	}
	return TS_OK;
}

/* Names of the numbers of a line: the words of the comment above if their number is the same, otherwise the
 * word before each number: "vertex", "hello (2)". */
static enum ts_status set_text_names(struct ts_reader *r)
{
	struct ts_lines *l = &r->lines;
	struct ts_frame *f = &r->frame;
	const char *before = "line";
	char name[40];

	f->columns = 0;
	if (r->inner.columns == l->nwords && is_numeric(l)) {
		for (size_t k = 0; k < l->nwords; k++)
			TS_TRY(ts_reader_add_name(r, f, r->inner.name[k]));
		return TS_OK;
	}
	for (size_t k = 0; k < l->nwords; k++) {
		bool number = ts_printed_is_number(l->word[k]);

		if (!number)
			before = l->word[k];
		snprintf(name, sizeof name, "%s%.30s", number ? "" : "word ", before);
		TS_TRY(ts_reader_add_name(r, f, name));
	}
	return TS_OK;
}

/* Reads a block: a line with the step and the number of rows, and the rows. */
static enum ts_status read_block(struct ts_reader *r)
{
	struct ts_lines *l = &r->lines;
	int64_t n;
	bool more;

	TS_TRY(ts_lines_int(l, 0, "the step", INT64_MIN, INT64_MAX, &r->frame.step));
	TS_TRY(ts_lines_int(l, 1, "the number of rows", 0, INT32_MAX, &n));
	r->frame.columns = r->frame.rows = 0;
	for (size_t k = 0; k < r->inner.columns; k++)
		TS_TRY(ts_reader_add_name(r, &r->frame, r->inner.name[k]));
	for (int64_t row = 0; row < n; row++) {
		TS_TRY(ts_lines_next_filled(l, &more));
		if (!more || l->nwords != r->inner.columns)
			return ts_reader_damaged(r, "the number of words in a block differs from its header");
		TS_TRY(add_row(r, 0));
	}
	return TS_OK;
}

/* Whether the line is the first one of the file and contains no numbers: a title. */
static bool is_title(const struct ts_reader *r)
{
	for (size_t k = 0; k < r->lines.nwords; k++)
		if (ts_printed_is_number(r->lines.word[k]))
			return false;
	return r->line == 1;
}

/* The last two comments are stored: those of a block contain the names in its first line and in its rows. */
static enum ts_status next_text(struct ts_reader *r, bool *got)
{
	struct ts_lines *l = &r->lines;
	bool more;

	for (;;) {
		TS_TRY(ts_lines_next(l, &more));
		if (!more)
			return TS_OK;
		r->line++;
		if (l->nwords && is_title(r))
			TS_TRY(set_names(r, &r->inner, l->word, l->nwords));
		else if (l->nwords)
			break;
		else if (*l->comment) {
			struct ts_frame swap = r->title;

			r->title = r->inner;
			r->inner = swap;
			TS_TRY(set_names_from_comment(r, &r->inner));
		}
	}
	*got = true;
	if (l->nwords > 1 && r->title.columns > 1 && strncmp(r->title.name[1], "Number-of-", 10) == 0)
		return read_block(r);
	TS_TRY(set_text_names(r));
	r->frame.rows = 0;
	TS_TRY(add_row(r, 0));
	set_step(r, r->line);
	return TS_OK;
}

/* Opens the next file, if there is one. */
static enum ts_status open_file(struct ts_reader *r)
{
	struct ts_str path = { 0 };
	enum ts_status status;

	ts_lines_close(&r->lines);
	r->open = r->table = false;
	r->title.columns = r->inner.columns = 0;
	r->line = 0;
	if (!*r->file)
		return TS_OK;
	ts_str_addf(&path, "%s/%s", r->folder, *r->file++);
	status = path.failed ? ts_nomem(r->err)
			     : ts_lines_open(&r->lines, NULL, r->err, r->pool, NULL, path.text);
	ts_str_release(&path);
	r->open = status == TS_OK;
	r->lines.commas = true; /* fix print may write any text */
	return status;
}

enum ts_status ts_reader_open(struct ts_reader *r)
{
	return open_file(r);
}

enum ts_status ts_reader_next(struct ts_reader *r, bool *got)
{
	*got = false;
	while (r->open && !*got) {
		r->frame.entries = r->frame.line = false;
		if (r->kind == TS_FRAMES_THERMO)
			TS_TRY(next_thermo(r, got));
		else if (r->kind == TS_FRAMES_DUMP)
			TS_TRY(next_dump(r, got));
		else if (r->kind == TS_FRAMES_VTK)
			TS_TRY(ts_reader_next_vtk(r, got));
		else
			TS_TRY(next_text(r, got));
		if (*got)
			TS_TRY(ts_meanings_order_partners(r->meanings, &r->frame));
		if (!*got)
			TS_TRY(open_file(r));
	}
	return TS_OK;
}

static void release_frame(struct ts_frame *f)
{
	ts_free(f->name);
	ts_free(f->cell);
	ts_free(f->swap_rule);
	ts_free(f->partner);
	ts_free(f->swapped);
	*f = (struct ts_frame){ 0 };
}

void ts_reader_close(struct ts_reader *r)
{
	ts_lines_close(&r->lines);
	release_frame(&r->frame);
	release_frame(&r->title);
	release_frame(&r->inner);
	r->open = false;
}
