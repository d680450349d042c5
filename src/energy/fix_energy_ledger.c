#include <inttypes.h>
#include <math.h>

#include "core/report.h"
#include "energy/ledger.h"
#include "io/csv.h"
#include "io/last_step.h"
#include "wall/wall.h"

#include "base/banned.h"

struct ledger {
	struct ts_ledger books; /* must be the first member */
	int64_t every;
	const char *replaced, *append;
	double tolerance;
	bool summary;
	struct ts_textfile file;
};

/* The file, if there is one. */
static const char *path_of(const struct ledger *s)
{
	return s->append ? s->append : s->replaced;
}

#define TS_LEDGER_NAME(name, text) #name,
#define TS_LEDGER_TEXT(name, text) text,
static const char *const names[] = { TS_LEDGER_LIST(TS_LEDGER_NAME) NULL };
static const char *const texts[] = { TS_LEDGER_LIST(TS_LEDGER_TEXT) NULL };

/* Table in the log: lines of name and value; zeros are left out. */
static void log_value(struct tsim *sim, const char *name, double value)
{
	if (value != 0)
		ts_log(&sim->log, "    %-52s %16.8g\n", name, value);
}

static void log_named_value(struct tsim *sim, const char *what, const char *name, double value)
{
	struct ts_str text = { 0 };

	ts_str_addf(&text, "%s %s", what, name);
	log_value(sim, ts_str_text(&text), value);
	ts_str_release(&text);
}

static void log_energies(struct tsim *sim, const struct ts_ledger *l, const double v[])
{
	double before = l->start_kinetic[0] + l->start_kinetic[1];

	for (int k = 0; k < TS_NSTORE; k++)
		before += l->start_store[k];
	ts_log(&sim->log, "  energies\n");
	for (int k = 0; k < TS_LEDGER_TOTAL_VALUE; k++)
		log_value(sim, texts[k], v[k]);
	ts_log(&sim->log, "    %-52s %16.8g, change %.8g\n", texts[TS_LEDGER_TOTAL_VALUE],
	       v[TS_LEDGER_TOTAL_VALUE], v[TS_LEDGER_TOTAL_VALUE] - before);
}

static void log_sources(struct tsim *sim, const struct ts_ledger *l)
{
	double came = 0;

	ts_log(&sim->log, "  sources\n");
	for (size_t a = 0; a < l->nactors; a++)
		log_named_value(sim,
				a == l->rest ? "unattributed forces, computed outside of"
				: l->actor[a].pushes == TS_LEDGER_IS_WALL ? "work of wall"
									  : "work of",
				l->actor[a].name, ts_compensated_value(&l->actor[a].work));
	log_value(sim, "box deformation", ts_compensated_value(&l->box));
	for (size_t a = 0; a < l->nactors; a++)
		log_named_value(sim, "velocities set, particles added or removed by", l->actor[a].name,
				ts_compensated_value(&l->actor[a].own));
	for (int k = 0; k < TS_NSTORE; k++)
		came += ts_compensated_value(&l->moved[k]);
	log_value(sim, "elastic energy of added or removed particles", came);
	log_value(sim, "constraints", ts_compensated_value(&l->held));
	log_value(sim, "commands between runs", ts_compensated_value(&l->between));
}

static void log_losses(struct tsim *sim, const double v[])
{
	ts_log(&sim->log, "  dissipation\n");
	for (int k = TS_LEDGER_NORMAL_DASHPOTS_VALUE; k < TS_LEDGER_LOST_VALUE; k++)
		log_value(sim, texts[k], v[k]);
	log_value(sim, texts[TS_LEDGER_LOST_VALUE], v[TS_LEDGER_LOST_VALUE]);
}

static double relative_to_turnover(const double v[], int value)
{
	double largest = v[TS_LEDGER_TURNOVER_VALUE];

	return largest > 0 ? v[value] / largest : 0;
}

