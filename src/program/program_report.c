/* -report on the command line: the command `report file` before the script begins. */
#include <stdlib.h>
#include <string.h>

#include "core/life.h"
#include "program/program.h"
#include "report/record.h"
#include "tsim.h"

#include "base/banned.h"

static void add_quoted(struct ts_str *out, const char *word)
{
	const bool plain =
		*word &&
		strspn(word, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=.,:/@%") ==
			strlen(word);

	ts_str_addf(out, plain ? "%s%s" : "%s'%s'", out->length ? " " : "", word);
}

static enum ts_status keep_command_line(struct tsim *sim, char **argv)
{
	struct ts_record *record = ts_record_of(sim);
	struct ts_str line = { 0 };

	for (; *argv; argv++)
		add_quoted(&line, *argv);
	if (record && !line.failed)
		record->command = ts_arena_strdup(&record->arena, ts_str_text(&line));
	ts_str_release(&line);
	return record && record->command ? TS_OK : ts_nomem(&sim->error);
}

/* Options with which a script is not run once. */
int ts_program_check_report(const struct ts_setup *setup)
{
	const char *other = setup->studied	  ? setup->sweep.n ? "-sweep" : "-calibrate"
			    : setup->advised	  ? "-advise"
			    : setup->crosscheck.n ? "-crosscheck"
						  : NULL;

	return setup->report.n && other
		       ? ts_program_usage_error("-report and %s cannot be given together%s", other,
						": a report is that of one run of a script")
		       : 0;
}

int ts_program_report(struct tsim *sim, const struct ts_setup *setup, char **argv)
{
	struct ts_word word[2 * TS_MOST_VALUES + 2] = { { .text = "report" }, { .text = "file" } };
	const size_t n = setup->report.n;
	enum ts_status status;

	if (keep_command_line(sim, argv) != TS_OK)
		return TS_NOMEM;
	if (!n)
		return TS_OK;
	memcpy(word + 2, setup->report.word, n * sizeof *word);
	for (size_t k = 0; k < n + 2; k++)
		word[k].place.file = ts_pool_get(sim->pool, TS_REPORT_OPTION);
	status = ts_sim_command(sim, (struct ts_words){ word, n + 2 });
	return (int)status;
}

int ts_program_report_end(struct tsim *sim, int quit)
{
	const enum ts_record_end end = sim->error.status == TS_STOPPED ? TS_RECORD_STOPPED
				       : quit != EXIT_SUCCESS	       ? TS_RECORD_FAILED
								       : TS_RECORD_ENDED;
	const char *text = sim->error.status ? tsim_error(sim) : NULL;

	if (ts_record_close(sim, end, text) == TS_OK)
		return quit;
	fputs(tsim_error(sim), stderr);
	ts_log_file(&sim->log, "%s", tsim_error(sim));
	return quit ? quit : EXIT_FAILURE;
}
