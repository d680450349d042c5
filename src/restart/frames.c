#include "restart/frames.h"

#include <math.h>
#include <string.h>

#include "base/banned.h"

enum ts_status ts_frames_open(struct ts_frames *f, struct tsim *sim, const char *path,
			      const struct ts_place *where)
{
	*f = (struct ts_frames){ .sim = sim, .where = where ? *where : (struct ts_place){ 0 } };
	TS_TRY(ts_lines_open(&f->lines, &sim->files, &sim->error, sim->pool, where, path));
	f->lines.may_be_torn = true;
	return ts_lines_next_filled(&f->lines, &f->more);
}

static void free_names(struct ts_frames *f)
{
	for (size_t k = 0; k < f->ncolumns; k++)
		ts_free(f->column[k]);
	f->ncolumns = 0;
}

void ts_frames_close(struct ts_frames *f)
{
	free_names(f);
	ts_free(f->column);
	ts_free(f->value);
	ts_lines_close(&f->lines);
	*f = (struct ts_frames){ 0 };
}

int ts_frames_column(const struct ts_frames *f, const char *name)
{
	for (size_t k = 0; k < f->ncolumns; k++)
		if (ts_streq(f->column[k], name))
			return (int)k;
	return -1;
}

/* The frame is incomplete and will be skipped; no error message. */
static enum ts_status mark_incomplete(struct ts_frames *f)
{
	f->cut = true;
	f->more &= f->lines.ended;
	return TS_DAMAGED;
}

static bool at_item(const struct ts_frames *f)
{
	return f->lines.nwords && ts_streq(f->lines.word[0], "ITEM:");
}

/* Reads a line within a frame. A last line without a line feed may be cut off: 0.12 of 0.1234. */
static enum ts_status read_required_line(struct ts_frames *f)
{
	TS_TRY(ts_lines_next_filled(&f->lines, &f->more));
	return f->more && f->lines.ended && !at_item(f) ? TS_OK : mark_incomplete(f);
}

static enum ts_status read_bounds(struct ts_frames *f)
{
	struct ts_lines *l = &f->lines;

	if (l->nwords >= 4 && ts_streq(l->word[3], "xy"))
		return ts_lines_fail(l, TS_RANGE, 3, "tilted boxes are not read");
	for (int d = 0; d < 3; d++) {
		TS_TRY(read_required_line(f));
		TS_TRY(ts_lines_real(l, 0, "the lower bound", &f->lo[d]));
		TS_TRY(ts_lines_real(l, 1, "the upper bound", &f->hi[d]));
		if (f->hi[d] < f->lo[d])
			return ts_lines_fail(l, TS_RANGE, 1, "the upper bound lies below the lower bound");
	}
	return TS_OK;
}

static enum ts_status read_names(struct ts_frames *f)
{
	struct ts_lines *l = &f->lines;

	free_names(f);
	for (size_t k = 2; k < l->nwords; k++) {
		if (TS_GROW(f->column, f->column_capacity, f->ncolumns + 1) != TS_OK)
			return ts_nomem(l->err);
		f->column[f->ncolumns] = ts_strdup(l->word[k]);
		if (!f->column[f->ncolumns])
			return ts_nomem(l->err);
		f->ncolumns++;
	}
	return TS_OK;
}

/* A row of wrong length: if a new frame follows, the row was cut off and a later run has appended to the
 * file; otherwise it is an error. */
static enum ts_status refuse_row(struct ts_frames *f)
{
	struct ts_lines *l = &f->lines;
	struct ts_place place = ts_lines_place(l, SIZE_MAX);
	size_t n = l->nwords;

	TS_TRY(ts_lines_next_filled(l, &f->more));
	if (f->more && at_item(f))
		return mark_incomplete(f);
	return ts_fail(l->err, TS_DAMAGED, &place, "a row of %zu words, but there are %zu columns", n,
		       f->ncolumns);
}

static enum ts_status read_rows(struct ts_frames *f)
{
	struct ts_lines *l = &f->lines;

