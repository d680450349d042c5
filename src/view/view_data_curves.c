/* Curves from columns: of all parts, or one a part; one for each set of values of the columns that tell curves apart. */
#include <math.h>
#include <string.h>

#include "base/sort.h"
#include "view/internal.h"

#include "base/banned.h"

enum { MOST_CURVES = 64 };

/* What a curve consists of: parts [from, to) of a file, rows of a group. */
struct strand {
	const struct ts_view_file *file;
	const struct ts_view_column *y;
	size_t from, to;
	size_t model; /* row of the first part that has the values of the group; SIZE_MAX: no groups */
};

struct point {
	double x, y, error, x_error;
};

static bool is_in_group(const struct strand *s, const struct ts_sheet *t, size_t row)
{
	for (size_t k = 0; k < s->file->nby && s->model != SIZE_MAX; k++) {
		const struct ts_sheet_column *c = &t->column[s->file->by[k]];

		if (c->cell ? !ts_streq(c->cell[row], c->cell[s->model])
			    : c->value[row] != c->value[s->model])
			return false;
	}
	return true;
}

static void set_point(struct ts_view_curve *c, size_t n, struct point p)
{
	c->x[n] = p.x;
	c->y[n] = p.y;
	c->error[n] = p.error;
	c->x_error[n] = p.x_error;
}

static enum ts_status add_point(struct ts_view_curve *c, struct point p)
{
	const size_t n = c->series.n;

	TS_TRY(TS_GROW(c->x, c->capacity[0], n + 1));
	TS_TRY(TS_GROW(c->y, c->capacity[1], n + 1));
	TS_TRY(TS_GROW(c->error, c->capacity[2], n + 1));
	TS_TRY(TS_GROW(c->x_error, c->capacity[3], n + 1));
	set_point(c, n, p);
	c->series.n++;
	return TS_OK;
}

/* A cell of a study without a value: the run has no such result. */
static bool is_absent(const struct ts_sheet_column *c, size_t row)
{
	return c->cell && !*c->cell[row];
}

/* Of a column that there may be. */
static double value_at(const struct ts_sheet *t, size_t column, size_t row, double otherwise)
{
	return column == SIZE_MAX ? otherwise : t->column[column].value[row];
}

static enum ts_status add_points(struct ts_view_curve *c, const struct strand *s)
{
	const size_t x = s->file->x;

	for (size_t p = s->from; p < s->to; p++) {
		const struct ts_sheet *t = s->file->part[p];

		for (size_t row = 0; row < t->rows; row++)
			if (is_in_group(s, t, row) && !is_absent(&t->column[s->y->column], row))
				TS_TRY(add_point(c,
						 (struct point){ value_at(t, x, row, (double)c->series.n),
								 t->column[s->y->column].value[row],
								 value_at(t, s->y->error, row, NAN),
								 value_at(t, s->file->x_error, row, NAN) }));
	}
	return TS_OK;
}

/* ---- order of x, in studies */

static int compare_x(const void *a, const void *b)
{
	const struct point *p = a, *q = b;

	return (p->x > q->x) - (p->x < q->x);
}

static enum ts_status sort_points(struct ts_view_curve *c)
{
	const size_t n = c->series.n;
	struct point *p = ts_alloc(n, sizeof *p);

	if (!p)
		return TS_NOMEM;
	for (size_t k = 0; k < n; k++)
		p[k] = (struct point){ c->x[k], c->y[k], c->error[k], c->x_error[k] };
	ts_sort(p, n, sizeof *p, compare_x);
	for (size_t k = 0; k < n; k++)
		set_point(c, k, p[k]);
	ts_free(p);
	return TS_OK;
}

/* ---- names */

/* "step 500, mu 0.3, file.txt": what tells the curve from others of the column. A label says from which file it is. */
static enum ts_status name_curve(struct ts_view_data *v, struct ts_view_curve *c, const struct strand *s)
{
	const struct ts_view_file *f = s->file;
	const struct ts_sheet *t = f->part[s->from];
	struct ts_str text = { 0 };

