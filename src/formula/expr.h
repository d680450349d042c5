/* Formulas: a recursive-descent parser that evaluates while it reads, without a syntax tree. A value is a
 * number, a number per local particle, a list of numbers, or (in conditions) a word.
 *
 * Precedence from low to high, all left-associative as in LIGGGHTS (ts_operators in expr_operand.c):
 *   ||   &&   == !=   < <= > >=   + -   * / %   ^   then unary - and !
 * so -2^2 is 4 and 2^3^2 is 64. */
#ifndef TS_FORMULA_EXPR_H
#define TS_FORMULA_EXPR_H

#include "base/quotes.h"
#include "formula/unknown.h"
#include "math/rng.h"

/* TS_OPEN: known only after a run (-check, -explain). */
enum ts_truth { TS_NO, TS_YES, TS_OPEN };

/* Evaluate the formula `text`, which was written at `place`: a number; a number per local particle; a
 * list. */
enum ts_status ts_expr_scalar(struct ts_formulas *formulas, const char *text, const struct ts_place *place,
			      double *out);
enum ts_status ts_expr_peratom(struct ts_formulas *formulas, const char *text, const struct ts_place *place,
			       struct ts_table *out);
enum ts_status ts_expr_vector(struct ts_formulas *formulas, const char *text, const struct ts_place *place,
			      struct ts_table *out);
/* A number for each row of the columns of variables of style internal. */
enum ts_status ts_expr_columns(struct ts_formulas *formulas, const char *text, const struct ts_place *place,
			       struct ts_table *out);
/* The condition of an `if`, where bare names are words that can be compared. */
enum ts_status ts_expr_condition(struct ts_formulas *formulas, const char *text, const struct ts_place *place,
				 enum ts_truth *out);

/* The rest is for the files of this folder and the manual. */

struct ts_operand {
	double scalar;
	double *data; /* not NULL: n values, owned by the arena */
	size_t n;
	const char *word; /* as written, if it is a bare name or a quoted word; else NULL */
	bool is_word;	  /* it has no numeric value */
	size_t at, end;	  /* its position in the text */
};

/* Which values names may have in a formula: numbers; numbers and columns of particles; numbers and lists; numbers, and the
 * columns of variables of style internal. */
enum ts_formula { TS_FORMULA_SCALAR, TS_FORMULA_PERATOM, TS_FORMULA_VECTOR, TS_FORMULA_COLUMNS };

struct ts_expr {
	struct ts_formulas *formulas;
	struct tsim *sim;
	struct ts_arena arena;
	const char *text;
	size_t length, at; /* of the text; position of the parser */
	const struct ts_place *place;
	enum ts_formula kind;
	bool condition;	  /* bare names are words */
	size_t rows;	  /* TS_FORMULA_PERATOM: number of local particles */
	const double *id; /* their identities */
};

/* expr.c */
enum ts_status ts_expr_fail(struct ts_expr *e, enum ts_status code, size_t at, size_t end, const char *format,
			    ...) __attribute__((format(printf, 5, 6)));
/* Sets the place of an error that has none. */
enum ts_status ts_expr_locate_error(struct ts_expr *e, enum ts_status status, size_t at, size_t end);
/* Evaluates operators of precedence `level` and higher; level 1: a whole formula, or one in parentheses. */
enum ts_status ts_expr_read(struct ts_expr *e, int level, struct ts_operand *out);
/* A whole formula, which must have one number. */
enum ts_status ts_expr_read_number(struct ts_expr *e, double *out);
char ts_expr_peek(struct ts_expr *e); /* skips blanks and returns the next character */
enum ts_status ts_expr_expect(struct ts_expr *e, char wanted);
const char *ts_expr_copy(struct ts_expr *e, size_t at, size_t end); /* NULL: out of memory */
/* Makes the operand a list of n numbers. */
enum ts_status ts_expr_array(struct ts_expr *e, size_t n, struct ts_operand *out);
/* To be called with a value read from the simulation, and the status of reading it: if it depends on a run
 * that was left out, makes it unknown and returns TS_OK. */