static void log_heat(struct tsim *sim, const struct ts_ledger *l, const double v[])
{
	ts_log(&sim->log, "  heat\n    %-52s %16.8g, change %.8g\n", texts[TS_LEDGER_HEAT_VALUE],
	       v[TS_LEDGER_HEAT_VALUE], v[TS_LEDGER_HEAT_VALUE] - l->heat.start);
	for (size_t a = 0; a < l->nactors; a++)
		log_named_value(sim, "from", l->actor[a].name, ts_compensated_value(&l->actor[a].heat));
	log_value(sim, "from sources", ts_compensated_value(&l->heat.source));
	log_value(sim, texts[TS_LEDGER_HEAT_MOVED_VALUE], v[TS_LEDGER_HEAT_MOVED_VALUE]);
	log_value(sim, texts[TS_LEDGER_HEAT_CLOSURE_VALUE], v[TS_LEDGER_HEAT_CLOSURE_VALUE]);
}

static enum ts_status log_summary(struct ts_instance *self, struct tsim *sim)
{
	static const char *const suspects[TS_NSTORE + 1] = {
		[TS_STORE_NORMAL] = "in normal springs between particles",
		[TS_NCONTACT_STORE + TS_STORE_NORMAL] = "in normal springs at walls",
		[TS_LEDGER_BOND] = "in bonds",
		[TS_NSTORE] = "in rotation of rigid bodies",
	};
	const struct ledger *s = self->state;
	double v[TS_LEDGER_VALUES], drift[TS_NSTORE + 1];

	if (!s->books.open || !s->summary)
		return TS_OK;
	ts_ledger_values(&s->books, v);
	ts_ledger_drifts(&s->books, drift);
	ts_log(&sim->log, "\nEnergy ledger fix %s, steps %" PRId64 " to %" PRId64 ", %g of time\n", self->id,
	       s->books.first, sim->clock.step, ts_sim_time(sim) - s->books.first_time);
	log_energies(sim, &s->books, v);
	log_sources(sim, &s->books);
	log_losses(sim, v);
	ts_log(&sim->log, "  residuals\n");
	for (int k = TS_LEDGER_CLOSURE_VALUE; k <= TS_LEDGER_DRIFT_VALUE; k++)
		ts_log(&sim->log, "    %-52s %16.8g, %.2g of the largest turnover\n",
		       k == TS_LEDGER_DRIFT_VALUE ? "drift (time integration error)" : "closure (round-off)",
		       v[k], relative_to_turnover(v, k));
	for (int k = 0; k <= TS_NSTORE; k++)
		if (suspects[k])
			log_named_value(sim, "  drift", suspects[k], drift[k]);
	log_value(sim, texts[TS_LEDGER_TURNOVER_VALUE], v[TS_LEDGER_TURNOVER_VALUE]);
	if (s->books.heat.known)
		log_heat(sim, &s->books, v);
	return TS_OK;
}

