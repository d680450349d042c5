#include "script/expr.h"

#include <ctype.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "base/banned.h"

enum { DEEPEST = 100, BINDING = 8 /* tighter than any binary operator */ };

enum ts_status ts_expr_fail(struct ts_expr *e, enum ts_status code, size_t at, size_t end,
			    const char *format, ...)
{
	struct ts_place place = ts_place_inside(e->place, e->length, at, end - at);
	char text[512];
	va_list args;

	va_start(args, format);
	vsnprintf(text, sizeof text, format, args);
	va_end(args);
	return ts_fail(&e->sim->error, code, &place, "%s", text);
}

enum ts_status ts_expr_blame(struct ts_expr *e, enum ts_status status, size_t at, size_t end)
{
	if (status != TS_OK && status != TS_NOMEM && !e->sim->error.place.line)
		e->sim->error.place = ts_place_inside(e->place, e->length, at, end - at);
	return status;
}

char ts_expr_peek(struct ts_expr *e)
{
	while (isspace((unsigned char)e->text[e->at]))
		e->at++;
	return e->text[e->at];
}

enum ts_status ts_expr_expect(struct ts_expr *e, char wanted)
{
	char found = ts_expr_peek(e);

	if (found == wanted) {
		e->at++;
		return TS_OK;
	}
	if (!found)
		return ts_expr_fail(e, TS_SYNTAX, e->length ? e->length - 1 : 0, e->length,
				    "expected '%c' after this, found the end of the formula",
				    wanted);
	return ts_expr_fail(e, TS_SYNTAX, e->at, e->at + 1, "expected '%c', found '%c'", wanted,
			    found);
}

const char *ts_expr_copy(struct ts_expr *e, size_t at, size_t end)
{
	char *copy = ts_arena_alloc(&e->arena, end - at + 1, 1);

	if (copy)
		memcpy(copy, e->text + at, end - at);
	else
		ts_nomem(&e->sim->error);
	return copy;
}

double *ts_expr_array(struct ts_expr *e)
{
	double *data = ts_arena_alloc(&e->arena, e->rows, sizeof *data);

	if (!data)
		ts_nomem(&e->sim->error);
	return data;
}

static enum ts_status read_number(struct ts_expr *e, struct ts_operand *out)
{
	const char *s = e->text + e->at, *copy;
	size_t n = strspn(s, "0123456789.");

	if (s[n] == 'e' || s[n] == 'E') {
		size_t sign = s[n + 1] == '+' || s[n + 1] == '-';

		if (isdigit((unsigned char)s[n + 1 + sign]))
			n += 1 + sign + strspn(s + n + 1 + sign, "0123456789");
	}
	while (isalnum((unsigned char)s[n]) || s[n] == '_')
		n++; /* "3abc" is one mistake, not two words */
	copy = ts_expr_copy(e, e->at, e->at + n);
	if (!copy)
		return TS_NOMEM;
	if (!ts_parse_real(copy, &out->scalar))
		return ts_expr_fail(e, TS_SYNTAX, e->at, e->at + n, "'%s' is not a number", copy);
	e->at += n;
	return TS_OK;
}

static enum ts_status read_quoted(struct ts_expr *e, struct ts_operand *out)
{
	size_t end = ts_quote_end(e->text, e->at);

	if (end == e->at)
		return ts_expr_fail(e, TS_SYNTAX, e->at, e->at + 1, "this quote is never closed");
	out->word = ts_expr_copy(e, e->at + 1, end - 1);
	out->is_word = true;
	e->at = end;
	return out->word ? TS_OK : TS_NOMEM;
}

/* In a condition, /home/x, ./x and ../x are words. */
static bool at_path(const struct ts_expr *e)
{
	const char *s = e->text + e->at;

	return e->condition &&
	       (s[0] == '/' || (s[0] == '.' && (s[1] == '/' || (s[1] == '.' && s[2] == '/'))));
}

static enum ts_status read_name(struct ts_expr *e, struct ts_operand *out)
{
	const char *s = e->text + e->at, *name;
	size_t at = e->at;
	bool word = e->condition && !(s[1] == '_' && strchr("cfv", s[0]));

	/* a bare word of a condition may be a path; v_x/2 is a quotient */
	while (isalnum((unsigned char)e->text[e->at]) || e->text[e->at] == '_' ||
	       (word && e->text[e->at] && strchr("/.-", e->text[e->at])))
		e->at++;
	name = ts_expr_copy(e, at, e->at);
	return name ? ts_expr_name(e, name, at, out) : TS_NOMEM;
}

