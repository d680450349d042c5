#include "dump/dump.h"

#include <stdio.h>
#include <string.h>

#include "box/domain.h"
#include "core/units.h"
#include "io/csv.h"
#include "io/decimal.h"
#include "io/last_step.h"
#include "io/series.h"

#include "base/banned.h"

static bool one_file_per_frame(const struct ts_dump_common *d)
{
	return d->single || strchr(d->file, '*') != NULL;
}

bool ts_dump_may_be_due(const struct ts_instance *self, const struct tsim *sim)
{
	const struct ts_dump_common *d = self->state;
	int64_t step = sim->clock.step;

	return (d->variable ? d->next <= step : step % d->every == 0) || (d->first && d->frames == 0);
}

void ts_dump_names(const struct ts_instance *self, void (*tell)(void *data, const char *text), void *data)
{
	const struct ts_dump_common *d = self->state;
	const char *word[] = { d->variable, d->region, d->refresh };

	for (size_t k = 0; k < sizeof word / sizeof *word; k++)
		if (word[k])
			tell(data, word[k]);
	for (size_t k = 0; k < d->nthresholds; k++)
		tell(data, d->threshold[k].value.input.name);
}

enum ts_status ts_dump_due(struct ts_instance *self, struct tsim *sim, bool *due)
{
	struct ts_dump_common *d = self->state;
	int64_t step = sim->clock.step;

	*due = d->variable ? d->next > 0 && step == d->next : step % d->every == 0;
	if (*due || d->variable || d->frames == 0)
		ts_deferred_loops_run(sim);
	if (d->variable && (*due || step == sim->clock.first_step || d->next <= step))
		TS_TRY(ts_sim_next_step(sim, "dump_modify every", "frame", d->variable, &self->where,
					&d->next));
	*due |= d->first && d->frames == 0 && sim->clock.first_step >= d->delay;
	*due &= step >= d->delay && !(d->frames && d->last == step);
	*due |= d->once; /* write_dump */
	if (*due) {
		d->last = step;
		d->frames++;
	}
	return TS_OK;
}

enum ts_status ts_dump_open(struct ts_instance *self, struct tsim *sim)
{
	struct ts_dump_common *d = self->state;

	ts_str_clear(&d->text);
	if (ts_textfile_is_open(&d->out))
		return TS_OK;
	ts_series_path(&d->path, d->file, (long long)sim->clock.step, (int)d->pad);
	if (d->path.failed)
		return ts_nomem(&sim->error);
	if (one_file_per_frame(d))
		return ts_textfile_open_whole(&d->out, sim, ts_instance_word(self, d->file),
					      ts_str_text(&d->path));
	TS_TRY(ts_textfile_open(&d->out, sim, ts_instance_word(self, d->file), ts_str_text(&d->path),
				d->append));
	ts_last_step_warn(&d->out, sim, ts_csv_is(d->file) ? TS_STEP_ROWS : TS_STEP_FRAMES, sim->clock.step);
	return TS_OK;
}

/* By all digits, so that rerun and read_dump get the same box; LIGGGHTS writes six. */
static void add_bound(struct ts_dump_common *d, const struct tsim *sim, double bound, const char *behind)
{
	char text[TS_DECIMAL_SIZE];

	if (sim->legacy == TS_LEGACY_LIGGGHTS) {
		ts_str_addf(&d->text, "%g%s", bound, behind);
		return;
	}
	ts_str_add_n(&d->text, text, ts_decimal_shortest(bound, text));
	ts_str_add(&d->text, behind);
}

