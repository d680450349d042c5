#include "core/ref_list.h"

#include <string.h>

#include "core/sim.h"
#include "core/unsupported_names.h"

#include "base/banned.h"

static const struct {
	enum ts_shape shape;
	const char *text;
} preference[] = {
	{ TS_PERATOM, "numbers of particles" },
	{ TS_SURFACE, "rows of triangles" },
	{ TS_LOCAL, "rows of contacts, bonds or triangles" },
	{ TS_ARRAY, "an array" },
	{ TS_VECTOR, "a vector" },
	{ TS_SCALAR, "a single number" },
};
enum { NSHAPES = sizeof preference / sizeof *preference };

static void append_shapes(unsigned shapes, struct ts_str *out)
{
	for (int k = 0; k < NSHAPES; k++)
		if (shapes & 1u << preference[k].shape)
			ts_str_addf(out, "%s%s", out->length ? " or " : "", preference[k].text);
}

static const char *hint_for_shapes(unsigned found, unsigned shapes, const struct ts_ref *ref)
{
	if (shapes & TS_WANT(SCALAR) && found & TS_WANT(VECTOR))
		return "; choose an element with [k]";
	if (shapes & TS_WANT(VECTOR) && found & TS_WANT(ARRAY))
		return "; choose a column with [k]";
	return ref->index ? "; is the index right?" : "";
}

static enum ts_status fail_wrong_shape(struct tsim *sim, const char *what, unsigned found, unsigned shapes,
				       const struct ts_ref_input *input)
{
	struct ts_str has = { 0 }, wanted = { 0 };
	enum ts_status status;

	append_shapes(found, &has);
	append_shapes(shapes, &wanted);
	status = ts_fail(&sim->error, TS_STATE, &input->where, "%s: '%s' is %s, expected %s%s", what,
			 input->name, has.length ? has.text : "no output", ts_str_text(&wanted),
			 hint_for_shapes(found, shapes, &input->ref));
	ts_str_release(&has);
	ts_str_release(&wanted);
	return status;
}

/* Where values of particles or local rows are expected, a bare name is a quantity, not a thermo keyword. */
static enum ts_status fail_unknown_quantity(struct tsim *sim, const char *what, unsigned shapes,
					    const struct ts_ref_input *input)
{
	struct ts_suggest suggest = ts_suggest_start(input->name);
	const char *remark = ts_unsupported_word_remark(TS_UNSUPPORTED_QUANTITY, input->name);

	if (remark && shapes & TS_WANT(PERATOM))
		return ts_fail(&sim->error, TS_UNKNOWN, &input->where,
			       "%s: quantity '%s' is known, but tsim does not have it: %s", what, input->name,
			       remark);
	if (shapes & TS_WANT(PERATOM))
		ts_quantity_suggest(sim, &suggest);
	return ts_fail(&sim->error, TS_UNKNOWN, &input->where,
		       "%s: unknown quantity '%s', expected %sc_ID[k], f_ID[k]%s%s", what, input->name,
		       shapes & TS_WANT(PERATOM) ? "a quantity of particles, " : "",
		       shapes & TS_WANT(PERATOM) ? " or v_NAME" : "", ts_suggest_text(&suggest));
}

/* Rows of several columns need an index. */
static enum ts_status require_column(struct tsim *sim, const char *what, const struct ts_ref_input *input)
{
	const struct ts_instance *inst = input->ref.inst;
	const struct ts_value *value = inst && !input->ref.index ? ts_value_find(inst, input->shape) : NULL;
	size_t columns = value ? ts_value_width(inst, value) : 0;

	if (columns <= 1 || !((TS_WANT(PERATOM) | TS_WANT(LOCAL) | TS_WANT(SURFACE)) & 1u << input->shape))
		return TS_OK;
	return ts_fail(&sim->error, TS_SYNTAX, &input->where, "%s: '%s' has %zu columns, choose one with [k]",
		       what, input->name, columns);
}

static bool is_reference(const char *name)
{
	return name[0] && strchr("cfv", name[0]) && name[1] == '_';
}

enum ts_status ts_ref_input_resolve(struct tsim *sim, const char *what, unsigned shapes,
				    struct ts_ref_input *input)
{
	unsigned found = TS_WANT(PERATOM);

