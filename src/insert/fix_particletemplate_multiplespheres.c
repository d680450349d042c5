/* Fix particletemplate/multiplespheres: several spheres that are inserted together. */
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
	.summary = "Several spheres that are inserted together",
	.doc = "The spheres keep their places to each other only while they are inserted; after that each "
	       "moves on its\n"
	       "own. A clump counts as one particle in numbers, with the mass of the space that its spheres "
	       "fill; that\n"
	       "volume, and the sphere around the clump by which places in a region are judged, are found by "
	       "lot with the\n"
	       "random stream of LIGGGHTS. orientation of fix insert/... turns the clump. Velocity and "
	       "angular velocity\n"
	       "are given to each sphere.",
	.example = "fix twins all particletemplate/multiplespheres 15485863 atom_type 1 density constant "
		   "2500 nspheres 2 ntry 100000 spheres 0 0 0 0.005 0.011 0 0 0.005",
	.args = args,
	.state_size = sizeof(struct state),
	.archive = ts_template_archive,
	.init = init,
};
