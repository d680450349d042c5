/* Command line in, exit status out. */
#include <inttypes.h>
#include <signal.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/clock.h"
#include "core/help.h"
#include "core/price.h"
#include "core/sim.h"
#include "crosscheck/crosscheck.h"
#include "script/manual.h"
#include "io/restart.h"
#include "script/script.h"
#include "tsim.h"

#include "base/banned.h"

enum { EXIT_USAGE = 2, MOST_VALUES = 256 };

enum option_id {
	OPT_IN,
	OPT_VAR,
	OPT_LOG,
	OPT_SCREEN,
	OPT_ECHO,
	OPT_THREADS,
	OPT_LEGACY,
	OPT_SHELL,
	OPT_CHECK,
	OPT_SIGNAL,
	OPT_EXPLAIN,
	OPT_CROSSCHECK,
	OPT_HELP,
	OPT_DOC,
	OPT_GRAMMAR,
	OPT_VERSION,
	NOPTIONS
};

static const struct {
	const char *name, *values, *help;
	int least; /* number of values it must have */
} options[NOPTIONS] = {
	[OPT_IN] = { "in", "FILE", "script to run; without it standard input is read", 1 },
	[OPT_VAR] = { "var", "NAME VALUE ...", "set an index variable of the script", 2 },
	[OPT_LOG] = { "log", "FILE|none", "log file (log.tsim)", 1 },
	[OPT_SCREEN] = { "screen", "FILE|none", "write there what else goes to the screen", 1 },
	[OPT_ECHO] = { "echo", "none|screen|log|both", "where input lines are shown (log)", 1 },
	[OPT_THREADS] = { "threads", "N", "number of threads (OMP_NUM_THREADS, else 1)", 1 },
	[OPT_LEGACY] = { "legacy", "", "the numbers of LIGGGHTS where they differ, see -help legacy", 0 },
	[OPT_SHELL] = { "shell", "yes|no", "whether `shell` may start programs (no)", 1 },
	[OPT_CHECK] = { "check", "", "run nothing: tell all errors and what the script would do", 0 },
	[OPT_SIGNAL] = { "restart-on-signal", "FILE|none", "where an interrupted run saves its state", 1 },
	[OPT_EXPLAIN] = { "explain", "", "run nothing: print the plan of each run", 0 },
	[OPT_CROSSCHECK] = { "crosscheck", "PROGRAM [WORDS]",
			     "run the script with liggghts or lammps too and compare all outputs", 1 },
	[OPT_HELP] = { "help", "[KIND] [NAME]", "manual page, e.g. -help fix gravity, -help ave/time", 0 },
	[OPT_DOC] = { "doc", "DIR", "write all manual pages to the directory as Markdown", 1 },
	[OPT_GRAMMAR] = { "grammar", "vim|vscode", "print the grammar file for that editor", 1 },
	[OPT_VERSION] = { "version", "", "print the version", 0 },
};

struct word_list {
	struct ts_word word[2 * MOST_VALUES];
	size_t n;
};

struct setup {
	const char *input, *log, *screen, *doc, *grammar;
	FILE *screen_file;
	bool help, version, log_given, check, explain;
	const char *help_kind, *help_style;
	struct word_list crosscheck, variables, own; /* the last two: for the programs that it runs */
};

/* A signal handler can reach the simulation by no other way. */
static struct tsim *volatile interrupted;
static volatile sig_atomic_t signal_number;
static volatile double signal_time;

/* The first signal asks politely; one that comes later kills. `timeout` and some batch systems send
 * theirs twice at once, which means the same as once. */
static void on_signal(int number)
{
	struct tsim *sim = interrupted;
	double now = ts_clock();

	if (signal_number && now - signal_time > 0.2) {
		signal(number, SIG_DFL);
		raise(number);
	}
	if (!signal_number)
		signal_time = now;
	signal_number = number;
	if (sim)
		tsim_stop(sim);
}

