/* Fix property/global: a material property. */
#include "material/property.h"

#include <math.h>

#include "base/banned.h"

struct state {
	struct ts_property property;
	struct ts_words words;
};

static enum ts_status read_number(struct tsim *sim, const struct ts_word *word, double *out)
{
	if (ts_parse_real(word->text, out) && isfinite(*out))
		return TS_OK;
	return ts_fail(&sim->error, TS_SYNTAX, &word->place,
		       "fix property/global: expected a number, found '%s'", word->text);
}

static enum ts_status refuse_pairs(struct tsim *sim, const struct state *s, size_t found)
{
	const size_t types = s->property.columns;

	return ts_fail(&sim->error, TS_SYNTAX, &s->words.word[0].place,
		       "fix property/global %s: %zu types make %zu pairs, found %zu values", s->property.name,
		       types, types * types, found);
}

/* peratomtypepair and matrix start with the number of columns. */
static enum ts_status read_columns(struct tsim *sim, struct state *s, struct ts_words *values)
{
	int64_t columns;

	if (!values->n || !ts_parse_int(values->word[0].text, &columns) || columns < 1)
		return ts_fail(&sim->error, TS_SYNTAX, &s->words.word[0].place,
			       "fix property/global %s: expected the number of types first",
			       s->property.name);
	*values = ts_words_from(*values, 1);
	s->property.columns = (size_t)columns;
	if (s->property.kind == TS_PROPERTY_PAIR && values->n != (size_t)columns * (size_t)columns)
		return refuse_pairs(sim, s, values->n);
	if (!values->n || values->n % (size_t)columns)
		return ts_fail(&sim->error, TS_SYNTAX, &s->words.word[0].place,
			       "fix property/global %s: %zu values are not a multiple of %zu",
			       s->property.name, values->n, s->property.columns);
	return TS_OK;
}

static enum ts_status check_symmetry(struct tsim *sim, const struct state *s)
{
	const struct ts_property *p = &s->property;

	if (p->kind != TS_PROPERTY_PAIR)
		return TS_OK;
	for (size_t a = 0; a < p->columns; a++)
		for (size_t b = 0; b < a; b++)
			if (fabs(p->value[a * p->columns + b] - p->value[b * p->columns + a]) > 0)
				return ts_fail(&sim->error, TS_RANGE,
					       &s->words.word[1 + a * p->columns + b].place,
					       "fix property/global %s: the value of types %zu and %zu must "
					       "be that of types %zu and %zu",
					       p->name, a + 1, b + 1, b + 1, a + 1);
	return TS_OK;
}

static enum ts_status refuse_duplicate(struct ts_instance *self, struct tsim *sim)
{
	const struct state *s = self->state;
	const struct ts_instance *by = NULL;

	if (!ts_property_find(sim, s->property.name, &by) || ts_streq(by->id, self->id))
		return TS_OK;
	return ts_fail(&sim->error, TS_STATE, ts_instance_word(self, s->property.name),
		       "fix property/global: %s is given by fix %s already; use its ID to redefine it",
		       s->property.name, by->id);
}

/* Names of kinds that LIGGGHTS has, too. */
enum { OTHER_TYPE = TS_PROPERTY_MATRIX + 1, OTHER_PAIR };

static int usual_kind(int kind)
{
	return kind == OTHER_TYPE ? TS_PROPERTY_TYPE : kind == OTHER_PAIR ? TS_PROPERTY_PAIR : kind;
}

static enum ts_status parse_values(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	struct ts_property *p = &s->property;
	struct ts_words values = s->words;

	TS_TRY(refuse_duplicate(self, sim));
	p->kind = usual_kind(p->kind);
	p->columns = 1;
	if (p->kind >= TS_PROPERTY_PAIR)
		TS_TRY(read_columns(sim, s, &values));
	if (p->kind == TS_PROPERTY_SCALAR && values.n != 1)
		return ts_fail(&sim->error, TS_SYNTAX, &s->words.word[values.n ? 1 : 0].place,
			       "fix property/global %s: a scalar has one value", p->name);
	p->n = values.n;
	if (!p->value)
		p->value = ts_arena_alloc(&self->arena, values.n, sizeof *p->value);
	if (!p->value)
		return ts_nomem(&sim->error);
	for (size_t k = 0; k < values.n; k++)
		TS_TRY(read_number(sim, &values.word[k], &p->value[k]));
	return check_symmetry(sim, s);
}

