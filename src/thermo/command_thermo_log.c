/* Command thermo_log: writes thermo output to a file, too. */
#include "core/sim.h"
#include "io/csv.h"
#include "thermo/thermo.h"

#include "base/banned.h"

struct state {
	const char *file;
	bool append;
};

static enum ts_status run(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct state *s = state;
	struct ts_thermo *t = sim->thermo;

	if (sim->reading.explain)
		return TS_OK;
	TS_TRY(ts_textfile_close(&t->file));
	ts_str_clear(&t->table);
	t->csv = false;
	if (ts_streq(s->file, "none"))
		return TS_OK;
	TS_TRY(ts_textfile_open(&t->file, sim, where, s->file, s->append));
	t->csv = ts_csv_is(s->file);
	return TS_OK;
}

static const struct ts_arg args[] = {
	TS_WORD("file", struct state, file, .flags = TS_POSITIONAL | TS_WRITES,
		.help = "name of the file; none: no file any more"),
	TS_FLAG("append", struct state, append, .help = "append to the file instead of replacing it"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_thermo_log)
const struct ts_command_style ts_command_thermo_log = {
	.style = {
		.name = "thermo_log",
		.kind = TS_KIND_COMMAND,
		.summary = "Writes thermo output to a file, too",
		.doc = "The file contains only the titles and the rows of the thermo output. A file whose "
		       "name ends in .csv is a table of comma-separated values with all digits: its first "
		       "line has the names of the columns as in thermo_style, and the later ones are the rows "
		       "of all runs; the columns may not change.",
		.example = "thermo_log thermo.txt\nthermo_log post/thermo.csv append",
		.args = args,
		.state_size = sizeof(struct state),
	},
	.run = run,
};