static void catch_signals(struct tsim *sim)
{
	struct sigaction action = { .sa_handler = on_signal, .sa_flags = SA_RESTART }, before;

	interrupted = sim;
	sigaction(SIGINT, &action, NULL);
	sigaction(SIGTERM, &action, NULL);
	sigaction(SIGHUP, NULL, &before);
	if (before.sa_handler != SIG_IGN) /* nohup */
		sigaction(SIGHUP, &action, NULL);
	signal(SIGXFSZ, SIG_IGN); /* ulimit -f: likewise */
	signal(SIGPIPE, SIG_IGN); /* a reader that goes is an error of writing like others */
}

static int usage_error(const char *format, const char *what, const char *more)
{
	fputs("tsim: ", stderr);
	fprintf(stderr, format, what, more);
	fputs("\n'tsim -help' lists the options\n", stderr);
	return EXIT_USAGE;
}

static int print_text(struct ts_str *text)
{
	bool bad = text->failed;

	fputs(ts_str_text(text), stdout);
	ts_str_release(text);
	return bad ? EXIT_FAILURE : EXIT_SUCCESS;
}

static void print_usage(void)
{
	struct ts_str text = { 0 };

	puts("usage: tsim [options] -in FILE\n\noptions");
	for (int k = 0; k < NOPTIONS; k++)
		printf("  -%s %-*s %s\n", options[k].name, 30 - (int)strlen(options[k].name),
		       options[k].values, options[k].help);
	puts("\nafter -crosscheck liggghts or -crosscheck lammps");
	ts_crosscheck_help(&text);
	print_text(&text);
	puts("\nmanual pages: tsim -help NAME for anything that has a name, tsim -help KIND for a "
	     "list of its styles,\ntsim -help KIND STYLE for one of them. Kinds are");
	for (int kind = TS_KIND_COMMAND; kind < TS_NKIND; kind++)
		printf("  %s\n", ts_kind_name((enum ts_kind)kind));
	puts("and further pages");
	for (const struct ts_topic *t = ts_topics; t->name; t++)
		printf("  %-12s %s\n", t->name, t->summary);
}

static int help(const struct setup *setup)
{
	struct ts_str text = { 0 };
	int status;

	if (!setup->help_kind) {
		print_usage();
		return EXIT_SUCCESS;
	}
	if (setup->help_style ? ts_manual_find(setup->help_style, setup->help_kind, &text)
			      : ts_manual_find(setup->help_kind, NULL, &text))
		return print_text(&text);
	status = usage_error("%s%s", ts_str_text(&text), "");
	ts_str_release(&text);
	return status;
}

static int print_grammar(const char *editor)
{
	struct ts_str text = { 0 };

	if (ts_streq(editor, "vim"))
		ts_grammar_vim(&text);
	else if (ts_streq(editor, "vscode"))
		ts_grammar_textmate(&text);
	else
		return usage_error("expected vim or vscode after -grammar, found '%s'%s", editor, "");
	return print_text(&text);
}

static int write_page(const char *directory, const char *name, const struct ts_str *text)
{
	struct ts_str path = { 0 };
	FILE *file;
	int bad = 1;

	ts_str_addf(&path, "%s/%s", directory, name);
	file = path.failed || text->failed ? NULL : fopen(path.text, "w");
	if (file) {
		bad = fputs(ts_str_text(text), file) < 0;
		bad |= fclose(file) != 0;
	}
	if (bad)
		fprintf(stderr, "tsim: cannot write '%s'\n", ts_str_text(&path));
	ts_str_release(&path);
	return bad ? EXIT_FAILURE : EXIT_SUCCESS;
}

static int write_manual(const char *directory)
{
	struct ts_str text = { 0 }, name = { 0 };
	int status = EXIT_SUCCESS;

	for (const struct ts_style *const *s = ts_style_table; *s && !status; s++) {
		ts_str_clear(&text);
		ts_str_clear(&name);
		ts_help_file_name(*s, &name);
		ts_help_page(*s, true, &text);
		status = write_page(directory, ts_str_text(&name), &text);
	}
	for (const struct ts_topic *t = ts_topics; t->name && !status; t++) {
		ts_str_clear(&text);
		ts_str_clear(&name);
		ts_str_addf(&name, "%s.md", t->name);
		t->page(true, &text);
		status = write_page(directory, ts_str_text(&name), &text);
	}
	ts_str_clear(&text);
	ts_manual_index(&text);
	if (!status)
		status = write_page(directory, "index.md", &text);
	ts_str_release(&text);
	ts_str_release(&name);
	return status;
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
	return usage_error("expected none, screen, log or both after -echo, found '%s'%s", where,
			   "");
}

