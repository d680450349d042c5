/* Output of text: commands print, echo, log. */
#include <errno.h>
#include <stdio.h>
#include <string.h>

#include "base/mkdirs.h"
#include "core/written_files.h"
#include "formula/unknown.h"
#include "script/internal.h"

#include "base/banned.h"

TS_STYLE(command, ts_command_style, ts_command_echo)
TS_STYLE(command, ts_command_style, ts_command_log)
TS_STYLE(command, ts_command_style, ts_command_print)

struct print {
	const char *text, *file, *append;
	bool screen, universe;
};

static const struct ts_arg print_args[] = {
	TS_WORD("text", struct print, text, .flags = TS_POSITIONAL,
		.help = "text, in quotes if it has blanks; variables in it are replaced"),
	TS_WORD("file", struct print, file, .flags = TS_OPTIONAL | TS_WRITES,
		.help = "file to write the line to; an existing file is overwritten"),
	TS_WORD("append", struct print, append, .flags = TS_OPTIONAL | TS_WRITES,
		.help = "file to append the line to"),
	TS_BOOL("screen", struct print, screen, .fallback = "yes",
		.help = "whether the line is also written to screen and log"),
	TS_BOOL("universe", struct print, universe, .fallback = "no",
		.help = "no effect: there is one partition"),
	TS_ARGS_END
};

static enum ts_status write_text_to_file(struct tsim *sim, const char *path, const char *mode,
					 const char *text, const struct ts_place *where)
{
	FILE *file;
	int bad;

	if (!path || sim->reading.explain)
		return TS_OK;
	ts_mkdirs_for(&sim->files, path); /* a failure shows when the file is opened */
	errno = 0;
	file = ts_files_open(&sim->files, path, mode);
	if (!file)
		return ts_fail(&sim->error, TS_IO, where, "cannot open '%s': %s", path,
			       ts_files_why(&sim->files));
	bad = fprintf(file, "%s\n", text) < 0;
	bad |= fclose(file) != 0;
	if (bad)
		return ts_fail(&sim->error, TS_IO, where, "cannot write '%s': %s", path,
			       ts_files_why(&sim->files));
	return TS_OK;
}

static void print_text(struct tsim *sim, const char *text)
{
	struct ts_str shown = { 0 };

	ts_unknown_show(sim, text, "(unknown)", &shown);
	ts_log(&sim->log, "%s\n", ts_str_text(&shown));
	ts_str_release(&shown);
}

static enum ts_status run_print(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct print *print = state;
	struct ts_str text = { 0 };
	struct ts_script *script;
	enum ts_status status;

	TS_TRY(ts_script_of(sim, where, &script));
	if (print->file)
		TS_TRY(ts_written_files_allow(sim, "print", print->file, where));
	status = ts_substitute_shown(script, print->text, ts_script_place(script, 1, where), &text);
	if (status == TS_OK && print->screen)
		print_text(sim, ts_str_text(&text));
	if (status == TS_OK)
		status = write_text_to_file(sim, print->file, "w", ts_str_text(&text), where);
	if (status == TS_OK)
		status = write_text_to_file(sim, print->append, "a", ts_str_text(&text), where);
	ts_str_release(&text);
	return status;
}

const struct ts_command_style ts_command_print = {
	.style = {
		.name = "print",
		.kind = TS_KIND_COMMAND,
		.ranks = TS_RANKS_FORMULAS,
		.summary = "prints a line of text",
		.doc = "The text is written to the screen, to the log file, and to the file given by `file` "
		       "or `append`, which is not compressed, whatever its name. Variables in the text are substituted; "
		       "$(formula:%.3f) prints a number with this format.",
		.example = "print \"depth ${depth} m, energy $(ke:%.4g) J\" append depth.txt",
		.args = print_args,
		.state_size = sizeof(struct print),
	},
	.run = run_print,
};

struct echo {
	int where;
};

static const char *const echo_choices[] = { "none", "screen", "log", "both", NULL };

static const struct ts_arg echo_args[] = {
	TS_ENUM("where", struct echo, where, echo_choices, .flags = TS_POSITIONAL,
		.help = "where input lines are printed before they are executed"),
	TS_ARGS_END
};

static enum ts_status run_echo(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct echo *echo = state;

	(void)where;
	sim->log.echo_screen = echo->where & 1;
	sim->log.echo_file = echo->where & 2;
	return TS_OK;
}

const struct ts_command_style ts_command_echo = {
	.style = {
		.name = "echo",
		.kind = TS_KIND_COMMAND,
		.ranks = TS_RANKS_FORMULAS,
		.summary = "sets where input lines are printed",
		.doc = "The default is `log`, or that of the option -echo.",
		.example = "echo both",
		.args = echo_args,
		.state_size = sizeof(struct echo),
	},
	.run = run_echo,
};

struct log_to {
	const char *file;
	bool append;
};

static const struct ts_arg log_args[] = {
	TS_WORD("file", struct log_to, file, .flags = TS_POSITIONAL | TS_WRITES,
		.help = "new log file; none: write no log"),
	TS_FLAG("append", struct log_to, append, .help = "append to the file if it exists"), TS_ARGS_END
};

static enum ts_status run_log(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct log_to *to = state;
	struct ts_script *script;

	TS_TRY(ts_script_of(sim, where, &script));
	if (sim->reading.explain)
		return TS_OK;
	return ts_log_open(&sim->log, &sim->error, ts_script_place(script, 1, where),
			   ts_streq(to->file, "none") ? NULL : to->file, to->append);
}

const struct ts_command_style ts_command_log = {
	.style = {
		.name = "log",
		.kind = TS_KIND_COMMAND,
		.ranks = TS_RANKS_FORMULAS,
		.summary = "closes the log file and opens another",
		.doc = "The first log file is log.tsim, or that of the option -log. A log is not compressed, "
		       "whatever its name.",
		.example = "log drilling.log",
		.args = log_args,
		.state_size = sizeof(struct log_to),
	},
	.run = run_log,
};
