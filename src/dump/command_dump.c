/* Command dump: defines a dump. */
#include "core/definition.h"

#include "base/banned.h"

static enum ts_status run(struct tsim *sim, void *state, const struct ts_place *where)
{
	(void)where;
	return ts_define(sim, TS_KIND_DUMP, state);
}

static const struct ts_arg args[] = {
	TS_DEFINITION_ARGS("particles to write", "style, steps between frames, file, columns"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_dump)
const struct ts_command_style ts_command_dump = {
	.style = {
		.name = "dump",
		.kind = TS_KIND_COMMAND,
		.summary = "Writes snapshots to files during runs",
		.doc = "Defines a dump, which writes snapshots to files during runs; the styles have pages of "
		       "their own. dump_modify changes the settings of a dump, undump ends it. Folders in the "
		       "path of the file are created if they do not exist. A dump with the id of one of the "
		       "same style replaces it; LIGGGHTS and LAMMPS refuse that.",
		.example = "dump rock all custom 1000 post/rock.dump id type x y z radius",
		.args = args,
		.ranks = TS_RANKS_FORMULAS,
		.state_size = sizeof(struct ts_definition),
	},
	.needs_box = true,
	.run = run,
};
