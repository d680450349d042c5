/* Rows of the log, runs, plans and ledgers. */
#include <math.h>
#include <string.h>

#include "base/clock.h"
#include "core/report.h"
#include "explain/guard.h"
#include "particle/particles.h"
#include "report/record.h"
#include "thermo/thermo.h"

#include "base/banned.h"

/* ---- rows */

/* Columns that say when, not what. */
static bool tells_time(const char *name)
{
	static const char *const names[] = {
		"step",	 "elapsed", "elaplong", "time",	     "dt",   "cpu",
		"tpcpu", "spcpu",   "cu",	"cpuremain", "part", "timeremain"
	};

	for (size_t k = 0; k < sizeof names / sizeof *names; k++)
		if (ts_streq(names[k], name))
			return true;
	return false;
}

static size_t columns_of(const struct ts_thermo *t)
{
	return t->n < TS_RECORD_COLUMNS ? t->n : TS_RECORD_COLUMNS;
}

static bool same_columns(const struct ts_record_table *table, const struct ts_thermo *t)
{
	if (table->n != columns_of(t))
		return false;
	for (size_t k = 0; k < table->n; k++)
		if (!ts_streq(table->column[k].title, t->column[k].title) ||
		    !ts_streq(table->column[k].name, t->column[k].input.name))
			return false;
	return true;
}

static bool set_column(struct ts_record *record, const struct tsim *sim, const struct ts_thermo_column *from,
		       struct ts_record_column *out)
{
	const struct ts_keyword *keyword = ts_keyword_find(sim->tables, from->input.name);

	out->title = ts_arena_strdup(&record->arena, from->title);
	out->name = ts_arena_strdup(&record->arena, from->input.name);
	out->help = keyword ? keyword->help : NULL;
	out->unit = keyword && *keyword->unit ? keyword->unit : NULL;
	out->integer = keyword && keyword->flags & TS_KEYWORD_INTEGER;
	out->clock = tells_time(from->input.name);
	return out->title && out->name;
}

static struct ts_record_table *new_table(struct ts_record *record, const struct tsim *sim)
{
	const struct ts_thermo *t = sim->thermo;
	struct ts_record_table *table = &record->table[record->ntables];
	bool good;

	record->left_out = record->ntables == TS_RECORD_TABLES;
	if (record->left_out) {
		record->tables_left++;
		return NULL;
	}
	*table = (struct ts_record_table){ .first_step = sim->clock.step, .first_time = ts_sim_time(sim) };
	table->n = columns_of(t);
	table->column = ts_arena_alloc(&record->arena, table->n, sizeof *table->column);
	table->last = ts_arena_alloc(&record->arena, table->n, sizeof *table->last);
	good = table->column && table->last && ts_rows_begin(&table->rows, table->n + 1) == TS_OK;
	for (size_t k = 0; good && k < table->n; k++)
		good = set_column(record, sim, &t->column[k], &table->column[k]);
	if (!good) {
		ts_rows_release(&table->rows);
		record->failed = true;
		return NULL;
	}
	record->ntables++;
	return table;
}

/* A table goes on over runs, as long as its columns stay the same and the step does not fall. */
static struct ts_record_table *present_table(struct ts_record *record, const struct tsim *sim)
{
	struct ts_record_table *last = record->ntables ? &record->table[record->ntables - 1] : NULL;
	const bool starts = sim->clock.step == sim->clock.first_step;

	if (record->left_out && !starts)
		return NULL;
	if (!last || !same_columns(last, sim->thermo) || sim->clock.step < last->last_step)
		last = new_table(record, sim);
	if (last)
		last->runs += starts;
	return last;
}

/* Whether the row says nothing but what the last one says: the first row of a run mostly repeats the last row of the run
 * before. Times begin anew there (elapsed, cpu), so they are not compared. A run of no steps after a change of the
 * script's variables has the step of the row before, but other values. */
static bool repeats_last(const struct ts_record_table *table, const struct tsim *sim)
{
	const struct ts_thermo *t = sim->thermo;

	if (!table->rows.count || table->last_step != sim->clock.step)
		return false;
	for (size_t k = 0; k < table->n; k++) {
		const double a = table->last[k], b = t->column[k].value;

		if (!table->column[k].clock && a != b && !(isnan(a) && isnan(b)))
			return false;
	}
	return true;
}

