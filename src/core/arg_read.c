/* Readers for each argument type: words of a line to values. */
#include "core/arg_read.h"

#include <math.h>
#include <string.h>

#include "core/group.h"
#include "core/unsupported_names.h"

#include "base/banned.h"

const struct ts_word *ts_arg_next_word(struct ts_parse *p)
{
	return p->next < p->words.n ? &p->words.word[p->next++] : NULL;
}

enum ts_status ts_arg_refuse(struct ts_parse *p, const struct ts_arg *row, const struct ts_word *word,
			     const char *expected)
{
	const struct ts_place *where = p->where;
	char meaning[96] = "";

	/* the message lists the choices of TS_ARG_ENUM and TS_ARG_MODE; they need no help text */
	if (row->help && strlen(row->help) < sizeof meaning - 8 && expected != row->help &&
	    row->type != TS_ARG_ENUM && row->type != TS_ARG_MODE)
		snprintf(meaning, sizeof meaning, " (%s)", row->help);
	if (word)
		return ts_fail(&p->sim->error, TS_SYNTAX, &word->place, "%s: %s is '%s', expected %s%s",
			       p->what, row->name, word->text, expected, meaning);
	if (!(row->flags & TS_POSITIONAL) && p->words.n)
		where = &p->words.word[p->words.n - 1].place;
	return ts_fail(&p->sim->error, TS_SYNTAX, where,
		       row->flags & TS_POSITIONAL ? "%s: %s is missing, expected %s%s"
						  : "%s: keyword %s lacks its value, expected %s%s",
		       p->what, row->name, expected, meaning);
}

static enum ts_status check_range(struct ts_parse *p, const struct ts_arg *row, const struct ts_word *word,
				  double value)
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

enum ts_status ts_arg_read_real(struct ts_parse *p, const struct ts_arg *row, double *out)
{
	const struct ts_word *word = ts_arg_next_word(p);

	if (!word || !ts_parse_real(word->text, out))
		return ts_arg_refuse(p, row, word, "a number");
	return check_range(p, row, word, *out);
}

/* Digits, a point, digits; no exponents, which LIGGGHTS cuts off as well: there 1e5 is 1. */
static bool cut_fraction(const char *text, char head[20], int64_t *out)
{
	size_t whole = strspn(text, "0123456789");

	if (whole >= 20 || text[whole] != '.' || text[whole + 1 + strspn(text + whole + 1, "0123456789")])
		return false;
	memcpy(head, text, whole);
	return ts_parse_int(head, out);
}

static bool read_whole_part(struct tsim *sim, const char *what, const char *name, const char *text,
			    const struct ts_place *where, int64_t *out)
{
	char head[20] = "";

	if (ts_parse_int(text, out))
		return true;
	if (!cut_fraction(text, head, out))
		return false;
	ts_warn(&sim->log, where, "%s: %s is %s, no integer: %s is taken, as in LIGGGHTS", what, name, text,
		head);
	return true;
}

bool ts_arg_whole_part(const struct ts_instance *self, struct tsim *sim, const char *name, const char *text,
		       int64_t *out)
{
	char what[80];

	snprintf(what, sizeof what, "%s %s", ts_kind_name(self->style->kind), self->style->name);
	return read_whole_part(sim, what, name, text, ts_instance_word(self, text), out);
}

/* 1e3 is not read as 1000, since LIGGGHTS reads 1 there without a word. */
static enum ts_status refuse_integer(struct ts_parse *p, const struct ts_arg *row, const struct ts_word *word)
{
	char expected[48] = "an integer";
	double value;

	if (word && ts_parse_real(word->text, &value) && value == floor(value) && fabs(value) < 1e15)
		snprintf(expected, sizeof expected, "an integer, such as %.0f", value);
	return ts_arg_refuse(p, row, word, expected);
}

enum ts_status ts_arg_read_int(struct ts_parse *p, const struct ts_arg *row, int64_t *out)
{
	const struct ts_word *word = ts_arg_next_word(p);
	bool read = word && (row->flags & TS_CUT ? read_whole_part(p->sim, p->what, row->name, word->text,
								   &word->place, out)
						 : ts_parse_int(word->text, out));

	if (!read)
		return refuse_integer(p, row, word);
	return check_range(p, row, word, (double)*out);
}

enum ts_status ts_arg_read_bool(struct ts_parse *p, const struct ts_arg *row, bool *out)
{
	const struct ts_word *word = ts_arg_next_word(p);

	if (word && (ts_streq(word->text, "yes") || ts_streq(word->text, "on")))
		*out = true;
	else if (word && (ts_streq(word->text, "no") || ts_streq(word->text, "off")))
		*out = false;
	else
		return ts_arg_refuse(p, row, word, "yes or no");
	return TS_OK;
}

enum ts_status ts_arg_read_word(struct ts_parse *p, const struct ts_arg *row, const char **out)
{
	const struct ts_word *word = ts_arg_next_word(p);

	if (!word)
		return ts_arg_refuse(p, row, NULL, "a word");
	*out = ts_arena_strdup(p->arena, word->text);
	return *out ? TS_OK : ts_nomem(&p->sim->error);
}

static void append_choices(const char *const *choices, struct ts_str *out)
{
	for (size_t k = 0; choices[k]; k++)
		ts_str_addf(out, "%s%s", k ? ", " : "", choices[k]);
}

enum ts_status ts_arg_read_enum(struct ts_parse *p, const struct ts_arg *row, int *out)
{
	const struct ts_word *word = ts_arg_next_word(p);
	struct ts_suggest suggest = ts_suggest_start(word ? word->text : "");
	struct ts_str expected = { 0 };
	const char *remark;
	enum ts_status status;