	input->quantity = shapes & TS_WANT(PERATOM) && ts_quantity_has(sim, input->name);
	if (!input->quantity && shapes & (TS_WANT(PERATOM) | TS_WANT(LOCAL) | TS_WANT(SURFACE)) &&
	    !is_reference(input->name))
		return fail_unknown_quantity(sim, what, shapes, input);
	if (!input->quantity) {
		TS_TRY(ts_ref_resolve(sim, input->name, &input->where, &input->ref));
		TS_TRY(ts_ref_check_index(sim, &input->ref, shapes, &input->where));
		found = ts_ref_shapes(sim, &input->ref);
	}
	for (int k = 0; k < NSHAPES; k++) {
		input->shape = preference[k].shape;
		if (found & shapes & 1u << input->shape)
			return input->quantity ? TS_OK : require_column(sim, what, input);
	}
	return fail_wrong_shape(sim, what, found, shapes, input);
}

/* A name with a `*` in its last brackets, split into head[lo*hi]. */
struct wildcard {
	char head[128];
	int64_t lo, hi; /* hi == 0: up to the last */
};

static bool read_bound(const char *from, const char *to, int64_t *bound)
{
	char digits[16] = "";
	size_t n = (size_t)(to - from);

	if (n == 0)
		return true;
	if (n >= sizeof digits)
		return false;
	memcpy(digits, from, n);
	return ts_parse_int(digits, bound) && *bound >= 1;
}

static bool parse_wildcard(const char *name, struct wildcard *w)
{
	const char *star = strchr(name, '*'), *open = star, *close = star ? strchr(star, ']') : NULL;

	while (open && open > name && *open != '[')
		open--;
	if (!close || close[1] || *open != '[' || (size_t)(open - name) >= sizeof w->head)
		return false;
	*w = (struct wildcard){ .lo = 1 };
	memcpy(w->head, name, (size_t)(open - name));
	return read_bound(open + 1, star, &w->lo) && read_bound(star + 1, close, &w->hi);
}

/* The number of columns or elements over which the `*` ranges: those of an output from which [k] selects
 * one of the accepted shapes. */
static enum ts_status count_wildcard(struct tsim *sim, const struct ts_ref_input *input, unsigned shapes,
				     size_t *n)
{
	static const struct {
		enum ts_shape whole, part;
		bool second; /* the `*` is the second of two indices */
	} parts[] = { { TS_PERATOM, TS_PERATOM, false }, { TS_SURFACE, TS_SURFACE, false },
		      { TS_LOCAL, TS_LOCAL, false },	 { TS_ARRAY, TS_VECTOR, false },
		      { TS_ARRAY, TS_SCALAR, true },	 { TS_VECTOR, TS_SCALAR, false } };

	for (size_t k = 0; input->ref.inst && k < sizeof parts / sizeof *parts; k++) {
		const struct ts_value *value = ts_value_find(input->ref.inst, parts[k].whole);
		struct ts_table *table = &input->ref.inst->table;

		if (!value || !(shapes & 1u << parts[k].part) || parts[k].second != (input->ref.index != 0))
			continue;
		*n = ts_value_width(input->ref.inst, value);
		if (*n)
			return TS_OK;
		TS_TRY(ts_value_cached(input->ref.inst, sim, value));
		*n = parts[k].whole == TS_VECTOR ? table->rows * table->columns : table->columns;
		return TS_OK;
	}
	*n = input->ref.inst ? 0 : ts_ref_standard_elements(sim, input->name);
	if (*n && shapes & 1u << TS_SCALAR)
		return TS_OK;
	return ts_fail(&sim->error, TS_STATE, &input->where, "'%s': there are no elements or columns for *",
		       input->name);
}

/* Of names that stand for all columns of an array: TS_WANT_COLUMNS. */
static bool names_all_columns(struct tsim *sim, const struct ts_word *word, unsigned shapes)
{
	struct ts_ref ref;
	unsigned found;

	if (!(shapes & TS_WANT_COLUMNS) || !is_reference(word->text) || strchr(word->text, '['))
		return false;
	if (ts_ref_resolve(sim, word->text, &word->place, &ref) != TS_OK) {
		ts_error_clear(&sim->error); /* told when it is used */
		return false;
	}
	found = ts_ref_shapes(sim, &ref);
	return found & TS_WANT(ARRAY) && !(found & TS_WANT(VECTOR));
}

