#include "material/material.h"

#include <math.h>
#include <string.h>

#include "base/hash.h"
#include "core/coeff.h"

#include "base/banned.h"

/* Value of an SI unit in the units of the script; 0: no equivalent (lj); NaN: unknown unit. */
static double unit_factor(const struct tsim *sim, const char *unit)
{
	static const struct {
		const char *name;
		double si, cgs, micro;
	} units[] = {
		{ "1", 1, 1, 1 },	    { "Pa", 1, 10, 1e-3 }, { "J/m3", 1, 10, 1e-3 },
		{ "kg/m3", 1, 1e-3, 1e-3 }, { "m/s", 1, 100, 1 },  { "W/m/K", 1, 1e5, 1e3 },
		{ "J/kg/K", 1, 1e4, 1 },
	};

	for (size_t k = 0; k < sizeof units / sizeof *units; k++) {
		if (!ts_streq(units[k].name, unit))
			continue;
		return sim->units == TS_UNITS_SI      ? units[k].si
		       : sim->units == TS_UNITS_CGS   ? units[k].cgs
		       : sim->units == TS_UNITS_MICRO ? units[k].micro
						      : k == 0;
	}
	return NAN;
}

static enum ts_status read_value(struct tsim *sim, const struct ts_word *number, const struct ts_word *unit,
				 double *out)
{
	double factor = unit_factor(sim, unit->text);

	if (!ts_parse_real(number->text, out) || !isfinite(*out))
		return ts_fail(&sim->error, TS_SYNTAX, &number->place,
			       "material: expected a number, found '%s'", number->text);
	if (isnan(factor))
		return ts_fail(&sim->error, TS_SYNTAX, &unit->place,
			       "material: unknown unit '%s', expected one of 1, Pa, J/m3, kg/m3, m/s, W/m/K, "
			       "J/kg/K",
			       unit->text);
	if (!(factor > 0))
		return ts_fail(&sim->error, TS_STATE, &unit->place,
			       "material: units lj have no %s; use si, cgs or micro, or give the property by "
			       "fix property/global",
			       unit->text);
	*out *= factor;
	return TS_OK;
}

static enum ts_status add_value(struct tsim *sim, struct ts_material *m, const struct ts_word *name,
				const struct ts_word *partner, double value)
{
	struct ts_material_value v = { ts_pool_get(sim->pool, name->text),
				       partner ? ts_pool_get(sim->pool, partner->text) : NULL, value,
				       name->place };

	if (!v.name || (partner && !v.partner) || TS_GROW(m->value, m->capacity, m->n + 1) != TS_OK)
		return ts_nomem(&sim->error);
	for (size_t k = 0; k < m->n; k++)
		if (ts_streq(m->value[k].name, v.name) && !v.partner == !m->value[k].partner &&
		    (!v.partner || ts_streq(v.partner, m->value[k].partner)))
			return ts_fail(&sim->error, TS_SYNTAX, &name->place, "material: '%s' is given twice",
				       name->text);
	m->value[m->n++] = v;
	return TS_OK;
}

/* Parses the sequence of NAME [with OTHER] value unit. */
static enum ts_status parse_values(struct tsim *sim, struct ts_material *m, struct ts_words words)
{
	for (size_t k = 0; k < words.n;) {
		const struct ts_word *name = &words.word[k++], *partner = NULL;
		double value;

		if (k + 1 < words.n && ts_streq(words.word[k].text, "with")) {
			partner = &words.word[k + 1];
			k += 2;
		}
		if (k + 1 >= words.n)
			return ts_fail(&sim->error, TS_SYNTAX, &name->place,
				       "material: expected a value and its unit (1: none) after '%s'",
				       name->text);
		TS_TRY(read_value(sim, &words.word[k], &words.word[k + 1], &value));
		TS_TRY(add_value(sim, m, name, partner, value));
		k += 2;
	}
	return TS_OK;
}

/* The material of "potentials/glass.material" is glass. */
static enum ts_status set_name(struct tsim *sim, struct ts_material *m, const char *file)
{
	const char *base = strrchr(file, '/');
	char name[64];

	snprintf(name, sizeof name, "%s", base ? base + 1 : file);
	if (ts_ends_with(name, ".material"))
		name[strlen(name) - strlen(".material")] = '\0';
	m->name = ts_pool_get(sim->pool, name);
	return m->name ? TS_OK : ts_nomem(&sim->error);
}

static void release_material(struct ts_material *m)
{
	ts_free(m->value);
	*m = (struct ts_material){ 0 };
}

enum ts_status ts_material_read(struct tsim *sim, int type, const struct ts_word *file)
{
	struct ts_materials *all = sim->materials;
	struct ts_material m = { 0 };
	struct ts_arena arena = { 0 };
	struct ts_words words;
	enum ts_status status = TS_GROW(all->of, all->n, (size_t)type + 1);

	if (status != TS_OK)
		return ts_nomem(&sim->error);
	status = ts_coeff_words(sim, file, ".material", &arena, &words);
	if (status == TS_OK)
		status = set_name(sim, &m, file->text);
	if (status == TS_OK)
		status = parse_values(sim, &m, words);
	ts_arena_release(&arena);
	if (status != TS_OK) {
		release_material(&m);
		return status;
	}
	release_material(&all->of[type]);
	all->of[type] = m;
	return TS_OK;
}

