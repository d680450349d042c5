/* Command create_box: the simulation box, from a region. */
#include "core/sim.h"

#include <math.h>

#include "particles/domain.h"
#include "particles/particles.h"
#include "particles/region.h"

#include "base/banned.h"

struct state {
	int64_t ntypes;
	struct ts_instance *region;
};

static enum ts_status run(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct state *s = state;
	struct ts_domain *domain = sim->domain;
	struct ts_particles *p = sim->particles;
	double lo[3], hi[3];
	double *type_mass;

	if (domain->exists)
		return ts_fail(&sim->error, TS_STATE, where, "there is a simulation box already");
	ts_region_bounds(s->region, lo, hi);
	for (int d = 0; d < 3; d++)
		if (!isfinite(lo[d]) || !isfinite(hi[d]) || lo[d] >= hi[d])
			return ts_fail(
				&sim->error, TS_RANGE, where,
				"region '%s' reaches from %c = %g to %g: no box can be made of it",
				s->region->id, 'x' + d, lo[d], hi[d]);
	type_mass = ts_alloc((size_t)s->ntypes + 1, sizeof *type_mass);
	if (!type_mass)
		return ts_nomem(&sim->error);
	ts_free(p->type_mass);
	p->type_mass = type_mass;
	p->ntypes = (int)s->ntypes;
	for (int d = 0; d < 3; d++) {
		domain->box.lo[d] = domain->first_lo[d] = lo[d];
		domain->box.hi[d] = domain->first_hi[d] = hi[d];
	}
	domain->exists = true;
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
