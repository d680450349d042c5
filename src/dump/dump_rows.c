/* Rows of dumps as text. Several threads write the text of blocks of rows, which is passed on block by block in their
 * order. */
#include <stdio.h>
#include <string.h>

#include "base/parallel.h"
#include "dump/dump.h"
#include "io/csv.h"

#include "base/banned.h"

/* Rows of a block: for one thread few, for little memory; for several many, so that they seldom wait for each other.
 * WORK: of a row, in iterations of a simple loop, for the number of threads. */
enum { ALONE = 512, SHARED = 4096, WORK = 100 };

/* The text of some blocks, one for each thread. */
struct rows {
	const struct ts_dump_common *dump;
	const struct tsim *sim;
	void (*add)(const struct rows *rows, struct ts_str *out, size_t row);
	bool trailing; /* a blank after the last column, too */
	struct ts_str *text;
	size_t first; /* row of the first block */
	size_t size;  /* rows of a block */
};

static void add_item(const struct rows *rows, struct ts_str *out, const struct ts_dump_column *c,
		     double value)
{
	const struct ts_words *element = &rows->dump->element;

	if (!c->element)
		ts_format_add(out, c->format, c->integer, value);
	else if (value >= 1 && value <= (double)element->n)
		ts_str_add(out, element->word[(size_t)value - 1].text);
	else
		ts_str_addf(out, "%.0f", value);
}

static void add_row(const struct rows *rows, struct ts_str *out, size_t row)
{
	const struct ts_dump_common *d = rows->dump;

	for (size_t k = 0; k < d->ncolumns; k++) {
		const struct ts_dump_column *c = &d->column[k];

		add_item(rows, out, c, ts_dump_value(rows->sim, c, (size_t)d->order[row]));
		if (rows->trailing || k + 1 < d->ncolumns)
			ts_str_add_n(out, " ", 1);
	}
	ts_str_add_n(out, "\n", 1);
}

/* A cell with all digits, unless dump_modify has changed the usual format. */
static void add_cell(const struct rows *rows, struct ts_str *out, const struct ts_dump_column *c,
		     double value)
{
	bool usual = ts_streq(c->format, "%g") || ts_streq(c->format, "%lld");
	size_t n = out->length;

	if (usual && !c->element) {
		ts_csv_real(out, value);
		return;
	}
	ts_str_add_n(out, ",", 1); /* the step is before it */
	add_item(rows, out, c, value);
	if (c->element && !out->failed && strpbrk(out->text + n + 1, ",\" ")) {
		out->length = n;
		ts_csv_text(out, rows->dump->element.word[(size_t)value - 1].text);
	}
}

/* Every frame of a table begins its rows with its step. */
static void add_table_row(const struct rows *rows, struct ts_str *out, size_t row)
{
	const struct ts_dump_common *d = rows->dump;

	ts_csv_int(out, rows->sim->clock.step);
	if (d->time)
		ts_csv_real(out, ts_sim_time(rows->sim));
	for (size_t k = 0; k < d->ncolumns; k++)
		add_cell(rows, out, &d->column[k],
			 ts_dump_value(rows->sim, &d->column[k], (size_t)d->order[row]));
	ts_csv_end(out);
}

static void add_blocks(void *context, size_t from, size_t to)
{
	const struct rows *rows = context;

	for (size_t k = from; k < to; k++) {
		size_t row = rows->first + k * rows->size, end = row + rows->size;
		struct ts_str text = rows->text[k]; /* not beside that of another thread in memory */

		ts_str_clear(&text);
		for (; row < end && row < rows->dump->nrows; row++)
			rows->add(rows, &text, row);
		rows->text[k] = text;
	}
}

static enum ts_status write_blocks(struct ts_dump_common *d, struct tsim *sim, struct rows *rows,
				   size_t blocks)
{
	for (rows->first = 0; rows->first < d->nrows; rows->first += blocks * rows->size) {
		ts_parallel((int)blocks, blocks, add_blocks, rows);
		for (size_t k = 0; k < blocks; k++) {
			if (rows->text[k].failed)
				return ts_nomem(&sim->error);
			TS_TRY(ts_textfile_write(&d->out, ts_str_text(&rows->text[k]), rows->text[k].length));
		}
	}
	return TS_OK;
}

/* Writes the text that is there, and all rows. */
static enum ts_status write_rows(struct ts_dump_common *d, struct tsim *sim, struct rows *rows)
{
	size_t blocks = (size_t)ts_team(sim, WORK * d->nrows);
	enum ts_status status;

	if (d->text.failed)
		return ts_nomem(&sim->error);
	TS_TRY(ts_textfile_write(&d->out, ts_str_text(&d->text), d->text.length));
	ts_str_clear(&d->text);
	rows->size = blocks > 1 ? SHARED : ALONE;
	rows->text = ts_alloc(blocks, sizeof *rows->text);
	if (!rows->text)
		return ts_nomem(&sim->error);
	status = write_blocks(d, sim, rows, blocks);
	for (size_t k = 0; k < blocks; k++)
		ts_str_release(&rows->text[k]);
	ts_free(rows->text);
	return status;
}

enum ts_status ts_dump_write_rows(struct ts_dump_common *d, struct tsim *sim, bool trailing)
{
	struct rows rows = { .dump = d, .sim = sim, .add = add_row, .trailing = trailing };

	return write_rows(d, sim, &rows);
}

enum ts_status ts_dump_write_table(struct ts_dump_common *d, struct tsim *sim)
{
	struct rows rows = { .dump = d, .sim = sim, .add = add_table_row };

	return write_rows(d, sim, &rows);
}
