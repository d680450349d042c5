/* The program: command line, signals, exit status. */
#include <errno.h>
#include <inttypes.h>
#include <signal.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "advise/advise.h"
#include "base/alloc.h"
#include "base/clock.h"
#include "base/files_peers.h"
#include "core/life.h"
#include "core/ranks.h"
#include "core/saver.h"
#include "core/sim.h"
#include "crosscheck/crosscheck.h"
#include "explain/price.h"
#include "io/series.h"
#include "program/program.h"
#include "program/program_ranks.h"
#include "restart/restart.h"
#include "script/script.h"
#include "tsim.h"

#include "base/banned.h"

static const double PATIENCE = 10; /* s without output after which a terminal shows the progress of a run */

/* The simulation that the signal handlers act on. */
static struct tsim *volatile interrupted;
static volatile sig_atomic_t signal_number;
static volatile double signal_time;

/* Ranks get a signal at different steps; they agree on the one after which they stop. */
static void request_stop(struct tsim *sim)
{
	if (sim && sim->world)
		sim->world->stop = 1;
	else if (sim)
		tsim_stop(sim);
}

/* The first signal stops the run after the present step; a later one terminates the program. `timeout` and
 * some batch systems send a signal twice at once, which counts as one. */
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
	request_stop(sim);
}

/* USR1: the state is saved after the present step or command, and the script continues. */
static void on_save(int number)
{
	struct tsim *sim = interrupted;

	(void)number;
	if (sim && sim->world)
		sim->world->save = 1;
	else if (sim)
		sim->requests.save = 1;
}

/* SIGXCPU, which the kernel sends each second once the processor time is used up. */
static void on_time_up(int number)
{
	struct tsim *sim = interrupted;

	signal_number = number;
	request_stop(sim);
}

static void catch_signals(struct tsim *sim)
{
	struct sigaction save = { .sa_handler = on_save, .sa_flags = SA_RESTART };
	struct sigaction time_up = { .sa_handler = on_time_up, .sa_flags = SA_RESTART };
	struct sigaction action = { .sa_handler = on_signal, .sa_flags = SA_RESTART }, before;

	interrupted = sim;
	sigaction(SIGINT, &action, NULL);
	sigaction(SIGTERM, &action, NULL);
	sigaction(SIGUSR1, &save, NULL);
	sigaction(SIGUSR2, &action, NULL);
	sigaction(SIGHUP, NULL, &before);
	if (before.sa_handler != SIG_IGN) /* ignored under nohup */
		sigaction(SIGHUP, &action, NULL);
	if (sim->files.closed)
		sigaction(SIGXCPU, &time_up, NULL);
	signal(SIGXFSZ, SIG_IGN); /* beyond ulimit -f: an error of writing */
	signal(SIGPIPE, SIG_IGN); /* a closed pipe: an error of writing */
}

static int open_output(struct tsim *sim, struct ts_setup *setup)
{
	const char *log = setup->log_given ? setup->log : sim->reading.explain ? "none" : "log.tsim";

	sim->log.screen = stdout;
	if (setup->screen && ts_streq(setup->screen, "none")) {
		sim->log.screen = NULL;
	} else if (setup->screen) {
		setup->screen_file = sim->log.screen = ts_files_open(&sim->files, setup->screen, "w");
		if (!sim->log.screen)
			return ts_program_usage_error("cannot open screen file '%s': %s", setup->screen,
						      ts_files_why(&sim->files));
	}
	if (!ts_ranks_first(sim))
		sim->log.screen = NULL;
	/* mpirun passes on what is written to a terminal of its own */
	sim->log.progress = sim->log.screen == stdout && !sim->world && isatty(STDOUT_FILENO);
	return ts_streq(log, "none") ? 0 : tsim_log(sim, log);
}

/* With several ranks an error ends all of them here; a request to stop, which all have agreed on, does not. */
static void report_error(struct tsim *sim)
{
	const char *text = tsim_error(sim);

	if (sim->world && sim->error.status != TS_STOPPED)
		ts_program_ranks_fail(sim->world, text);
	else if (ts_ranks_first(sim))
		ts_log_fatal(&sim->log, text);
}

