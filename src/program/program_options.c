/* The options of the command line. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/input_limit.h"
#include "core/ranks.h"
#include "program/program.h"
#include "program/program_ranks.h"
#include "script/script.h"
#include "tsim.h"

#include "base/banned.h"

enum option_id {
	OPT_IN,
	OPT_VAR,
	OPT_LOG,
	OPT_SCREEN,
	OPT_PROGRESS,
	OPT_ECHO,
	OPT_THREADS,
	OPT_PACKAGE,
	OPT_SUFFIX,
	OPT_NOCITE,
	OPT_LEGACY,
	OPT_LIMIT,
	OPT_SHELL,
	OPT_SANDBOX,
	OPT_CHECK,
	OPT_REPORT,
	OPT_SIGNAL,
	OPT_EXPLAIN,
	OPT_RANKS,
	OPT_FULL,
	OPT_ADVISE,
	OPT_CROSSCHECK,
	OPT_SWEEP,
	OPT_CALIBRATE,
	OPT_VARY,
	OPT_REPLICATE,
	OPT_TOLERANCE,
	OPT_JOBS,
	OPT_RESULTS,
	OPT_PLOT,
	OPT_RIGHT,
	OPT_X,
	OPT_STYLE,
	OPT_MARK,
	OPT_PANELS,
	OPT_OUT,
	OPT_XRANGE,
	OPT_YRANGE,
	OPT_RIGHTRANGE,
	OPT_PART,
	OPT_BY,
	OPT_TITLE,
	OPT_XLABEL,
	OPT_YLABEL,
	OPT_RIGHTLABEL,
	OPT_SIZE,
	OPT_HELP,
	OPT_DOC,
	OPT_GRAMMAR,
	OPT_VERSION,
	NOPTIONS
};

static const struct ts_program_option options[NOPTIONS] = {
	[OPT_IN] = { "in", "FILE", "script to run; without it standard input is read", 1, "i" },
	[OPT_VAR] = { "var", "NAME VALUE ...", "set an index variable of the script", 2, "v" },
	[OPT_LOG] = { "log", "FILE|none", "log file (log.tsim)", 1, "l" },
	[OPT_SCREEN] = { "screen", "FILE|none", "file for the screen output", 1, "sc" },
	[OPT_PROGRESS] = { "progress", "SECONDS|none",
			   "how long a terminal is silent before a run shows its progress (10)", 1 },
	[OPT_ECHO] = { "echo", "none|screen|log|both", "where input lines are echoed (log)", 1, "e" },
	[OPT_THREADS] = { "threads", "N", "number of threads (OMP_NUM_THREADS, else 1)", 1 },
	[OPT_PACKAGE] = { "package", "omp N", "the same, as in LAMMPS", 2, "pk" },
	[OPT_SUFFIX] = { "suffix", "WORDS", "of LAMMPS, no effect: all styles use threads", 1, "sf" },
	[OPT_NOCITE] = { "nocite", "", "of LAMMPS, no effect", 0, "nc" },
	[OPT_LEGACY] = { "legacy", "[lammps]",
			 "results of LIGGGHTS, or of LAMMPS, where they differ: -help legacy", 0 },
	[OPT_LIMIT] = { "input-limit", "GB",
			"most that a compressed input may unfold to, a frame of a dump; a line: a thousandth "
			"(4)",
			1 },
	[OPT_SHELL] = { "shell", "yes|no",
			"whether `shell` may start programs, set the environment, remove and move files "
			"anywhere (no)",
			1 },
	[OPT_SANDBOX] = { "sandbox", "[WORDS]",
			  "run an untrusted script: files of its folder only, with limits", 0 },
	[OPT_CHECK] = { "check", "", "run nothing: print all errors and what the script would do", 0 },
	[OPT_REPORT] = { "report", "FILE [WORDS]", "write a page about the run: -help report", 1 },
	[OPT_SIGNAL] = { "restart-on-signal", "FILE|none", "restart file of an interrupted run", 1 },
	[OPT_EXPLAIN] = { "explain", "", "run nothing: print the plan of each run", 0 },
	[OPT_RANKS] = { "ranks", "N", "with -explain or -check: as if mpirun started N ranks", 1 },
	[OPT_FULL] = { "full", "[PART ...]", "no optimizations that -explain lists as omitted: slower", 0 },
	[OPT_ADVISE] = { "advise", "[SECONDS] [WORDS]", "measure cost and effect of settings on the script",
			 0 },
	[OPT_CROSSCHECK] = { "crosscheck", "PROGRAM [WORDS]",
			     "run the script also with liggghts or lammps and compare all outputs", 1 },
	[OPT_SWEEP] = { "sweep", "NAME=VALUES ...", "run the script with all combinations of values", 1 },
	[OPT_CALIBRATE] = { "calibrate", "NAME=VALUE ...", "find variables for which results hit targets",
			    1 },
	[OPT_VARY] = { "vary", "NAME=START ...", "with -calibrate: the variables", 1 },
	[OPT_REPLICATE] = { "replicate", "NAME[=VALUES]",
			    "with both: the variable over which results are averaged", 1 },
	[OPT_TOLERANCE] = { "tolerance", "X", "with -calibrate: how near to a target, relative (0.05)", 1 },
	[OPT_JOBS] = { "j", "N", "with both: number of runs side by side (as many as processors)", 1 },
	[OPT_RESULTS] = { "results", "FOLDER", "with both: folder of the table and the runs (results)", 1 },
	[OPT_PLOT] = { "plot", "FILE [COLUMN ...]",
		       "draw columns of a log or table; several times: of all files", 1 },
	[OPT_RIGHT] = { "right", "COLUMN ...", "with -plot: of the file, by an axis on the right", 1 },
	[OPT_X] = { "x", "COLUMN", "with -plot: of the horizontal axis; -log x|y|xy|r: logarithmic axes", 1 },
	[OPT_STYLE] = { "style", "lines|points|both|steps", "with -plot: how curves are drawn", 1 },
	[OPT_MARK] = { "mark", "x|y=VALUE[:NAME] ...", "with -plot: lines across", 1 },
	[OPT_PANELS] = { "panels", "", "with -plot: a plot for each column, below each other", 0 },
	[OPT_OUT] = { "o", "FILE", "with -plot: picture, .svg or .png; without it the terminal is used", 1 },
	[OPT_XRANGE] = { "xrange", "LO:HI", "with -plot: ends of the axis, either may be left out", 1 },
	[OPT_YRANGE] = { "yrange", "LO:HI", "with -plot: the same of the vertical axis", 1 },
	[OPT_RIGHTRANGE] = { "rightrange", "LO:HI", "with -plot: the same of the axis on the right", 1 },
	[OPT_PART] = { "part", "N|last|all", "with -plot: which run of a log, which block of an average", 1 },
	[OPT_BY] = { "by", "COLUMN,...", "with -plot: a curve for each value of these columns", 1 },
	[OPT_TITLE] = { "title", "TEXT", "with -plot: title, '' for none (name of the file)", 1 },
	[OPT_XLABEL] = { "xlabel", "TEXT", "with -plot: name of the axis, its unit in parentheses", 1 },
	[OPT_YLABEL] = { "ylabel", "TEXT", "with -plot: the same of the vertical axis", 1 },
	[OPT_RIGHTLABEL] = { "rightlabel", "TEXT", "with -plot: the same of the axis on the right", 1 },
	[OPT_SIZE] = { "size", "WIDTHxHEIGHT", "with -plot: of a plot, letters are 13 high (480x320)", 1 },
	[OPT_HELP] = { "help", "[WORDS]", "manual page, -help fix gravity, or search, -help angle of repose",
		       0, "h" },
	[OPT_DOC] = { "doc", "DIR", "write all manual pages to the directory as Markdown", 1 },
	[OPT_GRAMMAR] = { "grammar", "vim|vscode|bash",
			  "print the colors for that editor, or the completion for bash", 1 },
	[OPT_VERSION] = { "version", "", "print the version, what this build has, and its libraries", 0 },
};

int ts_program_usage_error(const char *format, const char *what, const char *more)
{
	if (ts_program_ranks_first()) { /* options are read before ranks begin */
		fputs("tsim: ", stderr);
		fprintf(stderr, format, what, more);
		fputs("\n'tsim -help' lists the options\n", stderr);
	}
	return TS_EXIT_USAGE;
}

