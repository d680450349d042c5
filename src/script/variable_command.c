/* Command variable: defines or deletes a variable. */
#include "script/internal.h"

#include "base/banned.h"

TS_STYLE(command, ts_command_style, ts_command_variable)

struct variable {
	const char *name;
	int style;
	struct ts_words values;
};

#define NAME(style) #style,
static const char *const styles[] = { TS_VARIABLE_STYLES(NAME) "delete", NULL };
#undef NAME

static const struct ts_arg variable_args[] = {
	TS_WORD("name", struct variable, name, .flags = TS_POSITIONAL, .help = "letters, digits and _"),
	TS_ENUM("style", struct variable, style, styles, .flags = TS_POSITIONAL,
		.help = "style of the variable; delete: deletes the variable of that name"),
	TS_REST_OPTIONAL("values", struct variable, values,
			 .help = "index, universe: words; loop, uloop: N, or N1 N2, and pad; string, getenv, "
				 "world: one word; equal, atom, vector: a formula; format: a variable and a "
				 "format; internal: a number; file, atomfile: a path"),
	TS_ARGS_END
};

/* Deleting a variable that does not exist is no error (LIGGGHTS). */
static enum ts_status delete_variable(struct ts_script *script, const struct ts_word *name)
{
	struct ts_variable *found = ts_variable_find(&script->formulas, name->text);

	if (found && found->busy)
		return ts_fail(&script->sim->error, TS_STATE, &name->place,
			       "variable '%s' cannot be deleted while it is evaluated", name->text);
	if (found)
		ts_variable_delete(&script->formulas, found);
	return TS_OK;
}

/* As in LAMMPS variables in the quotes of a string are substituted when it is defined; LIGGGHTS keeps their names, and so does
 * a text that names a variable that is not defined yet. */
static enum ts_status define_string(struct ts_script *script, const struct ts_word *name,
				    struct ts_words values)
{
	struct ts_str text = { 0 };
	struct ts_word word = values.word[0];
	enum ts_status status = ts_substitute_text(script, word.text, &word.place, &text);

	if (status == TS_OK && text.failed)
		status = ts_nomem(&script->sim->error);
	if (status == TS_UNKNOWN && script->sim->error.missing[0]) {
		ts_warn(&script->sim->log, &word.place, "%s: variables in this text are not substituted",
			script->sim->error.message);
		ts_error_clear(&script->sim->error);
		status = TS_OK;
	} else {
		word.text = ts_str_text(&text);
	}
	if (status == TS_OK)
		status = ts_variable_define(&script->formulas, name, &ts_var_string,
					    (struct ts_words){ &word, 1 });
	ts_str_release(&text);
	return status;
}

static enum ts_status run_variable(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct variable *args = state;
	const struct ts_variable_style *style = ts_variable_styles[args->style];
	struct ts_script *script;
	struct ts_word name;

	TS_TRY(ts_script_of(sim, where, &script));
	name = (struct ts_word){ .text = args->name, .place = *ts_script_place(script, 1, where) };
	/* a program that sets a variable (no place) means the text as it is */
	if (style == &ts_var_string && args->values.n == 1 && args->values.word[0].place.file &&
	    sim->legacy != TS_LEGACY_LIGGGHTS)
		return define_string(script, &name, args->values);
	return style ? ts_variable_define(&script->formulas, &name, style, args->values)
		     : delete_variable(script, &name);
}

const struct ts_command_style ts_command_variable = {
	.style = {
		.name = "variable",
		.kind = TS_KIND_COMMAND,
		.ranks = TS_RANKS_FORMULAS,
		.summary = "defines a variable",
		.doc = "`tsim -help variables` describes the value of each style. A definition of style "
		       "index, loop, world, universe, uloop, file or atomfile has no effect if a variable of "
		       "that name exists, so that the option -var overrides it; the other styles replace a "
		       "variable of the same style. `equal`, `atom` and `vector` store a formula, which is "
		       "evaluated each time the variable is used; the page `functions` describes formulas. "
		       "`delete` deletes the variable, if it exists.\n\n"
		       "${name} (or $x for a one-letter name) outside of quotes is replaced by the value "
		       "before the line is executed; v_name is the value inside a formula; $(formula) is "
		       "replaced by the value of the formula. ${name:%.3f} and $(formula:%.3f) set the format "
		       "of the number.",
		.example = "variable wob index 2000\nvariable area equal PI*v_r^2\n"
			   "variable n loop 5\nvariable deep atom z<0.05\n"
			   "variable edges vector [0,0.1,0.25]",
		.args = variable_args,
		.state_size = sizeof(struct variable),
	},
	.run = run_variable,
};
