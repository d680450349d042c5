/* Variables of one value: string, getenv, format, timer, once, internal. */
#include <stdlib.h>

#include "base/clock.h"
#include "core/ranks.h"
#include "formula/expr.h"
#include "formula/number_format.h"

#include "base/banned.h"

static enum ts_status string_text(struct ts_formulas *formulas, struct ts_variable *variable,
				  const struct ts_place *where, struct ts_str *out)
{
	(void)formulas, (void)where;
	ts_str_add(out, variable->values.word[0].text);
	return TS_OK;
}

const struct ts_variable_style ts_var_string = {
	.name = "string",
	.values = "text",
	.help = "a text, in quotes if it has blanks; variables in it are substituted when it is defined",
	.least = 1,
	.most = 1,
	.text = string_text,
};

static enum ts_status getenv_text(struct ts_formulas *formulas, struct ts_variable *variable,
				  const struct ts_place *where, struct ts_str *out)
{
	const char *name = variable->values.word[0].text, *text = getenv(name);

	if (formulas->sim->files.closed)
		return ts_fail(&formulas->sim->error, TS_STATE, where,
			       "variable '%s': with -sandbox a script does not see the environment",
			       variable->name);
	if (!text)
		return ts_fail(&formulas->sim->error, TS_UNKNOWN, where,
			       "there is no environment variable '%s', which variable '%s' reads", name,
			       variable->name);
	ts_str_add(out, text);
	return TS_OK;
}

const struct ts_variable_style ts_var_getenv = {
	.name = "getenv",
	.values = "NAME",
	.help = "the environment variable of that name, read when the variable is used",
	.reads_all = true,
	.least = 1,
	.most = 1,
	.text = getenv_text,
};

static enum ts_status define_format(struct ts_formulas *formulas, struct ts_variable *variable)
{
	return ts_number_format_check(&formulas->sim->error, variable->values.word[1].text,
				      &variable->values.word[1].place);
}

static enum ts_status format_text(struct ts_formulas *formulas, struct ts_variable *variable,
				  const struct ts_place *where, struct ts_str *out)
{
	const struct ts_word *word = variable->values.word;
	struct ts_variable *source;
	double value = 0;

	(void)where;
	TS_TRY(ts_variable_require(formulas, word[0].text, &word[0].place, &source));
	TS_TRY(ts_variable_number(formulas, source, &word[0].place, &value));
	ts_unknown_add(formulas->sim, out, word[1].text, value);
	return TS_OK;
}

const struct ts_variable_style ts_var_format = {
	.name = "format",
	.values = "NAME FORMAT",
	.help = "the value of another variable, in a format such as %.6g",
	.least = 2,
	.most = 2,
	.define = define_format,
	.text = format_text,
};

static enum ts_status define_timer(struct ts_formulas *formulas, struct ts_variable *variable)
{
	if (variable->values.n)
		return ts_fail(&formulas->sim->error, TS_SYNTAX, &variable->values.word[0].place,
			       "a variable of style timer takes no words, found '%s'",
			       variable->values.word[0].text);
	variable->number = ts_ranks_same(formulas->sim, ts_clock());
	return TS_OK;
}

static enum ts_status plain_text(struct ts_formulas *formulas, struct ts_variable *variable,
				 const struct ts_place *where, struct ts_str *out)
{
	(void)where;
	ts_unknown_add(formulas->sim, out, "%.15g", variable->number);
	return TS_OK;
}

static enum ts_status plain_number(struct ts_formulas *formulas, struct ts_variable *variable,
				   const struct ts_place *where, double *out)
{
	(void)formulas, (void)where;
	*out = variable->number;
	return TS_OK;
}

const struct ts_variable_style ts_var_timer = {
	.reads_all = true,
	.name = "timer",
	.values = "",
	.help = "wall time in seconds when this line is executed; the difference of two is a duration",
	.define = define_timer,
	.text = plain_text,
	.number = plain_number,
};

/* In a script that continues from a restart file the value is the saved one. */
static enum ts_status define_once(struct ts_formulas *formulas, struct ts_variable *variable)
{
	const struct ts_word *formula = &variable->values.word[0];
	bool resumed = false;

	TS_TRY(ts_variable_resume(formulas, variable, &resumed));
	return resumed ? TS_OK : ts_expr_scalar(formulas, formula->text, &formula->place, &variable->number);
}

static bool save_once(const struct ts_variable *variable, double *number)
{
	*number = variable->number;
	return true;
}

static enum ts_status restore_once(struct ts_formulas *formulas, struct ts_variable *variable, double number)
{
	variable->number = number;
	ts_log(&formulas->sim->log, "Variable %s continues with %.15g from the restart file\n",
	       variable->name, number);
	return TS_OK;
}

const struct ts_variable_style ts_var_once = {
	.name = "once",
	.values = "formula",
	.help = "the value of a formula when this line is executed first; it is saved in restart files, and "
		"a script that continues from one gets the saved value",
	.least = 1,
	.most = 1,
	.keeps = true,
	.define = define_once,
	.text = plain_text,
	.number = plain_number,
	.save = save_once,
	.restore = restore_once,
};

static enum ts_status define_internal(struct ts_formulas *formulas, struct ts_variable *variable)
{
	const struct ts_word *word = variable->values.word;

	if (ts_unknown_read_text(formulas, word->text))
		variable->number = NAN;
	else if (!ts_parse_real(word->text, &variable->number))
		return ts_fail(&formulas->sim->error, TS_SYNTAX, &word->place,
			       "expected a number, found '%s'", word->text);
	return TS_OK;
}

static enum ts_status internal_number(struct ts_formulas *formulas, struct ts_variable *variable,
				      const struct ts_place *where, double *out)
{
	formulas->by_number |= variable->column != NULL;
	return plain_number(formulas, variable, where, out);
}

static enum ts_status internal_columns(struct ts_formulas *formulas, struct ts_variable *variable,
				       const struct ts_place *where, struct ts_table *out)
{
	(void)where;
	if (ts_table_resize(out, formulas->rows, 1) != TS_OK)
		return ts_nomem(&formulas->sim->error);
	for (size_t k = 0; k < formulas->rows; k++)
		out->data[k] = variable->column ? variable->column[k] : variable->number;
	return TS_OK;
}

const struct ts_variable_style ts_var_internal = {
	.name = "internal",
	.values = "number",
	.help = "a number that a command sets for the formulas it evaluates, e.g. create_atoms var",
	.least = 1,
	.most = 1,
	.define = define_internal,
	.text = plain_text,
	.number = internal_number,
	.columns = internal_columns,
};