static int set_shell(struct tsim *sim, const char *text)
{
	if (!ts_streq(text, "yes") && !ts_streq(text, "no"))
		return usage_error("expected yes or no after -shell, found '%s'%s", text, "");
	ts_script_allow_programs(sim->host_data, ts_streq(text, "yes"));
	return 0;
}

static int set_threads(struct tsim *sim, const char *text)
{
	int64_t n;

	if (!ts_parse_int(text, &n) || n < 1 || n > 1024)
		return usage_error("expected a number from 1 to 1024 after -threads, found '%s'%s",
				   text, "");
	sim->threads = (int)n;
	return 0;
}

static int set_variable(struct tsim *sim, char *const *value, int n)
{
	const char *list[MOST_VALUES];

	if (n > MOST_VALUES)
		return usage_error("too many values for variable '%s'%s", value[0], "");
	for (int k = 1; k < n; k++)
		list[k - 1] = value[k];
	if (ts_script_set(sim->host_data, value[0], list, (size_t)n - 1, "-var") == TS_OK)
		return 0;
	fputs(tsim_error(sim), stderr);
	return EXIT_USAGE;
}

static int add_words(struct word_list *list, const char *option, char *const *value, int n)
{
	size_t most = sizeof list->word / sizeof *list->word;

	if (list->n + (size_t)n + 1 > most)
		return usage_error("too many words at '%s'%s", value[0], "");
	if (option)
		list->word[list->n++] = (struct ts_word){ .text = option };
	for (int k = 0; k < n; k++)
		list->word[list->n++] = (struct ts_word){ .text = value[k] };
	return 0;
}

static int usage(bool wrong)
{
	return wrong ? EXIT_USAGE : 0;
}

static int apply(struct tsim *sim, struct setup *setup, enum option_id id, char *const *value,
		 int n)
{
	switch (id) {
	case OPT_IN:
		setup->input = value[0];
		break;
	case OPT_VAR:
		return usage(add_words(&setup->variables, "-var", value, n) ||
			     set_variable(sim, value, n));
	case OPT_LOG:
		setup->log = value[0];
		setup->log_given = true;
		break;
	case OPT_SCREEN:
		setup->screen = value[0];
		break;
	case OPT_ECHO:
		return set_echo(sim, value[0]);
	case OPT_THREADS:
		return usage(add_words(&setup->own, "-threads", value, n) || set_threads(sim, value[0]));
	case OPT_LEGACY:
		sim->legacy = true;
		break;
	case OPT_SIGNAL:
		sim->restart_on_signal = ts_streq(value[0], "none") ? "" : value[0];
		break;
	case OPT_SHELL:
		return usage(add_words(&setup->own, "-shell", value, n) || set_shell(sim, value[0]));
	case OPT_EXPLAIN:
		sim->explain = setup->explain = true;
		break;
	case OPT_CHECK:
		setup->check = true;
		return ts_script_check(sim->host_data) == TS_OK ? 0 : EXIT_USAGE;
	case OPT_CROSSCHECK:
		return add_words(&setup->crosscheck, NULL, value, n);
	case OPT_HELP:
		setup->help = true;
		setup->help_kind = n > 0 ? value[0] : NULL;
		setup->help_style = n > 1 ? value[1] : NULL;
		break;
	case OPT_DOC:
		setup->doc = value[0];
		break;
	case OPT_GRAMMAR:
		setup->grammar = value[0];
		break;
	case OPT_VERSION:
		setup->version = true;
		break;
	case NOPTIONS:
		break;
	}
	return 0;
}

/* -x or --x, but not -1.5 or a lone "-". */
static bool is_option(const char *text)
{
	return text[0] == '-' && text[1] && !strchr("0123456789.", text[1]);
}