const struct ts_program_option *ts_program_option(size_t k)
{
	return k < NOPTIONS ? &options[k] : NULL;
}

void ts_program_list_options(void)
{
	for (int k = 0; k < NOPTIONS; k++)
		printf("  -%s %-*s %s\n", options[k].name, 30 - (int)strlen(options[k].name),
		       options[k].values, options[k].help);
}

static int set_legacy(struct tsim *sim, const char *of)
{
	if (of && !ts_streq(of, "lammps"))
		return ts_program_usage_error("expected lammps or nothing after -legacy, found '%s'%s", of,
					      "");
	sim->legacy = sim->legacy_option = of ? TS_LEGACY_LAMMPS : TS_LEGACY_LIGGGHTS;
	return 0;
}

static int set_echo(struct tsim *sim, const char *where)
{
	static const char *const choices[] = { "none", "screen", "log", "both" };

	for (int k = 0; k < 4; k++) {
		if (!ts_streq(choices[k], where))
			continue;
		sim->log.echo_screen = k & 1;
		sim->log.echo_file = k & 2;
		return 0;
	}
	return ts_program_usage_error("expected none, screen, log or both after -echo, found '%s'%s", where,
				      "");
}

static int set_progress(struct tsim *sim, const char *text)
{
	double *patience = &sim->log.patience;

	*patience = HUGE_VAL;
	if (ts_streq(text, "none") || (ts_parse_real(text, patience) && *patience >= 0))
		return 0;
	return ts_program_usage_error("expected seconds >= 0 or none after -progress, found '%s'%s", text,
				      "");
}

