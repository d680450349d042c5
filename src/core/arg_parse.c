/* Parses the words of a line into the state of a style, according to its argument table. */
#include "core/arg_read.h"
#include "core/unsupported_names.h"

#include <string.h>

#include "base/banned.h"

static bool matches_name(const struct ts_arg *row, const char *name)
{
	size_t n;

	if (!(row->flags & TS_NAMED) || !ts_ends_with(row->name, "NAME"))
		return ts_streq(row->name, name);
	n = strlen(row->name) - strlen("NAME");
	return strncmp(row->name, name, n) == 0 && name[n];
}

static const struct ts_arg *find_keyword(const struct ts_arg *rows, const char *name)
{
	for (; rows && rows->type != TS_ARG_END; rows++)
		if (!(rows->flags & TS_POSITIONAL) && matches_name(rows, name))
			return rows;
	return NULL;
}

/* The number of words that the row `count` announces; 0 if that was not given. */
static size_t words_counted_by_row(const struct ts_arg *row, const struct ts_words *out,
				   const struct ts_arg *common)
{
	const struct ts_arg *count = find_keyword(common, row->count);
	const char *state = (const char *)out - row->offset;
	int64_t n = count ? *(const int64_t *)(state + count->offset) : 0;

	return n > 0 ? (size_t)n : 0;
}

static bool is_choice_of(const struct ts_arg *row, const char *text)
{
	for (int k = 0; row->choices && row->choices[k]; k++)
		if (ts_streq(row->choices[k], text))
			return true;
	for (int k = 0; row->modes && row->modes[k].name; k++)
		if (ts_streq(row->modes[k].name, text))
			return true;
	return false;
}

/* Whether the text is a keyword of the table, or a choice of one of its rows. */
static bool is_keyword_or_choice(const struct ts_arg *rows, const char *text)
{
	for (; rows && rows->type != TS_ARG_END; rows++)
		if ((!(rows->flags & TS_POSITIONAL) && matches_name(rows, text)) || is_choice_of(rows, text))
			return true;
	return false;
}

static enum ts_status read_rest(struct ts_parse *p, const struct ts_arg *row, struct ts_words *out,
				const struct ts_arg *common)
{
	struct ts_words rest;
	/* words taken even if they are keywords */
	size_t least = row->least ? row->least : row->flags & TS_REPEAT ? 1 : 0;

	if (row->count)
		least = words_counted_by_row(row, out, common);
	if (row->flags & TS_NAMED) {
		p->next--;
		least++;
	}
	rest = ts_words_from(p->words, p->next);
	for (size_t k = least; k < rest.n && (row->flags & TS_TO_KEYWORD); k++)
		if (!is_keyword_or_choice(row->inner, rest.word[k].text) &&
		    (find_keyword(common, rest.word[k].text) || find_keyword(p->rows, rest.word[k].text)))
			rest.n = k;
	if (row->most && rest.n > row->most)
		rest.n = row->most;
	if ((!rest.n || rest.n < row->least) && !(row->flags & TS_OPTIONAL))
		return ts_arg_refuse(p, row, NULL, row->help);
	p->next += rest.n;
	if (!(row->flags & TS_REPEAT))
		out->n = 0;
	if (ts_words_append(p->arena, rest, out) != TS_OK)
		return ts_nomem(&p->sim->error);
	return TS_OK;
}

static enum ts_status read_arguments(struct ts_parse *p, const struct ts_arg *rows,
				     const struct ts_arg *common);

static enum ts_status read_mode(struct ts_parse *p, const struct ts_arg *row, int *out,
				const struct ts_arg *common)
{
	const struct ts_word *word = ts_arg_next_word(p);
	struct ts_suggest suggest = ts_suggest_start(word ? word->text : "");
	struct ts_str expected = { 0 };
	enum ts_status status;

	for (int k = 0; row->modes[k].name; k++) {
		if (word && ts_streq(word->text, row->modes[k].name)) {
			*out = k;
			ts_str_release(&expected);
			return read_arguments(p, row->modes[k].args, common);
		}
		ts_suggest_try(&suggest, row->modes[k].name);
		ts_str_addf(&expected, "%s%s", k ? ", " : "one of ", row->modes[k].name);
	}
	ts_str_add(&expected, word && suggest.best ? ts_suggest_text(&suggest) : "");
	status = ts_arg_refuse(p, row, word, ts_str_text(&expected));
	ts_str_release(&expected);
	return status;
}

static enum ts_status read_argument(struct ts_parse *p, const struct ts_arg *row, const struct ts_arg *common)
{
	void *field = p->base + row->offset;

