/* Reads the words of a line into a state, guided by argument rows. */
#include "core/arg.h"

#include <string.h>

#include "core/group.h"
#include "core/known.h"
#include "core/sim.h"

#include "base/banned.h"

/* The parse of one line. */
struct parse {
	struct tsim *sim;
	const char *what;
	struct ts_words words;
	size_t next; /* first word not yet read */
	const struct ts_place *where;
	struct ts_arena *arena;
	char *base;
	bool *is_keyword; /* by word */
	const struct ts_arg *rows; /* being read: those of the innermost mode */
};

static const struct ts_word *take(struct parse *p)
{
	return p->next < p->words.n ? &p->words.word[p->next++] : NULL;
}

static enum ts_status refuse(struct parse *p, const struct ts_arg *row, const struct ts_word *word,
			     const char *expected)
{
	const struct ts_place *where = p->where;
	char meaning[96] = "";

	/* choices explain themselves */
	if (row->help && strlen(row->help) < sizeof meaning - 8 && expected != row->help &&
	    row->type != TS_ARG_ENUM && row->type != TS_ARG_MODE)
		snprintf(meaning, sizeof meaning, " (%s)", row->help);
	if (word)
		return ts_fail(&p->sim->error, TS_SYNTAX, &word->place,
			       "%s: %s is '%s', expected %s%s", p->what, row->name, word->text,
			       expected, meaning);
	if (!(row->flags & TS_POSITIONAL) && p->words.n)
		where = &p->words.word[p->words.n - 1].place;
	return ts_fail(&p->sim->error, TS_SYNTAX, where,
		       row->flags & TS_POSITIONAL ? "%s: %s is missing, expected %s%s"
						  : "%s: keyword %s lacks its value, expected %s%s",
		       p->what, row->name, expected, meaning);
}

static enum ts_status check_range(struct parse *p, const struct ts_arg *row,
				  const struct ts_word *word, double value)
{
	bool ok = true;
	char expected[96];

	switch (row->range) {
	case TS_ANY:
		break;
	case TS_POSITIVE:
		ok = value > 0;
		snprintf(expected, sizeof expected, "a number > 0");
		break;
	case TS_NOT_NEGATIVE:
		ok = value >= 0;
		snprintf(expected, sizeof expected, "a number >= 0");
		break;
	case TS_FRACTION:
		ok = value >= 0 && value <= 1;
		snprintf(expected, sizeof expected, "a number from 0 to 1");
		break;
	case TS_WITHIN:
		ok = value >= row->lo && value <= row->hi;
		snprintf(expected, sizeof expected, "a number from %g to %g", row->lo, row->hi);
		break;
	}
	if (ok)
		return TS_OK;
	return ts_fail(&p->sim->error, TS_RANGE, &word->place, "%s: %s is %s, expected %s", p->what,
		       row->name, word->text, expected);
}

static enum ts_status read_real(struct parse *p, const struct ts_arg *row, double *out)
{
	const struct ts_word *word = take(p);

	if (!word || !ts_parse_real(word->text, out))
		return refuse(p, row, word, "a number");
	return check_range(p, row, word, *out);
}

static enum ts_status read_int(struct parse *p, const struct ts_arg *row, int64_t *out)
{
	const struct ts_word *word = take(p);

	if (!word || !ts_parse_int(word->text, out))
		return refuse(p, row, word, "an integer");
	return check_range(p, row, word, (double)*out);
}

static enum ts_status read_bool(struct parse *p, const struct ts_arg *row, bool *out)
{
	const struct ts_word *word = take(p);

	if (word && (ts_streq(word->text, "yes") || ts_streq(word->text, "on")))
		*out = true;
	else if (word && (ts_streq(word->text, "no") || ts_streq(word->text, "off")))
		*out = false;
	else
		return refuse(p, row, word, "yes or no");
	return TS_OK;
}

static enum ts_status read_word(struct parse *p, const struct ts_arg *row, const char **out)
{
	const struct ts_word *word = take(p);

