/* Fix particletemplate/sphere: radius and density of spheres that other fixes insert. */
#include "insert/template.h"

#include "particle/sphere_shape.h"

#include "base/banned.h"

struct state {
	struct ts_template base;
};

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct ts_template *t = self->state;

	if (t->defined)
		return TS_OK;
	TS_TRY(ts_template_start(self, sim));
	TS_TRY(ts_template_spread(self, sim, "fix particletemplate/sphere: radius", t->radius_words,
				  &t->radius));
	t->volume = ts_particle_volume(sim, 1) * ts_spread_mean(&t->radius, 3);
	t->mass = t->volume * ts_spread_mean(&t->density, 1);
	t->least = ts_spread_smallest(&t->radius);
	t->largest = ts_spread_largest(&t->radius);
	t->lightest = ts_spread_smallest(&t->density) * ts_particle_volume(sim, t->least);
	TS_TRY(ts_template_check_volume(self, sim));
	t->defined = true;
	return TS_OK;
}

static const struct ts_arg args[] = {
	TS_TEMPLATE_ARGS(struct state),
	TS_LIST_KEYWORD("radius", struct state, base.radius_words, .flags = TS_TO_KEYWORD,
			.help = "constant R | uniform [number|mass] LO HI | gaussian [number|mass] MEAN "
				"DEVIATION | lognormal [number|mass] MEDIAN DEVIATION"),
	TS_ARGS_END,
};

TS_STYLE(fix, ts_style, ts_fix_particletemplate_sphere)
const struct ts_style ts_fix_particletemplate_sphere = {
	.name = "particletemplate/sphere",
	.kind = TS_KIND_FIX,
	.ranks = TS_RANKS_WHOLE | TS_RANKS_ROWLESS,
	.summary = "Template of spheres for insertion",
	.doc = "Defines radius and density of spheres, which fix particledistribution/discrete mixes and fix "
	       "insert/... inserts. Inserted particles also become members of the group of this fix.\n\n"
	       "Radius and density are constant or distributed: uniform between two values, gaussian with "
	       "mean and standard deviation, truncated at three standard deviations from the mean, or "
	       "lognormal with median and standard deviation of the logarithm, truncated in the same way. "
	       "The distribution counts particles by number (default) or by mass: with `uniform mass 1 2` "
	       "the particles in radius intervals of equal width have the same total mass. LIGGGHTS 3.8 has "
	       "constant only.",
	.example = "fix grains all particletemplate/sphere 15485863 atom_type 1 density constant 2500 radius "
		   "constant 0.0015\n"
		   "fix sand all particletemplate/sphere 15485867 density constant 2650 radius uniform mass "
		   "2e-4 6e-4",
	.args = args,
	.state_size = sizeof(struct state),
	.archive = ts_template_archive,
	.init = init,
};