	switch (row->type) {
	case TS_ARG_REAL:
		return ts_arg_read_real(p, row, field);
	case TS_ARG_INT:
		return ts_arg_read_int(p, row, field);
	case TS_ARG_BOOL:
		return ts_arg_read_bool(p, row, field);
	case TS_ARG_FLAG:
		*(bool *)field = true;
		return TS_OK;
	case TS_ARG_WORD:
	case TS_ARG_REF:
		return ts_arg_read_word(p, row, field);
	case TS_ARG_ENUM:
		return ts_arg_read_enum(p, row, field);
	case TS_ARG_VEC3:
		return ts_arg_read_vec3(p, row, field);
	case TS_ARG_COORD:
		return ts_arg_read_coord(p, row, field);
	case TS_ARG_NUMBER:
		return ts_arg_read_number(p, row, field);
	case TS_ARG_TYPES:
		return ts_arg_read_types(p, row, field);
	case TS_ARG_GROUP:
		return ts_arg_read_group(p, row, field);
	case TS_ARG_REGION:
		return ts_arg_read_region(p, row, field);
	case TS_ARG_MODE:
		return read_mode(p, row, field, common);
	case TS_ARG_REST:
		return read_rest(p, row, field, common);
	case TS_ARG_END:
		break;
	}
	return TS_OK;
}

static void suggest_keywords(const struct ts_arg *rows, struct ts_suggest *suggest)
{
	for (; rows && rows->type != TS_ARG_END; rows++)
		if (!(rows->flags & TS_POSITIONAL))
			ts_suggest_try(suggest, rows->name);
}

static enum ts_status fail_unknown_keyword(struct ts_parse *p, const struct ts_arg *rows,
					   const struct ts_arg *common, const struct ts_word *word)
{
	struct ts_suggest suggest = ts_suggest_start(word->text);
	const char *remark = ts_unsupported_word_remark(p->what, word->text);
	bool any = false;

	for (const struct ts_arg *r = rows; r && r->type != TS_ARG_END; r++)
		any |= !(r->flags & TS_POSITIONAL);
	for (const struct ts_arg *r = common; r && r->type != TS_ARG_END; r++)
		any |= !(r->flags & TS_POSITIONAL);
	if (!any)
		return ts_fail(&p->sim->error, TS_SYNTAX, &word->place,
			       "%s: unexpected '%s', the line should end before it", p->what, word->text);
	if (remark)
		return ts_fail(&p->sim->error, TS_UNKNOWN, &word->place,
			       "%s: keyword '%s' is known, but tsim does not have it: %s", p->what,
			       word->text, remark);
	suggest_keywords(rows, &suggest);
	suggest_keywords(common, &suggest);
	return ts_fail(&p->sim->error, TS_UNKNOWN, &word->place, "%s: unknown keyword '%s'%s", p->what,
		       word->text, ts_suggest_text(&suggest));
}

/* Whether the keyword is among the words that have been read as keywords before the present one. */
static bool is_given_before(const struct ts_parse *p, const char *name)
{
	for (size_t k = 0; k + 1 < p->next; k++)
		if (p->is_keyword[k] && ts_streq(p->words.word[k].text, name))
			return true;
	return false;
}

static enum ts_status read_keywords(struct ts_parse *p, const struct ts_arg *rows,
				    const struct ts_arg *common)
{
	const struct ts_word *word;

	if (!p->is_keyword)
		p->is_keyword = ts_arena_alloc(p->arena, p->words.n + 1, sizeof *p->is_keyword);
	if (!p->is_keyword)
		return ts_nomem(&p->sim->error);
	while ((word = ts_arg_next_word(p))) {
		const struct ts_arg *row = find_keyword(rows, word->text);

		if (!row)
			row = find_keyword(common, word->text);
		if (!row)
			return fail_unknown_keyword(p, rows, common, word);
		if (!(row->flags & TS_REPEAT) && is_given_before(p, word->text))
			return ts_fail(&p->sim->error, TS_SYNTAX, &word->place,
				       "%s: keyword '%s' is given twice", p->what, word->text);
		p->is_keyword[p->next - 1] = true;
		TS_TRY(read_argument(p, row, common ? common : rows));
	}
	return TS_OK;
}

static bool has_mode(const struct ts_arg *rows)
{
	for (; rows && rows->type != TS_ARG_END; rows++)
		if (rows->type == TS_ARG_MODE)
			return true;
	return false;
}

/* Whether the next word is a keyword; then optional positional arguments before it are absent. */
static bool at_keyword(const struct ts_parse *p, const struct ts_arg *rows, const struct ts_arg *common)
{
	const char *text = p->words.word[p->next].text;

	return find_keyword(rows, text) || find_keyword(common, text);
}

