#include "script/language.h"

#include "script/expr.h"

#include "base/banned.h"

static bool style_row(size_t k, struct ts_language_row *out)
{
	const struct ts_variable_style *style = ts_variable_styles[k];

	if (style)
		*out = (struct ts_language_row){ style->name, style->values, style->help, 0 };
	return style != NULL;
}

static bool operator_row(size_t k, struct ts_language_row *out)
{
	static const struct ts_language_row before[] = { { "-", "", "the number with other sign", 8 },
							 { "!", "", "1 if 0, else 0", 8 } };
	size_t n = sizeof before / sizeof *before;
	const struct ts_operator *op;

	if (k < n) {
		*out = before[k];
		return true;
	}
	op = &ts_operators[k - n];
	if (op->text)
		*out = (struct ts_language_row){ op->text, "", op->help, op->level };
	return op->text != NULL;
}

static bool constant_row(size_t k, struct ts_language_row *out)
{
	const struct ts_constant *constant = &ts_constants[k];

	if (constant->name)
		*out = (struct ts_language_row){ constant->name, "", constant->help, 0 };
	return constant->name != NULL;
}

static bool function_row(const struct ts_expr_function *f, struct ts_language_row *out)
{
	if (f->name)
		*out = (struct ts_language_row){ f->name, f->arguments, f->help, 0 };
	return f->name != NULL;
}

static bool math_row(size_t k, struct ts_language_row *out)
{
	return function_row(&ts_math_functions[k], out);
}

static bool step_row(size_t k, struct ts_language_row *out)
{
	return function_row(&ts_step_functions[k], out);
}

static bool series_row(size_t k, struct ts_language_row *out)
{
	return function_row(&ts_series_functions[k], out);
}

static bool special_row(size_t k, struct ts_language_row *out)
{
	return function_row(&ts_special_functions[k], out);
}

/* Functions of groups, from the systems that have them. */
static bool group_row(size_t k, struct ts_language_row *out)
{
	for (const struct ts_system_style *const *s = ts_system_table; *s; s++) {
		for (const struct ts_function *f = (*s)->functions; f && f->name; f++) {
			if (k-- > 0)
				continue;
			*out = (struct ts_language_row){ f->name, f->arguments, f->help, 0 };
			return true;
		}
	}
	return false;
}

const struct ts_language_topic ts_language_topics[] = {
	{ "variables", "Styles of variables", style_row },
	{ "operators", "Operators, from the loosest (level 1) to the tightest", operator_row },
	{ "constants", "Constants", constant_row },
	{ "functions", "Functions of numbers", math_row },
	{ "functions", "Functions of the clock", step_row },
	{ "functions", "Functions of a list of numbers", series_row },
	{ "functions", "Functions of a group, or of its part in a region", group_row },
	{ "functions", "Functions of names", special_row },
	{ .name = NULL },
};
