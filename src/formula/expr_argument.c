/* Arguments of a call. */
#include <ctype.h>
#include <string.h>

#include "formula/expr.h"

#include "base/banned.h"

enum ts_status ts_expr_count(struct ts_expr *e, size_t at, const char *name, const char *arguments,
			     size_t least, size_t most, size_t found)
{
	if (found >= least && found <= most)
		return TS_OK;
	if (least < most)
		return ts_expr_fail(e, TS_SYNTAX, at, e->at, "%s(%s) takes %zu to %zu arguments, found %s%zu",
				    name, arguments, least, most, found > most ? "at least " : "", found);
	return ts_expr_fail(e, TS_SYNTAX, at, e->at, "%s(%s) takes %zu argument%s, found %s%zu", name,
			    arguments, least, least == 1 ? "" : "s", found > most ? "at least " : "", found);
}

enum ts_status ts_expr_arguments(struct ts_expr *e, struct ts_operand *arg, size_t most, size_t *n)
{
	*n = 0;
	e->at++;
	if (ts_expr_peek(e) == ')') {
		e->at++;
		return TS_OK;
	}
	for (;;) {
		TS_TRY(ts_expr_read(e, 1, &arg[*n]));
		TS_TRY(ts_op_need_number(e, &arg[*n]));
		++*n;
		if (ts_expr_peek(e) != ',')
			return ts_expr_expect(e, ')');
		e->at++;
		if (*n == most) {
			++*n; /* too many: ts_expr_count fails */
			return TS_OK;
		}
	}
}

/* A word with ${ in it has not been replaced: that of a formula in $( ). */
static enum ts_status check_reference(struct ts_expr *e, size_t first, size_t end)
{
	for (; first + 1 < end; first++)
		if (e->text[first] == '$' && e->text[first + 1] == '{')
			return ts_expr_fail(e, TS_SYNTAX, first, end,
					    "variables are not replaced inside $( ): give the formula to "
					    "`variable NAME equal ...` and use that");
	return TS_OK;
}

enum ts_status ts_expr_words(struct ts_expr *e, size_t at, struct ts_word *word, size_t most, size_t *n)
{
	int depth = 0;

	*n = 0;
	do {
		size_t first = ++e->at, end;

		for (; e->text[e->at]; e->at++) {
			char c = e->text[e->at];

			if (!depth && (c == ',' || c == ')'))
				break;
			depth += (c == '(' || c == '[') - (c == ')' || c == ']');
		}
		if (!e->text[e->at])
			return ts_expr_fail(e, TS_SYNTAX, at, e->length, "'(' is never closed");
		end = e->at;
		while (first < end && isspace((unsigned char)e->text[first]))
			first++;
		while (first < end && isspace((unsigned char)e->text[end - 1]))
			end--;
		if (*n == most)
			return ts_expr_fail(e, TS_SYNTAX, first, end, "too many arguments");
		TS_TRY(check_reference(e, first, end));
		if (first == end && (*n || e->text[e->at] == ','))
			return ts_expr_fail(e, TS_SYNTAX, e->at, e->at + 1,
					    "an argument is missing before this");
		word[*n].text = ts_expr_copy(e, first, end);
		word[*n].place = ts_place_inside(e->place, e->length, first, end - first);
		if (!word[*n].text)
			return TS_NOMEM;
		*n += first < end;
	} while (e->text[e->at] == ',');
	e->at++;
	return TS_OK;
}