	if (!word)
		return refuse(p, row, NULL, "a word");
	*out = ts_arena_strdup(p->arena, word->text);
	return *out ? TS_OK : ts_nomem(&p->sim->error);
}

static void list_choices(const char *const *choices, struct ts_str *out)
{
	for (size_t k = 0; choices[k]; k++)
		ts_str_addf(out, "%s%s", k ? ", " : "", choices[k]);
}

static enum ts_status read_enum(struct parse *p, const struct ts_arg *row, int *out)
{
	const struct ts_word *word = take(p);
	struct ts_suggest suggest = ts_suggest_start(word ? word->text : "");
	struct ts_str expected = { 0 };
	const char *remark = word ? ts_known_choice_remark(row->name, word->text) : NULL;
	enum ts_status status;

	for (int k = 0; word && row->choices[k]; k++) {
		if (ts_streq(word->text, row->choices[k])) {
			*out = k;
			return TS_OK;
		}
		ts_suggest_try(&suggest, row->choices[k]);
	}
	ts_str_add(&expected, "one of ");
	list_choices(row->choices, &expected);
	if (remark)
		ts_str_addf(&expected, "; that one is known, but tsim does not have it: %s", remark);
	else
		ts_str_add(&expected, word && suggest.best ? ts_suggest_text(&suggest) : "");
	status = refuse(p, row, word, ts_str_text(&expected));
	ts_str_release(&expected);
	return status;
}

static enum ts_status read_coord(struct parse *p, const struct ts_arg *row, double *out)
{
	const struct ts_word *word = take(p);
	bool low = ts_ends_with(row->name, "lo");

	if (word && (ts_streq(word->text, "INF") || ts_streq(word->text, "EDGE"))) {
		*out = ts_streq(word->text, "INF") ? INFINITY : TS_EDGE;
		*out = low ? -*out : *out;
		return TS_OK;
	}
	if (!word || !ts_parse_real(word->text, out))
		return refuse(p, row, word, "a number, INF or EDGE");
	return check_range(p, row, word, *out);
}

static enum ts_status read_number(struct parse *p, const struct ts_arg *row, struct ts_number *out)
{
	const struct ts_word *word = take(p);
	const struct ts_host *host = p->sim->host;
	struct ts_suggest suggest;

	*out = (struct ts_number){ .at = p->next };
	if (word && (row->flags & TS_NULLABLE) && ts_streq(word->text, "NULL")) {
		out->null = true;
		return TS_OK;
	}
	if (word && strncmp(word->text, "v_", 2) == 0) {
		suggest = ts_suggest_start(word->text + 2);
		if (p->sim->unreached)
			return TS_OK;
		if (!host || !host->has_variable(p->sim->host_data, word->text + 2)) {
			if (host)
				host->suggest_variable(p->sim->host_data, &suggest);
			return ts_missing(&p->sim->error, "variable", word->text + 2, &word->place,
					  "%s: %s names an unknown variable '%s'%s", p->what,
					  row->name, word->text + 2, ts_suggest_text(&suggest));
		}
		out->variable = ts_arena_strdup(p->arena, word->text + 2);
		return out->variable ? TS_OK : ts_nomem(&p->sim->error);
	}
	if (!word || !ts_parse_real(word->text, &out->value))
		return refuse(p, row, word,
			      row->flags & TS_NULLABLE ? "a number, v_name or NULL"
						       : "a number or v_name");
	return check_range(p, row, word, out->value);
}

/* n, *, n*, *m, n*m */
bool ts_parse_types(const char *text, struct ts_types *out)
{
	const char *star = strchr(text, '*');
	char head[24] = "";
	int64_t lo = 1, hi = 0;
	size_t n = star ? (size_t)(star - text) : strlen(text);

	if (n >= sizeof head)
		return false;
	memcpy(head, text, n);
	if (n && (!ts_parse_int(head, &lo) || lo < 1 || lo > INT32_MAX))
		return false;
	if (!star) {
		hi = lo;
		if (!n)
			return false;
	} else if (star[1] && (!ts_parse_int(star + 1, &hi) || hi < lo || hi > INT32_MAX)) {
		return false;
	}
	*out = (struct ts_types){ (int)lo, (int)hi };
	return true;
}

