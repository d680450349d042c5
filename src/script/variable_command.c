#include "script/interpreter.h"

#include "base/banned.h"

TS_STYLE(command, ts_command_style, ts_command_variable)

struct variable {
	const char *name;
	int style;
	struct ts_words values;
};

/* The names of enum ts_variable_style, then `delete`, then LIGGGHTS' words for many replicas, of
 * which there is one here. */
static const char *const styles[] = { "index",	"loop",	    "string", "getenv", "equal", "atom",
				      "delete", "universe", "world",  "uloop",	NULL };
enum { DELETE = TS_VAR_ATOM + 1, UNIVERSE, WORLD, ULOOP };

static const struct ts_arg variable_args[] = {
	TS_WORD("name", struct variable, name, .flags = TS_POSITIONAL,
		.help = "letters, digits and _"),
	TS_ENUM("style", struct variable, style, styles, .flags = TS_POSITIONAL,
		.help = "what the variable is"),
	{ .name = "values",
	  .type = TS_ARG_REST,
	  .flags = TS_POSITIONAL | TS_OPTIONAL,
	  .offset = TS_FIELD(struct variable, values, struct ts_words *),
	  .help = "index: words; loop: N, or N1 N2 [pad]; string, getenv: one word; equal, "
		  "atom: a formula; delete: nothing" },
	TS_ARGS_END
};

static enum ts_status run_variable(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct variable *args = state;
	enum ts_variable_style style = TS_VAR_INDEX;
	struct ts_variable *found;
	struct ts_script *script;
	struct ts_word name;

	TS_TRY(ts_script_of(sim, where, &script));
	name = (struct ts_word){ .text = args->name, .place = *ts_script_place(script, 1, where) };
	if (args->style == DELETE) {
		TS_TRY(ts_variable_require(script, args->name, &name.place, &found));
		if (found->busy)
			return ts_fail(&sim->error, TS_STATE, &name.place,
				       "variable '%s' cannot be deleted while it is evaluated",
				       args->name);
		ts_variable_delete(script, found);
		return TS_OK;
	}
	if (args->style < DELETE)
		style = (enum ts_variable_style)args->style;
	else if (args->style == ULOOP)
		style = TS_VAR_LOOP;
	return ts_variable_define(script, &name, style, args->values);
}

const struct ts_command_style ts_command_variable = {
	.style = {
		.name = "variable",
		.kind = TS_KIND_COMMAND,
		.summary = "defines a variable",
		.doc = "`index` and `loop` variables step through their values with `next`; if one "
		       "of that name exists already the line does nothing, so that the option -var "
		       "wins. `equal` and `atom` keep a formula, which is evaluated each time the "
		       "variable is used; `string`, `getenv`, `equal` and `atom` replace a variable "
		       "of the same style.\n\n"
		       "${name} (or $x for a one-letter name) puts the value into a line before it "
		       "is run, outside of quotes; v_name reads it inside a formula; $(formula) "
		       "evaluates at once.",
		.example = "variable wob index 2000\nvariable area equal PI*v_r^2\n"
			   "variable n loop 5\nvariable deep atom z<0.05",
		.args = variable_args,
		.state_size = sizeof(struct variable),
	},
	.run = run_variable,
};
