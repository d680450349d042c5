/* Estimated output of a dump for -explain: size of a frame of the current state, from a sample of its
 * rows. */
#include <math.h>
#include <string.h>

#include "core/report.h"
#include "dump/dump.h"

#include "base/banned.h"

/* Compressed size / size with zlib, measured: of text, of 8-byte reals, of integers such as ids. */
static const double TEXT_LEFT = 0.45, REAL_LEFT = 0.9, INTEGER_LEFT = 0.25;
static const double NUMBER_WIDTH = 11; /* characters assumed for numbers that are still 0 */
static const double HEADER = 200;      /* bytes */
enum { SAMPLE = 200 };		       /* rows */

/* Mean number of characters of a column, with the blank. */
static double column_width(struct ts_dump_common *d, const struct ts_dump_column *c)
{
	size_t n = d->nrows < SAMPLE ? d->nrows : SAMPLE;
	double width = 0;

	for (size_t k = 0; k < n; k++) {
		double value = c->values.data[d->order[k * (d->nrows / n)]];

		ts_str_clear(&d->text);
		ts_dump_add_item(d, &d->text, c, value);
		width += c->integer || c->element || fabs(value) > 0 ? (double)d->text.length : NUMBER_WIDTH;
	}
	return n ? width / (double)n + 1 : 0;
}

static double frame_size(struct ts_dump_common *d, bool vtk)
{
	double row = vtk ? 3 * 8 * REAL_LEFT : 1;

	for (size_t k = 0; k < d->ncolumns; k++) {
		if (!vtk)
			row += column_width(d, &d->column[k]);
		else
			row += 8 * (d->column[k].integer ? INTEGER_LEFT : REAL_LEFT);
	}
	if (!vtk && ts_ends_with(d->file, ".gz"))
		row *= TEXT_LEFT;
	return HEADER + (double)d->nrows * row;
}

/* Number of frames in the run: multiples of the interval, and the first step if that is one or with
 * `first`. */
static int64_t count_frames(struct ts_dump_common *d, const struct tsim *sim)
{
	int64_t step = sim->clock.step;
	bool now = step % d->every == 0 || (d->first && d->frames == 0);
	bool written = (d->frames && d->last == step) || d->planned == step + 1;

	d->planned = sim->clock.last_step + 1;
	return ts_report_count(sim, d->every) + (now && !written);
}

/* `least`: rows that are not known before the first step are not counted. */
static enum ts_status price_frames(struct ts_instance *self, struct tsim *sim, double bytes, bool least,
				   struct ts_plan_report *report)
{
	struct ts_dump_common *d = self->state;
	struct ts_str name = { 0 };
	enum ts_status status;

	ts_str_addf(&name, "dump %s %s%s", self->id, d->file, least ? ", at least" : "");
	status = ts_report_output(report, ts_str_text(&name), count_frames(d, sim), bytes);
	ts_str_release(&name);
	return status == TS_OK ? TS_OK : ts_nomem(&sim->error);
}

enum ts_status ts_dump_price_frame(struct ts_instance *self, struct tsim *sim, double bytes,
				   struct ts_plan_report *report)
{
	return sim->reading.explain && !sim->log.quiet ? price_frames(self, sim, bytes, false, report)
						       : TS_OK;
}

enum ts_status ts_dump_price(struct ts_instance *self, struct tsim *sim, bool local, bool vtk,
			     struct ts_plan_report *report)
{
	struct ts_dump_common *d = self->state;
	bool unknown = false;

	if (!sim->reading.explain || sim->log.quiet)
		return TS_OK;
	/* columns that cannot be evaluated before the first step: the header alone is counted */
	if (ts_dump_gather(self, sim, local) != TS_OK) {
		if (sim->error.status == TS_NOMEM)
			return TS_NOMEM;
		ts_error_clear(&sim->error);
		d->nrows = 0;
		unknown = true;
	}
	return price_frames(self, sim, frame_size(d, vtk), unknown, report);
}

enum ts_status ts_dump_plan(struct ts_instance *self, struct tsim *sim, struct ts_plan_report *report)
{
	return ts_dump_price(self, sim, false, false, report);
}
