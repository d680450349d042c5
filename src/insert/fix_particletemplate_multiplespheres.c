/* Fix particletemplate/multiplespheres: groups of independent spheres that are inserted together. */
#include "insert/clump_template.h"

#include "base/banned.h"

struct state {
	union {
		struct ts_template base;
		struct ts_clump_template shape;
	};
};

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct ts_template *t = self->state;

	if (t->defined)
		return TS_OK;
	TS_TRY(ts_clump_template_init(self, sim, false));
	t->defined = true;
	return TS_OK;
}

static const struct ts_arg args[] = {
	TS_TEMPLATE_ARGS(struct state),
	TS_CLUMP_TEMPLATE_ARGS(struct state),
	TS_ARGS_END,
};

TS_STYLE(fix, ts_style, ts_fix_particletemplate_multiplespheres)
const struct ts_style ts_fix_particletemplate_multiplespheres = {
	.name = "particletemplate/multiplespheres",
	.kind = TS_KIND_FIX,
	.ranks = TS_RANKS_WHOLE | TS_RANKS_ROWLESS,
	.summary = "Template of several independent spheres that are inserted together",
	.doc = "The spheres have the given positions relative to each other when they are inserted; "
	       "afterwards each moves independently. A clump counts as one particle in the numbers that are "
	       "inserted. In what fix insert/pack finds in its region, each sphere counts as a particle with "
	       "its own mass and volume. The mass of a clump is the density times the volume that the "
	       "spheres fill together. This volume, and the bounding sphere by which positions in a region "
	       "are checked, are computed by Monte Carlo integration with the random stream of LIGGGHTS.\n\n"
	       "The keyword orientation of fix insert/... rotates the clump. Each sphere gets the velocity "
	       "and angular velocity of the insertion.",
	.example = "fix twins all particletemplate/multiplespheres 15485863 atom_type 1 density constant "
		   "2500 nspheres 2 ntry 100000 spheres 0 0 0 0.005 0.011 0 0 0.005",
	.args = args,
	.state_size = sizeof(struct state),
	.archive = ts_template_archive,
	.init = init,
};