	for (int k = 0; word && row->choices[k]; k++)
		if (ts_streq(word->text, row->choices[k])) {
			*out = k;
			return TS_OK;
		}
	for (int k = 0; word && row->choices[k]; k++)
		ts_suggest_try(&suggest, row->choices[k]);
	remark = word ? ts_unsupported_word_remark(row->name, word->text) : NULL;
	ts_str_add(&expected, row->choices[0] && row->choices[1] ? "one of " : "");
	append_choices(row->choices, &expected);
	if (remark)
		ts_str_addf(&expected, "; that one is known, but tsim does not have it: %s", remark);
	else
		ts_str_add(&expected, word && suggest.best ? ts_suggest_text(&suggest) : "");
	status = ts_arg_refuse(p, row, word, ts_str_text(&expected));
	ts_str_release(&expected);
	return status;
}

enum ts_status ts_arg_read_coord(struct ts_parse *p, const struct ts_arg *row, double *out)
{
	const struct ts_word *word = ts_arg_next_word(p);
	bool low = ts_ends_with(row->name, "lo");

	if (word && (ts_streq(word->text, "INF") || ts_streq(word->text, "EDGE"))) {
		*out = ts_streq(word->text, "INF") ? INFINITY : TS_EDGE;
		*out = low ? -*out : *out;
		return TS_OK;
	}
	if (!word || !ts_parse_real(word->text, out))
		return ts_arg_refuse(p, row, word, "a number, INF or EDGE");
	return check_range(p, row, word, *out);
}

enum ts_status ts_arg_read_number(struct ts_parse *p, const struct ts_arg *row, struct ts_number *out)
{
	const struct ts_word *word = ts_arg_next_word(p);
	const struct ts_script_api *api = p->sim->script_api;
	struct ts_suggest suggest;

	*out = (struct ts_number){ .at = p->next };
	if (word && (row->flags & TS_NULLABLE) && ts_streq(word->text, "NULL")) {
		out->null = true;
		return TS_OK;
	}
	if (word && strncmp(word->text, "v_", 2) == 0) {
		suggest = ts_suggest_start(word->text + 2);
		if (p->sim->reading.unreached)
			return TS_OK;
		if (!api || !api->has_variable(p->sim->script_api_data, word->text + 2)) {
			if (api)
				api->suggest_variable(p->sim->script_api_data, &suggest);
			return ts_missing(&p->sim->error, "variable", word->text + 2, &word->place,
					  "%s: %s names an unknown variable '%s'%s", p->what, row->name,
					  word->text + 2, ts_suggest_text(&suggest));
		}
		out->variable = ts_arena_strdup(p->arena, word->text + 2);
		return out->variable ? TS_OK : ts_nomem(&p->sim->error);
	}
	if (!word || !ts_parse_real(word->text, &out->value))
		return ts_arg_refuse(p, row, word,
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

enum ts_status ts_arg_read_types(struct ts_parse *p, const struct ts_arg *row, struct ts_types *out)
{
	const struct ts_word *word = ts_arg_next_word(p);

	if (!word || !ts_parse_types(word->text, out))
		return ts_arg_refuse(p, row, word, "a type n or a range such as * or 1*3");
	return TS_OK;
}

static bool is_style_name(const struct ts_tables *tables, const char *name)
{
	return ts_style_find(tables, TS_KIND_FIX, name) || ts_style_find(tables, TS_KIND_COMPUTE, name) ||
	       ts_style_find(tables, TS_KIND_DUMP, name);
}

enum ts_status ts_arg_read_group(struct ts_parse *p, const struct ts_arg *row, int *out)
{
	struct ts_error *error = &p->sim->error;
	enum ts_status status;
	char *tail;
	const struct ts_word *word = ts_arg_next_word(p);

	if (!word)
		return ts_arg_refuse(p, row, NULL, "the name of a group");
	if (p->sim->reading.unreached) {
		*out = 0;
		return TS_OK;
	}
	status = ts_group_require(p->sim, word, out);
	if (status == TS_UNKNOWN && is_style_name(p->sim->tables, word->text)) {
		tail = error->message + strlen(error->message);
		snprintf(tail, sizeof error->message - (size_t)(tail - error->message),
			 "; '%s' is a style, the group stands before it", word->text);
	}
	return status;
}

enum ts_status ts_arg_read_region(struct ts_parse *p, const struct ts_arg *row, struct ts_instance **out)
{
	const struct ts_word *word = ts_arg_next_word(p);

	*out = NULL;
	if (!word)
		return ts_arg_refuse(p, row, NULL, "the name of a region");
	if ((row->flags & TS_NULLABLE) && ts_streq(word->text, "NULL"))
		return TS_OK;
	if (p->sim->reading.unreached)
		return TS_OK;
	return ts_sim_require(p->sim, TS_KIND_REGION, word, out);
}

enum ts_status ts_arg_read_vec3(struct ts_parse *p, const struct ts_arg *row, double out[3])
{
	static const char *const ordinals[] = { "first", "second", "third" };
	char expected[48];

	for (int d = 0; d < 3; d++) {
		const struct ts_word *word = ts_arg_next_word(p);

		snprintf(expected, sizeof expected, "the %s of three numbers", ordinals[d]);
		if (!word || !ts_parse_real(word->text, &out[d]))
			return ts_arg_refuse(p, row, word, expected);
		TS_TRY(check_range(p, row, word, out[d]));
	}
	return TS_OK;
}
