/* Selection and order of the particles or local rows that a dump writes. */
#ifndef _GNU_SOURCE
#define _GNU_SOURCE /* qsort_r */
#endif
#include "dump/dump.h"

#include <stdio.h>
#include <stdlib.h>

#include "particle/columns.h"
#include "particle/particles.h"
#include "region/region.h"

#include "base/banned.h"

enum { LESS, LESS_EQUAL, GREATER, GREATER_EQUAL, EQUAL, UNEQUAL, EITHER };
static const char *const operators[] = { "<", "<=", ">", ">=", "==", "!=", "|^", NULL };

static bool holds(int operator, double a, double b)
{
	switch (operator) {
	case LESS:
		return a < b;
	case LESS_EQUAL:
		return a <= b;
	case GREATER:
		return a > b;
	case GREATER_EQUAL:
		return a >= b;
	case EQUAL:
		return a == b;
	case UNEQUAL:
		return a != b;
	default:
		return (a == 0) != (b == 0);
	}
}

void ts_dump_release_thresholds(struct ts_dump_common *d)
{
	d->restored = 0;
	for (size_t k = 0; k < d->nthresholds; k++)
		ts_table_release(&d->threshold[k].value.values);
	d->nthresholds = 0;
}

/* Column of the particles for LAST: the value at the last frame, and 1 if there is one. */
enum { VALUE, KNOWN, WIDTH };

static enum ts_status last_column(struct ts_instance *self, struct tsim *sim, size_t k, size_t *column)
{
	struct ts_str name = { 0 };
	enum ts_status status;

	ts_str_addf(&name, "dump %s last %zu", self->id, k);
	status = name.failed ? ts_nomem(&sim->error)
			     : ts_particles_add_column(sim, ts_str_text(&name), WIDTH, TS_COL_RESULT, column);
	ts_str_release(&name);
	return status;
}

static size_t count_last(const struct ts_dump_common *d)
{
	size_t n = 0;

	for (size_t k = 0; k < d->nthresholds; k++)
		n += d->threshold[k].last;
	return n;
}

static double *last_of(const struct tsim *sim, const struct ts_dump_threshold *t, size_t i)
{
	return (double *)sim->particles->column[t->column].data + WIDTH * i;
}

static enum ts_status keep_last(struct ts_instance *self, struct tsim *sim, struct ts_dump_threshold *t)
{
	const struct ts_dump_common *d = self->state;
	size_t k = count_last(d);

	TS_TRY(last_column(self, sim, k, &t->column));
	for (size_t i = 0; k >= d->restored && i < sim->particles->n; i++)
		last_of(sim, t, i)[KNOWN] =
			0; /* the column may still exist from a deleted dump of the same id */
	return TS_OK;
}

enum ts_status ts_dump_archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *archive)
{
	struct ts_dump_common *d = self->state;
	size_t n = ts_archive_writing(archive) ? count_last(d) : SIZE_MAX, column;
	char name[32];

	for (size_t k = 0; k < n; k++) {
		snprintf(name, sizeof name, "last %zu", k);
		if (!ts_archive_writing(archive) && !ts_archive_has(archive, name))
			break;
		TS_TRY(last_column(self, sim, k, &column));
		TS_TRY(ts_particles_archive_column(archive, sim, name, column));
		d->restored = k + 1;
	}
	return TS_OK;
}

static enum ts_status read_threshold(struct ts_instance *self, struct tsim *sim, struct ts_words words,
				     struct ts_dump_threshold *t)
{
	const char *name;

	if (words.n < 3)
		return ts_fail(&sim->error, TS_SYNTAX, &words.word[0].place,
			       "dump_modify: thresh takes a quantity, one of < <= > >= == != |^, and a "
			       "number, or none");
	while (operators[t->operator] && !ts_streq(operators[t->operator], words.word[1].text))
		t->operator++;
	if (!operators[t->operator])
		return ts_fail(&sim->error, TS_SYNTAX, &words.word[1].place,
			       "dump_modify: thresh: '%s' is none of < <= > >= == != |^", words.word[1].text);
	t->last = ts_streq(words.word[2].text, "LAST");
	if (!t->last && !ts_parse_real(words.word[2].text, &t->limit))
		return ts_fail(&sim->error, TS_SYNTAX, &words.word[2].place,
			       "dump_modify: thresh: '%s' is no number, nor LAST", words.word[2].text);
	name = ts_arena_strdup(&self->arena, words.word[0].text);
	if (!name)
		return ts_nomem(&sim->error);
	t->value.input = (struct ts_ref_input){ .name = name, .where = words.word[0].place };
	if (t->last)
		TS_TRY(keep_last(self, sim, t));
	return ts_dump_make_column(self, sim, &t->value, false);
}

