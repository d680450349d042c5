#include "io/frames.h"

#include <math.h>
#include <string.h>

#include "base/banned.h"

enum ts_status ts_frames_open(struct ts_frames *f, struct tsim *sim, const char *path,
			      const struct ts_place *where)
{
	*f = (struct ts_frames){ .sim = sim };
	TS_TRY(ts_lines_open(&f->lines, &sim->files, &sim->error, sim->pool, where, path));
	return ts_lines_next_filled(&f->lines, &f->more);
}

static void drop_names(struct ts_frames *f)
{
	for (size_t k = 0; k < f->ncolumns; k++)
		ts_free(f->column[k]);
	f->ncolumns = 0;
}

void ts_frames_close(struct ts_frames *f)
{
	drop_names(f);
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

static enum ts_status need_line(struct ts_frames *f, const char *what)
{
	TS_TRY(ts_lines_next_filled(&f->lines, &f->more));
	if (f->more)
		return TS_OK;
	return ts_lines_fail(&f->lines, TS_DAMAGED, SIZE_MAX, "the file ends before %s", what);
}

static enum ts_status read_bounds(struct ts_frames *f)
{
	struct ts_lines *l = &f->lines;

	if (l->nwords >= 4 && ts_streq(l->word[3], "xy"))
		return ts_lines_fail(l, TS_RANGE, 3, "tilted boxes are not read");
	for (int d = 0; d < 3; d++) {
		TS_TRY(need_line(f, "the bounds of the box"));
		TS_TRY(ts_lines_real(l, 0, "the lower bound", &f->lo[d]));
		TS_TRY(ts_lines_real(l, 1, "the upper bound", &f->hi[d]));
		if (f->hi[d] < f->lo[d])
			return ts_lines_fail(l, TS_RANGE, 1,
					     "the upper bound lies below the lower bound");
	}
	return TS_OK;
}

static enum ts_status read_names(struct ts_frames *f)
{
	struct ts_lines *l = &f->lines;

	drop_names(f);
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

static enum ts_status read_rows(struct ts_frames *f)
{
	struct ts_lines *l = &f->lines;

	for (size_t row = 0; row < f->n; row++) {
		TS_TRY(need_line(f, "the last row of the frame"));
		if (l->nwords != f->ncolumns)
			return ts_lines_fail(l, TS_DAMAGED, SIZE_MAX,
					     "a row of %zu words, but there are %zu columns",
					     l->nwords, f->ncolumns);
		if (TS_GROW(f->value, f->value_capacity, (row + 1) * f->ncolumns) != TS_OK)
			return ts_nomem(l->err);
		for (size_t k = 0; k < f->ncolumns; k++)
			if (!ts_parse_real(l->word[k], &f->value[row * f->ncolumns + k]))
				f->value[row * f->ncolumns + k] = NAN;
	}
	return TS_OK;
}

/* The line after an ITEM line, where it holds one integer. */
static enum ts_status read_count(struct ts_frames *f, const char *what, int64_t most, int64_t *out)
{
	TS_TRY(need_line(f, what));
	return ts_lines_int(&f->lines, 0, what, 0, most, out);
}

/* One ITEM and what follows it; *last is true after the rows. */
static enum ts_status read_item(struct ts_frames *f, bool *last)
{
	struct ts_lines *l = &f->lines;
	int64_t n;

	if (l->nwords < 2 || !ts_streq(l->word[0], "ITEM:"))
		return ts_lines_fail(l, TS_DAMAGED, 0,
				     "expected a line `ITEM: ...`: this is no dump of particles as text");
	if (ts_streq(l->word[1], "TIMESTEP"))
		return read_count(f, "the step", INT64_MAX, &f->step);
	if (ts_streq(l->word[1], "NUMBER")) {
		TS_TRY(read_count(f, "the number of particles", INT32_MAX, &n));
		f->n = (size_t)n;
		return TS_OK;
	}
	if (ts_streq(l->word[1], "BOX"))
		return read_bounds(f);
	if (ts_streq(l->word[1], "ATOMS")) {
		*last = true;
		TS_TRY(read_names(f));
		return read_rows(f);
	}
	return need_line(f, "what the item says"); /* UNITS, TIME, LABEL */
}

enum ts_status ts_frames_next(struct ts_frames *f, bool *got)
{
	bool last = false;

	*got = f->more;
	while (*got && !last) {
		TS_TRY(read_item(f, &last));
		TS_TRY(ts_lines_next_filled(&f->lines, &f->more));
		if (!last && !f->more)
			return ts_lines_fail(&f->lines, TS_DAMAGED, SIZE_MAX,
					     "the file ends in the middle of a frame");
	}
	return TS_OK;
}
