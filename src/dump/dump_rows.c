/* Rows of dumps as text. Several threads write the text of blocks of rows, which is passed on block by block in their
 * order. Of particles in the order of their identities, which is the same on all ranks, and of local rows each rank writes the text of
 * some rows, and sends it to the first one; all other text the first rank writes alone. */
#include <stdio.h>
#include <string.h>

#include "base/parallel.h"
#include "core/ranks.h"
#include "dump/dump.h"
#include "io/csv.h"

#include "base/banned.h"

/* Rows of a block: for one thread few, for little memory; for several many, so that they seldom wait for each other.
 * WORK: of a row, in iterations of a simple loop, for the number of threads. */
enum { ALONE = 512, SHARED = 4096, WORK = 100 };
/* Rows of a rank of which the text is sent at once, at most, and at least. */
enum { MOST_SENT = 8192, LEAST_SENT = 64 };

/* The text of some blocks, one for each thread. */
struct rows {
	const struct ts_dump_common *dump;
	const struct tsim *sim;
	void (*add)(const struct rows *rows, struct ts_str *out, size_t row);
	bool trailing; /* a blank after the last column, too */
	struct ts_str *text;
	size_t blocks;	  /* of one turn */
	size_t first;	  /* row of the first block */
	size_t size, end; /* rows of a block; row behind the last one */
	/* gets the text block by block */
	enum ts_status (*put)(struct rows *rows, const struct ts_str *text);
	struct ts_textfile *out;
	struct ts_parcel *mine; /* text for the first rank */
};

void ts_dump_add_item(const struct ts_dump_common *d, struct ts_str *out, const struct ts_dump_column *c,
		      double value)
{
	const struct ts_words *element = &d->element;
	char number[32];

	if (!c->element) {
		ts_format_add(out, c->format, c->integer, value);
	} else if (value >= 1 && value <= (double)element->n) {
		ts_format_add_text(out, c->format, element->word[(size_t)value - 1].text);
	} else {
		snprintf(number, sizeof number, "%.0f", value);
		ts_format_add_text(out, c->format, number);
	}
}

static void add_row(const struct rows *rows, struct ts_str *out, size_t row)
{
	const struct ts_dump_common *d = rows->dump;

	for (size_t k = 0; k < d->ncolumns; k++) {
		const struct ts_dump_column *c = &d->column[k];

		ts_dump_add_item(d, out, c, ts_dump_value(rows->sim, c, (size_t)d->order[row]));
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
	ts_dump_add_item(rows->dump, out, c, value);
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
		for (; row < end && row < rows->end; row++)
			rows->add(rows, &text, row);
		rows->text[k] = text;
	}
}

static enum ts_status put_file(struct rows *rows, const struct ts_str *text)
{
	return ts_textfile_write(rows->out, ts_str_text(text), text->length);
}

static enum ts_status put_parcel(struct rows *rows, const struct ts_str *text)
{
	return ts_parcel_add(rows->mine, ts_str_text(text), text->length);
}

/* The text of rows from .. to-1. */
static enum ts_status put_range(struct rows *rows, struct tsim *sim, size_t from, size_t to)
{
	rows->end = to;
	for (rows->first = from; rows->first < to; rows->first += rows->blocks * rows->size) {
		ts_parallel((int)rows->blocks, rows->blocks, add_blocks, rows);
		for (size_t k = 0; k < rows->blocks; k++) {
			if (rows->text[k].failed)
				return ts_nomem(&sim->error);
			TS_TRY(rows->put(rows, &rows->text[k]));
		}
	}
	return TS_OK;
}

/* ---- rows of several ranks */

static size_t row_before(const struct rows *rows, size_t row)
{
	return row < rows->dump->nrows ? row : rows->dump->nrows;
}

/* The first rank writes the text that all have sent. */
static enum ts_status write_sent(struct rows *rows, const struct ts_parcel *in, int ranks)
{
	for (int r = 0; r < ranks; r++)
		TS_TRY(ts_textfile_write(rows->out, (const char *)in[r].data, in[r].n));
	return TS_OK;
}

