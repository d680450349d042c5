/* Command create_box: the simulation box, from a region. */
#include "core/sim.h"

#include "bond/bonds.h"
#include "box/domain.h"
#include "particle/particles.h"
#include "region/region.h"

#include "base/banned.h"

struct state {
	int64_t ntypes;
	struct ts_instance *region;
	int64_t bond_types, bonds_per_atom, specials_per_atom;
	int64_t none[6]; /* types of angles, dihedrals ...: must be 0 */
};

static enum ts_status create_box(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct state *s = state;
	double lo[3], hi[3];

	if (sim->has_box)
		return ts_conflict(&sim->error, where, "there is a simulation box already");
	for (int k = 0; k < 6; k++)
		if (s->none[k])
			return ts_fail(&sim->error, TS_RANGE, where,
				       "create_box: particles have bonds, but no angles, dihedrals or "
				       "impropers");
	if (ts_streq(s->region->style->name, "prism"))
		return ts_fail(&sim->error, TS_STATE, where,
			       "region '%s' is a prism: boxes with tilted faces are not supported",
			       s->region->id);
	TS_TRY(ts_region_update(s->region, sim));
	ts_region_bounds(s->region, lo, hi);
	TS_TRY(ts_particles_make_box(sim, (int)s->ntypes, lo, hi, where));
	if (s->bond_types > sim->bonds->ntypes)
		sim->bonds->ntypes = (int)s->bond_types;
	ts_log(&sim->log, "Created orthogonal box = (%g %g %g) to (%g %g %g)\n", lo[0], lo[1], lo[2], hi[0],
	       hi[1], hi[2]);
	return TS_OK;
}

#define NONE(k, name)                                                                  \
	TS_INT(name, struct state, none[k], .fallback = "0", .range = TS_NOT_NEGATIVE, \
	       .help = "must be 0: only bonds are supported")
static const struct ts_arg args[] = {
	TS_INT("types", struct state, ntypes, .flags = TS_POSITIONAL, .range = TS_WITHIN, .lo = 1,
	       .hi = 10000, .help = "number of atom types"),
	TS_REGION("region", struct state, region, .flags = TS_POSITIONAL,
		  .help = "region whose bounding box becomes the simulation box"),
	TS_INT("bond/types", struct state, bond_types, .fallback = "0", .range = TS_WITHIN, .lo = 0,
	       .hi = 10000, .help = "number of bond types; bond_coeff can add more"),
	TS_INT("extra/bond/per/atom", struct state, bonds_per_atom, .fallback = "0", .range = TS_NOT_NEGATIVE,
	       .help = "no effect: any number is allowed"),
	TS_INT("extra/special/per/atom", struct state, specials_per_atom, .fallback = "0",
	       .range = TS_NOT_NEGATIVE, .help = "no effect: any number is allowed"),
	NONE(0, "angle/types"),
	NONE(1, "dihedral/types"),
	NONE(2, "improper/types"),
	NONE(3, "extra/angle/per/atom"),
	NONE(4, "extra/dihedral/per/atom"),
	NONE(5, "extra/improper/per/atom"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_create_box)
const struct ts_command_style ts_command_create_box = {
	.style = {
		.name = "create_box",
		.kind = TS_KIND_COMMAND,
		.summary = "creates the simulation box",
		.doc = "The simulation box is the bounding box of the region, which must be finite. Atom "
		       "types are 1 to `types`. Faces of boundary style s start 1e-4 of the box length "
		       "outside. With dimension 2 the box must be periodic in z and contain the plane z = 0.",
		.example = "region box block 0 1 0 1 0 1 units box\n"
		       "create_box 2 box",
		.args = args,
		.state_size = sizeof(struct state),
	},
	.run = create_box,
};
