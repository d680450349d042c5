/* Command create_box: the simulation box, from a region. */
#include "core/sim.h"

#include <math.h>

#include "particles/domain.h"
#include "particles/region.h"

#include "base/banned.h"

struct state {
	int64_t ntypes;
	struct ts_instance *region;
};

static enum ts_status run(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct state *s = state;
	double lo[3], hi[3];

	if (sim->domain->exists)
		return ts_fail(&sim->error, TS_STATE, where, "there is a simulation box already");
	ts_region_bounds(s->region, lo, hi);
	for (int d = 0; d < 3; d++)
		if (!isfinite(lo[d]) || !isfinite(hi[d]) || lo[d] >= hi[d])
			return ts_fail(
				&sim->error, TS_RANGE, where,
				"region '%s' reaches from %c = %g to %g: no box can be made of it",
				s->region->id, 'x' + d, lo[d], hi[d]);
	TS_TRY(ts_domain_make(sim, (int)s->ntypes, lo, hi));
	ts_log(&sim->log, "Created orthogonal box = (%g %g %g) to (%g %g %g)\n", lo[0], lo[1],
	       lo[2], hi[0], hi[1], hi[2]);
	return TS_OK;
}

static const struct ts_arg args[] = {
	TS_INT("types", struct state, ntypes, .flags = TS_POSITIONAL, .range = TS_WITHIN, .lo = 1,
	       .hi = 10000, .help = "number of particle types"),
	TS_REGION("region", struct state, region, .flags = TS_POSITIONAL,
		  .help = "region whose bounding box becomes the simulation box"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_create_box)
const struct ts_command_style ts_command_create_box = {
	.style = {
		.name = "create_box",
		.kind = TS_KIND_COMMAND,
		.summary = "Creates the simulation box",
		.doc = "The box is the bounding box of the region, which must end on all sides. Particles have\n"
		       "types from 1 to the number given.",
		.example = "region box block 0 1 0 1 0 1 units box\n"
		       "create_box 2 box",
		.args = args,
		.state_size = sizeof(struct state),
	},
	.run = run,
};
