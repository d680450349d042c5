/* Fix insert/pack: fills a region with particles. */
#include "insert/insertion_region.h"

#include "base/banned.h"

struct state {
	union {
		struct ts_insertion base;
		struct ts_insertion_region place;
	};
	double fraction, mass; /* NaN: not asked for */
	int64_t number;
};

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	const struct state *s = self->state;
	int targets = !isnan(s->fraction) + !isnan(s->mass) + (s->number != INT64_MIN);

	if (targets == 1)
		return ts_insertion_region_init(self, sim);
	return ts_fail(&sim->error, TS_SYNTAX, &self->where,
		       "fix insert/pack: %d of particles_in_region, volumefraction_region and "
		       "mass_in_region are given, expected one",
		       targets);
}

/* How many are missing; numbers found by division are rounded up or down by lot. *filled: which part of
 * the target is there. */
static int64_t missing(struct state *s, const struct ts_region_content *now, double *filled)
{
	const struct ts_distribution *d = s->base.distribution->state;
	double target = s->fraction * now->room, lot;

	if (s->number != INT64_MIN) {
		*filled = (double)now->number / (double)s->number;
		return s->number - now->number;
	}
	lot = ts_minstd_uniform(&s->base.random);
	if (!isnan(s->mass)) {
		*filled = now->mass / s->mass;
		return (int64_t)((s->mass - now->mass) / d->mass + lot);
	}
	*filled = now->volume / target;
	return (int64_t)((target - now->volume) / d->volume + lot);
}

/* The fuller it is, the more tries a particle needs. */
static int64_t most_tries(const struct state *s, int64_t n, double filled)
{
	double tries = (double)n * (double)s->base.maxattempt / (1 - filled);

	return tries < INT32_MAX && filled < 1 ? (int64_t)tries : INT32_MAX;
}

static enum ts_status pre_exchange(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	struct ts_region_content now;
	double filled;
	int64_t n;

	if (!s->base.due)
		return TS_OK;
	ts_insertion_next(self);
	TS_TRY(ts_insertion_region_content(self, sim, &now));
	n = missing(s, &now, &filled);
	return n > 0 ? ts_insertion_region_event(self, sim, n, most_tries(s, n, filled)) : TS_OK;
}

static const struct ts_arg args[] = {
	TS_INSERTION_ARGS(struct state),
	TS_WORD("insert_every", struct state, base.every_word,
		.help = "steps between events, or once: in the step after the fix is defined"),
	TS_INSERTION_REGION_ARGS(struct state),
	TS_INT("particles_in_region", struct state, number, .flags = TS_OPTIONAL, .range = TS_POSITIVE,
	       .help = "particles are inserted until the region has so many"),
	TS_REAL("volumefraction_region", struct state, fraction, .flags = TS_OPTIONAL, .range = TS_WITHIN,
		.lo = 0, .hi = 1, .help = "... until they fill this part of its volume"),
	TS_REAL("mass_in_region", struct state, mass, .flags = TS_OPTIONAL, .unit = "mass",
		.range = TS_POSITIVE, .help = "... until they have this mass"),
	TS_ARGS_END,
};

static const struct ts_saved saved[] = { TS_INSERTION_REGION_SAVED(struct state), TS_SAVED_ROWS_END };

TS_STYLE(fix, ts_style, ts_fix_insert_pack)
const struct ts_style ts_fix_insert_pack = {
	.name = "insert/pack",
	.kind = TS_KIND_FIX,
	.summary = "Fills a region with particles",
	.doc = "In the step after the definition, or at the step start, and then every insert_every steps as "
	       "many particles\n"
	       "are made as the region lacks to reach a number, a mass or a share of its volume. What is in "
	       "the region\n"
	       "is counted by centres. Numbers that follow from a mass or a volume are rounded up or down by "
	       "lot.\n\n"
	       "Particles come from a mixture, fix particledistribution/discrete, large ones first. Each is "
	       "tried at\n"
	       "random points of the region until it overlaps no other particle. All tries together are at "
	       "most the\n"
	       "number of particles times maxattempt, divided by the part of the target that is missing; "
	       "then a warning\n"
	       "says how many found no place. New particles are members of the group of the fix and of the "
	       "groups of\n"
	       "the mixture and the template, and feel forces from this step on.\n\n"
	       "The random streams are those of LIGGGHTS 3.8: a script gives the same particles at the same "
	       "places.\n"
	       "Regions that share a surface are not seen as one by all_in yes: a particle must lie wholly "
	       "in one of the\n"
	       "members of a union.",
	.example = "fix fill all insert/pack seed 32452867 distributiontemplate mix insert_every once "
		   "overlapcheck yes all_in yes vel constant 0 0 -0.5 region bed volumefraction_region 0.3",
	.args = args,
	.state_size = sizeof(struct state),
	.saved = saved,
	.archive = ts_insertion_region_archive,
	.values = ts_insertion_values,
	.init = init,
	.hook = { [TS_STAGE_CHECK] = ts_insertion_check, [TS_STAGE_PRE_EXCHANGE] = pre_exchange },
	.fini = ts_insertion_fini,
};