/* Appends the names that a word expands to (list NULL: only counts them). */
static enum ts_status expand_word(struct tsim *sim, struct ts_arena *arena, const struct ts_word *word,
				  unsigned shapes, struct ts_word *list, size_t *n)
{
	struct ts_ref_input whole = { .where = word->place };
	struct wildcard w;
	size_t count = 0;

	if (names_all_columns(sim, word, shapes)) {
		w = (struct wildcard){ .lo = 1 };
		snprintf(w.head, sizeof w.head, "%s", word->text);
	} else if (!parse_wildcard(word->text, &w)) {
		if (list)
			list[*n] = *word;
		++*n;
		return TS_OK;
	}
	whole.name = w.head;
	TS_TRY(ts_ref_resolve(sim, w.head, &word->place, &whole.ref));
	TS_TRY(count_wildcard(sim, &whole, shapes, &count));
	if (w.hi > (int64_t)count || w.lo > (w.hi ? w.hi : (int64_t)count))
		return ts_fail(&sim->error, TS_RANGE, &word->place, "'%s': '%s' has %zu", word->text, w.head,
			       count);
	for (int64_t k = w.lo; k <= (w.hi ? w.hi : (int64_t)count); k++, ++*n) {
		struct ts_str name = { 0 };

		if (!list)
			continue;
		ts_str_addf(&name, "%s[%lld]", w.head, (long long)k);
		list[*n] = *word;
		list[*n].text = name.failed ? NULL : ts_arena_strdup(arena, ts_str_text(&name));
		ts_str_release(&name);
		if (!list[*n].text)
			return ts_nomem(&sim->error);
	}
	return TS_OK;
}

enum ts_status ts_refs_expand(struct tsim *sim, struct ts_arena *arena, struct ts_words words,
			      unsigned shapes, struct ts_words *out)
{
	struct ts_word *list;
	size_t n = 0, filled = 0;

	for (size_t k = 0; k < words.n; k++)
		TS_TRY(expand_word(sim, arena, &words.word[k], shapes, NULL, &n));
	list = ts_arena_alloc(arena, n + 1, sizeof *list);
	if (!list)
		return ts_nomem(&sim->error);
	for (size_t k = 0; k < words.n; k++)
		TS_TRY(expand_word(sim, arena, &words.word[k], shapes, list, &filled));
	if (ts_words_copy(arena, (struct ts_words){ list, n }, out) != TS_OK)
		return ts_nomem(&sim->error);
	return TS_OK;
}

enum ts_status ts_ref_list_init(struct tsim *sim, const char *what, struct ts_arena *arena,
				struct ts_words words, unsigned shapes, struct ts_ref_list *list)
{
	if (!list->item) {
		struct ts_words expanded;
		struct ts_ref_input *item;

		TS_TRY(ts_refs_expand(sim, arena, words, shapes, &expanded));
		item = ts_arena_alloc(arena, expanded.n, sizeof *item);
		if (!item)
			return ts_nomem(&sim->error);
		for (size_t k = 0; k < expanded.n; k++) {
			item[k].name = expanded.word[k].text;
			item[k].where = expanded.word[k].place;
		}
		list->item = item;
		list->n = expanded.n;
	}
	for (size_t k = 0; k < list->n; k++)
		TS_TRY(ts_ref_input_resolve(sim, what, shapes & ~TS_WANT_COLUMNS, &list->item[k]));
	return TS_OK;
}

static const struct ts_place *place_of_variable(const struct ts_instance *inst, const char *name)
{
	for (size_t k = 0; k < inst->words.n; k++)
		if (strncmp(inst->words.word[k].text, "v_", 2) == 0 &&
		    ts_streq(inst->words.word[k].text + 2, name))
			return &inst->words.word[k].place;
	return &inst->where;
}