enum ts_status ts_dump_set_thresholds(struct ts_instance *self, struct tsim *sim, struct ts_words words)
{
	struct ts_dump_common *d = self->state;

	while (words.n) {
		struct ts_dump_threshold *all, new = { 0 };

		if (ts_streq(words.word[0].text, "none")) {
			ts_dump_release_thresholds(d);
			words = ts_words_from(words, 1);
			continue;
		}
		TS_TRY(read_threshold(self, sim, words, &new));
		all = ts_arena_alloc(&self->arena, d->nthresholds + 1, sizeof *all);
		if (!all)
			return ts_nomem(&sim->error);
		for (size_t k = 0; k < d->nthresholds; k++)
			all[k] = d->threshold[k];
		all[d->nthresholds] = new;
		d->threshold = all;
		d->nthresholds++;
		words = ts_words_from(words, 3);
	}
	return TS_OK;
}

static enum ts_status find_region(struct ts_instance *self, struct tsim *sim, struct ts_instance **out)
{
	const struct ts_dump_common *d = self->state;

	*out = d->region ? ts_sim_find(sim, TS_KIND_REGION, d->region) : NULL;
	if (*out || !d->region)
		return TS_OK;
	return ts_fail(&sim->error, TS_STATE, &self->where, "dump %s: its region '%s' is gone", self->id,
		       d->region);
}

/* Evaluates one condition for particle i; with LAST the current value is stored for the next frame. */
static bool passes_one(const struct tsim *sim, const struct ts_dump_threshold *t, size_t i)
{
	double value = t->value.values.data[i], *last;
	bool yes;

	if (!t->last)
		return holds(t->operator, value, t->limit);
	last = last_of(sim, t, i);
	yes = last[KNOWN] > 0 && holds(t->operator, value, last[VALUE]);
	last[VALUE] = value;
	last[KNOWN] = 1;
	return yes;
}

static bool passes(const struct tsim *sim, const struct ts_dump_common *d, size_t i)
{
	bool yes = true;

	for (size_t k = 0; k < d->nthresholds; k++)
		yes &= passes_one(sim, &d->threshold[k], i);
	return yes;
}

/* Sort key of particles: the value of a column; equal values are sorted by id. */
struct order {
	const int32_t *tag;
	const double *value; /* NULL: by id */
	int sign;	     /* 1: ascending; -1: descending */
};

static int compare(const void *a, const void *b, void *context)
{
	const struct order *by = context;
	int32_t i = *(const int32_t *)a, j = *(const int32_t *)b;

	if (by->value && by->value[i] != by->value[j])
		return by->value[i] > by->value[j] ? by->sign : -by->sign;
	return (by->tag[i] > by->tag[j]) - (by->tag[i] < by->tag[j]);
}

/* Whether rows are sorted by this column. */
static bool sorts(const struct ts_dump_common *d, const struct ts_dump_column *c)
{
	return c->number == (size_t)(d->sort_by < 0 ? -d->sort_by : d->sort_by);
}

static enum ts_status sort(struct ts_instance *self, struct tsim *sim)
{
	struct ts_dump_common *d = self->state;
	int64_t column = d->sort_by < 0 ? -d->sort_by : d->sort_by;
	struct order by = { .tag = sim->particles->tag, .sign = d->sort_by < 0 ? -1 : 1 };

	if ((size_t)column > d->ncolumns)
		return ts_fail(&sim->error, TS_RANGE, &self->where,
			       "dump %s: sort by column %lld, but there are %zu", self->id, (long long)column,
			       d->ncolumns);
	for (size_t k = 0; column && k < d->ncolumns; k++)
		if (sorts(d, &d->column[k]))
			by.value = d->column[k].values.data;
	if (!d->unsorted && d->nrows)
		qsort_r(d->order, d->nrows, sizeof *d->order, compare, &by);
	return TS_OK;
}

static enum ts_status select_particles(struct ts_instance *self, struct tsim *sim)
{
	struct ts_dump_common *d = self->state;
	const struct ts_particles *p = sim->particles;
	struct ts_instance *region;

	TS_TRY(find_region(self, sim, &region));
	if (region)
		TS_TRY(ts_region_update(region, sim));
	for (size_t k = 0; k < d->nthresholds; k++) {
		TS_TRY(ts_dump_make_column(self, sim, &d->threshold[k].value, false));
		TS_TRY(ts_dump_evaluate(&d->threshold[k].value, sim));
	}
	if (TS_GROW(d->order, d->order_capacity, p->n) != TS_OK)
		return ts_nomem(&sim->error);
	d->nrows = 0;
	for (size_t i = 0; i < p->n; i++)
		if (passes(sim, d, i) && ts_in_group(p, i, self->group) &&
		    (!region || ts_region_contains(region, p->x[i])))
			d->order[d->nrows++] = (int32_t)i;
	return sort(self, sim);
}

