#include "formula/expr.h"

#include <ctype.h>
#include <stdarg.h>
#include <string.h>

#include "base/banned.h"

enum {
	DEEPEST = 500,	 /* nesting of formulas */
	PATIENCE = 10000 /* formulas within one evaluation before a request to stop ends it */
};

enum ts_status ts_expr_fail(struct ts_expr *e, enum ts_status code, size_t at, size_t end, const char *format,
			    ...)
{
	struct ts_place place = ts_place_inside(e->place, e->length, at, end - at);
	va_list args;

	va_start(args, format);
	ts_vfail_at(&e->sim->error, code, &place, __FILE__, __LINE__, format, args);
	va_end(args);
	return code;
}

enum ts_status ts_expr_locate_error(struct ts_expr *e, enum ts_status status, size_t at, size_t end)
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
				    "expected '%c' after this, found the end of the formula", wanted);
	return ts_expr_fail(e, TS_SYNTAX, e->at, e->at + 1, "expected '%c', found '%c'", wanted, found);
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

enum ts_status ts_expr_array(struct ts_expr *e, size_t n, struct ts_operand *out)
{
	out->data = ts_arena_alloc(&e->arena, n, sizeof *out->data);
	out->n = n;
	return out->data ? TS_OK : ts_nomem(&e->sim->error);
}

enum ts_status ts_expr_or_unknown(struct ts_expr *e, const char *name, enum ts_status status,
				  struct ts_operand *out)
{
	if (!ts_unknown_value(e->formulas, name, &status))
		return status;
	out->scalar = NAN;
	for (size_t i = 0; out->data && i < out->n; i++)
		out->data[i] = NAN;
	return TS_OK;
}

enum ts_status ts_expr_take_table(struct ts_expr *e, enum ts_status status, struct ts_table *table,
				  struct ts_operand *out)
{
	if (status == TS_OK)
		status = ts_expr_array(e, table->rows, out);
	for (size_t i = 0; status == TS_OK && i < table->rows; i++)
		out->data[i] = table->data[i * table->columns];
	ts_table_release(table);
	return status;
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
		n++; /* "3abc" is reported as one error */
	copy = ts_expr_copy(e, e->at, e->at + n);
	if (!copy)
		return TS_NOMEM;
	if (ts_unknown_read_text(e->formulas, copy))
		out->scalar = NAN;
	else if (!ts_parse_real(copy, &out->scalar))
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
	out->scalar = out->word && ts_unknown_read_text(e->formulas, out->word) ? NAN : 0;
	e->at = end;
	return out->word ? TS_OK : TS_NOMEM;
}

/* In a condition /home/x, ./x and ../x are words. */
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

	/* a bare word of a condition may be a path with / . -, but v_x/2 is a quotient */
	while (isalnum((unsigned char)e->text[e->at]) || e->text[e->at] == '_' ||
	       (word && e->text[e->at] && strchr("/.-", e->text[e->at])))
		e->at++;
	name = ts_expr_copy(e, at, e->at);
	return name ? ts_expr_name(e, name, at, out) : TS_NOMEM;
}

/* [1,2.5,v_x] in a formula of a variable of style vector. */
static enum ts_status read_list(struct ts_expr *e, struct ts_operand *out)
{
	size_t at = e->at, n = 1, k = 0;
	double number;

	if (e->kind != TS_FORMULA_VECTOR)
		return ts_expr_fail(e, TS_SYNTAX, at, at + 1,
				    "a list [..] is allowed only in a variable of style vector and in sum(), "
				    "ave() and the like; one number is needed here");
	for (const char *c = e->text + at; *c;
	     c++) /* at most so many: elements may have commas and brackets */
		n += *c == ',';
	TS_TRY(ts_expr_array(e, n, out));
	do {
		e->at++;
		TS_TRY(ts_expr_read_number(e, &number));
		out->data[k++] = number;
	} while (ts_expr_peek(e) == ',');
	out->n = k;
	return ts_expr_expect(e, ']');
}

/* A primary expression: a number, a name, a call, a list, or a formula in parentheses. */
static enum ts_status read_primary(struct ts_expr *e, struct ts_operand *out)
{
	char c = ts_expr_peek(e);

	*out = (struct ts_operand){ .at = e->at };
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
	} else if (c == '[') {
		TS_TRY(read_list(e, out));
	} else if (!c) {
		return ts_expr_fail(e, TS_SYNTAX, e->length ? e->length - 1 : 0, e->length,
				    "expected a number or a name, found the end of the formula");
	} else {
		return ts_expr_fail(e, TS_SYNTAX, e->at, e->at + 1, "expected a number or a name, found '%c'",
				    c);
	}
	out->end = e->at;
	return TS_OK;
}

/* A primary expression with unary operators - + ! before it, applied from right to left. */
static enum ts_status read_signed(struct ts_expr *e, struct ts_operand *out)
{
	size_t first, at;

	ts_expr_peek(e);
	first = e->at;
	while (strchr("-!+", e->text[e->at]) && e->text[e->at]) {
		e->at++;
		ts_expr_peek(e);
	}
	at = e->at;
	TS_TRY(read_primary(e, out));
	while (at-- > first)
		if (strchr("-!+", e->text[at]))
			TS_TRY(ts_op_unary(e, e->text[at], out));
	out->at = first;
	return TS_OK;
}

/* Precedence climbing: evaluates binary operators of `level` and higher. */
enum ts_status ts_expr_read(struct ts_expr *e, int level, struct ts_operand *out)
{
	const struct ts_operator *op;
	struct ts_operand right, result;
	size_t at;

	int depth = e->formulas->depth;