static int set_shell(struct tsim *sim, const char *text)
{
	if (!ts_streq(text, "yes") && !ts_streq(text, "no"))
		return ts_program_usage_error("expected yes or no after -shell, found '%s'%s", text, "");
	ts_script_allow_programs(sim->script_api_data, ts_streq(text, "yes"));
	return 0;
}

/* `range`: "1024 after -threads", with the largest number. */
static int set_count(int *out, const char *text, int most, const char *range)
{
	int64_t n;

	if (!ts_parse_int(text, &n) || n < 1 || n > most)
		return ts_program_usage_error("expected a number from 1 to %s, found '%s'", range, text);
	*out = (int)n;
	return 0;
}

static int set_input_limit(const char *text)
{
	double value;

	if (!ts_parse_real(text, &value) || value < 1e-6 || value > 1e6)
		return ts_program_usage_error("expected a number of GB from 1e-6 to 1e6 after -input-limit, "
					      "found '%s'%s",
					      text, "");
	if (setenv(TS_INPUT_LIMIT, text, 1) != 0)
		return ts_program_usage_error("-input-limit: the environment is full%s%s", "", "");
	return 0;
}

/* Without parts: all. */
static int set_full(struct tsim *sim, char *const *value, int n)
{
	static const char *const parts[] = { "columns", "rows",	 "history", "rebuilds",
					     "threads", "looks", NULL };

	sim->full |= n ? 0 : TS_FULL_ALL;
	for (int k = 0; k < n; k++) {
		int part = 0;

		while (parts[part] && !ts_streq(parts[part], value[k]))
			part++;
		if (!parts[part])
			return ts_program_usage_error("expected columns, rows, history, rebuilds, threads or "
						      "looks after -full, found '%s'%s",
						      value[k], "");
		sim->full |= 1u << part;
	}
	if (sim->full & TS_FULL_THREADS)
		sim->grain = 1;
	return 0;
}