static enum ts_status read_types(struct parse *p, const struct ts_arg *row, struct ts_types *out)
{
	const struct ts_word *word = take(p);

	if (!word || !ts_parse_types(word->text, out))
		return refuse(p, row, word, "a type n or a range such as * or 1*3");
	return TS_OK;
}

static bool names_style(const char *name)
{
	return ts_style_find(TS_KIND_FIX, name) || ts_style_find(TS_KIND_COMPUTE, name) ||
	       ts_style_find(TS_KIND_DUMP, name);
}

static enum ts_status read_group(struct parse *p, const struct ts_arg *row, int *out)
{
	struct ts_error *error = &p->sim->error;
	enum ts_status status;
	char *tail;
	const struct ts_word *word = take(p);

	if (!word)
		return refuse(p, row, NULL, "the name of a group");
	if (p->sim->unreached) {
		*out = 0;
		return TS_OK;
	}
	status = ts_group_require(p->sim, word, out);
	if (status == TS_UNKNOWN && names_style(word->text)) {
		tail = error->message + strlen(error->message);
		snprintf(tail, sizeof error->message - (size_t)(tail - error->message),
			 "; '%s' is a style, the group stands before it", word->text);
	}
	return status;
}

static enum ts_status read_region(struct parse *p, const struct ts_arg *row,
				  struct ts_instance **out)
{
	const struct ts_word *word = take(p);

	*out = NULL;
	if (!word)
		return refuse(p, row, NULL, "the name of a region");
	if ((row->flags & TS_NULLABLE) && ts_streq(word->text, "NULL"))
		return TS_OK;
	if (p->sim->unreached)
		return TS_OK;
	return ts_sim_require(p->sim, TS_KIND_REGION, word, out);
}

static bool is_named(const struct ts_arg *row, const char *name)
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
		if (!(rows->flags & TS_POSITIONAL) && is_named(rows, name))
			return rows;
	return NULL;
}

/* How many words another row says there are. */
static size_t announced(const struct ts_arg *row, const struct ts_words *out, const struct ts_arg *common)
{
	const struct ts_arg *count = find_keyword(common, row->count);
	const char *state = (const char *)out - row->offset;
	int64_t n = count ? *(const int64_t *)(state + count->offset) : 0;

	return n > 0 ? (size_t)n : 0;
}

static enum ts_status read_rest(struct parse *p, const struct ts_arg *row, struct ts_words *out,
				const struct ts_arg *common)
{
	struct ts_words rest;
	size_t least = row->flags & TS_REPEAT ? 1 : 0; /* one word at least, whatever it is */

	if (row->count)
		least = announced(row, out, common);
	if (row->flags & TS_NAMED) {
		p->next--;
		least++;
	}
	rest = ts_words_from(p->words, p->next);
	for (size_t k = least; k < rest.n && (row->flags & TS_TO_KEYWORD); k++)
		if (find_keyword(common, rest.word[k].text) ||
		    find_keyword(p->rows, rest.word[k].text))
			rest.n = k;
	if (!rest.n && !(row->flags & TS_OPTIONAL))
		return refuse(p, row, NULL, row->help);
	p->next += rest.n;
	if (!(row->flags & TS_REPEAT))
		out->n = 0;
	if (ts_words_append(p->arena, rest, out) != TS_OK)
		return ts_nomem(&p->sim->error);
	return TS_OK;
}

static enum ts_status read_rows(struct parse *p, const struct ts_arg *rows,
				const struct ts_arg *common);