/* Local rows have no id: they are sorted by the first column, then by the second, and so on. */
static int compare_rows(const void *a, const void *b, void *context)
{
	const struct ts_dump_common *d = context;
	int32_t i = *(const int32_t *)a, j = *(const int32_t *)b;

	for (size_t k = 0; k < d->ncolumns; k++) {
		const double *value = d->column[k].values.data;

		if (d->column[k].index)
			continue;
		if (value[i] != value[j])
			return value[i] > value[j] ? 1 : -1;
	}
	return (i > j) - (i < j);
}

static enum ts_status select_rows(struct ts_dump_common *d, struct tsim *sim)
{
	const struct ts_dump_column *first = NULL;

	d->nrows = 0;
	for (size_t k = 0; k < d->ncolumns; k++) {
		struct ts_dump_column *c = &d->column[k];

		if (c->index)
			continue;
		if (first && c->values.rows != first->values.rows)
			return ts_fail(&sim->error, TS_STATE, &c->input.where,
				       "dump local: '%s' has %zu rows, but '%s' has %zu", c->input.name,
				       c->values.rows, first->input.name, first->values.rows);
		first = c;
	}
	if (!first)
		return TS_OK;
	if (TS_GROW(d->order, d->order_capacity, first->values.rows) != TS_OK)
		return ts_nomem(&sim->error);
	d->nrows = first->values.rows;
	for (size_t i = 0; i < d->nrows; i++)
		d->order[i] = (int32_t)i;
	if (!d->unsorted && d->nrows)
		qsort_r(d->order, d->nrows, sizeof *d->order, compare_rows, d);
	return TS_OK;
}

/* The column `index` numbers the rows in the order of writing. */
static enum ts_status number_rows(struct ts_dump_common *d, struct tsim *sim)
{
	for (size_t k = 0; k < d->ncolumns; k++) {
		struct ts_table *values = &d->column[k].values;

		if (!d->column[k].index)
			continue;
		if (ts_table_resize(values, d->nrows, 1) != TS_OK)
			return ts_nomem(&sim->error);
		for (size_t row = 0; row < d->nrows; row++)
			values->data[d->order[row]] = (double)(row + 1);
	}
	return TS_OK;
}

/* dump_modify refresh: renews the reference of the compute after the columns were evaluated. */
static enum ts_status refresh(struct ts_instance *self, struct tsim *sim)
{
	const struct ts_dump_common *d = self->state;
	struct ts_instance *compute = ts_sim_find(sim, TS_KIND_COMPUTE, d->refresh);

	if (compute && compute->style->refresh)
		return compute->style->refresh(compute, sim);
	return ts_fail(&sim->error, TS_STATE, &self->where, "dump %s: its compute '%s' is gone", self->id,
		       d->refresh);
}

double ts_dump_value(const struct tsim *sim, const struct ts_dump_column *c, size_t i)
{
	return c->direct ? c->direct(sim, i) : c->values.data[i];
}

/* `by_row`: built-in quantities are evaluated when they are written, except the one by which rows are sorted. */
static enum ts_status evaluate_columns(struct ts_dump_common *d, struct tsim *sim, bool by_row)
{
	for (size_t k = 0; k < d->ncolumns; k++) {
		struct ts_dump_column *c = &d->column[k];

		c->direct = by_row && !sorts(d, c) && !c->element && !c->index && c->input.quantity
				    ? ts_particles_quantity_fn(sim, c->input.name)
				    : NULL;
		if (!c->direct)
			TS_TRY(ts_dump_evaluate(c, sim));
	}
	return TS_OK;
}

enum ts_status ts_dump_gather_rows(struct ts_instance *self, struct tsim *sim)
{
	struct ts_dump_common *d = self->state;

	TS_TRY(evaluate_columns(d, sim, true));
	TS_TRY(select_particles(self, sim));
	return d->refresh ? refresh(self, sim) : TS_OK;
}

enum ts_status ts_dump_gather(struct ts_instance *self, struct tsim *sim, bool local)
{
	struct ts_dump_common *d = self->state;

	TS_TRY(evaluate_columns(d, sim, false));
	TS_TRY(local ? select_rows(d, sim) : select_particles(self, sim));
	TS_TRY(number_rows(d, sim));
	return d->refresh ? refresh(self, sim) : TS_OK;
}