static int unknown_option(const char *text)
{
	struct ts_suggest suggest = ts_suggest_start(text + 1);

	for (int k = 0; k < NOPTIONS; k++)
		ts_suggest_try(&suggest, options[k].name);
	if (suggest.best)
		return usage_error("unknown option '%s'; did you mean '-%s'?", text, suggest.best);
	return usage_error("unknown option '%s'%s", text, "");
}

static int read_options(struct tsim *sim, struct setup *setup, int argc, char **argv)
{
	int k = 1;

	while (k < argc) {
		const char *text = argv[k++];
		const char *name = text + (is_option(text) ? 1 + (text[1] == '-') : 0);
		bool variadic;
		int id = 0, n = 0, status;

		if (name == text)
			return usage_error("expected an option, found '%s'%s; a script is given by "
					   "-in FILE",
					   text, "");
		while (id < NOPTIONS && !ts_streq(options[id].name, name) &&
		       !(name[0] == options[id].name[0] && !name[1] && strchr("ivleh", name[0])))
			id++;
		if (id == NOPTIONS)
			return unknown_option(text);
		variadic = id == OPT_VAR || id == OPT_HELP || id == OPT_CROSSCHECK;
		while (k + n < argc && !is_option(argv[k + n]) &&
		       (variadic || n < options[id].least))
			n++;
		if (n < options[id].least)
			return usage_error("option -%s needs %s", options[id].name,
					   options[id].values);
		status = apply(sim, setup, (enum option_id)id, argv + k, n);
		if (status)
			return status;
		k += n;
	}
	return 0;
}

static int open_output(struct tsim *sim, struct setup *setup)
{
	const char *log = setup->log_given ? setup->log : sim->explain ? "none" : "log.tsim";

	sim->log.screen = stdout;
	if (setup->screen && ts_streq(setup->screen, "none")) {
		sim->log.screen = NULL;
	} else if (setup->screen) {
		setup->screen_file = sim->log.screen = fopen(setup->screen, "w");
		if (!sim->log.screen)
			return usage_error("cannot open screen file '%s'%s", setup->screen, "");
	}
	sim->log.progress = sim->log.screen == stdout && isatty(STDOUT_FILENO);
	return ts_streq(log, "none") ? 0 : tsim_log(sim, log);
}

static void report_error(struct tsim *sim)
{
	const char *text = tsim_error(sim);

	ts_log_progress(&sim->log, "");
	fflush(stdout);
	fputs(text, stderr);
	ts_log_file(&sim->log, "%s", text);
}

static void print_bill(struct tsim *sim)
{
	struct ts_str text = { 0 };

	ts_price_time(sim->bill.seconds, &text);
	if (sim->bill.most > 1.15 * sim->bill.seconds) {
		ts_str_add(&text, " to ");
		ts_price_time(sim->bill.most, &text);
	}
	ts_str_add(&text, " and ");
	ts_price_bytes(sim->bill.bytes, &text);
	ts_log(&sim->log,
	       "\nAll runs together: about %s of files.\nNothing was run: values printed by the "
	       "script are those before the first step, and a run is priced from the state that\n"
	       "the script has without the runs before it, and for the case that its particles come to "
	       "lie together.\n",
	       ts_str_text(&text));
	ts_str_release(&text);
}

/* Errors of a script that was only checked; the exit status. */
static int report_check(struct tsim *sim)
{
	struct ts_str errors = { 0 }, report = { 0 };
	int n = 0;
	bool bad = ts_script_check_report(sim->host_data, &errors, &report, &n) != TS_OK;

	bad |= errors.failed || report.failed;
	sim->log.quiet = false;
	fflush(stdout);
	fputs(ts_str_text(&errors), stderr);
	ts_log(&sim->log, "%s", ts_str_text(&report));
	ts_str_release(&errors);
	ts_str_release(&report);
	if (bad)
		report_error(sim);
	return bad || n ? EXIT_FAILURE : EXIT_SUCCESS;
}

/* Where an interrupted run is saved: beside the log file unless the user says otherwise. */
static void interrupted_path(const struct tsim *sim, const struct setup *setup, struct ts_str *out)
{
	const char *log = setup->log_given ? setup->log : "", *slash = strrchr(log, '/');

	if (!sim->restart_on_signal && slash)
		ts_str_add_n(out, log, (size_t)(slash + 1 - log));
	ts_str_add(out, sim->restart_on_signal ? sim->restart_on_signal
					       : "tsim.interrupted.restart");
}

