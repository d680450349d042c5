/* Command report: a page about the run of the script. */
#include "report/record.h"

#include "base/banned.h"

enum { FILE_MODE, PICTURE_MODE };

struct state {
	int mode;
	const char *file, *title;
	double renew;
	struct ts_words picture;
};

static const struct ts_arg file_rows[] = {
	TS_WORD("FILE", struct state, file, .flags = TS_POSITIONAL | TS_WRITES,
		.help = "name of the page, which ends in .html"),
	TS_WORD("title", struct state, title, .flags = TS_OPTIONAL,
		.help = "heading (the name of the script)"),
	TS_REAL("renew", struct state, renew, .fallback = "10", .range = TS_WITHIN, .lo = 0.1, .hi = 1e6,
		.unit = "s", .help = "least wall time between pages while the script runs"),
	TS_REST_KEYWORD("picture", struct state, picture,
			.help = "last keyword: the words of report picture"),
	TS_ARGS_END,
};
static const struct ts_arg picture_rows[] = {
	TS_REST("words", struct state, picture,
		.help = "none: no pictures; else N, the number of steps between pictures, or ends, only the "
			"first and the last state; then COLOR DIAMETER and keywords of dump image, then "
			"`modify` and keywords of dump_modify"),
	TS_ARGS_END,
};
static const struct ts_mode modes[] = {
	{ "file", "writes a report", file_rows },
	{ "picture", "pictures of the report, if there is one", picture_rows },
	{ .name = NULL },
};
static const struct ts_arg args[] = {
	TS_MODE("what", struct state, mode, modes, .help = "file: the report; picture: a view that it shows"),
	TS_ARGS_END,
};

static enum ts_status open_file(struct ts_record *record, struct tsim *sim, const struct state *s,
				const struct ts_place *where)
{
	if (!ts_ends_with(s->file, ".html") && !ts_ends_with(s->file, ".htm"))
		return ts_fail(&sim->error, TS_SYNTAX, where,
			       "report: the name of the page must end in .html, found '%s'", s->file);
	if (s->title)
		record->title = ts_arena_strdup(&record->arena, s->title);
	record->renew = s->renew;
	if (record->file && ts_streq(record->file, s->file)) /* executed again, in a loop or after `clear` */
		return TS_OK;
	if (record->file && record->by_option) {
		ts_log(&sim->log, "The report is written to %s, as the command line says, not to %s\n",
		       record->file, s->file);
		return TS_OK;
	}
	if (record->file)
		return ts_fail(&sim->error, TS_STATE, where,
			       "report: '%s' is written already (%s:%d), and a script has one report, "
			       "which contains all its runs",
			       record->file, TS_FILE_AND_LINE(record->where));
	return ts_record_open(record, sim, s->file, where,
			      where->file && ts_streq(where->file, TS_REPORT_OPTION));
}

static enum ts_status run(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct state *s = state;
	struct ts_record *record = ts_record_of(sim);
	const struct ts_place *at = ts_sim_word(sim, 2, where);

	if (!record)
		return ts_nomem(&sim->error);
	if (s->mode == FILE_MODE)
		TS_TRY(open_file(record, sim, s, at));
	return s->mode == PICTURE_MODE || s->picture.n ? ts_record_add_view(record, sim, s->picture, where)
						       : TS_OK;
}

TS_STYLE(command, ts_command_style, ts_command_report)
const struct ts_command_style ts_command_report = {
	.style = {
		.name = "report",
		.kind = TS_KIND_COMMAND,
		.summary = "Writes a page about the run of the script",
		.doc = "`report file` writes one HTML file about all runs of the script from this line on: "
		       "how it ended, RESULT lines, warnings, pictures, the table of the log as plots, the "
		       "energy ledger, limits of the time step, where time went, and what was run: scripts, "
		       "variables, settings and their defaults. It needs no network. The page is written at "
		       "once, renewed while the script runs, and completed at its end, also after an error or "
		       "a signal; results are the same with and without it. The option -report FILE does the "
		       "same without a line in the script, and its file replaces that of `report file`.\n\n"
		       "`report picture` adds a view to the report, drawn at the first and last state and "
		       "every N steps in between, with the words of dump image behind its file; without a "
		       "report it has no effect. At most 12 pictures in between are kept: of more each second "
		       "one, and so on. Without such a line the first and the last state are shown by type in "
		       "the default view. See doc/report.md.",
		.example = "report file run.html\n"
			   "report file post/run.html title \"Drilling, 500 N\" renew 30\n"
			   "report picture 5000 vz diameter size 640 480 zoom 1.6 modify backcolor white\n"
			   "report picture none",
		.args = args,
		.state_size = sizeof(struct state),
	},
	.run = run,
};