void ts_dump_header(struct ts_dump_common *d, struct tsim *sim, bool local)
{
	static const char letter[] = "pfsm"; /* in the order of enum ts_face */
	const struct ts_box *box = &sim->domain->box;
	const char *what = !local ? "ATOMS" : d->label ? d->label : "ENTRIES";

	if (d->units && (d->frames == 1 || one_file_per_frame(d)))
		ts_str_addf(&d->text, "ITEM: UNITS\n%s\n", ts_units_name(sim->units));
	if (d->time)
		ts_str_addf(&d->text, "ITEM: TIME\n%.16g\n", ts_sim_time(sim));
	ts_str_addf(&d->text, "ITEM: TIMESTEP\n%lld\n", (long long)sim->clock.step);
	if (d->label && !local)
		ts_str_addf(&d->text, "ITEM: LABEL\n%s\n", d->label);
	ts_str_addf(&d->text, "ITEM: NUMBER OF %s\n%zu\nITEM: BOX BOUNDS", what, d->nrows);
	for (int k = 0; k < 3; k++)
		ts_str_addf(&d->text, " %c%c", letter[box->face[k][0]], letter[box->face[k][1]]);
	ts_str_add(&d->text, "\n");
	for (int k = 0; k < 3; k++) {
		add_bound(d, sim, box->lo[k], " ");
		add_bound(d, sim, box->hi[k], "\n");
	}
	ts_str_addf(&d->text, "ITEM: %s ", what);
	for (size_t k = 0; k < d->ncolumns; k++)
		ts_str_addf(&d->text, "%s ", d->column[k].input.name);
	ts_str_add(&d->text, "\n");
}

enum ts_status ts_dump_keep_latest(struct ts_dump_common *d, struct tsim *sim)
{
	char **slot = d->nold ? &d->old[d->frames % d->nold] : NULL;

	if (!slot || sim->reading.explain)
		return TS_OK;
	if (*slot && !ts_streq(*slot, ts_str_text(&d->path))) /* written again after reset_timestep */
		ts_files_remove(&sim->files, *slot);
	ts_free(*slot);
	*slot = ts_strdup(ts_str_text(&d->path));
	return *slot ? TS_OK : ts_nomem(&sim->error);
}

enum ts_status ts_dump_frame_done(struct ts_dump_common *d, struct tsim *sim)
{
	if (!one_file_per_frame(d))
		return ts_textfile_flush(&d->out);
	TS_TRY(ts_textfile_close(&d->out));
	return ts_dump_keep_latest(d, sim);
}

/* The names of the columns of a table; every frame begins its rows with its step. */
static enum ts_status begin_table(struct ts_dump_common *d, struct tsim *sim)
{
	struct ts_str row = { 0 };

	ts_csv_text(&row, "step");
	if (d->time)
		ts_csv_text(&row, "time");
	for (size_t k = 0; k < d->ncolumns; k++)
		ts_csv_text(&row, d->column[k].input.name);
	ts_csv_end(&row);
	return ts_csv_begin(&d->out, sim, &row);
}

enum ts_status ts_dump_frame(struct ts_instance *self, struct tsim *sim, bool local)
{
	struct ts_dump_common *d = self->state;
	bool due, is_new;

	TS_TRY(ts_dump_due(self, sim, &due));
	if (!due)
		return TS_OK;
	TS_TRY(local ? ts_dump_gather(self, sim, true) : ts_dump_gather_rows(self, sim));
	is_new = !ts_textfile_is_open(&d->out);
	TS_TRY(ts_dump_open(self, sim));
	if (ts_csv_is(d->file)) {
		if (is_new && !d->headless)
			TS_TRY(begin_table(d, sim));
		TS_TRY(ts_dump_write_table(d, sim));
		return ts_dump_frame_done(d, sim);
	}
	if (!d->headless)
		ts_dump_header(d, sim, local);
	TS_TRY(ts_dump_write_rows(d, sim, true));
	return ts_dump_frame_done(d, sim);
}

void ts_dump_fini(struct ts_instance *self)
{
	struct ts_dump_common *d = self->state;

	ts_textfile_close(&d->out);
	for (size_t k = 0; k < d->ncolumns; k++)
		ts_table_release(&d->column[k].values);
	ts_dump_release_thresholds(d);
	for (int64_t k = 0; k < d->nold; k++)
		ts_free(d->old[k]);
	ts_free(d->old);
	ts_free(d->order);
	ts_str_release(&d->text);
	ts_str_release(&d->path);
}