static enum ts_status read_mode(struct parse *p, const struct ts_arg *row, int *out,
				const struct ts_arg *common)
{
	const struct ts_word *word = take(p);
	struct ts_suggest suggest = ts_suggest_start(word ? word->text : "");
	struct ts_str expected = { 0 };
	enum ts_status status;

	for (int k = 0; row->modes[k].name; k++) {
		if (word && ts_streq(word->text, row->modes[k].name)) {
			*out = k;
			ts_str_release(&expected);
			return read_rows(p, row->modes[k].args, common);
		}
		ts_suggest_try(&suggest, row->modes[k].name);
		ts_str_addf(&expected, "%s%s", k ? ", " : "one of ", row->modes[k].name);
	}
	ts_str_add(&expected, word && suggest.best ? ts_suggest_text(&suggest) : "");
	status = refuse(p, row, word, ts_str_text(&expected));
	ts_str_release(&expected);
	return status;
}

static enum ts_status read_vec3(struct parse *p, const struct ts_arg *row, double out[3])
{
	static const char *const ordinals[] = { "first", "second", "third" };
	char expected[48];

	for (int d = 0; d < 3; d++) {
		const struct ts_word *word = take(p);

		snprintf(expected, sizeof expected, "the %s of three numbers", ordinals[d]);
		if (!word || !ts_parse_real(word->text, &out[d]))
			return refuse(p, row, word, expected);
		TS_TRY(check_range(p, row, word, out[d]));
	}
	return TS_OK;
}

