/* Command thermo_log: writes thermo output to a file, too. */
#include "core/sim.h"
#include "thermo/thermo.h"

#include "base/banned.h"

struct state {
	const char *file;
};

static enum ts_status run(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct state *s = state;

	if (sim->reading.explain)
		return TS_OK;
	TS_TRY(ts_textfile_close(&sim->thermo->file));
	return ts_textfile_open(&sim->thermo->file, sim, where, s->file, false);
}

static const struct ts_arg args[] = {
	TS_WORD("file", struct state, file, .flags = TS_POSITIONAL | TS_WRITES, .help = "name of the file"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_thermo_log)
const struct ts_command_style ts_command_thermo_log = {
	.style = {
		.name = "thermo_log",
		.kind = TS_KIND_COMMAND,
		.summary = "Writes thermo output to a file, too",
		.doc = "The file contains only the titles and the rows of the thermo output.",
		.example = "thermo_log thermo.txt",
		.args = args,
		.state_size = sizeof(struct state),
	},
	.run = run,
};
