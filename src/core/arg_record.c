/* Arguments as text: synopsis and resolved values. */
#include "core/arg.h"

#include <inttypes.h>
#include <stdio.h>

#include "core/group.h"
#include "core/sim.h"

#include "base/banned.h"

static void append_real(struct ts_str *out, double value)
{
	double again;
	char text[32];

	if (isinf(value)) {
		ts_str_add(out, " INF");
		return;
	}
	/* as few digits as give the same number again */
	for (int digits = 15; digits <= 17; digits++) {
		snprintf(text, sizeof text, "%.*g", digits, value);
		if (ts_parse_real(text, &again) && !(again < value || again > value))
			break;
	}
	ts_str_addf(out, " %s", text);
}

static void append_number(struct ts_str *out, const struct ts_number *number)
{
	if (number->null)
		ts_str_add(out, " NULL");
	else if (number->variable)
		ts_str_addf(out, " v_%s", number->variable);
	else
		append_real(out, number->value);
}

static void append_types(struct ts_str *out, const struct ts_types *t)
{
	if (t->hi)
		ts_str_addf(out, " %d*%d", t->lo, t->hi);
	else
		ts_str_addf(out, " %d*", t->lo);
}

static void append_words(struct ts_str *out, const struct ts_words *words, size_t from)
{
	for (size_t k = from; k < words->n; k++)
		ts_str_addf(out, " %s", words->word[k].text);
}

/* Rows of TS_NAMED begin with their keyword. Several may share a field, as the surfaces of a picture do: it is shown with that
 * whose keyword comes first. */
static bool shows_own_keyword(const struct ts_arg *row)
{
	return row->flags & TS_NAMED && !ts_ends_with(row->name, "NAME");
}

static bool is_without_words(const struct ts_arg *row, const struct ts_words *words)
{
	return words->n == 0 || (shows_own_keyword(row) && !ts_streq(words->word[0].text, row->name));
}

static bool is_absent(const struct ts_arg *row, const void *field)
{
	switch (row->type) {
	case TS_ARG_REAL:
	case TS_ARG_COORD:
	case TS_ARG_VEC3:
		return isnan(*(const double *)field);
	case TS_ARG_INT:
		return *(const int64_t *)field == INT64_MIN;
	case TS_ARG_REST:
		return is_without_words(row, field);
	case TS_ARG_ENUM:
	case TS_ARG_GROUP:
	case TS_ARG_MODE:
		return *(const int *)field < 0;
	case TS_ARG_WORD:
	case TS_ARG_REF:
	case TS_ARG_REGION:
		return !*(const void *const *)field;
	case TS_ARG_FLAG:
		return !*(const bool *)field;
	default:
		return false;
	}
}

static void append_value(const struct tsim *sim, const struct ts_arg *row, const void *field,
			 struct ts_str *out)
{
	switch (row->type) {
	case TS_ARG_REAL:
	case TS_ARG_COORD:
		append_real(out, *(const double *)field);
		break;
	case TS_ARG_VEC3:
		for (int d = 0; d < 3; d++)
			append_real(out, ((const double *)field)[d]);
		break;
	case TS_ARG_INT:
		ts_str_addf(out, " %" PRId64, *(const int64_t *)field);
		break;
	case TS_ARG_BOOL:
		ts_str_add(out, *(const bool *)field ? " yes" : " no");
		break;
	case TS_ARG_WORD:
	case TS_ARG_REF:
		ts_str_addf(out, " %s", *(const char *const *)field);
		break;
	case TS_ARG_ENUM:
		ts_str_addf(out, " %s", row->choices[*(const int *)field]);
		break;
	case TS_ARG_MODE:
		ts_str_addf(out, " %s", row->modes[*(const int *)field].name);
		break;
	case TS_ARG_NUMBER:
		append_number(out, field);
		break;
	case TS_ARG_TYPES:
		append_types(out, field);
		break;
	case TS_ARG_GROUP:
		ts_str_addf(out, " %s", ts_group_name(sim, *(const int *)field));
		break;
	case TS_ARG_REGION:
		ts_str_addf(out, " %s", (*(struct ts_instance *const *)field)->id);
		break;
	case TS_ARG_REST:
		append_words(out, field, shows_own_keyword(row) ? 1 : 0);
		break;
	case TS_ARG_FLAG:
	case TS_ARG_END:
		break;
	}
}

