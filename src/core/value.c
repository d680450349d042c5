#include "core/value.h"

#include <string.h>

#include "core/sim.h"

#include "base/banned.h"

enum ts_status ts_table_resize(struct ts_table *table, size_t rows, size_t columns)
{
	TS_TRY(TS_GROW(table->data, table->capacity, rows * columns));
	table->rows = rows;
	table->columns = columns;
	return TS_OK;
}

void ts_table_release(struct ts_table *table)
{
	ts_free(table->data);
	*table = (struct ts_table){ 0 };
}

bool ts_value_given(const struct ts_instance *inst, const struct ts_value *value)
{
	return !inst->style->gives || inst->style->gives(inst, value);
}

const struct ts_value *ts_value_find(const struct ts_instance *inst, enum ts_shape shape)
{
	for (const struct ts_value *v = inst->style->values; v && v->name; v++)
		if (v->shape == shape && ts_value_given(inst, v))
			return v;
	return shape == TS_LOCAL ? ts_value_find(inst, TS_SURFACE) : NULL;
}

size_t ts_value_width(const struct ts_instance *inst, const struct ts_value *value)
{
	return value->columns || !inst->style->width ? value->columns : inst->style->width(inst);
}

enum ts_status ts_instance_init(struct ts_instance *inst, struct tsim *sim)
{
	const uint64_t before = inst->removals;
	enum ts_status status;

	inst->removals = sim->removals; /* init may evaluate outputs */
	status = inst->style->init ? inst->style->init(inst, sim) : TS_OK;
	if (status != TS_OK)
		inst->removals = before; /* what it points to may be gone */
	return status;
}

enum ts_status ts_value_find_again(struct ts_instance *inst, struct tsim *sim)
{
	if (inst->removals == sim->removals || sim->run.inside || inst->style->kind != TS_KIND_COMPUTE)
		return TS_OK;
	return ts_instance_init(inst, sim);
}

enum ts_status ts_value_eval(struct ts_instance *inst, struct tsim *sim, const struct ts_value *value,
			     struct ts_table *out)
{
	size_t columns = value->shape == TS_SCALAR ? 1 : value->columns;
	enum ts_status status;

	if (out == &inst->table)
		inst->cached = NULL;
	TS_TRY(ts_value_find_again(inst, sim));
	if (value->shape == TS_SCALAR || (value->shape == TS_VECTOR && columns))
		if (ts_table_resize(out, 1, columns) != TS_OK)
			return ts_nomem(&sim->error);
	status = value->eval(inst, sim, out);
	return status == TS_NOMEM ? ts_nomem(&sim->error) : status;
}

/* Several ranks make the lists only in steps in which core/due_lists.h finds a compute that reads them. */
static enum ts_status require_lists(const struct ts_instance *inst, struct tsim *sim)
{
	if (!sim->run.looks || inst->style->kind != TS_KIND_COMPUTE ||
	    inst->style->ranks & TS_RANKS_PARTICLES)
		return TS_OK;
	return ts_fail(&sim->error, TS_STATE, &inst->where,
		       "compute %s (%s) is read in a step in which each rank has the contacts of its own "
		       "particles "
		       "only: nothing that is due names it; run tsim without mpirun, with threads "
		       "(OMP_NUM_THREADS)",
		       inst->id, inst->style->name);
}

enum ts_status ts_value_cached(struct ts_instance *inst, struct tsim *sim, const struct ts_value *value)
{
	const struct ts_draws draws = sim->draws;
	enum ts_status status;

	if (sim->run.epoch && inst->cached == value && inst->cached_epoch == sim->run.epoch)
		return TS_OK;
	inst->cached = NULL;
	TS_TRY(require_lists(inst, sim));
	if (draws.site) /* random numbers of an output do not depend on which hook reads it first */
		sim->draws = (struct ts_draws){ ts_instance_site(inst, TS_NSTAGE), 0 };
	status = ts_value_eval(inst, sim, value, &inst->table);
	sim->draws = draws;
	if (status == TS_OK) {
		inst->cached = value;
		inst->cached_epoch = sim->run.epoch;
	}
	return status;
}

const struct ts_keyword *ts_keyword_find(const struct ts_tables *tables, const char *name)
{
	for (const struct ts_system_style *const *s = tables->systems; *s; s++)
		for (const struct ts_keyword *k = (*s)->keywords; k && k->name; k++)
			if (ts_streq(k->name, name))
				return k;
	return NULL;
}

enum ts_status ts_keyword_check(struct tsim *sim, const struct ts_keyword *keyword,
				const struct ts_place *where)
{
	for (const struct ts_system_style *const *s = sim->tables->systems; *s; s++)
		for (const struct ts_keyword *k = (*s)->keywords; k && k->name; k++)
			if (k == keyword && (*s)->check_keyword)
				return (*s)->check_keyword(sim, keyword, where);
	return TS_OK;
}

const struct ts_function *ts_function_find(const struct ts_tables *tables, const char *name)
{
	for (const struct ts_system_style *const *s = tables->systems; *s; s++)
		for (const struct ts_function *f = (*s)->functions; f && f->name; f++)
			if (ts_streq(f->name, name))
				return f;
	return NULL;
}

static const struct ts_system_style *find_quantity_owner(const struct tsim *sim, const char *name)
{
	for (const struct ts_system_style *const *s = sim->tables->systems; *s; s++)
		if ((*s)->has_quantity && (*s)->has_quantity(sim, name))
			return *s;
	return NULL;
}

bool ts_quantity_has(const struct tsim *sim, const char *name)
{
	return find_quantity_owner(sim, name) != NULL;
}

bool ts_quantity_kept(const struct tsim *sim, const char *name)
{
	bool kept = false;

	for (const struct ts_system_style *const *s = sim->tables->systems; *s; s++)
		kept |= (*s)->keeps_quantity && (*s)->keeps_quantity(sim, name);
	return kept;
}

enum ts_status ts_quantity_eval(struct tsim *sim, const char *name, struct ts_table *out)
{
	const struct ts_system_style *owner = find_quantity_owner(sim, name);

	if (!owner)
		return ts_fail(&sim->error, TS_UNKNOWN, NULL, "unknown per-particle quantity '%s'", name);
	return owner->quantity(sim, name, out);
}

void ts_quantity_suggest(const struct tsim *sim, struct ts_suggest *suggest)
{
	for (const struct ts_system_style *const *s = sim->tables->systems; *s; s++)
		if ((*s)->suggest_quantity)
			(*s)->suggest_quantity(suggest);
}

void ts_keyword_shows(struct tsim *sim, const struct ts_keyword *keyword)
{
	sim->run.shows_contacts |= (keyword->flags & TS_KEYWORD_CONTACTS) != 0;
	sim->run.shows_lists |= (keyword->flags & TS_KEYWORD_LISTS) != 0;
}

static void scan_words(struct tsim *sim, const char *text, const char *letters)
{
	char name[16];

	for (size_t n; *text; text += n ? n : 1) {
		const struct ts_keyword *keyword;

		n = strspn(text, letters);
		if (!n || n >= sizeof name)
			continue;
		memcpy(name, text, n);
		name[n] = '\0';
		keyword = ts_keyword_find(sim->tables, name);
		if (keyword)
			ts_keyword_shows(sim, keyword);
	}
}

void ts_keywords_scan(struct tsim *sim, const char *text)
{
	scan_words(sim, text, "abcdefghijklmnopqrstuvwxyz"); /* also the name in v_name */
	scan_words(sim, text, "abcdefghijklmnopqrstuvwxyz_");
}
