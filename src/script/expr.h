/* Formulas, evaluated while they are read: no tree is kept. A value is one number, or one per local
 * particle, or (in conditions) a word.
 *
 * Precedence from low to high, all left-associative as in LIGGGHTS:
 *   ||   &&   == !=   < <= > >=   + -   * / %   ^   then unary - and !
 * so -2^2 is 4 and 2^3^2 is 64. */
#ifndef TS_SCRIPT_EXPR_H
#define TS_SCRIPT_EXPR_H

#include "script/interpreter.h"

struct ts_operand {
	double scalar;
	double *data;	  /* not NULL: one value per particle, owned by the arena */
	const char *word; /* as written, if it is a bare name or a quoted word */
	bool is_word;	  /* has no number */
	size_t at, end;	  /* where it stands in the text */
};

struct ts_expr {
	struct ts_script *script;
	struct tsim *sim;
	struct ts_arena arena;
	const char *text;
	size_t length, at;
	const struct ts_place *place;
	bool peratom, condition;
	size_t rows; /* local particles, for peratom */
	int depth;
};

/* expr.c */
enum ts_status ts_expr_fail(struct ts_expr *e, enum ts_status code, size_t at, size_t end,
			    const char *format, ...) __attribute__((format(printf, 5, 6)));
/* An error of a callee that knew no place gets this one. */
enum ts_status ts_expr_blame(struct ts_expr *e, enum ts_status status, size_t at, size_t end);
enum ts_status ts_expr_read(struct ts_expr *e, int level, struct ts_operand *out);
char ts_expr_peek(struct ts_expr *e); /* the next character that is no blank */
enum ts_status ts_expr_expect(struct ts_expr *e, char wanted);
const char *ts_expr_copy(struct ts_expr *e, size_t at, size_t end); /* NULL: out of memory */
double *ts_expr_array(struct ts_expr *e);			    /* rows numbers, or NULL */

/* expr_operand.c */
enum ts_op {
	TS_OP_OR,
	TS_OP_XOR,
	TS_OP_AND,
	TS_OP_EQ,
	TS_OP_NE,
	TS_OP_LE,
	TS_OP_LT,
	TS_OP_GE,
	TS_OP_GT,
	TS_OP_ADD,
	TS_OP_SUB,
	TS_OP_MUL,
	TS_OP_DIV,
	TS_OP_MOD,
	TS_OP_POW,
	TS_NOP
};
/* The operator at the text, or TS_NOP; its level, 1 to 7, and length. */
enum ts_op ts_op_find(const char *text, int *level, size_t *length);
enum ts_status ts_op_binary(struct ts_expr *e, enum ts_op op, size_t at, const struct ts_operand *a,
			    const struct ts_operand *b, struct ts_operand *out);
enum ts_status ts_op_unary(struct ts_expr *e, char op, struct ts_operand *a);
/* Refuses words where numbers are needed. */
enum ts_status ts_op_need_number(struct ts_expr *e, const struct ts_operand *a);

/* expr_name.c: the name at `at`..`e->at`, which may be followed by [..] or (..). */
enum ts_status ts_expr_name(struct ts_expr *e, const char *name, size_t at, struct ts_operand *out);

/* expr_function.c, expr_series.c: what follows the bracket of a call. */
struct ts_math_function {
	const char *name, *arguments;
	size_t n;
	double (*pure)(double);
	enum ts_status (*eval)(struct ts_expr *e, const double *arg, double *out);
};
const struct ts_math_function *ts_math_function_find(const char *name);
void ts_math_function_suggest(struct ts_suggest *suggest);
enum ts_status ts_math_function_call(struct ts_expr *e, const struct ts_math_function *function,
				     size_t at, struct ts_operand *out);
struct ts_series_function;
const struct ts_series_function *ts_series_function_find(const char *name);
void ts_series_function_suggest(struct ts_suggest *suggest);
enum ts_status ts_series_function_call(struct ts_expr *e, const struct ts_series_function *function,
				       size_t at, struct ts_operand *out);
enum ts_status ts_group_function_call(struct ts_expr *e, const struct ts_function *function,
				      size_t at, struct ts_operand *out);

#endif
