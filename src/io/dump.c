#include "io/dump.h"

#include <string.h>

#include "particles/domain.h"

#include "base/banned.h"

enum { CHUNK = 1 << 16 };

static bool one_file_per_frame(const struct ts_dump_common *d)
{
	return strchr(d->file, '*') != NULL;
}

static enum ts_status keep_text(struct tsim *sim, struct ts_instance *dump, const char *text,
				const char **out)
{
	*out = ts_arena_strdup(&dump->arena, text);
	return *out ? TS_OK : ts_nomem(&sim->error);
}

static enum ts_status set_format(struct tsim *sim, struct ts_instance *dump,
				 const struct ts_dump_changes *changes,
				 const struct ts_place *where)
{
	struct ts_dump_common *d = dump->state;
	bool integer = changes->format_kind == TS_DUMP_FORMAT_INT;
	char *to = integer ? d->int_format : d->float_format;
	char checked[TS_FORMAT_SIZE];
	size_t n = strlen(changes->format);

	if (changes->format_kind == TS_DUMP_FORMAT_LINE) {
		if (ts_words_split(&dump->arena, changes->format, where, &d->line_format) != TS_OK)
			return ts_nomem(&sim->error);
		return TS_OK;
	}
	if (n >= TS_FORMAT_SIZE || !ts_format_check(changes->format, integer, checked))
		return ts_fail(
			&sim->error, TS_SYNTAX, where,
			"dump_modify: '%s' is no format for one %s, expected for instance %s",
			changes->format, integer ? "integer" : "number", integer ? "%d" : "%.15g");
	memcpy(to, changes->format, n + 1);
	return TS_OK;
}

enum ts_status ts_dump_modify(struct tsim *sim, struct ts_instance *dump,
			      const struct ts_dump_changes *changes, const struct ts_place *where)
{
	struct ts_dump_common *d = dump->state;

	if (changes->every != INT64_MIN)
		d->every = dump->every = changes->every;
	if (changes->pad != INT64_MIN)
		d->pad = changes->pad;
	if (changes->sort >= 0)
		d->unsorted = !changes->sort;
	if (changes->first >= 0)
		d->first = changes->first;
	if (changes->append >= 0)
		d->append = changes->append;
	if (changes->label)
		TS_TRY(keep_text(sim, dump, changes->label, &d->label));
	if (changes->format)
		TS_TRY(set_format(sim, dump, changes, where));
	return dump->style->init ? dump->style->init(dump, sim) : TS_OK;
}

bool ts_dump_due(struct ts_instance *self, struct tsim *sim)
{
	struct ts_dump_common *d = self->state;
	int64_t step = sim->clock.step;
	bool due = step % d->every == 0 || (d->first && d->frames == 0);

	if (!due || (d->frames && d->last == step))
		return false;
	d->last = step;
	d->frames++;
	return true;
}

enum ts_status ts_dump_open(struct ts_instance *self, struct tsim *sim)
{
	struct ts_dump_common *d = self->state;

	ts_str_clear(&d->text);
	if (ts_textfile_is_open(&d->out))
		return TS_OK;
	ts_step_path(&d->path, d->file, (long long)sim->clock.step, (int)d->pad);
	if (d->path.failed)
		return ts_nomem(&sim->error);
	return ts_textfile_open(&d->out, &sim->error, ts_instance_word(self, d->file), ts_str_text(&d->path),
				d->append && !one_file_per_frame(d));
}

void ts_dump_header(struct ts_dump_common *d, struct tsim *sim, const char *what)
{
	static const char letter[] = "pfsm"; /* in the order of enum ts_face */
	const struct ts_box *box = &sim->domain->box;

	ts_str_addf(&d->text, "ITEM: TIMESTEP\n%lld\n", (long long)sim->clock.step);
	if (d->label)
		ts_str_addf(&d->text, "ITEM: LABEL\n%s\n", d->label);
	ts_str_addf(&d->text, "ITEM: NUMBER OF %s\n%zu\nITEM: BOX BOUNDS", what, d->nrows);
	for (int k = 0; k < 3; k++)
		ts_str_addf(&d->text, " %c%c", letter[box->face[k][0]], letter[box->face[k][1]]);
	ts_str_add(&d->text, "\n");
	for (int k = 0; k < 3; k++)
		ts_str_addf(&d->text, "%g %g\n", box->lo[k], box->hi[k]);
	ts_str_addf(&d->text, "ITEM: %s ", what);
	for (size_t k = 0; k < d->ncolumns; k++)
		ts_str_addf(&d->text, "%s ", d->column[k].input.name);
	ts_str_add(&d->text, "\n");
}

static enum ts_status put_text(struct ts_dump_common *d, struct tsim *sim)
{
	if (d->text.failed)
		return ts_nomem(&sim->error);
	TS_TRY(ts_textfile_write(&d->out, ts_str_text(&d->text), d->text.length));
	ts_str_clear(&d->text);
	return TS_OK;
}

enum ts_status ts_dump_write_rows(struct ts_dump_common *d, struct tsim *sim)
{
	for (size_t row = 0; row < d->nrows; row++) {
		for (size_t k = 0; k < d->ncolumns; k++) {
			const struct ts_dump_column *c = &d->column[k];

			ts_format_add(&d->text, c->format, c->integer,
				      c->values.data[d->order[row]]);
			ts_str_add_n(&d->text, " ", 1);
		}
		ts_str_add_n(&d->text, "\n", 1);
		if (d->text.length > CHUNK)
			TS_TRY(put_text(d, sim));
	}
	return put_text(d, sim);
}

enum ts_status ts_dump_frame_done(struct ts_dump_common *d)
{
	return one_file_per_frame(d) ? ts_textfile_close(&d->out) : ts_textfile_flush(&d->out);
}

enum ts_status ts_dump_frame(struct ts_instance *self, struct tsim *sim, bool local)
{
	struct ts_dump_common *d = self->state;

	if (!ts_dump_due(self, sim))
		return TS_OK;
	TS_TRY(ts_dump_gather(self, sim, local));
	TS_TRY(ts_dump_open(self, sim));
	ts_dump_header(d, sim, local ? "ENTRIES" : "ATOMS");
	TS_TRY(ts_dump_write_rows(d, sim));
	return ts_dump_frame_done(d);
}

void ts_dump_fini(struct ts_instance *self)
{
	struct ts_dump_common *d = self->state;

	ts_textfile_close(&d->out);
	for (size_t k = 0; k < d->ncolumns; k++)
		ts_table_release(&d->column[k].values);
	ts_free(d->order);
	ts_str_release(&d->text);
	ts_str_release(&d->path);
}
