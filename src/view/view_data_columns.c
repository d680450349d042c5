/* Which parts and columns of a file are drawn. */
#include <math.h>
#include <string.h>

#include "sheet/sheet_read.h"
#include "view/internal.h"

#include "base/banned.h"

/* ---- names */

static size_t find_beside(const struct ts_sheet *t, size_t column, const char *ending)
{
	const char *name = t->column[column].name;
	const size_t n = strlen(name);

	for (size_t k = 0; k < t->columns; k++)
		if (strncmp(t->column[k].name, name, n) == 0 && ts_streq(t->column[k].name + n, ending))
			return k;
	return SIZE_MAX;
}

/* Whether the column is the error or the number of runs of another one. */
static bool is_attached(const struct ts_sheet *t, size_t column)
{
	const char *name = t->column[column].name;

	for (size_t k = 0; k < t->columns; k++) {
		const size_t n = strlen(t->column[k].name);

		if (k != column && strncmp(name, t->column[k].name, n) == 0 &&
		    (ts_streq(name + n, "_error") || ts_streq(name + n, "_runs")))
			return true;
	}
	return false;
}

static bool is_by(const struct ts_view_file *f, size_t column)
{
	for (size_t k = 0; k < f->nby; k++)
		if (f->by[k] == column)
			return true;
	return false;
}

bool ts_view_is_drawn(const struct ts_view_file *f, size_t column)
{
	const struct ts_sheet *t = f->part[0];

	if (column == f->x || is_by(f, column) || is_attached(t, column) || t->column[column].text)
		return false;
	return !f->results || (column >= f->first_result && column < f->first_result + f->results);
}

enum ts_status ts_view_find(const struct ts_view_data *v, struct ts_view_file *f, const char *name,
			    size_t *column)
{
	const struct ts_sheet *t = f->part[0];
	struct ts_suggest suggest = ts_suggest_start(name);
	const struct ts_sheet_column *c;
	struct ts_place where;

	*column = ts_sheet_find(t, name);
	for (size_t k = 0; k < t->columns && *column == SIZE_MAX; k++)
		ts_suggest_try(&suggest, t->column[k].name);
	if (*column == SIZE_MAX && ts_view_is_formula(name))
		return ts_view_add_formula(v, f, name, column);
	if (*column == SIZE_MAX)
		return ts_fail(&v->sim->error, TS_UNKNOWN, NULL, "%s has no column '%s'%s", f->source->path,
			       name, ts_suggest_text(&suggest));
	c = &t->column[*column];
	where = (struct ts_place){ .file = f->sheets.path, .text = "", .line = c->text_line };
	if (c->text && !is_by(f, *column))
		return ts_fail(&v->sim->error, TS_SYNTAX, &where,
			       "column '%s' has '%.60s', expected a number", c->name, c->text);
	return TS_OK;
}

/* ---- studies */

/* Variables are the columns from *first on. */
static bool find_roles(struct ts_view_file *f, size_t *first, size_t *variables)
{
	const struct ts_sheet *t = f->part[0];
	const size_t status = ts_sheet_find(t, "status"), error = ts_sheet_find(t, "error");

	if (f->sheets.kind != TS_SHEET_CSV)
		return false;
	if (t->columns > 6 && ts_streq(t->column[0].name, "run") && ts_streq(t->column[1].name, "script") &&
	    status != SIZE_MAX && error != SIZE_MAX && error > status && status >= 3) { /* runs.csv */
		*first = 3;
		*variables = status - 3;
		f->first_result = error + 1;
		f->results = t->columns - error - 1;
		return true;
	}
	for (size_t k = 0; k < t->columns; k++)
		if (find_beside(t, k, "_error") != SIZE_MAX && find_beside(t, k, "_runs") != SIZE_MAX) {
			*first = 0; /* summary.csv */
			*variables = k;
			f->first_result = k;
			f->results = t->columns - k;
			return true;
		}
	return false;
}

static bool varies(const struct ts_sheet_column *c, size_t rows)
{
	for (size_t k = 1; k < rows; k++)
		if (!ts_streq(c->cell[k], c->cell[0]))
			return true;
	return false;
}

/* Whether rows with the same value of one column have the same of the other, which follows it. */
static bool follows(const struct ts_sheet_column *c, const struct ts_sheet_column *leader, size_t rows)
{
	for (size_t k = 1; k < rows; k++)
		for (size_t j = 0; j < k; j++)
			if (ts_streq(leader->cell[j], leader->cell[k])) {
				if (!ts_streq(c->cell[j], c->cell[k]))
					return false;
				break;
			}
	return true;
}

/* x is the first variable with numbers that varies; curves are told apart by the others. */
static enum ts_status set_roles(struct ts_view_data *v, struct ts_view_file *f)
{
	const struct ts_sheet *t = f->part[0];
	size_t first, n;

