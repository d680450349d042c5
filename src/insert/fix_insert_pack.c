/* Fix insert/pack: fills a region with particles. */
#include "insert/insertion_region.h"

#include "base/banned.h"

struct state {
	union {
		struct ts_insertion base;
		struct ts_insertion_region place;
	};
	double fraction, mass; /* NaN: not given */
	int64_t number;
};

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	const struct state *s = self->state;
	int targets = !isnan(s->fraction) + !isnan(s->mass) + (s->number != INT64_MIN);

	if (targets == 1)
		return ts_insertion_region_init(self, sim);
	return ts_fail(&sim->error, TS_SYNTAX, &self->where,
		       "fix insert/pack: %d of particles_in_region, volumefraction_region and mass_in_region "
		       "are given, expected one",
		       targets);
}

/* Number of particles missing to the target. Numbers computed from a mass or a volume are rounded up or
 * down at random, so that their mean is exact. *filled: fraction of the target that is present. */
static int64_t count_missing(struct state *s, const struct ts_region_content *now, double *filled)
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

/* The number of tries grows as the region fills: n * maxattempt / (1 - filled). */
static int64_t max_tries(const struct state *s, int64_t n, double filled)
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
	n = count_missing(s, &now, &filled);
	return n > 0 ? ts_insertion_region_event(self, sim, n, max_tries(s, n, filled)) : TS_OK;
}

static const struct ts_arg args[] = {
	TS_INSERTION_ARGS(struct state),
	TS_WORD("insert_every", struct state, base.every_word,
		.help = "steps between insertions, or once: only in the step after the definition"),
	TS_INSERTION_REGION_ARGS(struct state),
	TS_INSERTION_AVOID_ARG(struct state),
	TS_INT("particles_in_region", struct state, number, .flags = TS_OPTIONAL | TS_CUT,
	       .range = TS_POSITIVE, .help = "target: number of particles in the region"),
	TS_REAL("volumefraction_region", struct state, fraction, .flags = TS_OPTIONAL, .range = TS_WITHIN,
		.lo = 0, .hi = 1, .help = "target: fraction of the volume of the region that particles fill"),
	TS_REAL("mass_in_region", struct state, mass, .flags = TS_OPTIONAL, .unit = "mass",
		.range = TS_POSITIVE, .help = "target: mass of the particles in the region"),
	TS_ARGS_END,
};

static const struct ts_saved saved[] = { TS_INSERTION_REGION_SAVED(struct state), TS_SAVED_ROWS_END };

static const struct ts_arg_group groups[] = {
	{ NULL, "insert_every particles_in_region volumefraction_region mass_in_region" },
	TS_INSERTION_REGION_GROUPS,
	TS_INSERTION_GROUPS,
	{ .words = NULL },
};

TS_STYLE(fix, ts_style, ts_fix_insert_pack)
const struct ts_style ts_fix_insert_pack = {
	.name = "insert/pack",
	.kind = TS_KIND_FIX,
	.ranks = TS_RANKS_STEPS | TS_RANKS_PARTICLES | TS_RANKS_ROWLESS,
	.due = ts_insertion_whole_due,
	.summary = "Fills a region with particles",
	.purpose = "Fills a bin, a drum or a box with grains that do not overlap: once, or again and again. "
		   "It needs a region, and a fix particledistribution/discrete with templates of particles.",
	.doc = "In the step after the definition, or in the step start, and then every insert_every steps, "
	       "particles are inserted until the region contains a given number, mass or volume fraction of "
	       "particles. Particles whose centers are in the region count. A rigid clump (fix multisphere) "
	       "counts as one particle with its mass and volume, if the center of its bounding sphere is in "
	       "the region; spheres of fix particletemplate/multiplespheres count one by one. Numbers "
	       "computed from a mass or a volume are rounded up or down at random, so that their mean is "
	       "exact. The volume of the region is that of its part in the box; it is computed again if the "
	       "box, or a variable that gives the size of the region, has changed it.\n\n"
	       "Particles are drawn from a mixture, fix particledistribution/discrete, and inserted in the "
	       "order of decreasing size. For each, random positions in the region are tried until it "
	       "overlaps no other particle. All tries together are limited to the number of particles times "
	       "maxattempt, divided by the fraction of the target that is missing; if some particles were "
	       "not placed, a warning gives their number. New particles belong to the groups of the fix, the "
	       "mixture and the template, and are subject to forces from this step on.\n\n"
	       "The random streams are those of LIGGGHTS 3.8: a script gives the same particles at the same "
	       "positions, but in a region mesh/tet or mesh/hex, in which LIGGGHTS draws a cell first, tsim "
	       "a point of the bounding box. With all_in yes and a union of regions, a particle must lie "
	       "completely in one member of the union, even if members share a surface; of a region mesh/tet "
	       "or mesh/hex in all cells together, if these do not overlap. Walls are not looked at, so that "
	       "a particle that is inserted where a thin solid of triangles is, as the flight of a screw, "
	       "stays inside of it; avoid_meshes prevents this.",
	.example = "fix fill all insert/pack seed 32452867 distributiontemplate mix insert_every once "
		   "overlapcheck yes all_in yes vel constant 0 0 -0.5 region bed volumefraction_region 0.3",
	.args = args,
	.groups = groups,
	.state_size = sizeof(struct state),
	.saved = saved,
	.archive = ts_insertion_region_archive,
	.values = ts_insertion_values,
	.init = init,
	.hook = { [TS_STAGE_CHECK] = ts_insertion_check, [TS_STAGE_PRE_EXCHANGE] = pre_exchange },
	.fini = ts_insertion_fini,
};