/* A number, a name, a bracket, or one of these behind - or !. */
static enum ts_status read_operand(struct ts_expr *e, struct ts_operand *out)
{
	char c = ts_expr_peek(e);

	*out = (struct ts_operand){ .at = e->at };
	if (c == '-' || c == '!' || c == '+') {
		size_t at = e->at++;

		TS_TRY(ts_expr_read(e, BINDING, out));
		out->at = at;
		return ts_op_unary(e, c, out);
	}
	if (c == '(') {
		size_t at = e->at++;

		TS_TRY(ts_expr_read(e, 1, out));
		TS_TRY(ts_expr_expect(e, ')'));
		out->at = at;
	} else if (isalpha((unsigned char)c) || c == '_' || at_path(e)) {
		TS_TRY(read_name(e, out));
	} else if (isdigit((unsigned char)c) || c == '.') {
		TS_TRY(read_number(e, out));
	} else if (e->condition && (c == '"' || c == '\'')) {
		TS_TRY(read_quoted(e, out));
	} else if (!c) {
		return ts_expr_fail(e, TS_SYNTAX, e->length ? e->length - 1 : 0, e->length,
				    "expected a number or a name, found the end of the formula");
	} else {
		return ts_expr_fail(e, TS_SYNTAX, e->at, e->at + 1,
				    "expected a number or a name, found '%c'", c);
	}
	out->end = e->at;
	return TS_OK;
}

/* Operators of at least this level. */
enum ts_status ts_expr_read(struct ts_expr *e, int level, struct ts_operand *out)
{
	struct ts_operand right, result;
	enum ts_op op;
	size_t n, at;
	int found;

	if (e->depth >= DEEPEST)
		return ts_expr_fail(e, TS_RANGE, e->at, e->at + 1,
				    "the formula is nested too deeply");
	e->depth++;
	TS_TRY(read_operand(e, out));
	for (;;) {
		ts_expr_peek(e);
		op = ts_op_find(e->text + e->at, &found, &n);
		if (op == TS_NOP || found < level)
			break;
		at = e->at;
		e->at += n;
		TS_TRY(ts_expr_read(e, found + 1, &right));
		TS_TRY(ts_op_binary(e, op, at, out, &right, &result));
		*out = result;
	}
	e->depth--;
	return TS_OK;
}

static enum ts_status evaluate(struct ts_expr *e, struct ts_operand *out)
{
	TS_TRY(ts_expr_read(e, 1, out));
	if (ts_expr_peek(e))
		return ts_expr_fail(e, TS_SYNTAX, e->at, e->at + 1,
				    "expected an operator or the end of the formula, found '%c'",
				    e->text[e->at]);
	return ts_op_need_number(e, out);
}

static struct ts_expr start(struct ts_script *script, const char *text,
			    const struct ts_place *place)
{
	static const struct ts_place nowhere;

	return (struct ts_expr){ .script = script,
				 .sim = script->sim,
				 .text = text,
				 .length = strlen(text),
				 .place = place ? place : &nowhere };
}

enum ts_status ts_expr_scalar(struct ts_script *script, const char *text,
			      const struct ts_place *place, double *out)
{
	struct ts_expr e = start(script, text, place);
	struct ts_operand value;
	enum ts_status status = evaluate(&e, &value);

	ts_arena_release(&e.arena);
	if (status == TS_OK)
		*out = value.scalar;
	return status;
}

enum ts_status ts_expr_condition(struct ts_script *script, const char *text,
				 const struct ts_place *place, bool *out)
{
	struct ts_expr e = start(script, text, place);
	struct ts_operand value;
	enum ts_status status;

	e.condition = true;
	status = evaluate(&e, &value);
	ts_arena_release(&e.arena);
	if (status == TS_OK)
		*out = value.scalar < 0 || value.scalar > 0;
	return status;
}

enum ts_status ts_expr_peratom(struct ts_script *script, const char *text,
			       const struct ts_place *place, struct ts_table *out)
{
	struct ts_expr e = start(script, text, place);
	struct ts_operand value;
	enum ts_status status = ts_quantity_eval(e.sim, "id", out);

	if (status != TS_OK)
		return ts_expr_blame(&e, status, 0, e.length);
	e.peratom = true;
	e.rows = out->rows;
	status = evaluate(&e, &value);
	if (status == TS_OK)
		status = ts_table_resize(out, e.rows, 1);
	if (status == TS_NOMEM)
		ts_nomem(&e.sim->error);
	for (size_t i = 0; status == TS_OK && i < e.rows; i++)
		out->data[i] = value.data ? value.data[i] : value.scalar;
	ts_arena_release(&e.arena);
	return status;
}
