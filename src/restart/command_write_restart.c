/* Command write_restart: writes the state of the simulation to a restart file. */
#include "core/sim.h"
#include "io/series.h"
#include "restart/restart.h"

#include "base/banned.h"

struct state {
	const char *file;
	bool noinit;
};

static enum ts_status run(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct state *s = state;
	struct ts_str path = { 0 };
	enum ts_status status;

	if (sim->reading.explain)
		return TS_OK;
	ts_series_path(&path, s->file, (long long)sim->clock.step, 0);
	status = path.failed ? ts_nomem(&sim->error) : ts_restart_write(sim, ts_str_text(&path), where);
	ts_str_release(&path);
	return status;
}

static const struct ts_arg args[] = {
	TS_WORD("file", struct state, file, .flags = TS_POSITIONAL | TS_WRITES,
		.help = "name of the file; `*` stands for the step"),
	TS_FLAG("noinit", struct state, noinit, .help = "no effect: the file can be written at any time"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_write_restart)
const struct ts_command_style ts_command_write_restart = {
	.style = {
		.name = "write_restart",
		.kind = TS_KIND_COMMAND,
		.summary = "Writes the state of the simulation to a restart file",
		.doc = "The file is compressed and has checksums. It is written under a temporary name and "
		       "renamed: a previous file of the same name is complete until the new one is. A run "
		       "continued from the file gives the same numbers, bit for bit, as an uninterrupted run. "
		       "Folders in the path of the file are created if they do not exist.",
		.example = "write_restart rock.restart",
		.args = args,
		.state_size = sizeof(struct state),
	},
	.needs_box = true,
	.run = run,
};