static int set_variable(struct tsim *sim, char *const *value, int n)
{
	const char *list[TS_MOST_VALUES];

	if (n > TS_MOST_VALUES)
		return ts_program_usage_error("too many values for variable '%s'%s", value[0], "");
	for (int k = 1; k < n; k++)
		list[k - 1] = value[k];
	if (ts_script_set_variable(sim->script_api_data, value[0], list, (size_t)n - 1, "-var") == TS_OK)
		return 0;
	fputs(tsim_error(sim), stderr);
	return TS_EXIT_USAGE;
}

static int add_words(struct ts_word_list *list, const char *option, char *const *value, int n)
{
	size_t most = sizeof list->word / sizeof *list->word;

	if (list->n + (size_t)n + 1 > most)
		return ts_program_usage_error("too many words at '%s'%s", n ? value[0] : "-sandbox", "");
	if (option)
		list->word[list->n++] = (struct ts_word){ .text = option };
	for (int k = 0; k < n; k++)
		list->word[list->n++] = (struct ts_word){ .text = value[k] };
	return 0;
}

static int set_jobs(struct ts_setup *setup, const char *text)
{
	if (!ts_parse_int(text, &setup->jobs) || setup->jobs < 1 || setup->jobs > 1024)
		return ts_program_usage_error("expected a number from 1 to 1024 after -j, found '%s'%s", text,
					      "");
	return 0;
}

static int set_tolerance(struct ts_setup *setup, const char *text)
{
	if (!ts_parse_real(text, &setup->tolerance) || setup->tolerance <= 0 || setup->tolerance >= 1)
		return ts_program_usage_error("expected a number above 0 and below 1 after -tolerance, found "
					      "'%s'%s",
					      text, "");
	return 0;
}

static int usage_status(bool wrong)
{
	return wrong ? TS_EXIT_USAGE : 0;
}

/* -package omp N; 0: as many as without it. */
static int set_package(struct tsim *sim, struct ts_setup *setup, char *const *value)
{
	if (!ts_streq(value[0], "omp"))
		return ts_program_usage_error("expected omp after -package, found '%s'; tsim has threads%s",
					      value[0], "");
	if (ts_streq(value[1], "0"))
		return 0;
	return usage_status(add_words(&setup->own, "-threads", value + 1, 1) ||
			    set_count(&sim->threads, value[1], 1024, "1024 after -package omp"));
}

/* Options of -sweep and -calibrate. */
static int apply_study(struct ts_setup *setup, enum option_id id, char *const *value, int n)
{
	setup->studied |= id == OPT_SWEEP || id == OPT_CALIBRATE;
	switch (id) {
	case OPT_SWEEP:
		return add_words(&setup->sweep, NULL, value, n);
	case OPT_CALIBRATE:
		return add_words(&setup->calibrate, NULL, value, n);
	case OPT_VARY:
		return add_words(&setup->vary, NULL, value, n);
	case OPT_REPLICATE:
		return add_words(&setup->replicate, NULL, value, n);
	case OPT_TOLERANCE:
		return set_tolerance(setup, value[0]);
	case OPT_JOBS:
		return set_jobs(setup, value[0]);
	default:
		setup->results = value[0];
		return 0;
	}
}

