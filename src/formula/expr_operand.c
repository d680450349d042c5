/* Operators of formulas, applied to numbers, lists and columns of particles. */
#include <math.h>
#include <string.h>

#include "formula/expr.h"

#include "base/banned.h"

static bool is_true(double a)
{
	return a < 0 || a > 0;
}

/* Whether the result of || or && is known although one operand is unknown, a NaN, which is neither true nor
 * zero here. */
static bool is_either_true(double a, double b)
{
	return is_true(a) || is_true(b);
}

static bool is_either_zero(double a, double b)
{
	return a == 0 || b == 0;
}

static double op_or(double a, double b)
{
	return is_true(a) || is_true(b);
}

static double op_xor(double a, double b)
{
	return is_true(a) != is_true(b);
}

static double op_and(double a, double b)
{
	return is_true(a) && is_true(b);
}

static double op_equal(double a, double b)
{
	return !(a < b) && !(a > b);
}

static double op_unequal(double a, double b)
{
	return a < b || a > b;
}

static double op_not_above(double a, double b)
{
	return a <= b;
}

static double op_below(double a, double b)
{
	return a < b;
}

static double op_not_below(double a, double b)
{
	return a >= b;
}

static double op_above(double a, double b)
{
	return a > b;
}

static double op_add(double a, double b)
{
	return a + b;
}

static double op_subtract(double a, double b)
{
	return a - b;
}

static double op_multiply(double a, double b)
{
	return a * b;
}

static double op_divide(double a, double b)
{
	return a / b;
}

/* Where one operator begins with another, the longer one is first. */
const struct ts_operator ts_operators[] = {
	{ "||", 1, op_or, "1 if one of the two is not 0", false, false, is_either_true },
	{ "|^", 1, op_xor, "1 if exactly one of the two is not 0", false, false, NULL },
	{ "&&", 2, op_and, "1 if neither is 0", false, false, is_either_zero },
	{ "==", 3, op_equal, "1 if equal", false, true, NULL },
	{ "!=", 3, op_unequal, "1 if not equal", false, true, NULL },
	{ "<=", 4, op_not_above, "1 if less or equal", false, false, NULL },
	{ "<", 4, op_below, "1 if less", false, false, NULL },
	{ ">=", 4, op_not_below, "1 if greater or equal", false, false, NULL },
	{ ">", 4, op_above, "1 if greater", false, false, NULL },
	{ "+", 5, op_add, "sum", false, false, NULL },
	{ "-", 5, op_subtract, "difference", false, false, NULL },
	{ "*", 6, op_multiply, "product", false, false, NULL },
	{ "/", 6, op_divide, "quotient", true, false, NULL },
	{ "%", 6, fmod, "remainder, with the sign of the left number", true, false, NULL },
	{ "^", 7, pow, "power", false, false, NULL },
	{ .text = NULL },
};

const struct ts_operator *ts_operator_find(const char *text)
{
	for (const struct ts_operator *op = ts_operators; op->text; op++)
		if (strncmp(text, op->text, strlen(op->text)) == 0)
			return op;
	return NULL;
}

/* For each element of a list: what only an error needs is found there. */
static enum ts_status apply_checked(struct ts_expr *e, const struct ts_operator *op, size_t at, double a,
				    double b, double *out)
{
	if (ts_unknown(e->sim, a) || ts_unknown(e->sim, b)) {
		*out = op->decides && op->decides(a, b) ? op->apply(a, b) : NAN;
		return TS_OK;
	}
	if (op->divides && !is_true(b))
		return ts_expr_fail(e, TS_RANGE, at, at + strlen(op->text), "division of %.6g by zero", a);
	*out = op->apply(a, b);
	if (isfinite(*out))
		return TS_OK;
	return ts_expr_fail(e, TS_RANGE, at, at + strlen(op->text), "%.6g %s %.6g is %s", a, op->text, b,
			    isnan(*out) ? "not a real number" : "too large for a number");
}

enum ts_status ts_op_need_number(struct ts_expr *e, const struct ts_operand *a)
{
	if (!a->is_word)
		return TS_OK;
	return ts_expr_fail(e, TS_SYNTAX, a->at, a->end,
			    "'%s' is a word here, a number is needed; the value of a keyword or variable is "
			    "written $(%s) or v_NAME",
			    a->word, a->word);
}

/* Whether the list depends on a run that -check has left out; then its length is not known either. */
static bool is_unknown(const struct ts_expr *e, const struct ts_operand *a)
{
	for (size_t i = 0; i < a->n; i++)
		if (ts_unknown(e->sim, a->data[i]))
			return true;
	return false;
}

static enum ts_status unknown_list(struct ts_expr *e, size_t n, struct ts_operand *out)
{
	TS_TRY(ts_expr_array(e, n, out));
	for (size_t i = 0; i < n; i++)
		out->data[i] = NAN;
	return TS_OK;
}

enum ts_status ts_op_binary(struct ts_expr *e, const struct ts_operator *op, size_t at,
			    const struct ts_operand *a, const struct ts_operand *b, struct ts_operand *out)
{
	bool words = a->is_word || b->is_word || (a->word && b->word);

	*out = (struct ts_operand){ .at = a->at, .end = b->end };
	if (words && op->compares_words && !ts_unknown(e->sim, a->scalar) && !ts_unknown(e->sim, b->scalar)) {
		bool same = a->word && b->word && ts_streq(a->word, b->word);

		out->scalar = op->apply(same, true);
		return TS_OK;
	}
	if (words && op->compares_words) { /* one operand is unknown and may be this word */
		out->scalar = NAN;
		return TS_OK;
	}
	TS_TRY(ts_op_need_number(e, a));
	TS_TRY(ts_op_need_number(e, b));
	if (!a->data && !b->data)
		return apply_checked(e, op, at, a->scalar, b->scalar, &out->scalar);
	if (a->data && b->data && a->n != b->n) {
		if (is_unknown(e, a) || is_unknown(e, b))
			return unknown_list(e, a->n > b->n ? a->n : b->n, out);
		return ts_expr_fail(e, TS_RANGE, a->at, b->end,
				    "lists of %zu and %zu numbers cannot be combined", a->n, b->n);
	}
	TS_TRY(ts_expr_array(e, a->data ? a->n : b->n, out));
	for (size_t i = 0; i < out->n; i++)
		TS_TRY(apply_checked(e, op, at, a->data ? a->data[i] : a->scalar,
				     b->data ? b->data[i] : b->scalar, &out->data[i]));
	return TS_OK;
}

enum ts_status ts_op_unary(struct ts_expr *e, char op, struct ts_operand *a)
{
	double *data = a->data ? a->data : &a->scalar;

	TS_TRY(ts_op_need_number(e, a));
	for (size_t i = 0; i < (a->data ? a->n : 1); i++) {
		if (op == '-')
			data[i] = -data[i];
		else if (op == '!')
			data[i] = ts_unknown(e->sim, data[i]) ? NAN : !is_true(data[i]);
	}
	a->word = NULL;
	return TS_OK;
}