	for (size_t row = 0; row < f->n; row++) {
		f->rows = row;
		TS_TRY(read_required_line(f));
		if (l->nwords != f->ncolumns || (l->nwords && ts_streq(l->word[l->nwords - 1], "...")))
			return refuse_row(f);
		if (TS_GROW(f->value, f->value_capacity, (row + 1) * f->ncolumns) != TS_OK)
			return ts_nomem(l->err);
		for (size_t k = 0; k < f->ncolumns; k++)
			if (!ts_parse_real(l->word[k], &f->value[row * f->ncolumns + k]))
				f->value[row * f->ncolumns + k] = NAN;
	}
	return TS_OK;
}

/* Reads the integer in the line after an ITEM line. */
static enum ts_status read_count(struct ts_frames *f, const char *what, int64_t most, int64_t *out)
{
	TS_TRY(read_required_line(f));
	return ts_lines_int(&f->lines, 0, what, 0, most, out);
}

/* Reads an ITEM line and its contents; *last is true after the rows, the last item of a frame. */
static enum ts_status read_item(struct ts_frames *f, bool *last)
{
	struct ts_lines *l = &f->lines;
	int64_t n;

	if (!l->ended)
		return mark_incomplete(f);
	if (l->nwords < 2 || !at_item(f))
		return ts_lines_fail(l, TS_DAMAGED, 0,
				     "expected a line `ITEM: ...`: this is not a text dump of particles");
	if (f->begun && (ts_streq(l->word[1], "TIMESTEP") || ts_streq(l->word[1], "TIME") ||
			 ts_streq(l->word[1], "UNITS")))
		return mark_incomplete(f);
	if (ts_streq(l->word[1], "TIMESTEP")) {
		TS_TRY(read_count(f, "the step", INT64_MAX, &f->step));
		f->begun = true;
		return TS_OK;
	}
	if (ts_streq(l->word[1], "NUMBER")) {
		TS_TRY(read_count(f, "the number of particles", INT32_MAX, &n));
		f->n = (size_t)n;
		f->counted = true;
		return TS_OK;
	}
	if (ts_streq(l->word[1], "BOX"))
		return read_bounds(f);
	if (ts_streq(l->word[1], "ATOMS")) {
		*last = true;
		if (!f->begun || !f->counted)
			return ts_lines_fail(l, TS_DAMAGED, 1,
					     "a frame without its step and number of particles");
		TS_TRY(read_names(f));
		return read_rows(f);
	}
	return read_required_line(f); /* UNITS, TIME, LABEL */
}

static enum ts_status read_frame(struct ts_frames *f)
{
	bool last = false;

	f->begun = f->counted = f->cut = false;
	f->n = f->rows = 0;
	f->lines.unfolded = 0;
	while (!last) {
		TS_TRY(read_item(f, &last));
		TS_TRY(ts_lines_next_filled(&f->lines, &f->more));
		if (!last && !f->more)
			return mark_incomplete(f);
	}
	return TS_OK;
}

static void warn_incomplete(struct ts_frames *f)
{
	const char *why = f->lines.torn ? ", whose compressed data end there" : "";

	f->broken++;
	if (f->begun && f->counted)
		ts_warn(&f->sim->log, &f->where,
			"'%s', line %d%s: the frame of step %lld is incomplete, it has %zu of %zu rows; it "
			"is skipped",
			f->lines.file, f->lines.number, why, (long long)f->step, f->rows, f->n);
	else if (f->begun)
		ts_warn(&f->sim->log, &f->where,
			"'%s', line %d%s: the frame of step %lld is incomplete; it is skipped", f->lines.file,
			f->lines.number, why, (long long)f->step);
	else
		ts_warn(&f->sim->log, &f->where,
			"'%s', line %d%s: an incomplete frame without a step is skipped", f->lines.file,
			f->lines.number, why);
}

enum ts_status ts_frames_next(struct ts_frames *f, bool *got)
{
	*got = false;
	while (f->more && !*got) {
		enum ts_status status = read_frame(f);

		*got = status == TS_OK;
		f->whole += *got;
		if (!*got && !f->cut)
			return status;
		if (!*got)
			warn_incomplete(f);
	}
	if (*got || f->whole || !f->broken)
		return TS_OK;
	return ts_fail(&f->sim->error, TS_DAMAGED, &f->where,
		       "'%s' has no complete frame: it ends before the last row of its first one",
		       f->lines.file);
}
