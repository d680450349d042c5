#include "average/average_file.h"

#include <string.h>

#include "io/csv.h"
#include "io/last_step.h"

#include "base/banned.h"

enum ts_status ts_average_file_init(struct ts_instance *self, struct tsim *sim, struct ts_average_file *f)
{
	TS_TRY(ts_textfile_choose(&sim->error, &self->where, self->style->name, f->file, f->append));
	if (f->overwrite && f->append)
		return ts_fail(&sim->error, TS_SYNTAX, &self->where,
			       "fix %s: overwrite can be used with file, not with append", self->style->name);
	if (!ts_format_check(f->format, false, f->checked))
		return ts_fail(&sim->error, TS_SYNTAX, &self->where,
			       "fix %s: format '%s' is not a format of a number, such as %%g or %%12.5f",
			       self->style->name, f->format);
	f->csv = ts_csv_is(f->file ? f->file : f->append);
	if (f->csv && (f->title[0] || f->title[1] || f->title[2]))
		return ts_fail(&sim->error, TS_SYNTAX, &self->where,
			       "fix %s: a table of comma-separated values has no title lines",
			       self->style->name);
	return TS_OK;
}

bool ts_average_file_wanted(const struct ts_average_file *f)
{
	return f->file || f->append;
}

enum ts_status ts_average_file_begin(struct ts_instance *self, struct tsim *sim, struct ts_average_file *f,
				     bool *titles)
{
	const char *path = f->file ? f->file : f->append;

	ts_str_clear(&f->text);
	if (f->overwrite)
		TS_TRY(ts_textfile_close(&f->out));
	*titles = !ts_textfile_is_open(&f->out);
	if (!*titles)
		return TS_OK;
	TS_TRY(ts_textfile_open(&f->out, sim, ts_instance_word(self, path), path, f->append != NULL));
	ts_last_step_warn(&f->out, sim, f->blocks && !f->csv ? TS_STEP_BLOCKS : TS_STEP_ROWS,
			  sim->clock.step);
	return TS_OK;
}

void ts_average_file_title(struct ts_average_file *f, int k, const char *usual)
{
	ts_str_addf(&f->text, "%s\n", f->title[k] ? f->title[k] : usual);
}

void ts_average_file_number(struct ts_average_file *f, double value)
{
	struct ts_str cell = { 0 };

	if (!f->csv) {
		ts_str_add(&f->text, " ");
		ts_format_add(&f->text, f->checked, false, value);
	} else if (ts_streq(f->format, "%g")) {
		ts_csv_real(&f->text, value);
	} else {
		ts_format_add(&cell, f->checked, false, value);
		ts_csv_text(&f->text, ts_str_text(&cell) + strspn(ts_str_text(&cell), " "));
		f->text.failed |= cell.failed;
		ts_str_release(&cell);
	}
}

void ts_average_file_place(struct ts_average_file *f, double value)
{
	if (f->csv)
		ts_csv_real(&f->text, value);
	else
		ts_str_addf(&f->text, " %g", value);
}

enum ts_status ts_average_file_names_done(struct tsim *sim, struct ts_average_file *f)
{
	ts_csv_end(&f->text);
	return ts_csv_begin(&f->out, sim, &f->text);
}

enum ts_status ts_average_file_end(struct tsim *sim, struct ts_average_file *f)
{
	if (f->text.failed)
		return ts_nomem(&sim->error);
	TS_TRY(ts_textfile_write(&f->out, ts_str_text(&f->text), f->text.length));
	return ts_textfile_flush(&f->out);
}

enum ts_status ts_average_file_plan(const struct ts_average_file *f, struct tsim *sim, int64_t every,
				    size_t rows, size_t columns, struct ts_plan_report *report)
{
	static const double INDEX = 10, NUMBER = 12; /* characters, with the blank: estimates */
	const char *path = f->file ? f->file : f->append;

	if (!sim->reading.explain || !path)
		return TS_OK;
	return ts_report_output(report, path, f->overwrite ? 1 : ts_report_count(sim, every),
				(double)rows * (INDEX + NUMBER * (double)columns)) == TS_OK
		       ? TS_OK
		       : ts_nomem(&sim->error);
}

void ts_average_file_release(struct ts_average_file *f)
{
	ts_textfile_close(&f->out);
	ts_str_release(&f->text);
}