/* Of each n rows one rank writes the text. After a failure all ranks go on to the end, but nothing is written. */
static enum ts_status write_by_turns(struct rows *rows, struct tsim *sim, size_t n, struct ts_parcel *out,
				     struct ts_parcel *in)
{
	struct ts_world *world = sim->world;
	enum ts_status status = TS_OK;

	rows->put = put_parcel;
	rows->size = rows->blocks > 1 ? (n + rows->blocks - 1) / rows->blocks : ALONE;
	for (size_t turn = 0; turn < rows->dump->nrows; turn += n * (size_t)world->n) {
		size_t from = row_before(rows, turn + n * (size_t)world->rank);

		rows->mine = &out[0];
		rows->mine->n = 0;
		if (status == TS_OK)
			status = put_range(rows, sim, from, row_before(rows, from + n));
		if (ts_world_deliver(world, out, in) != TS_OK)
			return ts_nomem(&sim->error);
		if (world->rank == 0 && status == TS_OK)
			status = write_sent(rows, in, world->n);
	}
	return status;
}

static enum ts_status write_divided(struct rows *rows, struct tsim *sim)
{
	size_t ranks = (size_t)sim->world->n, n = (rows->dump->nrows + ranks - 1) / ranks;
	struct ts_parcel *parcel = ts_alloc(2 * ranks, sizeof *parcel);
	enum ts_status status = parcel ? TS_OK : ts_nomem(&sim->error);

	if (status == TS_OK)
		status = write_by_turns(rows, sim, n < MOST_SENT ? n : MOST_SENT, parcel, parcel + ranks);
	for (size_t r = 0; parcel && r < 2 * ranks; r++)
		ts_parcel_release(&parcel[r]);
	ts_free(parcel);
	return status;
}

/* Local rows, and their order, are those of the first rank. */
static bool have_same_number(struct ts_world *world, size_t n)
{
	double most[2] = { (double)n, -(double)n };

	ts_world_most(world, most, 2);
	return most[0] == -most[1];
}

static void spread_local(const struct rows *rows, const struct tsim *sim)
{
	const struct ts_dump_common *d = rows->dump;

	ts_world_spread(sim->world, 0, d->order, d->nrows * sizeof *d->order);
	for (size_t k = 0; k < d->ncolumns; k++) {
		double *values = d->column[k].values.data;

		ts_world_spread(sim->world, 0, values, d->nrows * sizeof *values);
	}
}

static bool is_divided(const struct rows *rows, const struct tsim *sim)
{
	const struct ts_dump_common *d = rows->dump;

	if (!sim->world)
		return false;
	if (d->local && !have_same_number(sim->world, d->nrows))
		return false;
	/* particles have the same order on all ranks if they are sorted by identity */
	return (d->local || (!d->unsorted && !d->sort_by)) && d->nrows >= LEAST_SENT * (size_t)sim->world->n;
}

static enum ts_status put_rows(struct rows *rows, struct tsim *sim)
{
	const bool divided = is_divided(rows, sim);

	if (divided && rows->dump->local)
		spread_local(rows, sim);
	if (divided)
		return write_divided(rows, sim);
	rows->put = put_file;
	return ts_ranks_first(sim) ? put_range(rows, sim, 0, rows->dump->nrows) : TS_OK;
}

/* Writes the text that is there, and all rows. */
static enum ts_status write_rows(struct ts_dump_common *d, struct tsim *sim, struct rows *rows)
{
	enum ts_status status;

	if (d->text.failed)
		return ts_nomem(&sim->error);
	TS_TRY(ts_textfile_write(&d->out, ts_str_text(&d->text), d->text.length));
	ts_str_clear(&d->text);
	rows->out = &d->out;
	rows->blocks = (size_t)ts_team(sim, WORK * d->nrows);
	rows->size = rows->blocks > 1 ? SHARED : ALONE;
	rows->text = ts_alloc(rows->blocks, sizeof *rows->text);
	if (!rows->text)
		return ts_nomem(&sim->error);
	status = put_rows(rows, sim);
	for (size_t k = 0; k < rows->blocks; k++)
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