	if (!find_roles(f, &first, &n))
		return TS_OK;
	for (size_t k = first; k < first + n && f->x == SIZE_MAX; k++)
		if (!t->column[k].text && varies(&t->column[k], t->rows))
			f->x = k;
	if (f->x == SIZE_MAX || v->in->by)
		return TS_OK;
	f->by = ts_arena_alloc(&v->arena, n, sizeof *f->by);
	if (!f->by)
		return ts_nomem(&v->sim->error);
	for (size_t k = first; k < first + n; k++)
		if (k != f->x && varies(&t->column[k], t->rows) &&
		    !follows(&t->column[k], &t->column[f->x], t->rows))
			f->by[f->nby++] = k;
	return TS_OK;
}

/* -by A,B */
static enum ts_status set_by(struct ts_view_data *v, struct ts_view_file *f)
{
	const char *text = v->in->by;

	if (!text || f->nby)
		return TS_OK;
	f->by = ts_arena_alloc(&v->arena, strlen(text) + 1, sizeof *f->by);
	if (!f->by)
		return ts_nomem(&v->sim->error);
	while (*text) {
		const size_t n = strcspn(text, ",");
		char *name = ts_arena_alloc(&v->arena, n + 1, 1);

		if (!name)
			return ts_nomem(&v->sim->error);
		memcpy(name, text, n);
		f->by[f->nby++] = ts_sheet_find(f->part[0], name); /* may have words */
		if (f->by[f->nby - 1] == SIZE_MAX) {
			f->nby--;
			TS_TRY(ts_view_find(v, f, name, &f->by[f->nby]));
		}
		text += n + (text[n] == ',');
	}
	return TS_OK;
}

/* ---- parts */

/* The last part with rows, or the one of -part. */
static enum ts_status find_model(const struct ts_view_data *v, struct ts_view_file *f,
				 const struct ts_sheet **model)
{
	const struct ts_sheets *s = &f->sheets;
	const char *part = v->in->part;
	int64_t number = 0;

	*model = NULL;
	if (part && !ts_streq(part, "all") && !ts_streq(part, "last")) {
		if (!ts_parse_int(part, &number) || number < 1 || (size_t)number > s->n)
			return ts_fail(&v->sim->error, TS_RANGE, NULL,
				       "-part is '%s', expected all, last, or a number from 1 to %zu for %s",
				       part, s->n, f->source->path);
		*model = &s->sheet[number - 1];
	}
	for (size_t k = s->n; k-- > 0 && !*model;)
		if (s->sheet[k].rows)
			*model = &s->sheet[k];
	return TS_OK;
}

/* Runs of a log are joined, of blocks the last one is drawn, unless -part says which. */
static enum ts_status choose_parts(struct ts_view_data *v, struct ts_view_file *f)
{
	const struct ts_sheets *s = &f->sheets;
	const struct ts_sheet *model;
	const char *part = v->in->part;
	const bool all = part ? ts_streq(part, "all") : s->kind != TS_SHEET_BLOCKS;

	TS_TRY(find_model(v, f, &model));
	f->part = ts_arena_alloc(&v->arena, s->n, sizeof *f->part);
	if (!f->part)
		return ts_nomem(&v->sim->error);
	f->joined = !part;
	for (size_t k = 0; k < s->n; k++) {
		if (&s->sheet[k] == model || (all && s->sheet[k].rows && ts_sheet_alike(&s->sheet[k], model)))
			f->part[f->parts++] = &s->sheet[k];
		else if (all && s->sheet[k].rows)
			f->left_out++;
	}
	return TS_OK;
}

/* ---- columns */

static void guess_x(struct ts_view_file *f)
{
	static const char *const names[] = { "Step",  "TimeStep", "Timestep", "step",
					     "Coord", "Coord1",	  "TimeDelta" };
	const struct ts_sheet *t = f->part[0];

	for (size_t k = 0; k < sizeof names / sizeof *names && f->x == SIZE_MAX; k++)
		for (size_t c = 0; c < t->columns && f->x == SIZE_MAX; c++)
			if (ts_streq(t->column[c].name, names[k]))
				f->x = c;
	for (size_t c = 0; c < t->columns && f->x == SIZE_MAX && t->columns > 1; c++)
		if (!t->column[c].text)
			f->x = c;
}

/* A copy of a part of a text. */
static const char *part_of(struct ts_view_data *v, const char *from, size_t n)
{
	char *copy = ts_arena_alloc(&v->arena, n + 1, 1);

	if (copy)
		memcpy(copy, from, n);
	return copy;
}

/* NAME[+-ERROR]; *n bytes of the word are the name. */
static enum ts_status parse_error(struct ts_view_data *v, struct ts_view_file *f, const char *word, size_t *n,
				  size_t *column)
{
	const char *error = strstr(word, "+-"), *name;

	*column = SIZE_MAX;
	if (!error || error >= word + *n)
		return TS_OK;
	name = part_of(v, error + 2, (size_t)(word + *n - error) - 2);
	*n = (size_t)(error - word);
	return name ? ts_view_find(v, f, name, column) : ts_nomem(&v->sim->error);
}