static enum ts_status read_arguments(struct ts_parse *p, const struct ts_arg *rows,
				     const struct ts_arg *common)
{
	p->rows = rows;
	for (const struct ts_arg *row = rows; row && row->type != TS_ARG_END; row++) {
		bool may_lack = (row->flags & TS_OPTIONAL) || row->fallback;

		if (!(row->flags & TS_POSITIONAL))
			continue;
		if (may_lack && (p->next == p->words.n || at_keyword(p, rows, common)))
			continue;
		TS_TRY(read_argument(p, row, common ? common : rows));
	}
	/* the rows of the mode have read the keywords of both levels */
	if (has_mode(rows) && p->next == p->words.n)
		return TS_OK;
	return read_keywords(p, rows, common);
}

/* Every keyword that has no default and is not optional must have been given. */
static enum ts_status check_required(struct ts_parse *p, const struct ts_arg *rows)
{
	for (const struct ts_arg *row = rows; row && row->type != TS_ARG_END; row++) {
		bool found = false;

		if ((row->flags & (TS_POSITIONAL | TS_OPTIONAL)) || row->fallback || row->type == TS_ARG_FLAG)
			continue;
		for (size_t k = 0; p->is_keyword && k < p->words.n; k++)
			found |= p->is_keyword[k] && ts_streq(p->words.word[k].text, row->name);
		if (!found)
			return ts_fail(&p->sim->error, TS_SYNTAX, p->where,
				       "%s: keyword '%s' is missing (%s)", p->what, row->name, row->help);
	}
	return TS_OK;
}

static void store_absent_value(const struct ts_arg *row, void *field)
{
	switch (row->type) {
	case TS_ARG_REAL:
	case TS_ARG_COORD:
		*(double *)field = NAN;
		break;
	case TS_ARG_VEC3:
		for (int d = 0; d < 3; d++)
			((double *)field)[d] = NAN;
		break;
	case TS_ARG_INT:
		*(int64_t *)field = INT64_MIN;
		break;
	case TS_ARG_ENUM:
	case TS_ARG_GROUP:
	case TS_ARG_MODE:
		*(int *)field = -1;
		break;
	case TS_ARG_NUMBER:
		*(struct ts_number *)field = (struct ts_number){ .null = true };
		break;
	default: /* the state is zeroed: NULL, false, {0} */
		break;
	}
}

static enum ts_status set_default(struct tsim *sim, const struct ts_arg *row, struct ts_arena *arena,
				  void *base)
{
	const struct ts_place nowhere = { .file = "default" };
	struct ts_parse p = { sim, "default", { NULL, 0 }, 0, &nowhere, arena, base, NULL, NULL };

	if (!row->fallback) {
		store_absent_value(row, (char *)base + row->offset);
		return TS_OK;
	}
	if (ts_words_split(arena, row->fallback, &nowhere, &p.words) != TS_OK)
		return ts_nomem(&sim->error);
	return read_argument(&p, row, NULL);
}

enum ts_status ts_args_defaults(struct tsim *sim, const struct ts_arg *rows, struct ts_arena *arena,
				void *base)
{
	for (const struct ts_arg *row = rows; row && row->type != TS_ARG_END; row++) {
		TS_TRY(set_default(sim, row, arena, base));
		for (const struct ts_mode *m = row->modes; m && m->name; m++)
			TS_TRY(ts_args_defaults(sim, m->args, arena, base));
	}
	return TS_OK;
}

enum ts_status ts_args_parse(struct tsim *sim, const char *what, const struct ts_arg *rows,
			     struct ts_words words, const struct ts_place *where, struct ts_arena *arena,
			     void *base)
{
	struct ts_parse p = { sim, what, words, 0, where, arena, base, NULL, NULL };

	TS_TRY(ts_args_defaults(sim, rows, arena, base));
	TS_TRY(read_arguments(&p, rows, NULL));
	TS_TRY(check_required(&p, rows));
	for (const struct ts_arg *row = rows; row && row->type != TS_ARG_END; row++)
		if (row->type == TS_ARG_MODE && *(int *)((char *)base + row->offset) >= 0)
			TS_TRY(check_required(&p, row->modes[*(int *)((char *)base + row->offset)].args));
	return TS_OK;
}

enum ts_status ts_number_check(struct tsim *sim, const struct ts_number *number, const struct ts_place *where)
{
	if (!number->variable)
		return TS_OK;
	return sim->script_api->check_variable(sim->script_api_data, number->variable, TS_SCALAR, where);
}

enum ts_status ts_number_now(struct tsim *sim, const struct ts_number *number, const struct ts_place *where,
			     double *out)
{
	if (number->variable)
		return sim->script_api->scalar(sim->script_api_data, number->variable, where, out);
	*out = number->value;
	return TS_OK;
}
