/* Dump atom: id, type and position of particles as text. */
#include "core/sim.h"
#include "dump/dump.h"

#include "base/banned.h"

struct state {
	struct ts_dump_common common;
	bool plain, image; /* settings for which the columns were made */
};

/* The columns depend on `scale` and `image` of dump_modify. */
static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	static const char *const scaled[] = { "id", "type", "xs", "ys", "zs", "ix", "iy", "iz" };
	static const char *const plain[] = { "id", "type", "x", "y", "z", "ix", "iy", "iz" };
	struct state *s = self->state;
	struct ts_dump_common *d = &s->common;
	struct ts_word word[8];

	for (size_t k = 0; k < 8; k++)
		word[k] = (struct ts_word){ .text = d->plain ? plain[k] : scaled[k], .place = self->where };
	if (d->column && (s->plain != d->plain || s->image != d->image)) {
		for (size_t k = 0; k < d->ncolumns; k++)
			ts_table_release(&d->column[k].values);
		d->column = NULL; /* the columns are made again */
		d->ncolumns = 0;
	}
	s->plain = d->plain;
	s->image = d->image;
	return ts_dump_columns(self, sim, (struct ts_words){ word, d->image ? 8 : 5 }, false);
}

static enum ts_status output(struct ts_instance *self, struct tsim *sim)
{
	return ts_dump_frame(self, sim, false);
}

static const struct ts_arg args[] = { TS_DUMP_ARGS(struct state), TS_ARGS_END };

static const struct ts_saved saved[] = { TS_DUMP_SAVED(struct state), TS_SAVED_ROWS_END };

TS_STYLE(dump, ts_style, ts_dump_atom)
const struct ts_style ts_dump_atom = {
	.name = "atom",
	.kind = TS_KIND_DUMP,
	.dump_words = TS_DUMP_SELECTION " refresh format label time units scale image header append",
	.ranks = TS_RANKS_WHOLE | TS_RANKS_PARTICLES | TS_RANKS_ROWLESS,
	.due = ts_dump_may_be_due,
	.names = ts_dump_names,
	.summary = "Id, type and position of particles as text",
	.doc = "As dump custom with the columns id type xs ys zs: positions are scaled from 0 to 1 across "
	       "the box. `dump_modify scale no` writes x y z instead, `image yes` adds ix iy iz. A file "
	       "whose name ends in .csv is a table of comma-separated values, as of dump custom.",
	.example = "dump rock all atom 1000 post/rock*.dump\ndump_modify rock scale no image yes",
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
