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
	sim->requests.restart_file = NULL;
	if (s->write && !s->file)
		return TS_OK;
	sim->requests.restart_file = ts_pool_get(sim->pool, s->write ? s->file : "");
	return sim->requests.restart_file ? TS_OK : ts_nomem(&sim->error);
}

static const struct ts_arg args[] = {
	TS_BOOL("write", struct state, write, .flags = TS_POSITIONAL,
		.help = "whether signals save the state"),
	TS_WORD("file", struct state, file, .flags = TS_OPTIONAL, .help = "name of the file"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_write_restart_on_signal)
const struct ts_command_style ts_command_write_restart_on_signal = {
	.style = {
		.name = "write_restart_on_signal",
		.kind = TS_KIND_COMMAND,
		.summary = "Whether signals write a restart file: interrupts, USR1, USR2",
		.doc = "After the signals INT (Ctrl-C), TERM, HUP and USR2 the step at hand is finished, "
		       "files are completed,\n"
		       "and the state is saved, by default as tsim.interrupted.restart beside the log file; "
		       "a `*` in the\n"
		       "name stands for the step. A run that goes on from it gives the same numbers as one "
		       "that was not\n"
		       "interrupted. The message says how. The exit status is 128 and the number of the "
		       "signal (USR2: 140);\n"
		       "after USR2 it is 1 if the file could not be written. A second of these signals ends "
		       "the program at once.\n\n"
		       "After the signal USR1 the same file is written at the end of the step, after all "
		       "outputs of that step,\n"
		       "and the run goes on with the same numbers. Several USR1 within a step write one "
		       "file. If the file\n"
		       "cannot be written a warning says why. The log says what was done.\n\n"
		       "Between runs, and while a command reads files or creates particles, USR1 acts after "
		       "that command; before\n"
		       "there is a box nothing is saved. The other signals end such a command where they "
		       "can, and nothing\n"
		       "is saved then, because its work is not done; after a command that was finished the "
		       "state is saved.\n"
		       "With `no`, with `-restart-on-signal none` and with -check and -explain no file is "
		       "written: USR1 has no\n"
		       "effect, the others stop. `-restart-on-signal FILE` or `none` on the command line "
		       "says the same from\n"
		       "outside. Programs that use the library keep their own handlers of all signals.",
		.example = "write_restart_on_signal no\n"
			   "write_restart_on_signal yes file post/interrupted.restart",
		.args = args,
		.state_size = sizeof(struct state),
	},
	.run = run,
};