/* -x NAME[+-ERROR] */
static enum ts_status parse_x(struct ts_view_data *v, struct ts_view_file *f, const char *word)
{
	size_t n = strlen(word);
	const char *name;

	if (ts_sheet_find(f->part[0], word) == SIZE_MAX)
		TS_TRY(parse_error(v, f, word, &n, &f->x_error));
	name = part_of(v, word, n);
	return name ? ts_view_find(v, f, name, &f->x) : ts_nomem(&v->sim->error);
}

/* The `=` before a label; those of == != <= >= belong to a formula. NULL: there is none. */
static const char *find_label(const char *word)
{
	for (const char *at = word; (at = strchr(at, '='));) {
		if (at[1] == '=')
			at += 2;
		else if (at > word && strchr("!<>", at[-1]))
			at++;
		else
			return at;
	}
	return NULL;
}

/* NAME[+-ERROR][=LABEL], each a name or a formula; a column that has the whole word as its name goes first. */
static enum ts_status parse_column(struct ts_view_data *v, struct ts_view_file *f, const char *word,
				   struct ts_view_column *out)
{
	const char *equal = find_label(word), *name = word;
	size_t n = strlen(word);

	*out = (struct ts_view_column){ .error = SIZE_MAX };
	if (ts_sheet_find(f->part[0], word) == SIZE_MAX) {
		if (equal) {
			out->label = equal + 1;
			n = (size_t)(equal - word);
		}
		TS_TRY(parse_error(v, f, word, &n, &out->error));
		name = part_of(v, word, n);
		if (!name)
			return ts_nomem(&v->sim->error);
	}
	TS_TRY(ts_view_find(v, f, name, &out->column));
	if (out->error == SIZE_MAX)
		out->error = find_beside(f->part[0], out->column, "_error");
	return TS_OK;
}

static enum ts_status set_y(struct ts_view_data *v, struct ts_view_file *f, const struct ts_words *named,
			    const struct ts_words *right)
{
	const struct ts_sheet *t = f->part[0];

	f->y = ts_arena_alloc(&v->arena, named->n + right->n + t->columns, sizeof *f->y);
	if (!f->y)
		return ts_nomem(&v->sim->error);
	for (size_t k = 0; k < named->n; k++)
		TS_TRY(parse_column(v, f, named->word[k].text, &f->y[f->ny++]));
	for (size_t k = 0; k < right->n; k++) {
		TS_TRY(parse_column(v, f, right->word[k].text, &f->y[f->ny]));
		f->y[f->ny++].right = true;
	}
	for (size_t k = 0; k < t->columns && !named->n && !right->n; k++)
		if (ts_view_is_drawn(f, k))
			f->y[f->ny++] =
				(struct ts_view_column){ .column = k, .error = find_beside(t, k, "_error") };
	return f->ny ? TS_OK
		     : ts_fail(&v->sim->error, TS_SYNTAX, NULL, "%s has no column to be drawn besides '%s'",
			       f->source->path, f->x == SIZE_MAX ? "" : t->column[f->x].name);
}

static enum ts_status read_file(struct ts_view_data *v, struct ts_view_file *f, const struct ts_words *named,
				const struct ts_words *right)
{
	struct tsim *sim = v->sim;

	f->x = f->x_error = SIZE_MAX;
	TS_TRY(ts_sheets_read(&f->sheets, &sim->files, &sim->error, sim->pool, f->source->path));
	if (f->sheets.torn)
		ts_warn(&sim->log,
			&(struct ts_place){ .file = f->sheets.path, .text = "", .line = f->sheets.torn },
			"the last row is not complete; it is left out");
	TS_TRY(choose_parts(v, f));
	if (f->left_out)
		ts_warn(&sim->log, NULL,
			"%s: %zu of %zu runs left out, which have other columns; -part N shows one",
			f->source->path, f->left_out, f->sheets.n);
	if (f->source->x)
		TS_TRY(parse_x(v, f, f->source->x));
	TS_TRY(set_roles(v, f));
	TS_TRY(set_by(v, f));
	guess_x(f);
	return set_y(v, f, named, right);
}

enum ts_status ts_view_data_read(struct ts_view_data *v)
{
	struct ts_words named = { 0 }, right = { 0 };

	v->file = ts_arena_alloc(&v->arena, v->in->n, sizeof *v->file);
	if (!v->file)
		return ts_nomem(&v->sim->error);
	for (size_t k = 0; k < v->in->n; k++) {
		v->file[k].source = &v->in->source[k];
		if (v->in->source[k].columns.n || v->in->source[k].right.n) {
			named = v->in->source[k].columns;
			right = v->in->source[k].right;
		}
		TS_TRY(read_file(v, &v->file[k], &named, &right));
	}
	return TS_OK;
}