/* Checks that variables of arguments which are numbers can be such numbers. */
static enum ts_status check_numbers(struct tsim *sim, const struct ts_instance *inst,
				    const struct ts_arg *rows)
{
	for (const struct ts_arg *row = rows; row && row->type != TS_ARG_END; row++) {
		const void *field = (const char *)inst->state + row->offset;
		const struct ts_number *number = row->type == TS_ARG_NUMBER ? field : NULL;
		const int mode = row->type == TS_ARG_MODE ? *(const int *)field : -1;

		if (mode >= 0)
			TS_TRY(check_numbers(sim, inst, row->modes[mode].args));
		if (!number || !number->variable ||
		    !sim->script_api->has_variable(sim->script_api_data, number->variable) ||
		    (row->flags & TS_EACH &&
		     sim->script_api->is_peratom(sim->script_api_data, number->variable)))
			continue;
		TS_TRY(ts_number_check(sim, number, place_of_variable(inst, number->variable)));
	}
	return TS_OK;
}

enum ts_status ts_refs_check(struct tsim *sim, const struct ts_instance *inst)
{
	enum ts_kind kind = inst->style->kind;

	if (kind != TS_KIND_FIX && kind != TS_KIND_COMPUTE && kind != TS_KIND_DUMP)
		return TS_OK;
	TS_TRY(check_numbers(sim, inst, inst->style->args));
	for (size_t k = 0; k < inst->words.n; k++) {
		const struct ts_word *word = &inst->words.word[k];
		const char *name = word->text + 2;
		enum ts_shape shape;

		if (strncmp(word->text, "v_", 2) != 0 ||
		    !sim->script_api->has_variable(sim->script_api_data, name))
			continue;
		shape = sim->script_api->is_peratom(sim->script_api_data, name)	 ? TS_PERATOM
			: sim->script_api->is_vector(sim->script_api_data, name) ? TS_VECTOR
										 : TS_SCALAR;
		TS_TRY(sim->script_api->check_variable(sim->script_api_data, name, shape, &word->place));
	}
	return TS_OK;
}

void ts_ref_list_release(struct ts_ref_list *list)
{
	ts_table_release(&list->column);
	list->n = 0; /* the arena owns the items */
}

enum ts_status ts_ref_input_scalar(struct tsim *sim, const struct ts_ref_input *input, double *out)
{
	return ts_ref_scalar(sim, &input->ref, &input->where, out);
}

enum ts_status ts_ref_input_eval(struct tsim *sim, const struct ts_ref_input *input, struct ts_table *out)
{
	const struct ts_value *array;

	if (input->quantity)
		return ts_quantity_eval(sim, input->name, out);
	switch (input->shape) {
	case TS_SCALAR:
		if (ts_table_resize(out, 1, 1) != TS_OK)
			return ts_nomem(&sim->error);
		return ts_ref_scalar(sim, &input->ref, &input->where, out->data);
	case TS_VECTOR:
		TS_TRY(ts_ref_vector(sim, &input->ref, &input->where, out));
		out->rows *= out->columns;
		out->columns = 1;
		return TS_OK;
	case TS_PERATOM:
		return ts_ref_peratom(sim, &input->ref, &input->where, out);
	case TS_LOCAL:
	case TS_SURFACE:
		return ts_ref_local(sim, &input->ref, &input->where, out);
	case TS_ARRAY:
		break;
	}
	array = ts_value_find(input->ref.inst, TS_ARRAY);
	return ts_value_eval(input->ref.inst, sim, array, out);
}

enum ts_status ts_ref_list_scalars(struct tsim *sim, const struct ts_ref_list *list, double *out)
{
	for (size_t k = 0; k < list->n; k++)
		TS_TRY(ts_ref_input_scalar(sim, &list->item[k], &out[k]));
	return TS_OK;
}

enum ts_status ts_ref_list_table(struct tsim *sim, struct ts_ref_list *list, struct ts_table *out)
{
	struct ts_table *column = &list->column;

	for (size_t k = 0; k < list->n; k++) {
		TS_TRY(ts_ref_input_eval(sim, &list->item[k], column));
		if (k == 0 && ts_table_resize(out, column->rows, list->n) != TS_OK)
			return ts_nomem(&sim->error);
		if (column->rows != out->rows)
			return ts_fail(&sim->error, TS_STATE, &list->item[k].where,
				       "'%s' has %zu elements, but '%s' has %zu", list->item[k].name,
				       column->rows, list->item[0].name, out->rows);
		for (size_t i = 0; i < out->rows; i++)
			out->data[i * list->n + k] = column->data[i];
	}
	return TS_OK;
}
