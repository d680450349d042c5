#include <inttypes.h>
#include <math.h>

#include "core/report.h"
#include "energy/ledger.h"
#include "io/textfile.h"

#include "base/banned.h"

struct ledger {
	struct ts_ledger books; /* first */
	int64_t every;
	const char *path;
	double tolerance;
	bool summary;
	struct ts_textfile file;
};

#define TS_LEDGER_NAME(name, text) #name,
#define TS_LEDGER_TEXT(name, text) text,
static const char *const names[] = { TS_LEDGER_LIST(TS_LEDGER_NAME) NULL };
static const char *const texts[] = { TS_LEDGER_LIST(TS_LEDGER_TEXT) NULL };

/* A table of the log: name, value and, where there is one, a note. */
static void line(struct tsim *sim, const char *name, double value)
{
	if (value != 0)
		ts_log(&sim->log, "    %-52s %16.8g\n", name, value);
}

static void named(struct tsim *sim, const char *what, const char *name, double value)
{
	struct ts_str text = { 0 };

	ts_str_addf(&text, "%s %s", what, name);
	line(sim, ts_str_text(&text), value);
	ts_str_release(&text);
}

static void energies(struct tsim *sim, const struct ts_ledger *l, const double v[])
{
	double before = l->start_kinetic[0] + l->start_kinetic[1];

	for (int k = 0; k < TS_NSTORE; k++)
		before += l->start_store[k];
	ts_log(&sim->log, "  energy now\n");
	for (int k = 0; k < TS_LEDGER_TOTAL_VALUE; k++)
		line(sim, texts[k], v[k]);
	ts_log(&sim->log, "    %-52s %16.8g, %.8g more than at the start\n", texts[TS_LEDGER_TOTAL_VALUE],
	       v[TS_LEDGER_TOTAL_VALUE], v[TS_LEDGER_TOTAL_VALUE] - before);
}

static void sources(struct tsim *sim, const struct ts_ledger *l)
{
	double came = 0;

	ts_log(&sim->log, "  came from\n");
	for (size_t a = 0; a < l->nactors; a++)
		named(sim,
		      a == l->rest				? "forces made before, or changed later, than"
		      : l->actor[a].pushes == TS_LEDGER_IS_WALL ? "motion of"
								: "forces of",
		      l->actor[a].name, ts_compensated_value(&l->actor[a].work));
	line(sim, "the box that changes its shape", ts_compensated_value(&l->box));
	for (size_t a = 0; a < l->nactors; a++)
		named(sim, "motion set, particles made or taken by", l->actor[a].name,
		      ts_compensated_value(&l->actor[a].own));
	for (int k = 0; k < TS_NSTORE; k++)
		came += ts_compensated_value(&l->moved[k]);
	line(sim, "springs of particles that came or went", came);
	line(sim, "particles held against forces", ts_compensated_value(&l->held));
	line(sim, "commands between runs", ts_compensated_value(&l->between));
}

static void losses(struct tsim *sim, const double v[])
{
	ts_log(&sim->log, "  was lost\n");
	for (int k = TS_LEDGER_NORMAL_DASHPOTS_VALUE; k < TS_LEDGER_LOST_VALUE; k++)
		line(sim, texts[k], v[k]);
	line(sim, texts[TS_LEDGER_LOST_VALUE], v[TS_LEDGER_LOST_VALUE]);
}

static double share(const double v[], int value)
{
	double most = v[TS_LEDGER_TURNOVER_VALUE];

	return most > 0 ? v[value] / most : 0;
}

static void heat(struct tsim *sim, const struct ts_ledger *l, const double v[])
{
	ts_log(&sim->log, "  heat\n    %-52s %16.8g, %.8g more than at the start\n",
	       texts[TS_LEDGER_HEAT_VALUE], v[TS_LEDGER_HEAT_VALUE], v[TS_LEDGER_HEAT_VALUE] - l->heat.start);
	for (size_t a = 0; a < l->nactors; a++)
		named(sim, "from", l->actor[a].name, ts_compensated_value(&l->actor[a].heat));
	line(sim, "from sources", ts_compensated_value(&l->heat.source));
	line(sim, texts[TS_LEDGER_HEAT_MOVED_VALUE], v[TS_LEDGER_HEAT_MOVED_VALUE]);
	line(sim, texts[TS_LEDGER_HEAT_CLOSURE_VALUE], v[TS_LEDGER_HEAT_CLOSURE_VALUE]);
}