	for (size_t k = 0; k < f->nby && s->model != SIZE_MAX; k++) {
		const struct ts_sheet_column *b = &t->column[f->by[k]];

		ts_str_addf(&text, "%s%s ", text.length ? ", " : "", b->name);
		if (b->cell)
			ts_str_add(&text, b->cell[s->model]);
		else
			ts_str_addf(&text, "%.6g", b->value[s->model]);
	}
	if (!f->joined && f->sheets.n > 1)
		ts_str_addf(&text, "%s%s", text.length ? ", " : "", t->title);
	if (v->in->n > 1 && !s->y->label)
		ts_str_addf(&text, "%s%s", text.length ? ", " : "", f->source->path);
	c->name = text.failed ? NULL : ts_arena_strdup(&v->arena, ts_str_text(&text));
	ts_str_release(&text);
	return c->name ? TS_OK : TS_NOMEM;
}

static enum ts_status add_curve(struct ts_view_data *v, const struct strand *s)
{
	const struct ts_sheet *t = s->file->part[0];
	struct ts_view_curve *c;
	enum ts_status status;

	if (v->curves == MOST_CURVES)
		return ts_fail(&v->sim->error, TS_RANGE, NULL,
			       "more than %d curves: choose columns, -part or -by", MOST_CURVES);
	if (TS_GROW(v->curve, v->capacity, v->curves + 1) != TS_OK)
		return ts_nomem(&v->sim->error);
	c = &v->curve[v->curves++];
	c->column = s->y->label ? s->y->label : t->column[s->y->column].name;
	status = add_points(c, s);
	if (status == TS_OK && s->file->results && s->file->x != SIZE_MAX)
		status = sort_points(c);
	if (status == TS_OK)
		status = name_curve(v, c, s);
	c->series.x = c->x;
	c->series.y = c->y;
	c->series.error = s->y->error == SIZE_MAX ? NULL : c->error;
	c->series.x_error = s->file->x_error == SIZE_MAX ? NULL : c->x_error;
	c->series.right = s->y->right;
	c->series.style = s->file->style;
	return status == TS_OK ? TS_OK : ts_nomem(&v->sim->error);
}

/* A curve for each set of values, in the order in which they appear. */
static enum ts_status add_groups(struct ts_view_data *v, struct strand s)
{
	const struct ts_sheet *t = s.file->part[s.from];

	if (!s.file->nby)
		return add_curve(v, &s);
	for (size_t row = 0; row < t->rows; row++) {
		bool is_new = true;

		for (s.model = 0; s.model < row && is_new; s.model++)
			is_new = !is_in_group(&s, t, row);
		s.model = row;
		if (is_new)
			TS_TRY(add_curve(v, &s));
	}
	return TS_OK;
}

enum ts_status ts_view_data_curves(struct ts_view_data *v, const struct ts_view_file *f,
				   const struct ts_view_column *column)
{
	struct strand s = { .file = f, .y = column, .to = f->parts, .model = SIZE_MAX };

	if (f->joined)
		return add_groups(v, s);
	for (size_t k = 0; k < f->parts; k++) {
		s.from = k;
		s.to = k + 1;
		TS_TRY(add_groups(v, s));
	}
	return TS_OK;
}

void ts_view_data_forget(struct ts_view_data *v)
{
	for (size_t k = 0; k < v->curves; k++) {
		ts_free(v->curve[k].x);
		ts_free(v->curve[k].y);
		ts_free(v->curve[k].error);
		ts_free(v->curve[k].x_error);
		v->curve[k] = (struct ts_view_curve){ 0 };
	}
	v->curves = 0;
}

void ts_view_data_release(struct ts_view_data *v)
{
	ts_view_data_forget(v);
	for (size_t k = 0; v->file && k < v->in->n; k++)
		ts_sheets_release(&v->file[k].sheets);
	ts_free(v->curve);
	ts_arena_release(&v->arena);
}
