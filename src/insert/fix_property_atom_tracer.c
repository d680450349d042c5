/* Fix property/atom/tracer: marks the particles in a region. */
#include "insert/tracer.h"
#include "region/region.h"

#include "base/banned.h"

struct state {
	struct ts_tracer tracer;
	struct ts_instance *region;
	int64_t step, every;
	int when;
	int32_t done; /* saved: a dirac pulse has been marked */
};

enum { DIRAC, HEAVISIDE };
static const char *const when_names[] = { "dirac", "heaviside", NULL };

static enum ts_status end_of_step(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	const struct ts_particles *p = sim->particles;

	if (s->done || sim->clock.step < s->step || sim->clock.step % s->every != 0)
		return TS_OK;
	TS_TRY(ts_region_update(s->region, sim));
	for (size_t i = 0; i < p->n; i++)
		if (ts_in_group(p, i, self->group) && ts_region_contains(s->region, p->x[i]))
			ts_tracer_mark(sim, &s->tracer, i);
	s->done = s->when == DIRAC;
	return TS_OK;
}

static const struct ts_arg args[] = {
	TS_REGION("region_mark", struct state, region, .help = "region in which particles are marked"),
	TS_INT("mark_step", struct state, step, .range = TS_NOT_NEGATIVE, .flags = TS_STATEFUL | TS_CUT,
	       .help = "first step in which particles are marked"),
	TS_ENUM("marker_style", struct state, when, when_names, .fallback = "dirac", .flags = TS_STATEFUL,
		.help = "dirac: particles are marked once; heaviside: from mark_step on"),
	TS_INT("check_mark_every", struct state, every, .fallback = "10", .range = TS_POSITIVE,
	       .help = "particles are marked only in steps that are multiples of this number"),
	TS_ARGS_END,
};

static const struct ts_saved saved[] = {
	TS_TRACER_SAVED(struct state),
	TS_SAVE_I32(struct state, done),
	TS_SAVED_ROWS_END,
};

static bool is_due(const struct ts_instance *self, const struct tsim *sim)
{
	const struct state *s = self->state;

	return !s->done && sim->clock.step >= s->step && sim->clock.step % s->every == 0;
}

TS_STYLE(fix, ts_style, ts_fix_property_atom_tracer)
const struct ts_style ts_fix_property_atom_tracer = {
	.name = "property/atom/tracer",
	.kind = TS_KIND_FIX,
	.ranks = TS_RANKS_WHOLE,
	.due = is_due,
	.summary = "Marks the particles in a region",
	.doc = "At the end of the first step that is at least mark_step and a multiple of check_mark_every, "
	       "the particles of the group whose centers are in the region are marked; with heaviside in "
	       "every such step. A particle keeps the mark until compute nparticles/tracer/region removes "
	       "it. Both together measure residence time distributions.\n\n"
	       "f_ID of a particle is 1 if it is marked, else 0. f_ID as a scalar is the number of particles "
	       "marked since its last evaluation in another step.",
	.example = "region mark block INF INF INF INF 0.2 0.25 units box\n"
		   "fix tracer all property/atom/tracer region_mark mark mark_step 10000 marker_style dirac "
		   "check_mark_every 10",
	.family = TS_FAMILY_TRACER,
	.args = args,
	.state_size = sizeof(struct state),
	.saved = saved,
	.archive = ts_tracer_archive,
	.values = ts_tracer_values,
	.init = ts_tracer_init,
	.hook = { [TS_STAGE_END_OF_STEP] = end_of_step },
};