static enum ts_status summary(struct ts_instance *self, struct tsim *sim)
{
	static const char *const suspects[] = { "in normal springs between particles",
						"",
						"",
						"in normal springs at walls",
						"",
						"",
						"in bonds",
						"in turning bodies" };
	const struct ledger *s = self->state;
	double v[TS_LEDGER_VALUES], drift[TS_NSTORE + 1];

	if (!s->books.open || !s->summary)
		return TS_OK;
	ts_ledger_values(&s->books, v);
	ts_ledger_drifts(&s->books, drift);
	ts_log(&sim->log, "\nEnergy ledger fix %s, steps %" PRId64 " to %" PRId64 ", %g of time\n", self->id,
	       s->books.first, sim->clock.step, ts_sim_time(sim) - s->books.first_time);
	energies(sim, &s->books, v);
	sources(sim, &s->books);
	losses(sim, v);
	ts_log(&sim->log, "  cannot be explained\n");
	for (int k = TS_LEDGER_CLOSURE_VALUE; k <= TS_LEDGER_DRIFT_VALUE; k++)
		ts_log(&sim->log, "    %-52s %16.8g, %.2g of the largest turnover\n",
		       k == TS_LEDGER_DRIFT_VALUE ? "drift: error of the time step" : "closure: rounding",
		       v[k], share(v, k));
	for (int k = 0; k <= TS_NSTORE; k++)
		if (*suspects[k])
			named(sim, "  drift", suspects[k], drift[k]);
	line(sim, texts[TS_LEDGER_TURNOVER_VALUE], v[TS_LEDGER_TURNOVER_VALUE]);
	if (s->books.heat.known)
		heat(sim, &s->books, v);
	return TS_OK;
}

static const char *suspect(const struct ts_ledger *l)
{
	static const char *const text[] = { "normal springs between particles", "normal springs at walls",
					    "bonds", "turning bodies" };
	static const int store[] = { TS_STORE_NORMAL, TS_NCONTACT_STORE + TS_STORE_NORMAL, TS_LEDGER_BOND,
				     TS_NSTORE };
	double drift[TS_NSTORE + 1];
	int worst = 0;

	ts_ledger_drifts(l, drift);
	for (int k = 1; k < 4; k++)
		if (fabs(drift[store[k]]) > fabs(drift[store[worst]]))
			worst = k;
	return text[worst];
}

static enum ts_status finish(struct ts_instance *self, struct tsim *sim)
{
	const struct ledger *s = self->state;
	double v[TS_LEDGER_VALUES];

	ts_ledger_values(&s->books, v);
	TS_TRY(summary(self, sim));
	if (fabs(share(v, TS_LEDGER_DRIFT_VALUE)) > s->tolerance)
		ts_warn(&sim->log, &self->where,
			"fix %s %s: the energy of springs drifted by %.2g of the largest turnover, tolerance "
			"%g; mostly %s. A smaller time step helps, by its square where forces have no jumps",
			self->id, self->style->name, share(v, TS_LEDGER_DRIFT_VALUE), s->tolerance,
			suspect(&s->books));
	return TS_OK;
}

static enum ts_status open_file(struct ts_instance *self, struct tsim *sim)
{
	struct ledger *s = self->state;

	if (!s->path || ts_textfile_is_open(&s->file))
		return TS_OK;
	TS_TRY(ts_textfile_open(&s->file, sim, ts_instance_word(self, s->path), s->path, false));
	TS_TRY(ts_textfile_printf(&s->file, "# step time"));
	for (int k = 0; k < TS_LEDGER_VALUES; k++)
		TS_TRY(ts_textfile_printf(&s->file, " %s", names[k]));
	return ts_textfile_printf(&s->file, "\n");
}

static enum ts_status write(struct ts_instance *self, struct tsim *sim)
{
	struct ledger *s = self->state;
	double v[TS_LEDGER_VALUES];

	if (!s->path || sim->clock.step % s->every != 0)
		return TS_OK;
	TS_TRY(open_file(self, sim));
	ts_ledger_values(&s->books, v);
	TS_TRY(ts_textfile_printf(&s->file, "%" PRId64 " %.9g", sim->clock.step, ts_sim_time(sim)));
	for (int k = 0; k < TS_LEDGER_VALUES; k++)
		TS_TRY(ts_textfile_printf(&s->file, " %.12g", v[k]));
	TS_TRY(ts_textfile_printf(&s->file, "\n"));
	return ts_textfile_flush(&s->file);
}

