/* Dump xyz: type and position of particles in the XYZ format. */
#include "core/sim.h"
#include "dump/dump.h"
#include "io/csv.h"

#include "base/banned.h"

struct state {
	struct ts_dump_common common;
};

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	static const char *const names[] = { "element", "x", "y", "z" };
	const struct state *s = self->state;
	struct ts_word word[4];

	if (ts_csv_is(s->common.file))
		return ts_fail(&sim->error, TS_SYNTAX, ts_instance_word(self, s->common.file),
			       "dump xyz writes the XYZ format: for a table of comma-separated values take "
			       "`dump ID GROUP custom N %s type x y z`",
			       s->common.file);
	for (size_t k = 0; k < 4; k++)
		word[k] = (struct ts_word){ .text = names[k], .place = self->where };
	return ts_dump_columns(self, sim, (struct ts_words){ word, 4 }, false);
}

static enum ts_status output(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	struct ts_dump_common *d = &s->common;
	bool due;

	TS_TRY(ts_dump_due(self, sim, &due));
	if (!due)
		return TS_OK;
	TS_TRY(ts_dump_gather_rows(self, sim));
	TS_TRY(ts_dump_open(self, sim));
	ts_str_addf(&d->text, "%zu\nAtoms. Timestep: %lld", d->nrows, (long long)sim->clock.step);
	if (d->time)
		ts_str_addf(&d->text, " Time: %f", ts_sim_time(sim));
	ts_str_add(&d->text, "\n");
	TS_TRY(ts_dump_write_rows(d, sim, false));
	return ts_dump_frame_done(d, sim);
}

static const struct ts_arg args[] = { TS_DUMP_ARGS(struct state), TS_ARGS_END };

static const struct ts_saved saved[] = { TS_DUMP_SAVED(struct state), TS_SAVED_ROWS_END };

TS_STYLE(dump, ts_style, ts_dump_xyz)
const struct ts_style ts_dump_xyz = {
	.name = "xyz",
	.kind = TS_KIND_DUMP,
	.dump_words = TS_DUMP_SELECTION " refresh format time element append",
	.ranks = TS_RANKS_WHOLE | TS_RANKS_PARTICLES | TS_RANKS_ROWLESS,
	.due = ts_dump_may_be_due,
	.names = ts_dump_names,
	.summary = "Type and position of particles in the XYZ format",
	.doc = "Writes frames in the XYZ format: the number of particles, a line with the step, and a line "
	       "`type x y z` for each particle. `dump_modify element` replaces the types by names.",
	.example = "dump rock all xyz 1000 post/rock.xyz\ndump_modify rock element granite bit",
	.args = args,
	.state_size = sizeof(struct state),
	.saved = saved,
	.archive = ts_dump_archive,
	.init = init,
	.hook[TS_STAGE_OUTPUT] = output,
	.defers = TS_DEFERS(OUTPUT),
	.plan = ts_dump_plan,
	.fini = ts_dump_fini,
};