static void fingerprint(const struct ts_instance *self, const struct tsim *sim, struct ts_hash *hash)
{
	const struct ts_property *p = self->state;

	(void)sim;
	ts_hash_text(hash, p->name);
	ts_hash_add(hash, p->value, p->n * sizeof *p->value);
}

static enum ts_status eval_scalar(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct ts_property *p = self->state;

	(void)sim;
	out->data[0] = p->value[0];
	return TS_OK;
}

static enum ts_status eval_vector(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct ts_property *p = self->state;

	(void)sim;
	if (ts_table_resize(out, 1, p->n) != TS_OK)
		return TS_NOMEM;
	for (size_t k = 0; k < p->n; k++)
		out->data[k] = p->value[k];
	return TS_OK;
}

static const struct ts_value values[] = {
	{ .name = "first", .unit = "", .help = "first value", .shape = TS_SCALAR, .eval = eval_scalar },
	{ .name = "all",
	  .unit = "",
	  .help = "all values, row by row",
	  .shape = TS_VECTOR,
	  .eval = eval_vector },
	{ .name = NULL },
};

static const struct ts_arg list_rows[] = {
	TS_REST("values", struct state, words, .help = "numbers"),
	TS_ARGS_END,
};
static const struct ts_arg matrix_rows[] = {
	TS_REST("values", struct state, words,
		.help = "number of types N, then N rows of N numbers; peratomtypepair must be symmetric"),
	TS_ARGS_END,
};
/* In the order of enum ts_property_kind, then OTHER_TYPE and OTHER_PAIR. */
static const struct ts_mode kinds[] = {
	{ "scalar", "one number", list_rows },
	{ "vector", "a list of numbers", list_rows },
	{ "peratomtype", "one number per atom type", list_rows },
	{ "peratomtypepair", "one number per pair of atom types", matrix_rows },
	{ "matrix", "a matrix of numbers", matrix_rows },
	{ "atomtype", "the same as peratomtype", list_rows },
	{ "atomtypepair", "the same as peratomtypepair", matrix_rows },
	{ .name = NULL },
};

static const struct ts_arg args[] = {
	TS_WORD("name", struct state, property.name, .flags = TS_POSITIONAL,
		.help = "name of the property: youngsModulus, coefficientFriction ..., or any other name"),
	TS_MODE("kind", struct state, property.kind, kinds, .help = "what the values refer to"),
	TS_ARGS_END,
};

TS_STYLE(fix, ts_style, ts_fix_property_global)
const struct ts_style ts_fix_property_global = {
	.name = "property/global",
	.kind = TS_KIND_FIX,
	.ranks = TS_RANKS_WHOLE | TS_RANKS_ROWLESS,
	.summary = "defines a material property by name",
	.doc = "Defines material properties for contact laws by atom type: youngsModulus and poissonsRatio "
	       "per type; coefficientRestitution, coefficientFriction and others per pair of types. The "
	       "manual page of each law lists the properties it requires. Other names can be used freely in "
	       "scripts. The scalar f_ID is the first value, the vector f_ID[k] are all values, row by row. "
	       "To change a property, define the fix with the same ID again.",
	.example = "fix m1 all property/global youngsModulus peratomtype 5.0e6 8.7e9\n"
		   "fix m2 all property/global coefficientFriction peratomtypepair 2 0.5 0.3 0.3 0.4\n"
		   "fix m3 all property/global characteristicVelocity scalar 2.0",
	.args = args,
	.state_size = sizeof(struct state),
	.fingerprint = fingerprint,
	.values = values,
	.init = parse_values,
};
