/* Fix insert/rate/region: inserts particles in a region at a given rate. */
#include "insert/insertion_rate.h"
#include "insert/insertion_region.h"

#include "base/banned.h"

struct state {
	union {
		struct ts_insertion base;
		struct ts_insertion_region place;
	};
	struct ts_insertion_rate rate;
};

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	TS_TRY(ts_insertion_region_init(self, sim));
	if (s->base.every < 1)
		return ts_fail(&sim->error, TS_SYNTAX, ts_instance_word(self, "insert_every"),
			       "fix insert/rate/region: insert_every is '%s', expected a number of steps > 0",
			       s->base.every_word);
	return ts_insertion_rate_init(self, sim, &s->rate);
}

static enum ts_status setup(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	ts_insertion_rate_print(self, sim, &s->rate);
	return TS_OK;
}

static enum ts_status pre_exchange(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	int64_t n;

	if (!s->base.due)
		return TS_OK;
	n = ts_insertion_rate_count(self, sim, &s->rate);
	TS_TRY(ts_insertion_region_content(self, sim, NULL));
	if (n > 0)
		TS_TRY(ts_insertion_region_event(self, sim, n, n * s->base.maxattempt));
	ts_insertion_rate_next(self, &s->rate);
	return TS_OK;
}

static const struct ts_arg args[] = {
	TS_INSERTION_ARGS(struct state),
	TS_INSERTION_RATE_ARGS(struct state),
	TS_WORD("insert_every", struct state, base.every_word, .help = "steps between insertions"),
	TS_INSERTION_REGION_ARGS(struct state),
	TS_INSERTION_AVOID_ARG(struct state),
	TS_ARGS_END,
};

static const struct ts_saved saved[] = { TS_INSERTION_REGION_SAVED(struct state), TS_SAVED_ROWS_END };

static const struct ts_arg_group groups[] = {
	{ NULL, "nparticles mass particlerate massrate insert_every" },
	TS_INSERTION_REGION_GROUPS,
	TS_INSERTION_GROUPS,
	{ .words = NULL },
};

TS_STYLE(fix, ts_style, ts_fix_insert_rate_region)
const struct ts_style ts_fix_insert_rate_region = {
	.name = "insert/rate/region",
	.kind = TS_KIND_FIX,
	.ranks = TS_RANKS_STEPS | TS_RANKS_PARTICLES | TS_RANKS_ROWLESS,
	.due = ts_insertion_whole_due,
	.summary = "Inserts particles in a region at a given rate",
	.purpose = "A feeder: grains appear in a region at a given rate. It needs a region, and a fix "
		   "particledistribution/discrete with templates of particles.",
	.doc = "Every insert_every steps, first in the step after the definition or in the step start, "
	       "particles are inserted at random positions in the region. Their number is rate times "
	       "interval, rounded up or down at random so that the mean is exact, until a total number is "
	       "reached. A total mass M gives the number M divided by the mean mass of a particle of the "
	       "mixture, as in LIGGGHTS: the mass inserted differs from M if particles of the mixture have "
	       "different masses. Particles for which no position was found are inserted later. For "
	       "everything else see fix insert/pack.",
	.example = "fix rain all insert/rate/region seed 32452867 distributiontemplate mix nparticles 1000 "
		   "particlerate 5000 insert_every 1000 overlapcheck yes region sky",
	.args = args,
	.groups = groups,
	.state_size = sizeof(struct state),
	.saved = saved,
	.archive = ts_insertion_region_archive,
	.values = ts_insertion_values,
	.init = init,
	.hook = { [TS_STAGE_CHECK] = ts_insertion_check,
		  [TS_STAGE_PRE_EXCHANGE] = pre_exchange,
		  [TS_STAGE_SETUP] = setup },
	.fini = ts_insertion_fini,
};
