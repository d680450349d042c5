/* Substitution of ${name}, $x and $(formula) in lines and texts. */
#include <string.h>

#include "formula/expr.h"
#include "formula/number_format.h"
#include "script/internal.h"

#include "base/banned.h"

enum { MOST_SHOWN = 100 /* substitutions of a line that are echoed; behind these only the last */ };

/* Position of the parenthesis that closes the one at `at`; 0: there is none. */
static size_t find_closing_parenthesis(const char *text, size_t at)
{
	int depth = 0;

	for (size_t k = at; text[k]; k++) {
		depth += text[k] == '(';
		depth -= text[k] == ')';
		if (!depth)
			return k;
	}
	return 0;
}

/* Splits `text:%format`, which begins at `from` of the line, at the colon. *format is changed if there is
 * one; *place is that of the text before the colon. */
static enum ts_status split_format(struct ts_script *script, const struct ts_line *line, size_t from,
				   struct ts_str *text, const char **format, struct ts_place *place)
{
	char *colon = text->failed ? NULL : strstr(ts_str_text(text), ":%");
	struct ts_place part;
	size_t at;

	*place = ts_line_place(line, from, text->length);
	if (text->failed)
		return ts_nomem(&script->sim->error);
	if (!colon)
		return TS_OK;
	at = (size_t)(colon - text->text);
	part = ts_line_place(line, from + at + 1, text->length - at - 1);
	*place = ts_line_place(line, from, at);
	*colon = '\0';
	*format = colon + 1;
	return ts_number_format_check(&script->sim->error, *format, &part);
}

/* $(formula) or $(formula:%format); from..to is the text between the parentheses. */
static enum ts_status substitute_formula(struct ts_script *script, const struct ts_line *line, size_t from,
					 size_t to, struct ts_str *out)
{
	struct ts_place place;
	struct ts_str inner = { 0 };
	const char *format = "%.20g";
	enum ts_status status;
	double value = 0;

	if (from == to) {
		place = ts_line_place(line, from - 2, 3);
		return ts_fail(&script->sim->error, TS_SYNTAX, &place,
			       "$() needs a formula between its brackets");
	}
	ts_str_add_n(&inner, line->text.text + from, to - from);
	status = split_format(script, line, from, &inner, &format, &place);
	if (status == TS_OK)
		status = ts_expr_scalar(&script->formulas, inner.text, &place, &value);
	if (status == TS_OK)
		ts_unknown_add(script->sim, out, format, value);
	ts_str_release(&inner);
	return status;
}

/* ${name} or ${name:%format}; from..to is the text between the braces. */
static enum ts_status substitute_variable(struct ts_script *script, const struct ts_line *line, size_t from,
					  size_t to, const struct ts_place *where, struct ts_str *out)
{
	struct ts_variable *found;
	struct ts_str name = { 0 };
	struct ts_place place;
	const char *format = NULL;
	enum ts_status status;
	double value = 0;

	ts_str_add_n(&name, line->text.text + from, to - from);
	status = split_format(script, line, from, &name, &format, &place);
	if (status == TS_OK)
		status = ts_variable_require(&script->formulas, ts_str_text(&name), where, &found);
	if (status == TS_OK && !format)
		status = ts_variable_text(&script->formulas, found, where, out);
	else if (status == TS_OK)
		status = ts_variable_number(&script->formulas, found, where, &value);
	if (status == TS_OK && format)
		ts_unknown_add(script->sim, out, format, value);
	ts_str_release(&name);
	return status;
}

/* Appends the value of the reference with its $ at `at`; *next is the position behind it. */
static enum ts_status substitute_reference(struct ts_script *script, const struct ts_line *line, size_t at,
					   size_t *next, struct ts_str *out)
{
	const char *text = line->text.text, *brace;
	struct ts_place where;
	size_t end;

	if (text[at + 1] == '(') {
		end = find_closing_parenthesis(text, at + 1);
		*next = end + 1;
		if (end)
			return substitute_formula(script, line, at + 2, end, out);
		where = ts_line_place(line, at, 2);
		return ts_fail(&script->sim->error, TS_SYNTAX, &where, "'$(' is never closed");
	}
	if (text[at + 1] == '{') {
		brace = strchr(text + at, '}');
		if (!brace) {
			where = ts_line_place(line, at, 2);
			return ts_fail(&script->sim->error, TS_SYNTAX, &where, "'${' is never closed");
		}
		end = (size_t)(brace - text);
		where = ts_line_place(line, at, end + 1 - at);
		*next = end + 1;
		return substitute_variable(script, line, at + 2, end, &where, out);
	}
	if (!text[at + 1] || strchr(" \t\n", text[at + 1])) {
		where = ts_line_place(line, at, 1);
		return ts_fail(&script->sim->error, TS_SYNTAX, &where,
			       "'$' must be followed by the name of a variable");
	}
	where = ts_line_place(line, at, 2);
	*next = at + 2;
	return substitute_variable(script, line, at + 1, at + 2, &where, out);
}

