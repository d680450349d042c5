/* Dump custom: selected quantities of particles as text. */
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

	return ts_dump_columns(self, sim, s->names, false);
}

static enum ts_status output(struct ts_instance *self, struct tsim *sim)
{
	return ts_dump_frame(self, sim, false);
}

static const struct ts_arg args[] = {
	TS_DUMP_ARGS(struct state),
	TS_REST("columns", struct state, names,
		.help = "quantities: id, type, x, y, z, vx, radius ..., c_ID[k], f_ID[k], v_NAME"),
	TS_ARGS_END,
};

static const struct ts_saved saved[] = { TS_DUMP_SAVED(struct state), TS_SAVED_ROWS_END };

TS_STYLE(dump, ts_style, ts_dump_custom)
const struct ts_style ts_dump_custom = {
	.name = "custom",
	.kind = TS_KIND_DUMP,
	.dump_words = TS_DUMP_SELECTION " refresh format label time units element header append",
	.ranks = TS_RANKS_WHOLE | TS_RANKS_PARTICLES | TS_RANKS_ROWLESS,
	.due = ts_dump_may_be_due,
	.names = ts_dump_names,
	.summary = "Selected quantities of particles as text, readable by OVITO",
	.doc = "Writes a frame when the step is a multiple of N, including the first step of a run, but "
	       "never twice for the same step. Each frame begins with ITEM lines: step, number of particles, "
	       "bounds of the box, names of the columns. Particles are written in the order of their ids "
	       "(see dump_modify sort), so that the file does not depend on the number of threads or on the "
	       "order in memory. If a run is interrupted, all previous frames are complete.\n\nA file whose "
	       "name ends in .csv or .csv.gz is a table of comma-separated values instead: one line with the "
	       "names of the columns, then a row for each particle of each frame, which begins with the step "
	       "(`dump_modify time yes`: and the time); numbers have all digits unless dump_modify gives a "
	       "format.",
	.example = "dump rock all custom 1000 post/rock.dump id type x y z vx vy vz radius\n"
		   "dump rock all custom 1000 post/rock*.dump.gz id x y z c_strain",
	.args = args,
	.state_size = sizeof(struct state),
	.saved = saved,
	.archive = ts_dump_archive,
	.init = init,
	.plan = ts_dump_plan,
	.hook[TS_STAGE_OUTPUT] = output,
	.defers = TS_DEFERS(OUTPUT),
	.fini = ts_dump_fini,
};