static enum ts_status read_row(struct parse *p, const struct ts_arg *row,
			       const struct ts_arg *common)
{
	void *field = p->base + row->offset;

	switch (row->type) {
	case TS_ARG_REAL:
		return read_real(p, row, field);
	case TS_ARG_INT:
		return read_int(p, row, field);
	case TS_ARG_BOOL:
		return read_bool(p, row, field);
	case TS_ARG_FLAG:
		*(bool *)field = true;
		return TS_OK;
	case TS_ARG_WORD:
	case TS_ARG_REF:
		return read_word(p, row, field);
	case TS_ARG_ENUM:
		return read_enum(p, row, field);
	case TS_ARG_VEC3:
		return read_vec3(p, row, field);
	case TS_ARG_COORD:
		return read_coord(p, row, field);
	case TS_ARG_NUMBER:
		return read_number(p, row, field);
	case TS_ARG_TYPES:
		return read_types(p, row, field);
	case TS_ARG_GROUP:
		return read_group(p, row, field);
	case TS_ARG_REGION:
		return read_region(p, row, field);
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

static enum ts_status unknown_keyword(struct parse *p, const struct ts_arg *rows,
				      const struct ts_arg *common, const struct ts_word *word)
{
	struct ts_suggest suggest = ts_suggest_start(word->text);
	bool any = false;

	for (const struct ts_arg *r = rows; r && r->type != TS_ARG_END; r++)
		any |= !(r->flags & TS_POSITIONAL);
	for (const struct ts_arg *r = common; r && r->type != TS_ARG_END; r++)
		any |= !(r->flags & TS_POSITIONAL);
	if (!any)
		return ts_fail(&p->sim->error, TS_SYNTAX, &word->place,
			       "%s: unexpected '%s', the line should end before it", p->what,
			       word->text);
	suggest_keywords(rows, &suggest);
	suggest_keywords(common, &suggest);
	return ts_fail(&p->sim->error, TS_UNKNOWN, &word->place, "%s: unknown keyword '%s'%s",
		       p->what, word->text, ts_suggest_text(&suggest));
}

/* A keyword given twice: stands earlier among the words already read as keywords. */
static bool given_before(const struct parse *p, const char *name)
{
	for (size_t k = 0; k + 1 < p->next; k++)
		if (p->is_keyword[k] && ts_streq(p->words.word[k].text, name))
			return true;
	return false;
}

static enum ts_status read_keywords(struct parse *p, const struct ts_arg *rows,
				    const struct ts_arg *common)
{
	const struct ts_word *word;

	if (!p->is_keyword)
		p->is_keyword = ts_arena_alloc(p->arena, p->words.n + 1, sizeof *p->is_keyword);
	if (!p->is_keyword)
		return ts_nomem(&p->sim->error);
	while ((word = take(p))) {
		const struct ts_arg *row = find_keyword(rows, word->text);

		if (!row)
			row = find_keyword(common, word->text);
		if (!row)
			return unknown_keyword(p, rows, common, word);
		if (!(row->flags & TS_REPEAT) && given_before(p, word->text))
			return ts_fail(&p->sim->error, TS_SYNTAX, &word->place,
				       "%s: keyword '%s' is given twice", p->what, word->text);
		p->is_keyword[p->next - 1] = true;
		TS_TRY(read_row(p, row, common ? common : rows));
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

/* Is the next word the keyword of a row? Then optional positional rows before it are absent. */
static bool at_keyword(const struct parse *p, const struct ts_arg *rows,
		       const struct ts_arg *common)
{
	const char *text = p->words.word[p->next].text;

	return find_keyword(rows, text) || find_keyword(common, text);
}

static enum ts_status read_rows(struct parse *p, const struct ts_arg *rows,
				const struct ts_arg *common)
{
	p->rows = rows;
	for (const struct ts_arg *row = rows; row && row->type != TS_ARG_END; row++) {
		bool may_lack = (row->flags & TS_OPTIONAL) || row->fallback;

		if (!(row->flags & TS_POSITIONAL))
			continue;
		if (may_lack && (p->next == p->words.n || at_keyword(p, rows, common)))
			continue;
		TS_TRY(read_row(p, row, common ? common : rows));
	}
	/* the rows of a mode read the keywords of both levels */
	if (has_mode(rows) && p->next == p->words.n)
		return TS_OK;
	return read_keywords(p, rows, common);
}

/* Every keyword without default that is not optional must have been written. */
static enum ts_status check_required(struct parse *p, const struct ts_arg *rows)
{
	for (const struct ts_arg *row = rows; row && row->type != TS_ARG_END; row++) {
		bool found = false;

		if ((row->flags & (TS_POSITIONAL | TS_OPTIONAL)) || row->fallback ||
		    row->type == TS_ARG_FLAG)
			continue;
		for (size_t k = 0; k < p->words.n; k++)
			found |= ts_streq(p->words.word[k].text, row->name);
		if (!found)
			return ts_fail(&p->sim->error, TS_SYNTAX, p->where,
				       "%s: keyword '%s' is missing (%s)", p->what, row->name,
				       row->help);
	}
	return TS_OK;
}

static void set_absent(const struct ts_arg *row, void *field)
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

static enum ts_status set_default(struct tsim *sim, const struct ts_arg *row,
				  struct ts_arena *arena, void *base)
{
	const struct ts_place nowhere = { .file = "default" };
	struct parse p = { sim, "default", { NULL, 0 }, 0, &nowhere, arena, base, NULL, NULL };

	if (!row->fallback) {
		set_absent(row, (char *)base + row->offset);
		return TS_OK;
	}
	if (ts_words_split(arena, row->fallback, &nowhere, &p.words) != TS_OK)
		return ts_nomem(&sim->error);
	return read_row(&p, row, NULL);
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
			     struct ts_words words, const struct ts_place *where,
			     struct ts_arena *arena, void *base)
{
	struct parse p = { sim, what, words, 0, where, arena, base, NULL, NULL };

	TS_TRY(ts_args_defaults(sim, rows, arena, base));
	TS_TRY(read_rows(&p, rows, NULL));
	TS_TRY(check_required(&p, rows));
	for (const struct ts_arg *row = rows; row && row->type != TS_ARG_END; row++)
		if (row->type == TS_ARG_MODE && *(int *)((char *)base + row->offset) >= 0)
			TS_TRY(check_required(
				&p, row->modes[*(int *)((char *)base + row->offset)].args));
	return TS_OK;
}

enum ts_status ts_number_now(struct tsim *sim, const struct ts_number *number,
			     const struct ts_place *where, double *out)
{
	if (number->variable)
		return sim->host->scalar(sim->host_data, number->variable, where, out);
	*out = number->value;
	return TS_OK;
}