enum ts_status ts_expr_or_unknown(struct ts_expr *e, const char *name, enum ts_status status,
				  struct ts_operand *out);
/* Copies the first column of the table to the operand if status is TS_OK; releases the table. */
enum ts_status ts_expr_take_table(struct ts_expr *e, enum ts_status status, struct ts_table *table,
				  struct ts_operand *out);

/* expr_operand.c */
struct ts_operator {
	const char *text;
	int level; /* precedence, 1 to 7 */
	double (*apply)(double a, double b);
	const char *help;
	bool divides; /* the right operand must not be 0 */
	bool compares_words;
	bool (*decides)(double a,
			double b); /* the result is known though an operand is unknown; NULL: never */
};
extern const struct ts_operator ts_operators[];		      /* closed by .text NULL */
const struct ts_operator *ts_operator_find(const char *text); /* the one the text begins with, or NULL */
enum ts_status ts_op_binary(struct ts_expr *e, const struct ts_operator *op, size_t at,
			    const struct ts_operand *a, const struct ts_operand *b, struct ts_operand *out);
enum ts_status ts_op_unary(struct ts_expr *e, char op, struct ts_operand *a);
/* Refuses words where numbers are needed. */
enum ts_status ts_op_need_number(struct ts_expr *e, const struct ts_operand *a);

/* expr_name.c: evaluates the name at `at`..`e->at`, which may be followed by [..] or (..). */
enum ts_status ts_expr_name(struct ts_expr *e, const char *name, size_t at, struct ts_operand *out);
struct ts_constant {
	const char *name;
	double value;
	const char *help;
};
extern const struct ts_constant ts_constants[]; /* closed by .name NULL */

/* expr_argument.c: read the arguments of a call, which are formulas, or words such as names of groups.
 * e->at is at the opening parenthesis before, behind the closing one after. */
enum ts_status ts_expr_arguments(struct ts_expr *e, struct ts_operand *arg, size_t most, size_t *n);
enum ts_status ts_expr_words(struct ts_expr *e, size_t at, struct ts_word *word, size_t most, size_t *n);
enum ts_status ts_expr_count(struct ts_expr *e, size_t at, const char *name, const char *arguments,
			     size_t least, size_t most, size_t found);
enum { TS_MOST_ARGUMENTS = 8 };

/* A function of formulas. The tables below are closed by .name NULL; each row has one of the six function
 * pointers. */
struct ts_expr_function {
	const char *name, *arguments, *help;
	size_t least, most;	/* number of arguments */
	double (*pure)(double); /* of one number */
	enum ts_status (*eval)(struct ts_expr *e, const double *arg, double *out);
	/* random; the last argument is the seed */
	enum ts_status (*draw)(struct ts_expr *e, const double *arg, struct ts_rng *rng, double *out);
	enum ts_status (*series)(const double *x, size_t n, double *out); /* number of a list, n >= length */
	size_t length;
	bool lazy;			  /* arguments but the first may be unknown: ternary */
	void (*map)(double *x, size_t n); /* replaces a list by another */
	/* of words */
	enum ts_status (*words)(struct ts_expr *e, struct ts_words words, struct ts_operand *out);
};
extern const struct ts_expr_function ts_math_functions[], ts_step_functions[], ts_series_functions[],
	ts_special_functions[];
/* All tables of functions, closed by NULL. */
extern const struct ts_expr_function *const ts_expr_functions[];
const struct ts_expr_function *ts_expr_function_find(const char *name);
/* Evaluate a call; e->at is at the opening parenthesis. */
enum ts_status ts_expr_call(struct ts_expr *e, const struct ts_expr_function *f, size_t at,
			    struct ts_operand *out);
enum ts_status ts_expr_call_group(struct ts_expr *e, const struct ts_function *f, size_t at,
				  struct ts_operand *out);

#endif
