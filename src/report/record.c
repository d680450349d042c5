#include "report/record.h"

#include "base/clock.h"
#include "report/page.h"

#include "base/banned.h"

/* Wall time between pages in units of the time that writing one takes: half a percent of the run. */
static const double SHARE = 200;
/* The clock is read about so often, s: a reading takes as long as a step of a few particles. */
static const double LOOK = 0.05;

static struct ts_record *record_of(struct ts_recorder *self)
{
	return (struct ts_record *)self;
}

/* ---- pages */

/* A page that cannot be written is no reason to end a run: there is a warning, and the next page may be possible. */
static void renew_page(struct ts_record *record, struct tsim *sim)
{
	const struct ts_error before = sim->error;
	const double start = ts_clock();

	if (ts_page_write(record, sim) != TS_OK && !record->warned) {
		ts_warn(&sim->log, &record->where, "the report is not renewed: %s", sim->error.message);
		record->warned = true;
	}
	sim->error = before;
	record->cost += ts_clock() - start;
	record->pages++;
	record->due = ts_clock() + SHARE * (ts_clock() - start);
	if (record->due < start + record->renew)
		record->due = start + record->renew;
}

static void step(struct ts_recorder *self, struct tsim *sim)
{
	struct ts_record *record = record_of(self);
	double now;

	if (--record->countdown > 0)
		return;
	now = ts_clock();
	if (record->file && now >= record->due)
		renew_page(record, sim);
	if (now - record->read < LOOK && record->checked < 1 << 20)
		record->checked *= 2;
	else if (now - record->read > 2 * LOOK && record->checked > 1)
		record->checked /= 2;
	record->countdown = record->checked;
	record->read = now;
}

/* ---- functions of the recorder */

static enum ts_status begin(struct ts_recorder *self, struct tsim *sim)
{
	return ts_record_views_begin(record_of(self), sim);
}

static void planned(struct ts_recorder *self, struct tsim *sim, const struct ts_plan_report *plan)
{
	if (record_of(self)->file)
		ts_record_plan(record_of(self), sim, plan);
}

static void row(struct ts_recorder *self, struct tsim *sim)
{
	if (record_of(self)->file)
		ts_record_row(record_of(self), sim);
}

static bool records(const struct ts_recorder *self)
{
	return record_of((struct ts_recorder *)self)->file != NULL;
}

static void stop(struct ts_recorder *self, struct tsim *sim, const struct ts_plan *plan)
{
	if (record_of(self)->file)
		ts_record_run(record_of(self), sim, plan);
}

static void clear(struct ts_recorder *self, struct tsim *sim)
{
	if (record_of(self)->file)
		ts_record_views_end(record_of(self), sim);
}

static void release(struct ts_recorder *self, struct tsim *sim)
{
	struct ts_record *record = record_of(self);

	sim->log.copy = NULL;
	sim->recorder = NULL;
	for (size_t k = 0; k < record->ntables; k++)
		ts_rows_release(&record->table[k].rows);
	ts_record_views_release(record);
	ts_str_release(&record->line);
	ts_str_release(&record->plan);
	ts_arena_release(&record->arena);
	ts_free(record);
}

struct ts_record *ts_record_of(struct tsim *sim)
{
	struct ts_record *record;

	if (sim->recorder)
		return record_of(sim->recorder);
	record = ts_alloc(1, sizeof *record);
	if (!record)
		return NULL;
	record->base = (struct ts_recorder){ begin, planned, row, step, records, stop, clear, release };
	record->renew = TS_RECORD_RENEW;
	record->checked = 1;
	sim->recorder = &record->base;
	return record;
}

/* ---- begin and end */

/* A page is written at once: that the file cannot be written is better known now than after the run. */
enum ts_status ts_record_open(struct ts_record *record, struct tsim *sim, const char *file,
			      const struct ts_place *where, bool by_option)
{
	enum ts_status status;

	record->where = where ? *where : (struct ts_place){ 0 };
	record->by_option = by_option;
	record->file = ts_arena_strdup(&record->arena, file);
	if (!record->file)
		return ts_nomem(&sim->error);
	record->begun = time(NULL);
	record->start = record->read = ts_clock();
	if (sim->reading.explain)
		return TS_OK;
	sim->log.copy = ts_record_log;
	sim->log.copy_data = record;
	record->due = record->start + record->renew;
	status = ts_page_write(record, sim);
	if (status != TS_OK)
		record->file = NULL; /* not tried again at the end */
	return status;
}

enum ts_status ts_record_close(struct tsim *sim, enum ts_record_end end, const char *message)
{
	struct ts_record *record = sim->recorder ? record_of(sim->recorder) : NULL;
	const struct ts_error before = sim->error;
	enum ts_status status;

	if (!record || !record->file || sim->reading.explain || record->end != TS_RECORD_RUNNING)
		return TS_OK;
	ts_record_views_end(record, sim);
	record->end = end;
	record->message = message ? ts_arena_strdup(&record->arena, message) : NULL;
	record->error_at = before.place;
	sim->log.copy = NULL;
	ts_error_clear(&sim->error);
	status = ts_page_write(record, sim);
	if (status == TS_OK)
		sim->error = before;
	return status;
}