/* Options of -plot. */
static int apply_plot(struct ts_setup *setup, enum option_id id, char *const *value, int n)
{
	struct ts_plot_words *w = &setup->plotted;
	const char **const place[OPT_SIZE - OPT_OUT + 1] = {
		[OPT_OUT - OPT_OUT] = &w->out,
		[OPT_XRANGE - OPT_OUT] = &w->xrange,
		[OPT_YRANGE - OPT_OUT] = &w->yrange,
		[OPT_PART - OPT_OUT] = &w->part,
		[OPT_BY - OPT_OUT] = &w->by,
		[OPT_TITLE - OPT_OUT] = &w->title,
		[OPT_XLABEL - OPT_OUT] = &w->xlabel,
		[OPT_YLABEL - OPT_OUT] = &w->ylabel,
		[OPT_SIZE - OPT_OUT] = &w->size,
		[OPT_RIGHTRANGE - OPT_OUT] = &w->right_range,
		[OPT_RIGHTLABEL - OPT_OUT] = &w->right_label,
	};

	setup->plots |= id == OPT_PLOT;
	setup->plot_words |= id != OPT_PLOT;
	switch (id) {
	case OPT_PLOT:
		return add_words(&setup->plot, "-plot", value, n);
	case OPT_RIGHT:
		return add_words(&setup->plot, "-right", value, n);
	case OPT_X:
		return add_words(&setup->plot, "-x", value, n);
	case OPT_STYLE:
		return add_words(&setup->plot, "-style", value, n);
	case OPT_MARK:
		return add_words(&setup->marks, NULL, value, n);
	case OPT_PANELS:
		w->panels = true;
		return 0;
	default:
		*place[id - OPT_OUT] = value[0];
		return 0;
	}
}

/* Options that print a page. */
static int apply_page(struct ts_setup *setup, enum option_id id, char *const *value, int n)
{
	if (id == OPT_HELP) {
		setup->help = true;
		setup->help_words = value;
		setup->help_count = n;
	} else if (id == OPT_DOC) {
		setup->doc = value[0];
	} else if (id == OPT_GRAMMAR) {
		setup->grammar = value[0];
	} else {
		setup->version = true;
	}
	return 0;
}

/* Options by which the script is read, planned, varied or compared instead of run. */
static int apply_plan(struct tsim *sim, struct ts_setup *setup, enum option_id id, char *const *value, int n)
{
	switch (id) {
	case OPT_EXPLAIN:
		sim->reading.explain = setup->explain = true;
		return 0;
	case OPT_RANKS:
		return set_count(&sim->reading.ranks, value[0], TS_RANKS_MOST, "a million after -ranks");
	case OPT_FULL:
		return set_full(sim, value, n);
	case OPT_CHECK:
		setup->check = true;
		return ts_script_check(sim->script_api_data) == TS_OK ? 0 : TS_EXIT_USAGE;
	case OPT_ADVISE:
		setup->advised = true;
		return add_words(&setup->advise, NULL, value, n);
	default: /* OPT_CROSSCHECK */
		return add_words(&setup->crosscheck, NULL, value, n);
	}
}

static int apply_option(struct tsim *sim, struct ts_setup *setup, enum option_id id, char *const *value,
			int n)
{
	switch (id) {
	case OPT_IN:
		setup->input = value[0];
		return add_words(&setup->inputs, NULL, value, n);
	case OPT_VAR:
		return usage_status(add_words(&setup->variables, "-var", value, n) ||
				    set_variable(sim, value, n));
	case OPT_LOG:
		setup->log = value[0];
		setup->log_given = true;
		break;
	case OPT_SCREEN:
		setup->screen = value[0];
		break;
	case OPT_PROGRESS:
		return set_progress(sim, value[0]);
	case OPT_ECHO:
		return set_echo(sim, value[0]);
	case OPT_THREADS:
		return usage_status(add_words(&setup->own, "-threads", value, n) ||
				    set_count(&sim->threads, value[0], 1024, "1024 after -threads"));
	case OPT_PACKAGE:
		return set_package(sim, setup, value);
	case OPT_SUFFIX:
	case OPT_NOCITE:
		break;
	case OPT_LEGACY:
		return set_legacy(sim, n ? value[0] : NULL);
	case OPT_SIGNAL:
		sim->requests.restart_file = ts_streq(value[0], "none") ? "" : value[0];
		break;
	case OPT_REPORT:
		return add_words(&setup->report, NULL, value, n);
	case OPT_SANDBOX:
		setup->sandboxed = true;
		return add_words(&setup->sandbox, NULL, value, n);
	case OPT_LIMIT:
		return set_input_limit(value[0]);
	case OPT_SHELL:
		setup->programs = ts_streq(value[0], "yes");
		return usage_status(add_words(&setup->own, "-shell", value, n) || set_shell(sim, value[0]));
	default:
		return id < OPT_SWEEP  ? apply_plan(sim, setup, id, value, n)
		       : id < OPT_PLOT ? apply_study(setup, id, value, n)
		       : id < OPT_HELP ? apply_plot(setup, id, value, n)
				       : apply_page(setup, id, value, n);
	}
	return 0;
}

