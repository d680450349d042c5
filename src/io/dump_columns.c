/* Columns of dumps: what they are called, their values, which rows and in which order. */
#ifndef _GNU_SOURCE
#define _GNU_SOURCE /* qsort_r */
#endif
#include "io/dump.h"

#include <stdlib.h>
#include <string.h>

#include "particles/particles.h"

#include "base/banned.h"

static bool names_integer(const char *name)
{
	static const char *const integers[] = { "id", "type", "ix",   "iy",
						"iz", "mol",  "proc", "index" };

	for (size_t k = 0; k < sizeof integers / sizeof *integers; k++)
		if (ts_streq(name, integers[k]))
			return true;
	return false;
}

static enum ts_status make_column(struct ts_instance *self, struct tsim *sim,
				  struct ts_dump_column *c, bool local)
{
	struct ts_suggest suggest = ts_suggest_start(c->name);
	unsigned wanted = local ? 1u << TS_LOCAL : 1u << TS_PERATOM | 1u << TS_SCALAR;

	c->integer = names_integer(c->name);
	if (local && ts_streq(c->name, "index")) {
		c->kind = TS_DUMP_INDEX;
		return TS_OK;
	}
	if (!local && ts_quantity_has(sim, c->name)) {
		c->kind = TS_DUMP_QUANTITY;
		return TS_OK;
	}
	c->kind = TS_DUMP_REF;
	if (!c->name[0] || c->name[1] != '_' || !strchr("cfv", c->name[0])) {
		if (local)
			ts_suggest_try(&suggest, "index");
		else
			ts_quantity_suggest(&suggest);
		return ts_fail(&sim->error, TS_UNKNOWN, &c->where,
			       "dump %s: unknown column '%s', expected %s%s", self->style->name,
			       c->name,
			       local ? "index, c_ID[k] or f_ID[k]"
				     : "a quantity of particles, c_ID[k], f_ID[k] or v_NAME",
			       ts_suggest_text(&suggest));
	}
	TS_TRY(ts_ref_resolve(sim, c->name, &c->where, &c->ref));
	if (!(ts_ref_shapes(sim, &c->ref) & wanted))
		return ts_fail(&sim->error, TS_STATE, &c->where, "dump %s: '%s' has no %s values",
			       self->style->name, c->name, local ? "local" : "per-particle");
	return TS_OK;
}

static enum ts_status set_format(struct ts_dump_common *d, struct tsim *sim, size_t k)
{
	struct ts_dump_column *c = &d->column[k];
	const char *line = k < d->line_format.n ? d->line_format.word[k].text : NULL;
	const char *fallback = c->integer ? d->int_format : d->float_format;

	if (!line && d->line_format.n)
		return ts_fail(&sim->error, TS_SYNTAX, &d->line_format.word[0].place,
			       "dump_modify format line has %zu formats, the dump has %zu columns",
			       d->line_format.n, d->ncolumns);
	if (!line)
		line = *fallback ? fallback : c->integer ? "%d" : "%g";
	if (ts_format_check(line, c->integer, c->format))
		return TS_OK;
	return ts_fail(&sim->error, TS_SYNTAX,
		       d->line_format.n ? &d->line_format.word[k].place : &c->where,
		       "'%s' is no format for column %s, expected for instance %s", line, c->name,
		       c->integer ? "%d" : "%g");
}

enum ts_status ts_dump_columns(struct ts_instance *self, struct tsim *sim, struct ts_words names,
			       bool local)
{
	struct ts_dump_common *d = self->state;

	self->every = d->every;
	if (!d->column) {
		d->column = ts_arena_alloc(&self->arena, names.n, sizeof *d->column);
		if (!d->column)
			return ts_nomem(&sim->error);
		d->ncolumns = names.n;
	}
	for (size_t k = 0; k < names.n; k++) {
		d->column[k].name = names.word[k].text;
		d->column[k].where = names.word[k].place;
		TS_TRY(make_column(self, sim, &d->column[k], local));
		TS_TRY(set_format(d, sim, k));
	}
	return TS_OK;
}

static enum ts_status evaluate(struct ts_dump_column *c, struct tsim *sim, bool local)
{
	switch (c->kind) {
	case TS_DUMP_QUANTITY:
		return ts_quantity_eval(sim, c->name, &c->values);
	case TS_DUMP_REF:
		if (local)
			return ts_ref_local(sim, &c->ref, &c->where, &c->values);
		return ts_ref_peratom(sim, &c->ref, &c->where, &c->values);
	case TS_DUMP_INDEX:
		break;
	}
	return TS_OK;
}

static int compare_tags(const void *a, const void *b, void *context)
{
	const int32_t *tag = context;
	int32_t s = tag[*(const int32_t *)a], t = tag[*(const int32_t *)b];

	return (s > t) - (s < t);
}

static enum ts_status select_particles(struct ts_instance *self, struct tsim *sim)
{
	struct ts_dump_common *d = self->state;
	const struct ts_particles *p = sim->particles;

	if (TS_GROW(d->order, d->order_capacity, p->n) != TS_OK)
		return ts_nomem(&sim->error);
	d->nrows = 0;
	for (size_t i = 0; i < p->n; i++)
		if (ts_in_group(p, i, self->group))
			d->order[d->nrows++] = (int32_t)i;
	if (!d->unsorted && d->nrows)
		qsort_r(d->order, d->nrows, sizeof *d->order, compare_tags, p->tag);
	return TS_OK;
}

/* Local rows have no identity: they are ordered by their columns, from left to right. */
static int compare_rows(const void *a, const void *b, void *context)
{
	const struct ts_dump_common *d = context;
	int32_t i = *(const int32_t *)a, j = *(const int32_t *)b;

	for (size_t k = 0; k < d->ncolumns; k++) {
		const double *value = d->column[k].values.data;

		if (d->column[k].kind == TS_DUMP_INDEX)
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

		if (c->kind == TS_DUMP_INDEX)
			continue;
		if (first && c->values.rows != first->values.rows)
			return ts_fail(&sim->error, TS_STATE, &c->where,
				       "dump local: '%s' has %zu rows, but '%s' has %zu", c->name,
				       c->values.rows, first->name, first->values.rows);
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

/* The index counts the rows as they are written. */
static enum ts_status number_rows(struct ts_dump_common *d, struct tsim *sim)
{
	for (size_t k = 0; k < d->ncolumns; k++) {
		struct ts_table *values = &d->column[k].values;

		if (d->column[k].kind != TS_DUMP_INDEX)
			continue;
		if (ts_table_resize(values, d->nrows, 1) != TS_OK)
			return ts_nomem(&sim->error);
		for (size_t row = 0; row < d->nrows; row++)
			values->data[d->order[row]] = (double)(row + 1);
	}
	return TS_OK;
}

enum ts_status ts_dump_gather(struct ts_instance *self, struct tsim *sim, bool local)
{
	struct ts_dump_common *d = self->state;

	for (size_t k = 0; k < d->ncolumns; k++)
		TS_TRY(evaluate(&d->column[k], sim, local));
	TS_TRY(local ? select_rows(d, sim) : select_particles(self, sim));
	return number_rows(d, sim);
}
