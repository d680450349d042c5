/* Fix property/atom/tracer: marks the particles in a region. */
#include "insert/tracer.h"
#include "region/region.h"

#include "base/banned.h"

struct state {
	struct ts_tracer tracer;
	struct ts_instance *region;
	int64_t step, every;
	int when;
	int32_t done; /* saved: the pulse is over */
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
	TS_REGION("region_mark", struct state, region, .help = "where particles are marked"),
	TS_INT("mark_step", struct state, step, .range = TS_NOT_NEGATIVE, .flags = TS_STATEFUL,
	       .help = "step from which on particles are marked"),
	TS_ENUM("marker_style", struct state, when, when_names, .fallback = "dirac", .flags = TS_STATEFUL,
		.help = "dirac: at that step only; heaviside: from then on, whoever comes by"),
	TS_INT("check_mark_every", struct state, every, .fallback = "10", .range = TS_POSITIVE,
	       .help = "steps between looks: particles are marked in steps that are multiples of it"),
	TS_ARGS_END,
};

static const struct ts_saved saved[] = {
	TS_TRACER_SAVED(struct state),
	TS_SAVE_I32(struct state, done),
	TS_SAVED_ROWS_END,
};

TS_STYLE(fix, ts_style, ts_fix_property_atom_tracer)
const struct ts_style ts_fix_property_atom_tracer = {
	.name = "property/atom/tracer",
	.kind = TS_KIND_FIX,
	.summary = "Marks the particles that are in a region",
	.doc = "At the end of the first step that is not before mark_step and is a multiple of\n"
	       "check_mark_every, the particles of the group with their centers in the region are marked; "
	       "with\n"
	       "heaviside at every such step. The mark goes with the particle until compute\n"
	       "nparticles/tracer/region takes it away. Together they measure distributions of residence "
	       "times.\n\n"
	       "f_ID of a particle: 1 marked, 0 not. f_ID as a number: how many have been marked since it "
	       "was\n"
	       "last asked for in another step.",
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