/* -x or --x, but not -1.5 or a lone "-". */
static bool is_option(const char *text)
{
	return text[0] == '-' && text[1] && !strchr("0123456789.", text[1]);
}

static bool is_called(const struct ts_program_option *option, const char *name)
{
	return ts_streq(option->name, name) || (option->alias && ts_streq(option->alias, name));
}

static int unknown_option(const char *text)
{
	struct ts_suggest suggest = ts_suggest_start(text + 1);

	for (int k = 0; k < NOPTIONS; k++)
		ts_suggest_try(&suggest, options[k].name);
	if (suggest.best)
		return ts_program_usage_error("unknown option '%s'; did you mean '-%s'?", text, suggest.best);
	return ts_program_usage_error("unknown option '%s'%s", text, "");
}

/* Options that need another one. */
static int check_together(const struct tsim *sim, const struct ts_setup *setup)
{
	bool left =
		setup->vary.n || setup->replicate.n || setup->tolerance > 0 || setup->jobs || setup->results;

	if (!setup->plots && setup->plot_words)
		return ts_program_usage_error("-x, -right, -style, -mark, -panels, -o, -xrange, -yrange, "
					      "-rightrange, -part, -by, -title, -xlabel, -ylabel, "
					      "-rightlabel and -size belong to -plot, which is not given%s%s",
					      "", "");
	if (sim->reading.ranks && !setup->explain && !setup->check)
		return ts_program_usage_error("-ranks belongs to -explain or -check, and neither is given; "
					      "several ranks are started by mpirun -np N%s%s",
					      "", "");
	if (!setup->studied && left)
		return ts_program_usage_error("-vary, -replicate, -tolerance, -j and -results belong to "
					      "-sweep or -calibrate, and neither is given%s%s",
					      "", "");
	if (!setup->studied && setup->inputs.n > 1)
		return ts_program_usage_error("two scripts are given, '%s' and '%s': only -sweep and "
					      "-calibrate run several",
					      setup->inputs.word[0].text, setup->inputs.word[1].text);
	return 0;
}

int ts_program_options(struct tsim *sim, struct ts_setup *setup, int argc, char **argv)
{
	int k = 1;

	while (k < argc) {
		const char *text = argv[k++];
		const char *name = text + (is_option(text) ? 1 + (text[1] == '-') : 0);
		bool variadic;
		int id = 0, n = 0, status;

		if (name == text)
			return ts_program_usage_error("expected an option, found '%s'%s; a script is given "
						      "by -in FILE",
						      text, "");
		while (id < NOPTIONS && !is_called(&options[id], name))
			id++;
		if (id == NOPTIONS)
			return unknown_option(text);
		variadic = id == OPT_VAR || id == OPT_PACKAGE || id == OPT_SUFFIX || id == OPT_LEGACY ||
			   id == OPT_HELP || id == OPT_ADVISE || id == OPT_FULL || id == OPT_CROSSCHECK ||
			   id == OPT_SANDBOX || id == OPT_PLOT || id == OPT_RIGHT || id == OPT_MARK ||
			   id == OPT_REPORT || (id >= OPT_SWEEP && id <= OPT_REPLICATE);
		while (k + n < argc && !is_option(argv[k + n]) && (variadic || n < options[id].least))
			n++;
		if (n < options[id].least)
			return ts_program_usage_error("option -%s needs %s", options[id].name,
						      options[id].values);
		status = apply_option(sim, setup, (enum option_id)id, argv + k, n);
		if (status)
			return status;
		k += n;
	}
	return check_together(sim, setup);
}
