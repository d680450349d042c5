/* Command write_restart: saves the whole state. */
#include "core/sim.h"
#include "io/textfile.h"
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
	ts_step_path(&path, s->file, (long long)sim->clock.step, 0);
	status = path.failed ? ts_nomem(&sim->error) : ts_restart_write(sim, ts_str_text(&path), where);
	ts_str_release(&path);
	return status;
}

static const struct ts_arg args[] = {
	TS_WORD("file", struct state, file, .flags = TS_POSITIONAL | TS_WRITES,
		.help = "name of the file; `*` stands for the step"),
	TS_FLAG("noinit", struct state, noinit, .help = "no effect: nothing has to be prepared for the file"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_write_restart)
const struct ts_command_style ts_command_write_restart = {
	.style = {
		.name = "write_restart",
		.kind = TS_KIND_COMMAND,
		.summary = "Saves the whole state to a file",
		.doc = "The file is compressed and checksummed, written beside its place and renamed into "
		       "it: an older\n"
		       "file of the same name stays whole until the new one is complete. A run continued "
		       "from it gives\n"
		       "the same numbers, bit for bit, as a run that was not interrupted. Missing folders on "
		       "the way to it are made.",
		.example = "write_restart rock.restart",
		.args = args,
		.state_size = sizeof(struct state),
	},
	.needs_box = true,
	.run = run,
};