static void print_cost(struct tsim *sim)
{
	struct ts_str text = { 0 };

	ts_str_add(&text, sim->cost.open ? "at least " : "about ");
	ts_price_time(sim->cost.seconds, &text);
	if (sim->cost.most > 1.15 * sim->cost.seconds) {
		ts_str_add(&text, " to ");
		ts_price_time(sim->cost.most, &text);
	}
	ts_str_add(&text, " and ");
	ts_price_bytes(sim->cost.bytes, &text);
	ts_log(&sim->log,
	       "\nAll runs together: %s of files%s.\nNothing was run: values that depend on results of runs "
	       "are unknown. The duration of a run\nis measured from the state without the previous runs, "
	       "and for a dense packing of its particles.\n",
	       ts_str_text(&text),
	       sim->cost.open ? " (loop iterations and steps that depend on results are unknown)" : "");
	ts_str_release(&text);
}

/* Prints the errors of a script that was only checked; returns the exit status. */
static int report_check(struct tsim *sim)
{
	struct ts_str errors = { 0 }, report = { 0 };
	int n = 0;
	bool bad = ts_script_check_report(sim->script_api_data, &errors, &report, &n) != TS_OK;

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

/* Saves the state on request. */
struct saver {
	struct ts_saver base;
	const struct ts_setup *setup;
};

/* Path of the restart file: in the folder of the log file, unless the user gives one; "": none. */
static void saved_path(const struct tsim *sim, const struct ts_setup *setup, struct ts_str *out)
{
	const char *log = setup->log_given ? setup->log : "", *slash = strrchr(log, '/');
	struct ts_str file = { 0 };

	if (!sim->requests.restart_file && slash)
		ts_str_add_n(&file, log, (size_t)(slash + 1 - log));
	ts_str_add(&file,
		   sim->requests.restart_file ? sim->requests.restart_file : "tsim.interrupted.restart");
	ts_series_path(out, ts_str_text(&file), (long long)sim->clock.step, 0);
	out->failed |= file.failed;
	ts_str_release(&file);
}

/* USR1. An error here does not end the run. */
static enum ts_status save_and_go_on(struct ts_saver *self, struct tsim *sim)
{
	struct ts_str path = { 0 };

	if (sim->reading.explain)
		return TS_OK;
	saved_path(sim, ((struct saver *)self)->setup, &path);
	if (!path.length)
		ts_log(&sim->log, "Signal USR1: nothing is saved, because no restart file shall be written "
				  "on signals\n");
	else if (!ts_sim_has_box(sim))
		ts_log(&sim->log, "Signal USR1: nothing is saved, because there is no simulation box yet\n");
	else if (ts_restart_write(sim, ts_str_text(&path), NULL) != TS_OK)
		ts_warn(&sim->log, NULL, "signal USR1: the state at step %" PRId64 " is not saved: %s",
			sim->clock.step, sim->error.message);
	else
		ts_log(&sim->log, "Signal USR1: the state at step %" PRId64 " is saved in %s\n",
		       sim->clock.step, ts_str_text(&path));
	ts_error_clear(&sim->error);
	ts_str_release(&path);
	return TS_OK;
}

/* After a signal that ended the run: saves the state and prints how to continue. False if the state could
 * not be saved. */
static bool save_interrupted(struct tsim *sim, const struct ts_setup *setup)
{
	struct ts_str path = { 0 };
	bool good = true, whole = sim->requests.stopped_whole;

	saved_path(sim, setup, &path);
	tsim_error_clear(sim);
	if (!path.length || !ts_sim_has_box(sim) || sim->reading.explain) {
		ts_str_release(&path);
		return true;
	}
	if (!whole) {
		ts_log(&sim->log, "The state is not saved: a command of the script was ended before it had "
				  "done its work.\n");
		ts_str_release(&path);
		return false;
	}
	good = ts_restart_write(sim, ts_str_text(&path), NULL) == TS_OK;
	if (!good)
		report_error(sim);
	else
		ts_log(&sim->log,
		       "The state at step %" PRId64 " is saved. To go on, put in the script, instead of "
		       "create_box, create_atoms or read_data,\n"
		       "  read_restart %s\nand as run command\n  run %" PRId64 " upto\nAll fixes stay, those "
		       "that insert particles, too.\n",
		       sim->clock.step, ts_str_text(&path), sim->clock.goal);
	ts_str_release(&path);
	return good;
}

/* All ranks get what the first one reads. */
static int run_standard_input(struct tsim *sim)
{
	const struct ts_files_peers *peers = sim->files.peers;
	int descriptor = peers ? ts_peers_copy(peers, peers->first ? STDIN_FILENO : -1) : -1, status;
	FILE *copy = descriptor < 0 ? NULL : fdopen(descriptor, "r");

	if (peers && !copy)
		return ts_program_usage_error("cannot read %s: %s", "stdin", strerror(errno));
	status = tsim_stream(sim, copy ? copy : stdin, "stdin");
	if (copy)
		fclose(copy);
	return status;
}

/* Runs the script; returns the exit status. */
static int run(struct tsim *sim, struct ts_setup *setup, char **argv)
{
	struct saver saver = { { save_and_go_on }, setup };
	struct ts_str said = { 0 };
	int status = setup->sandboxed && sim->world
			     ? ts_program_usage_error("%s does not work with several ranks%s", "-sandbox", "")
		     : setup->sandboxed ? ts_program_sandbox(sim, setup, &said)
					: 0,
	    quit = EXIT_SUCCESS;

	status = status ? status : open_output(sim, setup);
	if (status == TS_EXIT_USAGE && sim->error.status == TS_OK) {
		ts_str_release(&said);
		return status;
	}
	sim->requests.saver = &saver.base;
	catch_signals(sim);
	if (!status)
		ts_log(&sim->log, "tsim %s\n%s", tsim_version(), ts_str_text(&said));
	ts_str_release(&said);
	sim->log.quiet = setup->check && !setup->explain;
	status = status ? status : ts_program_report(sim, setup, argv);
	sim->run.pauses = !sim->reading.explain && !setup->check;
	if (!status && setup->input)
		status = tsim_file(sim, setup->input);
	else if (!status)
		status = run_standard_input(sim);
	if (status) {
		report_error(sim);
		quit = ts_program_report_end(sim, EXIT_FAILURE);
		if (signal_number == SIGXCPU)
			fputs("the processor time that -sandbox allows is used up (-sandbox time)\n", stderr);
		if (sim->error.status == TS_STOPPED && signal_number) {
			quit = 128 + signal_number;
			if (!save_interrupted(sim, setup) && signal_number == SIGUSR2)
				quit = EXIT_FAILURE; /* SIGUSR2 requests that the state is saved */
		}
	} else {
		if (setup->explain)
			print_cost(sim);
		ts_script_warn_unused(sim->script_api_data);
		ts_script_quit(sim->script_api_data, &quit);
		if (setup->check)
			quit = report_check(sim);
		if (ts_sim_close(sim) != TS_OK) {
			report_error(sim);
			quit = EXIT_FAILURE;
		}
		quit = ts_program_report_end(sim, quit);
		if (ts_log_close(&sim->log, &sim->error) != TS_OK) {
			report_error(sim);
			quit = EXIT_FAILURE;
		}
	}
	interrupted = NULL;
	sim->requests.saver = NULL;
	return quit;
}

static struct ts_words words_of(const struct ts_word_list *list)
{
	return (struct ts_words){ list->word, list->n };
}

/* Returns the verdict as the exit status. */
static int crosscheck(struct tsim *sim, const struct ts_setup *setup, const char *called)
{
	struct ts_crosscheck_input input = { setup->input, called, words_of(&setup->crosscheck),
					     words_of(&setup->variables), words_of(&setup->own) };
	struct ts_str text = { 0 };
	int verdict = (int)ts_crosscheck(sim, &input, &text);

	if (sim->error.status)
		fputs(tsim_error(sim), stderr);
	return ts_program_print(&text) ? EXIT_FAILURE : verdict;
}

static int advise(struct tsim *sim, const struct ts_setup *setup)
{
	struct ts_advise_input input = { setup->input, words_of(&setup->advise),
					 words_of(&setup->variables) };
	struct ts_str text = { 0 }, trouble = { 0 };
	int status;

	sim->log.screen = stdout;
	sim->log.progress = isatty(STDOUT_FILENO);
	status = ts_advise(sim, &input, &text, &trouble);
	if (sim->error.status)
		fputs(tsim_error(sim), stderr);
	fputs(ts_str_text(&trouble), stderr);
	ts_str_release(&trouble);
	return ts_program_print(&text) ? EXIT_FAILURE : status;
}

/* Many runs of scripts. A signal ends them; what has ended is kept. */
static int study(struct tsim *sim, struct ts_setup *setup, const char *called)
{
	int status;

	catch_signals(sim);
	status = ts_program_study(sim, setup, called);
	interrupted = NULL;
	if (sim->error.status)
		fputs(tsim_error(sim), stderr);
	return sim->error.status == TS_STOPPED && signal_number ? 128 + signal_number : status;
}

/* Draws columns of files. */
static int plot(struct tsim *sim, const struct ts_setup *setup)
{
	int status = ts_program_plot(sim, setup);

	if (sim->error.status)
		fputs(tsim_error(sim), stderr);
	return status;
}

/* What each rank would do for itself is done by the first one alone; false: this is another one. */
static bool work_alone(struct tsim *sim, const struct ts_setup *setup)
{
	const bool runs = !(setup->version || setup->help || setup->grammar || setup->doc || setup->plots ||
			    setup->studied || setup->advised || setup->crosscheck.n || setup->explain);
	bool first = ts_ranks_first(sim);

	if (runs)
		return true;
	if (setup->explain && !sim->reading.ranks)
		sim->reading.ranks = ts_ranks(sim);
	sim->world = NULL;
	sim->files.peers = NULL;
	return first;
}

/* Options that run the script in other ways than -advise and -crosscheck do. */
static int refuse_conflicts(const struct ts_setup *setup)
{
	const char *name = setup->advised ? "-advise" : "-crosscheck";
	const char *other = setup->advised && setup->crosscheck.n ? "-crosscheck"
			    : setup->check			  ? "-check"
			    : setup->explain			  ? "-explain"
								  : NULL;

	return other ? ts_program_usage_error("%s and %s cannot be given together", name, other) : 0;
}

static int run_command_line(struct tsim *sim, struct ts_setup *setup, int argc, char **argv)
{
	int status = ts_program_options(sim, setup, argc, argv);

	if (status)
		return status;
	if (!work_alone(sim, setup))
		return EXIT_SUCCESS;
	if (setup->version)
		return ts_program_version();
	if (setup->help)
		return ts_program_help(setup);
	if (setup->grammar)
		return ts_program_grammar(setup->grammar);
	if (setup->doc)
		return ts_program_manual(setup->doc);
	if (ts_program_check_report(setup))
		return TS_EXIT_USAGE;
	if (setup->plots)
		return plot(sim, setup);
	if (setup->studied)
		return study(sim, setup, argv[0]);
	if (setup->sandboxed && (setup->advised || setup->crosscheck.n))
		return ts_program_sandbox(sim, setup, &(struct ts_str){ 0 }); /* prints why it is refused */
	if ((setup->advised || setup->crosscheck.n) && refuse_conflicts(setup))
		return TS_EXIT_USAGE;
	if (setup->advised)
		return advise(sim, setup);
	if (setup->crosscheck.n)
		return crosscheck(sim, setup, argv[0]);
	return run(sim, setup, argv);
}

int main(int argc, char **argv)
{
	struct ts_setup setup = { 0 };
	struct ts_files_peers peers;
	const char *why = NULL;
	struct ts_world *world = ts_program_ranks_begin(&argc, &argv, &why);
	struct tsim *sim;
	int status;

	ts_alloc_tune();
	sim = why ? NULL : tsim_open();
	if (!sim) {
		fputs(why ? "tsim: error: " : tsim_error(NULL), stderr);
		fputs(why ? why : "", stderr);
		fputs(why ? "\n" : "", stderr);
		exit(EXIT_FAILURE);
	}
	if (world && world->n > 1) {
		sim->world = world;
		peers = ts_program_ranks_files(world);
		sim->files.peers = &peers;
		ts_program_ranks_listen(world, &sim->log);
	}
	sim->log.echo_file = true;
	sim->log.patience = PATIENCE;
	status = run_command_line(sim, &setup, argc, argv);
	sim->log.screen = NULL;
	if (setup.screen_file && fclose(setup.screen_file) != 0)
		status = status ? status : EXIT_FAILURE;
	tsim_close(sim);
	if ((fflush(stdout) != 0 || ferror(stdout)) && !status) {
		fputs("tsim: cannot write to standard output\n", stderr);
		status = EXIT_FAILURE;
	}
	ts_program_ranks_end(world);
	exit(status);
}
