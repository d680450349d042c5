/* Command fix: defines a fix. */
#include "core/definition.h"

#include "base/banned.h"

static enum ts_status run_fix(struct tsim *sim, void *state, const struct ts_place *where)
{
	(void)where;
	return ts_define(sim, TS_KIND_FIX, state);
}

static const struct ts_arg args[] = {
	TS_DEFINITION_ARGS("particles it acts on", "style and its arguments"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_fix)
const struct ts_command_style ts_command_fix = {
	.style = {
		.name = "fix",
		.kind = TS_KIND_COMMAND,
		.summary = "Defines an operation that is applied in each step of a run",
		.doc = "Fixes of the same stage of a step are applied in the order of their definition. A fix "
		       "with the\n"
		       "id of one of the same style replaces it, in its place of that order. See the pages of "
		       "the fix\n"
		       "styles.",
		.example = "fix fall all gravity 9.81 vector 0 0 -1",
		.args = args,
		.ranks = TS_RANKS_FORMULAS,
		.state_size = sizeof(struct ts_definition),
	},
	.run = run_fix,
};