/* Of books that were begun before the row of this step has been written. */
static enum ts_status setup(struct ts_instance *self, struct tsim *sim)
{
	bool begun = ((struct ledger *)self->state)->books.open != 0;

	TS_TRY(ts_ledger_setup(self, sim));
	return begun ? TS_OK : write(self, sim);
}

static enum ts_status end_of_step(struct ts_instance *self, struct tsim *sim)
{
	TS_TRY(ts_ledger_settle(self, sim));
	return write(self, sim);
}

static enum ts_status plan(struct ts_instance *self, struct tsim *sim, struct ts_plan_report *report)
{
	const struct ledger *s = self->state;
	size_t numbers = TS_LEDGER_COLUMN;

	for (size_t a = 0; a < s->books.nactors; a++)
		numbers += s->books.actor[a].pushes ? TS_CAUSE_NUMBERS : 0;
	ts_report_line(report, "energy ledger", "%zu bytes a particle", numbers * sizeof(double));
	if (!sim->reading.explain || !s->path)
		return TS_OK;
	return ts_report_output(report, s->path, ts_report_times(sim, s->every),
				20 + 18.0 * TS_LEDGER_VALUES) == TS_OK
		       ? TS_OK
		       : ts_nomem(&sim->error);
}

static enum ts_status eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	(void)sim;
	ts_ledger_values(self->state, out->data);
	return TS_OK;
}

static enum ts_status eval_residual(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	double v[TS_LEDGER_VALUES];

	(void)sim;
	ts_ledger_values(self->state, v);
	out->data[0] = share(v, TS_LEDGER_CLOSURE_VALUE) + share(v, TS_LEDGER_DRIFT_VALUE);
	return TS_OK;
}

static void fini(struct ts_instance *self)
{
	ts_textfile_close(&((struct ledger *)self->state)->file);
	ts_ledger_fini(self);
}

static const struct ts_arg args[] = {
	TS_INT("every", struct ledger, every, .range = TS_POSITIVE, .fallback = "1000",
	       .help = "steps between lines of the file"),
	TS_WORD("file", struct ledger, path, .flags = TS_OPTIONAL | TS_WRITES, .help = "table of all values"),
	TS_REAL("tolerance", struct ledger, tolerance, .range = TS_POSITIVE, .fallback = "0.01", .unit = "",
		.help = "a warning where the drift is a larger part of the largest turnover"),
	TS_BOOL("summary", struct ledger, summary, .fallback = "yes",
		.help = "a table in the log at the end of each run"),
	TS_ARGS_END,
};

static const struct ts_value values[] = {
	{ "residual", "", "closure and drift as a part of the largest turnover", TS_SCALAR, 1, NULL,
	  eval_residual },
	{ "books", "energy", "energies now, where energy came from, where it was lost, what is unexplained",
	  TS_VECTOR, TS_LEDGER_VALUES, names, eval },
	{ .name = NULL },
};

TS_STYLE(fix, ts_style, ts_fix_energy_ledger)
const struct ts_style ts_fix_energy_ledger = {
	.name = "energy/ledger",
	.kind = TS_KIND_FIX,
	.summary = "Books where the energy of the particles comes from and where it goes",
	.doc = "Splits the work of all forces by cause and adds up what the springs store; it only looks, "
	       "and results\n"
	       "are the same with it. Each half kick v' = v + s F/m changes the kinetic energy by s F.(v + "
	       "v')/2\n"
	       "exactly, so the works of all causes close to rounding: closure. What springs store differs "
	       "from\n"
	       "the work put in by the error of the time step: drift, of second order in the step for "
	       "forces\n"
	       "without jumps. With the values f_ID[k] listed below,\n\n"
	       "  TOTAL - TOTAL(0) = FORCES + DRIVE + MOVED - LOST + CLOSURE + DRIFT\n\n"
	       "The table at the end of a run names who has brought what; a warning says if the drift is "
	       "more than\n"
	       "`tolerance` of the largest turnover, and where most of it is. The group has no effect: the "
	       "books are\n"
	       "those of all particles. doc/energy.md has the details.",
	.example = "fix books all energy/ledger every 100 file post/energy.txt tolerance 0.001",
	.args = args,
	.state_size = sizeof(struct ledger),
	.archive = ts_ledger_archive,
	.values = values,
	.init = ts_ledger_init,
	.watch = ts_ledger_watch,
	.hook = { [TS_STAGE_SETUP] = setup,
		  [TS_STAGE_END_OF_STEP] = end_of_step,
		  [TS_STAGE_FINISH] = finish },
	.plan = plan,
	.fini = fini,
};