static const char *largest_drift(const struct ts_ledger *l)
{
	static const char *const text[] = { "normal springs between particles", "normal springs at walls",
					    "bonds", "rotation of rigid bodies" };
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

static enum ts_status finish_run(struct ts_instance *self, struct tsim *sim)
{
	const struct ledger *s = self->state;
	double v[TS_LEDGER_VALUES];

	ts_ledger_values(&s->books, v);
	TS_TRY(log_summary(self, sim));
	if (fabs(relative_to_turnover(v, TS_LEDGER_DRIFT_VALUE)) > s->tolerance)
		ts_warn(&sim->log, &self->where,
			"fix %s %s: the energy drift is %.2g of the largest turnover (tolerance %g), mostly "
			"in %s. It decreases with the square of the time step if forces are continuous",
			self->id, self->style->name, relative_to_turnover(v, TS_LEDGER_DRIFT_VALUE),
			s->tolerance, largest_drift(&s->books));
	return TS_OK;
}

static enum ts_status begin_table(struct ledger *s, struct tsim *sim)
{
	struct ts_str row = { 0 };

	ts_csv_text(&row, "step");
	ts_csv_text(&row, "time");
	ts_csv_names(&row, names, TS_LEDGER_VALUES);
	ts_csv_end(&row);
	return ts_csv_begin(&s->file, sim, &row);
}

static enum ts_status add_table_row(struct ledger *s, struct tsim *sim, const double v[])
{
	struct ts_str row = { 0 };

	ts_csv_int(&row, sim->clock.step);
	ts_csv_real(&row, ts_sim_time(sim));
	for (int k = 0; k < TS_LEDGER_VALUES; k++)
		ts_csv_real(&row, v[k]);
	ts_csv_end(&row);
	return ts_csv_write(&s->file, sim, &row);
}

static enum ts_status open_file(struct ts_instance *self, struct tsim *sim)
{
	struct ledger *s = self->state;
	const char *path = path_of(s);

	if (!path || ts_textfile_is_open(&s->file))
		return TS_OK;
	TS_TRY(ts_textfile_open(&s->file, sim, ts_instance_word(self, path), path, s->append != NULL));
	ts_last_step_warn(&s->file, sim, TS_STEP_ROWS, sim->clock.step);
	if (ts_csv_is(path))
		return begin_table(s, sim);
	TS_TRY(ts_textfile_printf(&s->file, "# step time"));
	for (int k = 0; k < TS_LEDGER_VALUES; k++)
		TS_TRY(ts_textfile_printf(&s->file, " %s", names[k]));
	return ts_textfile_printf(&s->file, "\n");
}

static enum ts_status write_row(struct ts_instance *self, struct tsim *sim)
{
	struct ledger *s = self->state;
	double v[TS_LEDGER_VALUES];

	if (!path_of(s) || sim->clock.step % s->every != 0)
		return TS_OK;
	TS_TRY(open_file(self, sim));
	ts_ledger_values(&s->books, v);
	if (ts_csv_is(path_of(s)))
		return add_table_row(s, sim, v);
	TS_TRY(ts_textfile_printf(&s->file, "%" PRId64 " %.9g", sim->clock.step, ts_sim_time(sim)));
	for (int k = 0; k < TS_LEDGER_VALUES; k++)
		TS_TRY(ts_textfile_printf(&s->file, " %.12g", v[k]));
	TS_TRY(ts_textfile_printf(&s->file, "\n"));
	return ts_textfile_flush(&s->file);
}

/* If the balance starts now, the row of this step has not been written yet. */
static enum ts_status setup_ledger(struct ts_instance *self, struct tsim *sim)
{
	bool begun = ((struct ledger *)self->state)->books.open != 0;

	TS_TRY(ts_ledger_setup(self, sim));
	return begun ? TS_OK : write_row(self, sim);
}

static enum ts_status end_of_step(struct ts_instance *self, struct tsim *sim)
{
	TS_TRY(ts_ledger_finish_step(self, sim));
	return write_row(self, sim);
}

/* The energy of a surface that is a spring under particles is in no store. */
static enum ts_status check_walls(struct ts_instance *self, struct tsim *sim)
{
	const struct ts_instance *by;
	const struct ts_wall *w;
	size_t k = 0;

	while ((w = ts_walls_next(sim, &k, &by)))
		if (w->yields)
			return ts_fail(&sim->error, TS_STATE, &self->where,
				       "fix energy/ledger: the surface of wall %s is a spring under "
				       "particles (`winkler` of fix surface/voxel), whose energy is not "
				       "known",
				       by->id);
	return TS_OK;
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	const struct ledger *s = self->state;

	TS_TRY(ts_textfile_choose(&sim->error, &self->where, self->style->name, s->replaced, s->append));
	return ts_ledger_init(self, sim);
}

static enum ts_status report_memory(struct ts_instance *self, struct tsim *sim, struct ts_plan_report *report)
{
	const struct ledger *s = self->state;
	size_t numbers = TS_LEDGER_COLUMN;

	TS_TRY(check_walls(self, sim));
	for (size_t a = 0; a < s->books.nactors; a++)
		numbers += s->books.actor[a].pushes ? TS_CAUSE_NUMBERS : 0;
	ts_report_line(report, "energy ledger", "%zu bytes per particle", numbers * sizeof(double));
	if (!sim->reading.explain || !path_of(s))
		return TS_OK;
	return ts_report_output(report, path_of(s), ts_report_count(sim, s->every),
				20 + 18.0 * TS_LEDGER_VALUES) == TS_OK
		       ? TS_OK
		       : ts_nomem(&sim->error);
}

static enum ts_status eval_balance(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
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
	out->data[0] = relative_to_turnover(v, TS_LEDGER_CLOSURE_VALUE) +
		       relative_to_turnover(v, TS_LEDGER_DRIFT_VALUE);
	return TS_OK;
}

static void fini(struct ts_instance *self)
{
	ts_textfile_close(&((struct ledger *)self->state)->file);
	ts_ledger_fini(self);
}

/* All ranks have the same values at the end of each step. */
static bool is_due(const struct ts_instance *self, const struct tsim *sim)
{
	(void)self, (void)sim;
	return true;
}

static const struct ts_arg args[] = {
	TS_INT("every", struct ledger, every, .range = TS_POSITIVE, .fallback = "1000",
	       .help = "number of time steps between lines of the file"),
	TS_WORD("file", struct ledger, replaced, .flags = TS_OPTIONAL | TS_WRITES,
		.help = "text file with all values; comma-separated values if it ends in .csv; an existing "
			"one is "
			"replaced"),
	TS_WORD("append", struct ledger, append, .flags = TS_OPTIONAL | TS_WRITES,
		.help = "the same; the values are appended to an existing file"),
	TS_REAL("tolerance", struct ledger, tolerance, .range = TS_POSITIVE, .fallback = "0.01", .unit = "",
		.help = "relative drift, divided by the largest turnover, above which a warning is printed"),
	TS_BOOL("summary", struct ledger, summary, .fallback = "yes",
		.help = "print a table at the end of each run"),
	TS_ARGS_END,
};

static const struct ts_value values[] = {
	{ "residual", "", "closure plus drift, divided by the largest turnover", TS_SCALAR, 1, NULL,
	  eval_residual },
	{ "books", "energy", "current energies, sources, losses and residuals", TS_VECTOR, TS_LEDGER_VALUES,
	  names, eval_balance },
	{ .name = NULL },
};

TS_STYLE(fix, ts_style, ts_fix_energy_ledger)
const struct ts_style ts_fix_energy_ledger = {
	.name = "energy/ledger",
	.kind = TS_KIND_FIX,
	.summary = "computes the energy balance of the particles by sources and losses",
	.doc = "Computes the work of all forces by cause, and the elastic energy of contacts and bonds. The "
	       "fix does not change the simulation: results are bitwise the same with it. Each half kick v' "
	       "= v + s F/m changes the kinetic energy by exactly s F . (v + v')/2, so the works of all "
	       "causes add up to its change to rounding; the residual is CLOSURE. The elastic energy differs "
	       "from the work put into springs by the error of the time integration: DRIFT, of second order "
	       "in the time step for forces without jumps. The values f_ID[k] listed below fulfil\n\n"
	       "  TOTAL - TOTAL(0) = FORCES + DRIVE + MOVED - LOST + CLOSURE + DRIFT\n\n"
	       "At the end of a run a table lists the contributions of each style. A warning is printed if "
	       "the drift exceeds `tolerance` times the largest turnover; it names the springs with the "
	       "largest drift. The balance is that of all particles, whatever the group. See doc/energy.md "
	       "for details.",
	.example = "fix books all energy/ledger every 100 file post/energy.txt tolerance 0.001",
	.args = args,
	.ranks = TS_RANKS_OWN | TS_RANKS_OUTPUTS,
	.due = is_due,
	.settle = ts_ledger_settle,
	.join = ts_ledger_join,
	.state_size = sizeof(struct ledger),
	.archive = ts_ledger_archive,
	.values = values,
	.init = init,
	.watch = ts_ledger_watch,
	.hook = { [TS_STAGE_SETUP] = setup_ledger,
		  [TS_STAGE_END_OF_STEP] = end_of_step,
		  [TS_STAGE_FINISH] = finish_run },
	.plan = report_memory,
	.fini = fini,
};