/* After a signal: saves the state and says how to go on. */
static void save_interrupted(struct tsim *sim, const struct setup *setup)
{
	struct ts_str path = { 0 };

	interrupted_path(sim, setup, &path);
	tsim_error_clear(sim);
	if (!path.length || !ts_sim_has_box(sim) || sim->explain) {
		ts_str_release(&path);
		return;
	}
	if (ts_restart_write(sim, ts_str_text(&path), NULL) != TS_OK)
		report_error(sim);
	else
		ts_log(&sim->log,
		       "The state at step %" PRId64 " is saved. To go on, put in the script, instead of "
		       "what makes the box and the particles,\n"
		       "  read_restart %s\nand as run command\n  run %" PRId64 " upto\n",
		       sim->clock.step, ts_str_text(&path), sim->clock.goal);
	ts_str_release(&path);
}

/* Runs the script; the exit status. */
static int run(struct tsim *sim, struct setup *setup)
{
	int status = open_output(sim, setup), quit = EXIT_SUCCESS;

	if (status == EXIT_USAGE && sim->error.status == TS_OK)
		return status;
	catch_signals(sim);
	if (!status)
		ts_log(&sim->log, "tsim %s\n", tsim_version());
	sim->log.quiet = setup->check && !setup->explain;
	if (!status && setup->input)
		status = tsim_file(sim, setup->input);
	else if (!status)
		status = tsim_stream(sim, stdin, "stdin");
	if (status) {
		report_error(sim);
		quit = EXIT_FAILURE;
		if (sim->error.status == TS_STOPPED && signal_number) {
			quit = 128 + signal_number;
			save_interrupted(sim, setup);
		}
	} else {
		if (setup->explain)
			print_bill(sim);
		ts_script_warn_unused(sim->host_data);
		ts_script_quit(sim->host_data, &quit);
		if (setup->check)
			quit = report_check(sim);
		if (ts_log_close(&sim->log, &sim->error) != TS_OK) {
			report_error(sim);
			quit = EXIT_FAILURE;
		}
	}
	interrupted = NULL;
	return quit;
}

static struct ts_words words_of(const struct word_list *list)
{
	return (struct ts_words){ list->word, list->n };
}

/* The exit status is the verdict. */
static int crosscheck(struct tsim *sim, const struct setup *setup, const char *called)
{
	struct ts_crosscheck_input input = { setup->input, called, words_of(&setup->crosscheck),
					     words_of(&setup->variables), words_of(&setup->own) };
	struct ts_str text = { 0 };
	int verdict = (int)ts_crosscheck(sim, &input, &text);

	if (sim->error.status)
		fputs(tsim_error(sim), stderr);
	return print_text(&text) ? EXIT_FAILURE : verdict;
}

static int act(struct tsim *sim, struct setup *setup, int argc, char **argv)
{
	int status = read_options(sim, setup, argc, argv);

	if (status)
		return status;
	if (setup->version) {
		printf("tsim %s\n", tsim_version());
		return EXIT_SUCCESS;
	}
	if (setup->help)
		return help(setup);
	if (setup->grammar)
		return print_grammar(setup->grammar);
	if (setup->doc)
		return write_manual(setup->doc);
	if (setup->crosscheck.n)
		return crosscheck(sim, setup, argv[0]);
	return run(sim, setup);
}

int main(int argc, char **argv)
{
	struct tsim *sim = tsim_open();
	struct setup setup = { 0 };
	int status;

	if (!sim) {
		fputs(tsim_error(NULL), stderr);
		exit(EXIT_FAILURE);
	}
	sim->log.echo_file = true;
	status = act(sim, &setup, argc, argv);
	tsim_close(sim);
	if (setup.screen_file && fclose(setup.screen_file) != 0)
		status = status ? status : EXIT_FAILURE;
	if (fflush(stdout) != 0 && !status) {
		fputs("tsim: cannot write to standard output\n", stderr);
		status = EXIT_FAILURE;
	}
	exit(status);
}