static const struct ts_material *material_of(const struct tsim *sim, int type)
{
	static const struct ts_material none;
	const struct ts_materials *all = sim->materials;

	return type > 0 && (size_t)type < all->n ? &all->of[type] : &none;
}

static const struct ts_material_value *value_of(const struct ts_material *m, const char *name,
						const char *partner)
{
	for (size_t k = 0; k < m->n; k++) {
		const struct ts_material_value *v = &m->value[k];

		if (ts_streq(v->name, name) && !v->partner == !partner &&
		    (!partner || ts_streq(v->partner, partner)))
			return v;
	}
	return NULL;
}

/* Value that the file of `m` gives for the pair with the other material. */
static const struct ts_material_value *value_with(const struct ts_material *m, const char *name,
						  const struct ts_material *other)
{
	return other->name ? value_of(m, name, other->name) : NULL;
}

static enum ts_status check_agreement(struct tsim *sim, const struct ts_material_value *one,
				      const struct ts_material_value *other)
{
	if (!one || !other || !(one->value < other->value || one->value > other->value))
		return TS_OK;
	return ts_fail(&sim->error, TS_RANGE, &one->where,
		       "material: %s with %s is %g here, but %g in the other file (line %d)", one->name,
		       one->partner, one->value, other->value, other->where.line);
}

/* Warns once per pair that no value was given for this pair. */
static enum ts_status warn_about_mean(struct tsim *sim, const struct ts_material *a,
				      const struct ts_material *b, const struct ts_material_value *own,
				      double mean)
{
	struct ts_map *warned = &sim->materials->warned;
	bool turn = strcmp(a->name, b->name) > 0;
	struct ts_str key = { 0 };
	const char *pooled;

	ts_str_addf(&key, "%s of %s with %s", own->name, turn ? b->name : a->name, turn ? a->name : b->name);
	pooled = key.failed ? NULL : ts_pool_get(sim->pool, ts_str_text(&key));
	ts_str_release(&key);
	if (!pooled)
		return ts_nomem(&sim->error);
	if (ts_map_get(warned, pooled))
		return TS_OK;
	ts_warn(&sim->log, &own->where,
		"material: no file gives %s; the mean of both materials, %g, is used. A line `%s with %s "
		"VALUE 1` in a file, or fix property/global, sets the measured value",
		pooled, mean, own->name, b->name);
	return ts_map_set(warned, pooled, warned) == TS_OK ? TS_OK : ts_nomem(&sim->error);
}

enum ts_status ts_material_find(struct tsim *sim, const char *name, int a, int b, bool *found, double *out)
{
	const struct ts_material *ma = material_of(sim, a), *mb = material_of(sim, b);
	const struct ts_material_value *own = value_of(ma, name, NULL), *others = own;
	const struct ts_material_value *mutual[2] = { NULL, NULL };

	if (b > 0) {
		mutual[0] = value_with(ma, name, mb);
		mutual[1] = value_with(mb, name, ma);
		TS_TRY(check_agreement(sim, mutual[0], mutual[1]));
		others = value_of(mb, name, NULL);
	}
	*found = mutual[0] || mutual[1] || (own && others);
	if (mutual[0] || mutual[1])
		*out = mutual[mutual[0] ? 0 : 1]->value;
	else if (*found)
		*out = 0.5 * (own->value + others->value);
	if (*found && !mutual[0] && !mutual[1] && b > 0 && ma->name && mb->name &&
	    !ts_streq(ma->name, mb->name))
		return warn_about_mean(sim, ma, mb, own, *out);
	return TS_OK;
}

const char *ts_material_name(const struct tsim *sim, int type)
{
	return material_of(sim, type)->name;
}

const struct ts_place *ts_material_place(const struct tsim *sim, const char *name, int a, int b)
{
	const struct ts_material *ma = material_of(sim, a), *mb = material_of(sim, b);
	const struct ts_material_value *v = b > 0 ? value_with(ma, name, mb) : NULL;

	if (!v && b > 0)
		v = value_with(mb, name, ma);
	if (!v)
		v = value_of(ma, name, NULL);
	return v ? &v->where : NULL;
}

bool ts_material_given(const struct tsim *sim, const char *name)
{
	const struct ts_materials *all = sim->materials;

	for (size_t t = 0; t < all->n; t++)
		for (size_t k = 0; k < all->of[t].n; k++)
			if (ts_streq(all->of[t].value[k].name, name))
				return true;
	return false;
}

void ts_materials_fingerprint(const struct ts_materials *m, struct ts_hash *hash)
{
	for (size_t t = 0; t < m->n; t++)
		for (size_t k = 0; k < m->of[t].n; k++)
			ts_hash_add(hash, &m->of[t].value[k].value, sizeof(double));
}

void ts_materials_release(struct ts_materials *m)
{
	for (size_t t = 0; t < m->n; t++)
		release_material(&m->of[t]);
	ts_free(m->of);
	ts_map_release(&m->warned);
	*m = (struct ts_materials){ 0 };
}
