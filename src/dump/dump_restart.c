/* Dump restart: writes restart files every N steps. */
#include "core/report.h"
#include "core/sim.h"
#include "dump/dump.h"
#include "io/series.h"
#include "neigh/neigh.h"
#include "restart/restart.h"

#include "base/banned.h"

struct state {
	struct ts_dump_common common;
	const char *other;
};

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	const struct state *s = self->state;

	self->every = s->common.every;
	/* a run continued from the file outputs the contacts of its step: their forces must be stored */
	ts_neigh_keep_forces_every(sim->neigh, s->common.variable ? 1 : self->every);
	return TS_OK;
}

/* The first step of a run is not written: it is the state that the run was started from. */
static enum ts_status output(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	struct ts_dump_common *d = &s->common;
	bool due;

	if (sim->clock.step == sim->clock.first_step)
		return TS_OK;
	TS_TRY(ts_dump_due(self, sim, &due));
	if (!due)
		return TS_OK;
	ts_series_path(&d->path, s->other && d->frames % 2 == 0 ? s->other : d->file,
		       (long long)sim->clock.step, (int)d->pad);
	if (d->path.failed)
		return ts_nomem(&sim->error);
	return ts_restart_write(sim, ts_str_text(&d->path), &self->where);
}

/* Size of the file / size of its data: numbers of random digits are not compressed (restart/pack.c), zeros and equal ones are. */
static const double COMPRESSED = 0.9;

static enum ts_status add_instance_size(struct ts_instance *inst, struct tsim *sim, double *bytes)
{
	struct ts_archive *archive = ts_archive_new(sim, true);
	const unsigned char *block;
	enum ts_status status;
	size_t n = 0;

	if (!archive)
		return ts_nomem(&sim->error);
	status = ts_archive_instance(archive, inst, sim);
	if (status == TS_OK)
		status = ts_archive_bytes(archive, &block, &n);
	*bytes += COMPRESSED * (double)n;
	ts_archive_free(archive);
	return status;
}

static enum ts_status plan(struct ts_instance *self, struct tsim *sim, struct ts_plan_report *report)
{
	const struct state *s = self->state;
	double bytes = 0;

	for (int kind = 0; kind < TS_NKIND && sim->reading.explain && !sim->log.quiet; kind++)
		for (size_t k = 0; k < sim->instances[kind].n; k++)
			TS_TRY(add_instance_size(sim->instances[kind].item[k], sim, &bytes));
	return ts_report_output(report, s->common.file, ts_report_count(sim, s->common.every), bytes) == TS_OK
		       ? TS_OK
		       : ts_nomem(&sim->error);
}

static const struct ts_arg args[] = {
	TS_DUMP_ARGS(struct state),
	TS_WORD("other", struct state, other, .flags = TS_POSITIONAL | TS_WRITES | TS_OPTIONAL,
		.help = "a second file: the two are written alternately"),
	TS_ARGS_END,
};

static const struct ts_saved saved[] = { TS_DUMP_SAVED(struct state), TS_SAVED_ROWS_END };

TS_STYLE(dump, ts_style, ts_dump_restart)
const struct ts_style ts_dump_restart = {
	.name = "restart",
	.kind = TS_KIND_DUMP,
	.ranks = TS_RANKS_WHOLE | TS_RANKS_ROWLESS,
	.due = ts_dump_may_be_due,
	.names = ts_dump_names,
	.summary = "Writes restart files every N steps",
	.doc = "Writes a restart file every N steps, as write_restart does, after all other outputs of the "
	       "step: it contains which frames they have written, and a continued run does not write a frame "
	       "twice.",
	.example = "dump save all restart 10000 a.restart b.restart",
	.args = args,
	.state_size = sizeof(struct state),
	.saved = saved,
	.init = init,
	.plan = plan,
	.hook[TS_STAGE_OUTPUT] = output,
	.defers = TS_DEFERS(OUTPUT),
	.saves_outputs = true,
	.fini = ts_dump_fini,
};
