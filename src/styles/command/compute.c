/* Command compute: makes a compute. */
#include "core/definition.h"

#include "base/banned.h"

static enum ts_status run(struct tsim *sim, void *state, const struct ts_place *where)
{
	(void)where;
	return ts_define(sim, TS_KIND_COMPUTE, state);
}

static const struct ts_arg args[] = {
	TS_DEFINITION_ARGS("particles it looks at", "style and its arguments"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_compute)
const struct ts_command_style ts_command_compute = {
	.style = {
		.name = "compute",
		.kind = TS_KIND_COMMAND,
		.summary = "Defines a quantity computed from particles",
		.doc = "It is evaluated when something asks for it by the name c_ID. See the pages of the compute\n"
		       "styles.",
		.example = "compute energy all ke",
		.args = args,
		.state_size = sizeof(struct ts_definition),
	},
	.needs_box = true,
	.run = run,
};
