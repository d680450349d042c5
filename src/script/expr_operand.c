#include <math.h>
#include <string.h>

#include "script/expr.h"

#include "base/banned.h"

/* Longer spellings first, where one begins with another. */
static const struct {
	const char *text;
	enum ts_op op;
	int level;
} operators[] = {
	{ "||", TS_OP_OR, 1 }, { "|^", TS_OP_XOR, 1 }, { "&&", TS_OP_AND, 2 },
	{ "==", TS_OP_EQ, 3 }, { "!=", TS_OP_NE, 3 },  { "<=", TS_OP_LE, 4 },
	{ "<", TS_OP_LT, 4 },  { ">=", TS_OP_GE, 4 },  { ">", TS_OP_GT, 4 },
	{ "+", TS_OP_ADD, 5 }, { "-", TS_OP_SUB, 5 },  { "*", TS_OP_MUL, 6 },
	{ "/", TS_OP_DIV, 6 }, { "%", TS_OP_MOD, 6 },  { "^", TS_OP_POW, 7 },
};

enum ts_op ts_op_find(const char *text, int *level, size_t *length)
{
	for (size_t k = 0; k < sizeof operators / sizeof *operators; k++) {
		*length = strlen(operators[k].text);
		*level = operators[k].level;
		if (strncmp(text, operators[k].text, *length) == 0)
			return operators[k].op;
	}
	return TS_NOP;
}

static bool truth(double a)
{
	return a < 0 || a > 0;
}

static bool equal(double a, double b)
{
	return !(a < b) && !(a > b);
}

static double apply(enum ts_op op, double a, double b)
{
	switch (op) {
	case TS_OP_OR:
		return truth(a) || truth(b);
	case TS_OP_XOR:
		return truth(a) != truth(b);
	case TS_OP_AND:
		return truth(a) && truth(b);
	case TS_OP_EQ:
		return equal(a, b);
	case TS_OP_NE:
		return !equal(a, b);
	case TS_OP_LE:
		return a <= b;
	case TS_OP_LT:
		return a < b;
	case TS_OP_GE:
		return a >= b;
	case TS_OP_GT:
		return a > b;
	case TS_OP_ADD:
		return a + b;
	case TS_OP_SUB:
		return a - b;
	case TS_OP_MUL:
		return a * b;
	case TS_OP_DIV:
		return a / b;
	case TS_OP_MOD:
		return fmod(a, b);
	case TS_OP_POW:
		return pow(a, b);
	case TS_NOP:
		break;
	}
	return NAN;
}

static enum ts_status checked(struct ts_expr *e, enum ts_op op, size_t at, double a, double b,
			      double *out)
{
	size_t end = at + 1;

	if ((op == TS_OP_DIV || op == TS_OP_MOD) && !truth(b))
		return ts_expr_fail(e, TS_RANGE, at, end, "division of %.6g by zero", a);
	*out = apply(op, a, b);
	if (isfinite(*out))
		return TS_OK;
	return ts_expr_fail(e, TS_RANGE, at, end, "%.6g %c %.6g is %s", a, e->text[at], b,
			    isnan(*out) ? "not a real number" : "too large for a number");
}

enum ts_status ts_op_need_number(struct ts_expr *e, const struct ts_operand *a)
{
	if (!a->is_word)
		return TS_OK;
	return ts_expr_fail(e, TS_SYNTAX, a->at, a->end,
			    "'%s' is a word here, a number is needed; the value of a keyword or "
			    "variable is written $(%s) or v_NAME",
			    a->word, a->word);
}

enum ts_status ts_op_binary(struct ts_expr *e, enum ts_op op, size_t at, const struct ts_operand *a,
			    const struct ts_operand *b, struct ts_operand *out)
{
	bool words = a->is_word || b->is_word;

	*out = (struct ts_operand){ .at = a->at, .end = b->end };
	if (words && (op == TS_OP_EQ || op == TS_OP_NE)) {
		bool same = a->word && b->word && ts_streq(a->word, b->word);

		out->scalar = same == (op == TS_OP_EQ);
		return TS_OK;
	}
	TS_TRY(ts_op_need_number(e, a));
	TS_TRY(ts_op_need_number(e, b));
	if (!a->data && !b->data)
		return checked(e, op, at, a->scalar, b->scalar, &out->scalar);
	out->data = ts_expr_array(e);
	if (!out->data)
		return TS_NOMEM;
	for (size_t i = 0; i < e->rows; i++)
		TS_TRY(checked(e, op, at, a->data ? a->data[i] : a->scalar,
			       b->data ? b->data[i] : b->scalar, &out->data[i]));
	return TS_OK;
}

enum ts_status ts_op_unary(struct ts_expr *e, char op, struct ts_operand *a)
{
	double *data = a->data ? a->data : &a->scalar;

	TS_TRY(ts_op_need_number(e, a));
	for (size_t i = 0; i < (a->data ? e->rows : 1); i++) {
		if (op == '-')
			data[i] = -data[i];
		else if (op == '!')
			data[i] = !truth(data[i]);
	}
	a->word = NULL;
	return TS_OK;
}
