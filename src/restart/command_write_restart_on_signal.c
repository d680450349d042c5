/* Command write_restart_on_signal: whether signals write a restart file. */
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
	sim->requests.restart_file = NULL;
	if (s->write && !s->file)
		return TS_OK;
	sim->requests.restart_file = ts_pool_get(sim->pool, s->write ? s->file : "");
	return sim->requests.restart_file ? TS_OK : ts_nomem(&sim->error);
}

static const struct ts_arg args[] = {
	TS_BOOL("write", struct state, write, .flags = TS_POSITIONAL,
		.help = "whether signals write a restart file"),
	TS_WORD("file", struct state, file, .flags = TS_OPTIONAL, .help = "name of the file"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_write_restart_on_signal)
const struct ts_command_style ts_command_write_restart_on_signal = {
	.style = {
		.name = "write_restart_on_signal",
		.kind = TS_KIND_COMMAND,
		.summary = "Whether signals write a restart file: interrupts, USR1, USR2",
		.doc = "After one of the signals INT (Ctrl-C), TERM, HUP and USR2 the current step is "
		       "finished, output files are completed, and a restart file is written, by default "
		       "tsim.interrupted.restart in the folder of the log file; a `*` in the name stands for "
		       "the step. A run continued from it gives the same numbers as an uninterrupted one. The "
		       "message says how to continue. The exit status is 128 plus the number of the signal "
		       "(USR2: 140); after USR2 it is 1 if the file could not be written. A second of these "
		       "signals ends the program at once.\n\n"
		       "After the signal USR1 the same file is written at the end of the step, after all "
		       "outputs of that step, and the run continues with the same numbers. Several signals "
		       "USR1 within a step write one file. If the file cannot be written, a warning gives the "
		       "reason. The log reports each file.\n\n"
		       "Between runs, and while a command reads files or creates particles, USR1 takes effect "
		       "after that command; before there is a box nothing is written. The other signals abort "
		       "such a command where possible, and nothing is written then, because the command is "
		       "incomplete; after a completed command the file is written. With `no`, with "
		       "`-restart-on-signal none` and with -check and -explain no file is written: USR1 has "
		       "no effect, the other signals end the run. The command line options "
		       "`-restart-on-signal FILE` and `-restart-on-signal none` set the same. Programs that "
		       "use the library keep their own handlers of all signals.",
		.example = "write_restart_on_signal no\n"
			   "write_restart_on_signal yes file post/interrupted.restart",
		.args = args,
		.state_size = sizeof(struct state),
	},
	.run = run,
};
