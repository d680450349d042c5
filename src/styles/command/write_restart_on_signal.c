/* Command write_restart_on_signal: whether an interrupted run leaves a restart file. */
#include "core/sim.h"

#include "base/banned.h"

struct state {
	bool write;
	const char *file;
};

static enum ts_status run(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct state *s = state;

	(void)where;
	sim->restart_on_signal = NULL;
	if (s->write && !s->file)
		return TS_OK;
	sim->restart_on_signal = ts_pool_get(sim->pool, s->write ? s->file : "");
	return sim->restart_on_signal ? TS_OK : ts_nomem(&sim->error);
}

static const struct ts_arg args[] = {
	TS_BOOL("write", struct state, write, .flags = TS_POSITIONAL,
		.help = "whether a run stopped by a signal saves its state"),
	TS_WORD("file", struct state, file, .flags = TS_OPTIONAL, .help = "name of the file"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_write_restart_on_signal)
const struct ts_command_style ts_command_write_restart_on_signal = {
	.style = {
		.name = "write_restart_on_signal",
		.kind = TS_KIND_COMMAND,
		.summary = "Whether an interrupted run leaves a restart file",
		.doc = "After the signals INT (Ctrl-C), TERM and HUP the step at hand is finished, files are completed,\n"
		       "and the state is saved, by default as tsim.interrupted.restart beside the log file; a run that\n"
		       "goes on from it gives the same numbers as one that was not interrupted. The message says how.\n"
		       "A second signal stops at once. `-restart-on-signal FILE` or `none` on the command line says the\n"
		       "same from outside.",
		.example = "write_restart_on_signal no\n"
			   "write_restart_on_signal yes file post/interrupted.restart",
		.args = args,
		.state_size = sizeof(struct state),
	},
	.run = run,
};