/* Echoes the line after a substitution; `rest` is not substituted yet. */
static void echo_line(struct ts_script *script, const struct ts_line *done, const char *rest)
{
	struct ts_str shown = { 0 };

	if (done->text.failed)
		return;
	ts_str_addf(&shown, "%s%s", ts_str_text(&done->text), rest);
	ts_log_echo(&script->sim->log, ts_str_text(&shown));
	ts_str_release(&shown);
}

/* quotes: inside of them, too. */
static enum ts_status substitute_all(struct ts_script *script, const struct ts_line *line, bool echo,
				     bool quotes, struct ts_line *out, struct ts_str *value)
{
	const char *text = ts_str_text(&line->text);
	size_t at = 0, steps = 0;

	if (ts_line_copy_rows(out, line) != TS_OK)
		return TS_NOMEM;
	while (text[at]) {
		size_t end = quotes ? at : ts_quote_end(text, at);

		if (text[at] == '$') {
			ts_str_clear(value);
			TS_TRY(substitute_reference(script, line, at, &end, value));
			ts_line_add_from(out, ts_str_text(value), value->length, line, at, end - at);
			if (echo && ++steps < MOST_SHOWN)
				echo_line(script, out, text + end);
			at = end;
			continue;
		}
		for (end = end > at ? end : at + 1; at < end; at++)
			ts_line_add_from(out, text + at, 1, line, at, 1);
	}
	if (steps >= MOST_SHOWN)
		echo_line(script, out, "");
	return out->text.failed || value->failed ? TS_NOMEM : TS_OK;
}

static enum ts_status substitute_line(struct ts_script *script, struct ts_line *line, bool echo, bool quotes)
{
	struct ts_line out = { 0 };
	struct ts_str value = { 0 };
	enum ts_status status;

	if (!strchr(ts_str_text(&line->text), '$'))
		return TS_OK;
	status = substitute_all(script, line, echo, quotes, &out, &value);
	if (status == TS_NOMEM)
		ts_nomem(&script->sim->error);
	ts_str_release(&value);
	if (status == TS_OK) {
		ts_line_release(line);
		*line = out;
	} else {
		ts_line_release(&out);
	}
	return status;
}

enum ts_status ts_substitute(struct ts_script *script, struct ts_line *line, bool echo)
{
	return substitute_line(script, line, echo, false);
}

static enum ts_status substitute_text(struct ts_script *script, const char *text,
				      const struct ts_place *where, bool quotes, struct ts_str *out)
{
	struct ts_place nowhere = { 0 };
	struct ts_line line = { 0 };
	enum ts_status status = ts_line_set(&line, text, strlen(text), where ? where : &nowhere);

	if (status == TS_OK)
		status = substitute_line(script, &line, false, quotes);
	if (status == TS_OK)
		ts_str_add_n(out, ts_str_text(&line.text), line.text.length);
	if (status == TS_NOMEM || out->failed)
		status = ts_nomem(&script->sim->error);
	ts_line_release(&line);
	return status;
}

enum ts_status ts_substitute_text(struct ts_script *script, const char *text, const struct ts_place *where,
				  struct ts_str *out)
{
	return substitute_text(script, text, where, false, out);
}

static enum ts_status substitute_shown(struct ts_script *script, const char *text,
				       const struct ts_place *where, bool quotes, struct ts_str *out)
{
	bool before = script->formulas.doubts_words;
	enum ts_status status;

	script->formulas.doubts_words = true;
	status = substitute_text(script, text, where, quotes, out);
	script->formulas.doubts_words = before;
	return status;
}

enum ts_status ts_substitute_shown(struct ts_script *script, const char *text, const struct ts_place *where,
				   struct ts_str *out)
{
	return substitute_shown(script, text, where, false, out);
}

enum ts_status ts_substitute_condition(struct ts_script *script, const char *text,
				       const struct ts_place *where, struct ts_str *out)
{
	return substitute_shown(script, text, where, true, out);
}