	if (level == 1 && depth > DEEPEST)
		return ts_expr_fail(e, TS_RANGE, e->at, e->at + 1,
				    "the formula is nested too deeply, more than %d times", DEEPEST);
	e->formulas->depth += level == 1;
	TS_TRY(read_signed(e, out));
	for (;;) {
		ts_expr_peek(e);
		op = ts_operator_find(e->text + e->at);
		if (!op || op->level < level)
			break;
		at = e->at;
		e->at += strlen(op->text);
		TS_TRY(ts_expr_read(e, op->level + 1, &right));
		TS_TRY(ts_op_binary(e, op, at, out, &right, &result));
		*out = result;
	}
	e->formulas->depth = depth;
	return TS_OK;
}

enum ts_status ts_expr_read_number(struct ts_expr *e, double *out)
{
	enum ts_formula kind = e->kind;
	struct ts_operand value;
	enum ts_status status;

	e->kind = TS_FORMULA_SCALAR;
	status = ts_expr_read(e, 1, &value);
	e->kind = kind;
	if (status == TS_OK)
		status = ts_op_need_number(e, &value);
	if (status == TS_OK)
		*out = value.scalar;
	return status;
}

static struct ts_expr init_expr(struct ts_formulas *formulas, const char *text, const struct ts_place *place,
				enum ts_formula kind)
{
	static const struct ts_place nowhere;

	return (struct ts_expr){ .formulas = formulas,
				 .sim = formulas->sim,
				 .text = text,
				 .length = strlen(text),
				 .place = place ? place : &nowhere,
				 .kind = kind };
}

/* Evaluates the whole text. The depth includes the formulas of variables, so that a long chain of
 * variables cannot exhaust the stack. */
static enum ts_status evaluate_formula(struct ts_expr *e, struct ts_operand *out)
{
	int depth = e->formulas->depth;
	enum ts_status status;

	e->formulas->evaluation += depth == 0;
	e->formulas->evaluated = depth ? e->formulas->evaluated + 1 : 0;
	if (e->sim->requests.stop && e->formulas->evaluated > PATIENCE)
		return ts_expr_fail(e, TS_STOPPED, 0, e->length,
				    "stopped on request in a formula that takes long");
	status = ts_expr_read(e, 1, out);
	e->formulas->depth = depth;
	if (!depth)
		ts_variables_release_cache(e->formulas);
	if (status != TS_OK)
		return status;
	if (ts_expr_peek(e))
		return ts_expr_fail(e, TS_SYNTAX, e->at, e->at + 1,
				    "expected an operator or the end of the formula, found '%c'",
				    e->text[e->at]);
	return ts_op_need_number(e, out);
}

enum ts_status ts_expr_scalar(struct ts_formulas *formulas, const char *text, const struct ts_place *place,
			      double *out)
{
	struct ts_expr e = init_expr(formulas, text, place, TS_FORMULA_SCALAR);
	struct ts_operand value;
	enum ts_status status = evaluate_formula(&e, &value);

	ts_arena_release(&e.arena);
	if (status == TS_OK)
		*out = value.scalar;
	return status;
}

enum ts_status ts_expr_condition(struct ts_formulas *formulas, const char *text, const struct ts_place *place,
				 enum ts_truth *out)
{
	struct ts_expr e = init_expr(formulas, text, place, TS_FORMULA_SCALAR);
	struct ts_operand value;
	enum ts_status status;

	e.condition = true;
	status = evaluate_formula(&e, &value);
	ts_arena_release(&e.arena);
	if (status == TS_OK)
		*out = ts_unknown(formulas->sim, value.scalar) ? TS_OPEN
		       : value.scalar < 0 || value.scalar > 0  ? TS_YES
							       : TS_NO;
	return status;
}

/* Stores the n values of a list or column, or n copies of a number. */
static enum ts_status store_values(struct ts_expr *e, const struct ts_operand *value, size_t n,
				   struct ts_table *out)
{
	if (ts_table_resize(out, n, 1) != TS_OK)
		return ts_nomem(&e->sim->error);
	for (size_t i = 0; i < n; i++)
		out->data[i] = value->data ? value->data[i] : value->scalar;
	return TS_OK;
}

enum ts_status ts_expr_peratom(struct ts_formulas *formulas, const char *text, const struct ts_place *place,
			       struct ts_table *out)
{
	struct ts_expr e = init_expr(formulas, text, place, TS_FORMULA_PERATOM);
	struct ts_table id = { 0 };
	struct ts_operand value;
	enum ts_status status = ts_quantity_eval(e.sim, "id", &id);

	e.rows = id.rows;
	e.id = id.data;
	status = status == TS_OK ? evaluate_formula(&e, &value)
				 : ts_expr_locate_error(&e, status, 0, e.length);
	if (status == TS_OK)
		status = store_values(&e, &value, e.rows, out);
	ts_arena_release(&e.arena);
	ts_table_release(&id);
	return status;
}

enum ts_status ts_expr_vector(struct ts_formulas *formulas, const char *text, const struct ts_place *place,
			      struct ts_table *out)
{
	struct ts_expr e = init_expr(formulas, text, place, TS_FORMULA_VECTOR);
	struct ts_operand value;
	enum ts_status status = evaluate_formula(&e, &value);

	if (status == TS_OK)
		status = store_values(&e, &value, value.data ? value.n : 1, out);
	ts_arena_release(&e.arena);
	return status;
}

enum ts_status ts_expr_columns(struct ts_formulas *formulas, const char *text, const struct ts_place *place,
			       struct ts_table *out)
{
	struct ts_expr e = init_expr(formulas, text, place, TS_FORMULA_COLUMNS);
	struct ts_operand value;
	enum ts_status status = evaluate_formula(&e, &value);

	if (status == TS_OK)
		status = store_values(&e, &value, formulas->rows, out);
	ts_arena_release(&e.arena);
	return status;
}