bool ts_arg_record(const struct tsim *sim, const struct ts_arg *row, const void *base, struct ts_str *out)
{
	const void *field = (const char *)base + row->offset;

	if (is_absent(row, field))
		return false;
	if (row->type == TS_ARG_FLAG)
		ts_str_add(out, " yes");
	else
		append_value(sim, row, field, out);
	return true;
}

void ts_args_record(const struct tsim *sim, const struct ts_arg *rows, const void *base, struct ts_str *out)
{
	for (const struct ts_arg *row = rows; row && row->type != TS_ARG_END; row++) {
		const void *field = (const char *)base + row->offset;

		if (row->flags & TS_WRITES || is_absent(row, field))
			continue;
		if (!(row->flags & TS_POSITIONAL))
			ts_str_addf(out, " %s", row->name);
		append_value(sim, row, field, out);
		if (row->type == TS_ARG_MODE)
			ts_args_record(sim, row->modes[*(const int *)field].args, base, out);
	}
}

static enum ts_status report_file_written(struct tsim *sim, const char *what, const char *path,
					  struct ts_words words, const struct ts_place *where)
{
	for (size_t k = 0; k < words.n; k++)
		if (ts_streq(words.word[k].text, path))
			where = &words.word[k].place;
	return sim->script_api->would_write(sim->script_api_data, where, what, path);
}

enum ts_status ts_args_outputs(struct tsim *sim, const char *what, const struct ts_arg *rows,
			       const void *base, struct ts_words words, const struct ts_place *where)
{
	if (!sim->reading.check || !sim->script_api)
		return TS_OK;
	for (const struct ts_arg *row = rows; row && row->type != TS_ARG_END; row++) {
		const void *field = (const char *)base + row->offset;

		if (is_absent(row, field))
			continue;
		if (row->flags & TS_WRITES)
			TS_TRY(report_file_written(sim, what, *(const char *const *)field, words, where));
		if (row->type == TS_ARG_MODE)
			TS_TRY(ts_args_outputs(sim, what, row->modes[*(const int *)field].args, base, words,
					       where));
	}
	return TS_OK;
}

static void append_choices(const char *const *choices, struct ts_str *out)
{
	for (size_t k = 0; choices[k]; k++)
		ts_str_addf(out, "%s%s", k ? "|" : "", choices[k]);
}

static void append_modes(const struct ts_mode *modes, struct ts_str *out)
{
	for (size_t k = 0; modes[k].name; k++)
		ts_str_addf(out, "%s%s", k ? "|" : "", modes[k].name);
}

static void append_placeholder(const struct ts_arg *row, struct ts_str *out)
{
	switch (row->type) {
	case TS_ARG_ENUM:
		append_choices(row->choices, out);
		break;
	case TS_ARG_MODE:
		append_modes(row->modes, out);
		ts_str_add(out, " ...");
		break;
	case TS_ARG_BOOL:
		ts_str_add(out, "yes|no");
		break;
	case TS_ARG_VEC3:
		ts_str_add(out, "x y z");
		break;
	case TS_ARG_REST:
		ts_str_addf(out, "%s ...", row->flags & TS_POSITIONAL ? row->name : "words");
		break;
	case TS_ARG_GROUP:
		ts_str_add(out, "GROUP");
		break;
	case TS_ARG_REGION:
		ts_str_add(out, "REGION");
		break;
	default:
		ts_str_add(out, row->flags & TS_POSITIONAL ? row->name : "value");
		break;
	}
}

void ts_arg_synopsis(const struct ts_arg *row, struct ts_str *out)
{
	bool bracket = (row->flags & TS_OPTIONAL) || row->fallback || row->type == TS_ARG_FLAG;

	ts_str_add(out, bracket ? "[" : "");
	if (row->flags & TS_POSITIONAL) {
		append_placeholder(row, out);
	} else {
		ts_str_add(out, row->name);
		if (row->type != TS_ARG_FLAG) {
			ts_str_add(out, " ");
			append_placeholder(row, out);
		}
	}
	ts_str_add(out, bracket ? "]" : "");
}
