/* Columns of dumps: resolution of their names, and their values. */
#include "dump/dump.h"

#include <stdlib.h>
#include <string.h>

#include "particle/particles.h"

#include "base/banned.h"

static bool names_integer(const char *name)
{
	static const char *const integers[] = { "id", "type", "ix", "iy", "iz", "mol", "proc", "index" };

	for (size_t k = 0; k < sizeof integers / sizeof *integers; k++)
		if (ts_streq(name, integers[k]))
			return true;
	return strncmp(name, "i_", 2) == 0; /* integer property of fix property/atom */
}

enum ts_status ts_dump_make_column(struct ts_instance *self, struct tsim *sim, struct ts_dump_column *c,
				   bool local)
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
	return ts_ref_input_resolve(sim, what, local ? TS_WANT(LOCAL) : TS_WANT(PERATOM), &c->input);
}

/* Called once: expands c_ID[*] to several columns. */
static enum ts_status name_columns(struct ts_instance *self, struct tsim *sim, struct ts_words names,
				   bool local)
{
	struct ts_dump_common *d = self->state;
	struct ts_words all;

	TS_TRY(ts_refs_expand(sim, &self->arena, names, local ? TS_WANT(LOCAL) : TS_WANT(PERATOM), &all));
	d->column = ts_arena_alloc(&self->arena, all.n, sizeof *d->column);
	if (!d->column)
		return ts_nomem(&sim->error);
	for (size_t k = 0; k < all.n; k++) {
		d->column[k].input =
			(struct ts_ref_input){ .name = all.word[k].text, .where = all.word[k].place };
		d->column[k].number = k + 1;
	}
	d->ncolumns = all.n;
	return TS_OK;
}

enum ts_status ts_dump_columns(struct ts_instance *self, struct tsim *sim, struct ts_words names, bool local)
{
	struct ts_dump_common *d = self->state;

	self->every = d->every;
	d->local = local;
	if (!d->column)
		TS_TRY(name_columns(self, sim, names, local));
	for (size_t k = 0; k < d->ncolumns; k++) {
		struct ts_dump_column *c = &d->column[k];

		TS_TRY(ts_dump_make_column(self, sim, c, local));
		if (c->element)
			TS_TRY(ts_formats_choose_text(&d->formats, &sim->error, k, c->format));
		else
			TS_TRY(ts_formats_choose(&d->formats, &sim->error, k, c->integer,
						 c->integer ? "%d" : "%g", c->format));
	}
	return TS_OK;
}

enum ts_status ts_dump_evaluate(struct ts_dump_column *c, struct tsim *sim)
{
	if (c->index)
		return TS_OK;
	if (c->element)
		return ts_quantity_eval(sim, "type", &c->values);
	return ts_ref_input_eval(sim, &c->input, &c->values);
}
