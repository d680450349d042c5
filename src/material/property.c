#include "material/property.h"

#include <string.h>

#include "material/material.h"

#include "base/banned.h"

const struct ts_property *ts_property_find(const struct tsim *sim, const char *name,
					   const struct ts_instance **by)
{
	const struct ts_instances *fixes = &sim->instances[TS_KIND_FIX];

	for (size_t k = fixes->n; k-- > 0;) { /* the last definition is valid */
		const struct ts_property *p = fixes->item[k]->state;

		if (!ts_streq(fixes->item[k]->style->name, "property/global") || !ts_streq(p->name, name))
			continue;
		if (by)
			*by = fixes->item[k];
		return p;
	}
	return NULL;
}

bool ts_property_given(const struct tsim *sim, const char *name)
{
	return ts_property_find(sim, name, NULL) != NULL || ts_material_given(sim, name);
}

/* Suggests a defined property only if its name is long and differs by at most two letters: kn is not a
 * misspelt kt. */
static void suggest_if_misspelt(struct ts_suggest *suggest, const char *defined)
{
	struct ts_suggest strict = ts_suggest_start(suggest->word);
	enum { SLIPS = 2, LONG = 8 };

	ts_suggest_try(&strict, defined);
	if (strlen(defined) >= LONG && strict.best && strict.distance <= SLIPS)
		ts_suggest_try(suggest, defined);
}

/* Hint about material files for the error message. */
static void describe_material_files(const struct tsim *sim, int a, int b, char *out, size_t size)
{
	const char *one = ts_material_name(sim, a), *other = ts_material_name(sim, b);

	out[0] = '\0';
	if (sim->materials->n)
		snprintf(out, size, ", or a line in the files of the materials");
	if (one && (b == 0 || (other && ts_streq(one, other))))
		snprintf(out, size, ", or a line in the files of the materials; that of %.60s has no value",
			 one);
	else if (one && other)
		snprintf(out, size,
			 ", or a line in the files of the materials; those of %.60s and %.60s have no value "
			 "for this pair, nor one for each",
			 one, other);
}

static enum ts_status fail_missing(struct tsim *sim, const char *name, int a, int b, const char *who,
				   const struct ts_place *where)
{
	const char *kind = b ? "peratomtypepair N" : a ? "peratomtype" : "scalar";
	char files[256];
	struct ts_suggest suggest = ts_suggest_start(name);
	const struct ts_instances *fixes = &sim->instances[TS_KIND_FIX];

	for (size_t k = 0; k < fixes->n; k++)
		if (ts_streq(fixes->item[k]->style->name, "property/global"))
			suggest_if_misspelt(&suggest,
					    ((const struct ts_property *)fixes->item[k]->state)->name);
	describe_material_files(sim, a, b, files, sizeof files);
	return ts_fail(&sim->error, TS_STATE, where, "%s needs `fix ID all property/global %s %s ...`%s%s",
		       who, name, kind, files, ts_suggest_text(&suggest));
}

static size_t index_of(const struct ts_property *p, int a, int b)
{
	size_t row = (size_t)(a > 0 ? a - 1 : 0), column = (size_t)(b > 0 ? b - 1 : 0);

	return p->kind == TS_PROPERTY_SCALAR ? 0 : row * p->columns + column;
}

const struct ts_place *ts_property_place(const struct tsim *sim, const char *name, int a, int b)
{
	const struct ts_instance *by;
	const struct ts_property *p = ts_property_find(sim, name, &by);
	size_t word;

	if (!p)
		return ts_material_place(sim, name, a, b);
	word = (p->kind >= TS_PROPERTY_PAIR ? 3 : 2) + index_of(p, a, b); /* name, kind, columns */
	return word < by->words.n ? &by->words.word[word].place : &by->where;
}

enum ts_status ts_property_value(struct tsim *sim, const char *name, int a, int b, const char *who,
				 const struct ts_place *where, double *out)
{
	const struct ts_instance *by;
	const struct ts_property *p = ts_property_find(sim, name, &by);
	size_t row = (size_t)(a > 0 ? a - 1 : 0), column = (size_t)(b > 0 ? b - 1 : 0);
	bool found = false;

	if (!p)
		TS_TRY(ts_material_find(sim, name, a, b, &found, out));
	if (found)
		return TS_OK;
	if (!p)
		return fail_missing(sim, name, a, b, who, where);
	if (p->kind == TS_PROPERTY_SCALAR) {
		*out = p->value[0];
		return TS_OK;
	}
	if ((p->kind >= TS_PROPERTY_PAIR) != (b > 0))
		return ts_fail(&sim->error, TS_STATE, &by->where,
			       "%s: %s is given %s, but %s needs it for each %s", by->id, name,
			       p->kind >= TS_PROPERTY_PAIR ? "per pair of types" : "per type", who,
			       b > 0 ? "pair of types (peratomtypepair)" : "type (peratomtype)");
	if (row >= p->n / p->columns || column >= p->columns)
		return ts_fail(&sim->error, TS_RANGE, &by->where,
			       "property/global %s has values for %zu types, but there is a type %d", name,
			       p->kind >= TS_PROPERTY_PAIR ? p->columns : p->n, a > b ? a : b);
	*out = p->value[row * p->columns + column];
	return TS_OK;
}