void ts_record_row(struct ts_record *record, struct tsim *sim)
{
	const struct ts_thermo *t = sim->thermo;
	struct ts_record_table *table = record->failed ? NULL : present_table(record, sim);
	double value[TS_RECORD_COLUMNS + 1];

	if (!table || repeats_last(table, sim))
		return;
	for (size_t k = 0; k < table->n; k++)
		value[k] = table->last[k] = t->column[k].value;
	value[table->n] = sim->guard->fraction > 0 ? sim->guard->fraction : NAN;
	table->last_step = sim->clock.step;
	table->last_time = ts_sim_time(sim);
	ts_rows_add(&table->rows, table->last_time, value);
}

/* ---- runs */

static void add_times(struct ts_record_run *to, const struct ts_record_run *run)
{
	to->wall += run->wall;
	for (int part = 0; part < TS_PLAN_PARTS; part++)
		to->part[part] += run->part[part];
}

static void read_ledger(struct ts_record *record, struct tsim *sim, struct ts_instance *fix)
{
	const struct ts_value *value = ts_value_find(fix, TS_VECTOR);
	struct ts_record_ledger *l = record->ledger;
	struct ts_table table = { 0 };

	while (l < record->ledger + record->nledgers && !ts_streq(l->id, fix->id))
		l++;
	if (!value || l == record->ledger + TS_RECORD_LEDGERS ||
	    ts_value_eval(fix, sim, value, &table) != TS_OK) {
		ts_table_release(&table);
		return;
	}
	if (l == record->ledger + record->nledgers) {
		l->id = ts_arena_strdup(&record->arena, fix->id);
		l->value = ts_arena_alloc(&record->arena, value->columns, sizeof *l->value);
		l->name = value->column_names;
		l->n = value->columns;
		record->nledgers += l->id && l->value;
	}
	if (l->value)
		memcpy(l->value, table.data, l->n * sizeof *l->value);
	l->step = sim->clock.step;
	ts_table_release(&table);
}

static void read_ledgers(struct ts_record *record, struct tsim *sim)
{
	const struct ts_instances *fixes = &sim->instances[TS_KIND_FIX];

	for (size_t k = 0; k < fixes->n; k++)
		if (ts_streq(fixes->item[k]->style->name, "energy/ledger"))
			read_ledger(record, sim, fixes->item[k]);
}

void ts_record_run(struct ts_record *record, struct tsim *sim, const struct ts_plan *plan)
{
	struct ts_record_run run = { .first = sim->clock.first_step,
				     .last = sim->clock.step,
				     .goal = sim->clock.goal,
				     .time = ts_sim_time(sim),
				     .dt = sim->clock.dt,
				     .wall = ts_clock() - sim->clock.wall_start,
				     .particles = sim->particles->n,
				     .limit = record->limit,
				     .limit_of = record->limit_of };
	struct ts_record_run *last = record->nruns ? &record->run[record->nruns - 1] : NULL;
	const bool again =
		sim->run.in_pieces && last && last->first == run.first; /* the next piece of the last run */

	for (int part = 0; part < TS_PLAN_PARTS; part++)
		run.part[part] = ts_plan_part_seconds(plan, part);
	record->steps += run.last - (again ? last->last : run.first);
	if (again)
		*last = run;
	else if (record->nruns < TS_RECORD_RUNS)
		record->run[record->nruns++] = run;
	else
		add_times(&record->rest, &run);
	record->runs += !again;
	if (!sim->error.status)
		read_ledgers(record, sim);
}

/* ---- plans */

static void add_left_out(struct ts_str *out, const struct ts_plan_report *plan)
{
	for (size_t k = 0; k < plan->nleft_out; k++)
		ts_str_addf(out, "%s  %-16s %s\n", k ? "" : "omitted, since results do not depend on it:\n",
			    plan->left_out[k].name, plan->left_out[k].why);
}

static void add_outputs(struct ts_str *out, const struct ts_plan_report *plan)
{
	bool any = false;

	for (size_t k = 0; k < plan->noutputs; k++) {
		const struct ts_output *o = &plan->output[k];

		if (!o->frames)
			continue;
		ts_str_addf(out, "%s  %-28s %lld times\n", any ? "" : "output files:\n", o->name,
			    (long long)o->frames);
		any = true;
	}
}

void ts_record_plan(struct ts_record *record, struct tsim *sim, const struct ts_plan_report *plan)
{
	const struct ts_limit *hard = ts_report_binding(plan, true);
	struct ts_str *out = &record->plan;

	(void)sim;
	record->limit = hard ? hard->dt : NAN;
	record->limit_of = hard ? ts_arena_strdup(&record->arena, hard->text) : NULL;
	ts_str_clear(out);
	ts_str_addf(out, "modelled:\n%s", ts_str_text(&plan->lines));
	add_left_out(out, plan);
	ts_str_addf(out, "memory: about %.3g MB\n", plan->bytes / 1e6);
	add_outputs(out, plan);
}
