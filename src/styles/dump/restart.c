/* Dump restart: saves the state at intervals. */
#include "core/sim.h"
#include "io/dump.h"
#include "io/restart.h"

#include "base/banned.h"

struct state {
	struct ts_dump_common common;
	const char *other;
};

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	const struct state *s = self->state;

	(void)sim;
	self->every = s->common.every;
	return TS_OK;
}

/* Not at the first step of a run: that state is where it came from. */
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
	ts_step_path(&d->path, s->other && d->frames % 2 == 0 ? s->other : d->file,
		     (long long)sim->clock.step, (int)d->pad);
	if (d->path.failed)
		return ts_nomem(&sim->error);
	return ts_restart_write(sim, ts_str_text(&d->path), &self->where);
}

static const struct ts_arg args[] = {
	TS_DUMP_ARGS(struct state),
	TS_WORD("other", struct state, other, .flags = TS_POSITIONAL | TS_WRITES | TS_OPTIONAL,
		.help = "a second file: the two are written in turn"),
	TS_ARGS_END,
};

static const struct ts_saved saved[] = { TS_DUMP_SAVED(struct state), TS_SAVED_ROWS_END };

TS_STYLE(dump, ts_style, ts_dump_restart)
const struct ts_style ts_dump_restart = {
	.name = "restart",
	.kind = TS_KIND_DUMP,
	.summary = "Saves the whole state at intervals",
	.doc = "As write_restart, every N steps. Define it after all other dumps: it then knows "
	       "which frames they\n"
	       "have written, and a continued run does not write one twice.",
	.example = "dump save all restart 10000 a.restart b.restart",
	.args = args,
	.state_size = sizeof(struct state),
	.saved = saved,
	.init = init,
	.hook[TS_STAGE_OUTPUT] = output,
	.fini = ts_dump_fini,
};
