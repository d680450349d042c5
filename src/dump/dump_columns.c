/* Columns of dumps: what they are called, their values, which rows and in which order. */
#ifndef _GNU_SOURCE
#define _GNU_SOURCE /* qsort_r */
#endif
#include "dump/dump.h"

#include <stdlib.h>
#include <string.h>

#include "particle/particles.h"

#include "base/banned.h"

static bool names_integer(const char *name)
{
	static const char *const integers[] = { "id", "type", "ix",   "iy",
						"iz", "mol",  "proc", "index" };

	for (size_t k = 0; k < sizeof integers / sizeof *integers; k++)
		if (ts_streq(name, integers[k]))
			return true;
	return strncmp(name, "i_", 2) == 0; /* of fix property/atom */
}

enum ts_status ts_dump_make_column(struct ts_instance *self, struct tsim *sim,
				   struct ts_dump_column *c, bool local)
{
	char what[64];

	c->integer = names_integer(c->input.name);
	c->element = !local && ts_streq(c->input.name, "element");
	if (c->element)
		return TS_OK;
	c->index = local && ts_streq(c->input.name, "index");
	if (c->index)
		return TS_OK;
	snprintf(what, sizeof what, "dump %s", self->style->name);
	return ts_ref_input_resolve(sim, what,
				    local ? TS_WANT(LOCAL) : TS_WANT(PERATOM) | TS_WANT(SCALAR),
				    &c->input);
}

/* Once: c_ID[*] becomes several columns. */
static enum ts_status name_columns(struct ts_instance *self, struct tsim *sim,
				   struct ts_words names, bool local)
{
	struct ts_dump_common *d = self->state;
	struct ts_words all;

	TS_TRY(ts_refs_expand(sim, &self->arena, names, local ? TS_WANT(LOCAL) : TS_WANT(PERATOM),
			      &all));
	d->column = ts_arena_alloc(&self->arena, all.n, sizeof *d->column);
	if (!d->column)
		return ts_nomem(&sim->error);
	for (size_t k = 0; k < all.n; k++)
		d->column[k].input = (struct ts_ref_input){ .name = all.word[k].text,
							    .where = all.word[k].place };
	d->ncolumns = all.n;
	return TS_OK;
}

enum ts_status ts_dump_columns(struct ts_instance *self, struct tsim *sim, struct ts_words names,
			       bool local)
{
	struct ts_dump_common *d = self->state;

	self->every = d->every;
	if (!d->column)
		TS_TRY(name_columns(self, sim, names, local));
	for (size_t k = 0; k < d->ncolumns; k++) {
		TS_TRY(ts_dump_make_column(self, sim, &d->column[k], local));
		TS_TRY(ts_formats_choose(&d->formats, &sim->error, k, d->column[k].integer,
					 d->column[k].integer ? "%d" : "%g", d->column[k].format));
	}
	return TS_OK;
}

enum ts_status ts_dump_evaluate(struct ts_dump_column *c, struct tsim *sim)
{
	if (c->index)
		return TS_OK;
	if (c->element)
		return ts_quantity_eval(sim, "type", &c->values);
	if (c->input.shape == TS_SCALAR) /* the same for all particles */
		return ts_ref_peratom(sim, &c->input.ref, &c->input.where, &c->values);
	return ts_ref_input_eval(sim, &c->input, &c->values);
}

/* Local rows have no identity: they are ordered by their columns, from left to right. */
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

/* The index counts the rows as they are written. */
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

/* dump_modify refresh: the values of this frame are taken already. */
static enum ts_status refresh(struct ts_instance *self, struct tsim *sim)
{
	const struct ts_dump_common *d = self->state;
	struct ts_instance *compute = ts_sim_find(sim, TS_KIND_COMPUTE, d->refresh);

	if (compute && compute->style->refresh)
		return compute->style->refresh(compute, sim);
	return ts_fail(&sim->error, TS_STATE, &self->where, "dump %s: its compute '%s' is gone", self->id,
		       d->refresh);
}

enum ts_status ts_dump_gather(struct ts_instance *self, struct tsim *sim, bool local)
{
	struct ts_dump_common *d = self->state;

	for (size_t k = 0; k < d->ncolumns; k++)
		TS_TRY(ts_dump_evaluate(&d->column[k], sim));
	TS_TRY(local ? select_rows(d, sim) : ts_dump_select(self, sim));
	TS_TRY(number_rows(d, sim));
	return d->refresh ? refresh(self, sim) : TS_OK;
}
