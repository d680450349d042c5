#include <inttypes.h>
#include <string.h>

#include "bond/bonds.h"
#include "io/csv.h"
#include "io/last_step.h"

#include "base/banned.h"

enum { COLUMNS = 11 };
enum { MODE = 9 }; /* column */

static const char *const event_names[] = { "step", "time", "i",	    "j",    "type",  "x",
					   "y",	   "z",	   "force", "mode", "energy" };

struct breakage {
	const char *path;
	struct ts_textfile file;
	int64_t written; /* number of events already in the file */
};

static enum ts_status begin_table(struct breakage *s, struct tsim *sim)
{
	struct ts_str row = { 0 };

	ts_csv_names(&row, event_names, MODE);
	ts_csv_names(&row, event_names + MODE + !sim->bonds->transmits,
		     (size_t)(COLUMNS - MODE - !sim->bonds->transmits));
	ts_csv_end(&row);
	return ts_csv_begin(&s->file, sim, &row);
}

static void add_table_row(struct ts_str *row, const struct ts_bonds *bonds, int64_t k)
{
	const struct ts_bond_event *e = &bonds->event[k];

	ts_csv_int(row, e->step);
	ts_csv_real(row, e->time);
	ts_csv_int(row, e->tag[0]);
	ts_csv_int(row, e->tag[1]);
	ts_csv_int(row, e->type);
	for (int d = 0; d < 3; d++)
		ts_csv_real(row, e->x[d]);
	ts_csv_real(row, e->force);
	if (bonds->transmits)
		ts_csv_text(row, ts_bond_failure_name(e->mode));
	ts_csv_real(row, bonds->event_energy[k]);
	ts_csv_end(row);
}

static enum ts_status write_table(struct breakage *s, struct tsim *sim)
{
	struct ts_str rows = { 0 };

	for (; s->written < (int64_t)sim->bonds->nevents; s->written++)
		add_table_row(&rows, sim->bonds, s->written);
	return ts_csv_write(&s->file, sim, &rows);
}

static enum ts_status open_file(struct ts_instance *self, struct tsim *sim)
{
	struct breakage *s = self->state;

	if (ts_textfile_is_open(&s->file) || !s->path || sim->reading.explain)
		return TS_OK;
	TS_TRY(ts_textfile_open(&s->file, sim, ts_instance_word(self, s->path), s->path, s->written > 0));
	ts_last_step_warn(&s->file, sim, TS_STEP_ROWS, sim->clock.step + 1);
	if (ts_csv_is(s->path))
		return begin_table(s, sim);
	if (!s->written)
		TS_TRY(ts_textfile_printf(&s->file, "# step time i j type x y z force%s energy\n",
					  sim->bonds->transmits ? " mode" : ""));
	return TS_OK;
}

/* With several ranks events are written when all of them are known anyway. */
static bool is_due(const struct ts_instance *self, const struct tsim *sim)
{
	(void)self, (void)sim;
	return false;
}

static enum ts_status write_new_events(struct ts_instance *self, struct tsim *sim)
{
	struct breakage *s = self->state;
	const struct ts_bonds *bonds = sim->bonds;

	if (sim->division || !ts_textfile_is_open(&s->file) || s->written == (int64_t)bonds->nevents)
		return TS_OK;
	if (ts_csv_is(s->path))
		return write_table(s, sim);
	for (; s->written < (int64_t)bonds->nevents; s->written++) {
		const struct ts_bond_event *e = &bonds->event[s->written];

		TS_TRY(ts_textfile_printf(&s->file,
					  "%" PRId64 " %.9g %d %d %d %.9g %.9g %.9g %.9g%s%s %.9g\n", e->step,
					  e->time, e->tag[0], e->tag[1], e->type, e->x[0], e->x[1], e->x[2],
					  e->force, bonds->transmits ? " " : "",
					  bonds->transmits ? ts_bond_failure_name(e->mode) : "",
					  bonds->event_energy[s->written]));
	}
	return ts_textfile_flush(&s->file);
}

static enum ts_status eval_count(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	(void)self;
	out->data[0] = (double)sim->bonds->broken;
	return TS_OK;
}

static enum ts_status eval_events(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct ts_bonds *bonds = sim->bonds;

	(void)self;
	TS_TRY(ts_table_resize(out, bonds->nevents, COLUMNS));
	for (size_t k = 0; k < bonds->nevents; k++) {
		const struct ts_bond_event *e = &bonds->event[k];
		const double row[COLUMNS] = { (double)e->step,
					      e->time,
					      e->tag[0],
					      e->tag[1],
					      e->type,
					      e->x[0],
					      e->x[1],
					      e->x[2],
					      e->force,
					      e->mode,
					      bonds->event_energy[k] };

		memcpy(out->data + COLUMNS * k, row, sizeof row);
	}
	return TS_OK;
}

static void fini(struct ts_instance *self)
{
	ts_textfile_close(&((struct breakage *)self->state)->file);
}

static const struct ts_arg args[] = {
	TS_WORD("file", struct breakage, path, .flags = TS_OPTIONAL | TS_WRITES,
		.help = "text file with one line per broken bond; comma-separated values if it ends in .csv"),
	TS_ARGS_END,
};

static const struct ts_value values[] = {
	{ "count", "", "bonds broken so far", TS_SCALAR, 1, NULL, eval_count },
	{ "events", "", "one row per broken bond", TS_LOCAL, COLUMNS, event_names, eval_events },
	{ .name = NULL },
};

static const struct ts_saved saved[] = {
	TS_SAVE_I64(struct breakage, written),
	TS_SAVED_ROWS_END,
};

TS_STYLE(fix, ts_style, ts_fix_bond_breakage)
const struct ts_style ts_fix_bond_breakage = {
	.name = "bond/breakage",
	.kind = TS_KIND_FIX,
	.ranks = TS_RANKS_WHOLE | TS_RANKS_PARTICLES,
	.summary = "lists broken bonds with time and position",
	.doc = "Writes one line for each bond that breaks: step, time, IDs i and j of the partners, bond "
	       "type, midpoint x y z of the partners, and the bond force at breakage (> 0 in tension); for "
	       "bonds that transmit moments also the mode of failure: tension, shear, compression, cut (by "
	       "fix bond/break) or temperature; last the elastic energy of the bond, which is lost. The same "
	       "list is available as a local array for dump local, with the mode as number: 0 force (central "
	       "springs), 1 tension, 2 shear, 3 compression, 4 cut, 5 temperature. Bonds of all groups are "
	       "listed. With several ranks lines are written at steps with other output, and at the end of "
	       "a run.",
	.example = "fix crack all bond/breakage file post/broken.txt",
	.args = args,
	.state_size = sizeof(struct breakage),
	.saved = saved,
	.values = values,
	.hook = { [TS_STAGE_SETUP] = open_file, [TS_STAGE_END_OF_STEP] = write_new_events },
	.due = is_due,
	.fini = fini,
};
