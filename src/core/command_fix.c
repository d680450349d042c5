/* Command fix: makes a fix. */
#include "core/definition.h"

#include "base/banned.h"

static enum ts_status run(struct tsim *sim, void *state, const struct ts_place *where)
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
		.summary = "Makes something act on particles during runs",
		.doc = "Fixes act in the order in which they are made. An id in use by the same style is "
		       "replaced\n"
		       "in its place. See the pages of the fix styles.",
		.example = "fix fall all gravity 9.81 vector 0 0 -1",
		.args = args,
		.state_size = sizeof(struct ts_definition),
	},
	.run = run,
};
