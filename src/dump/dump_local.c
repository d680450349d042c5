/* Dump local: rows of local arrays of computes and fixes, such as bonds and contacts, as text. */
#include "core/sim.h"
#include "dump/dump.h"

#include "base/banned.h"

struct state {
	struct ts_dump_common common;
	struct ts_words names;
};

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	const struct state *s = self->state;

	return ts_dump_columns(self, sim, s->names, true);
}

static enum ts_status output(struct ts_instance *self, struct tsim *sim)
{
	return ts_dump_frame(self, sim, true);
}

static enum ts_status plan(struct ts_instance *self, struct tsim *sim, struct ts_plan_report *report)
{
	return ts_dump_price(self, sim, true, false, report);
}

static const struct ts_arg args[] = {
	TS_DUMP_ARGS(struct state),
	TS_REST("columns", struct state, names, .help = "local quantities: index, c_ID[k], f_ID[k]"),
	TS_ARGS_END,
};

static const struct ts_saved saved[] = { TS_DUMP_SAVED(struct state), TS_SAVED_ROWS_END };

TS_STYLE(dump, ts_style, ts_dump_local)
const struct ts_style ts_dump_local = {
	.name = "local",
	.kind = TS_KIND_DUMP,
	.dump_words = "refresh format label time units header append",
	.ranks = TS_RANKS_WHOLE | TS_RANKS_PARTICLES | TS_RANKS_ROWLESS,
	.due = ts_dump_may_be_due,
	.names = ts_dump_names,
	.summary = "Local arrays of computes and fixes, such as bonds and contacts, as text",
	.doc = "All columns must have the same number of rows. Rows are sorted by the first column, then by "
	       "the second, and so on; with `dump_modify sort off` they are written in the order of the "
	       "compute or fix. index numbers the rows in the order of writing.\n\nA file whose name ends in "
	       ".csv or .csv.gz is a table of comma-separated values instead: one line with the names of the "
	       "columns, then a row for each local row of each frame, which begins with the step "
	       "(`dump_modify time yes`: and the time); numbers have all digits unless dump_modify gives a "
	       "format.",
	.example = "dump bonds all local 1000 post/bonds.dump index c_bonds[1] c_bonds[2] c_bonds[3]",
	.args = args,
	.state_size = sizeof(struct state),
	.saved = saved,
	.init = init,
	.plan = plan,
	.hook[TS_STAGE_OUTPUT] = output,
	.defers = TS_DEFERS(OUTPUT),
	.fini = ts_dump_fini,
};
