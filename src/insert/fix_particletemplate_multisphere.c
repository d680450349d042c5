/* Fix particletemplate/multisphere: clumps of spheres that are inserted as rigid bodies. */
#include "insert/clump_template.h"
#include "rigid/rigid_motion.h"

#include "base/banned.h"

struct state {
	union {
		struct ts_template base;
		struct ts_clump_template shape;
	};
	int64_t kind;
	double mass; /* NaN: density * volume */
	struct ts_words moment_words, shift_words, turn_words;
	bool use_volume, use_density;
};

/* Reads xx xy xz yy yz zz, the order of LIGGGHTS, to the order xx yy zz xy xz yz. */
static enum ts_status read_moments(struct ts_instance *self, struct tsim *sim, double tensor[6])
{
	static const int index_of[6] = { 0, 3, 4, 1, 5, 2 };
	const struct state *s = self->state;

	for (size_t k = 0; k < s->moment_words.n; k++)
		if (s->moment_words.n != 6 ||
		    !ts_parse_real(s->moment_words.word[k].text, &tensor[index_of[k]]))
			return ts_fail(&sim->error, TS_SYNTAX, &s->moment_words.word[k].place,
				       "fix particletemplate/multisphere: inertia_tensor is followed by the "
				       "six numbers xx xy xz yy yz zz");
	return TS_OK;
}

static enum ts_status read_free(struct ts_instance *self, struct tsim *sim, struct ts_words words,
				double free[3])
{
	for (size_t k = 0; k < 3; k++)
		free[k] = 1;
	for (size_t k = 0; k < words.n; k++) {
		bool on = ts_streq(words.word[k].text, "on");

		if (words.n != 3 || !(on || ts_streq(words.word[k].text, "off")))
			return ts_fail(&sim->error, TS_SYNTAX, &words.word[k].place,
				       "fix %s: expected on or off three times, for x, y and z",
				       self->style->name);
		free[k] = on;
	}
	return TS_OK;
}

static enum ts_status check_mass(struct ts_instance *self, struct tsim *sim)
{
	const struct state *s = self->state;
	bool given = !isnan(s->mass);

	if (given == (s->moment_words.n > 0) && given == (s->use_volume != s->use_density) &&
	    !(s->use_volume && s->use_density))
		return TS_OK;
	return ts_fail(&sim->error, TS_SYNTAX, &self->where,
		       "fix particletemplate/multisphere: mass and inertia_tensor are given together, with "
		       "one of use_volume and use_density");
}

static enum ts_status define_body(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	struct ts_template *t = &s->base;
	double tensor[6];

	for (int k = 0; k < 6; k++)
		tensor[k] = s->shape.clump.moments[k] * t->density.a;
	if (sim->legacy == TS_LEGACY_LIGGGHTS) /* LIGGGHTS 3.8 uses the mean of xz and yz for yz */
		tensor[5] = 0.5 * (tensor[4] + tensor[5]);
	TS_TRY(read_moments(self, sim, tensor));
	if (!isnan(s->mass)) {
		t->mass = s->mass;
		if (s->use_volume)
			t->density.a = s->mass / t->volume;
		else
			t->volume = s->mass / t->density.a;
	}
	t->body.mass = t->mass;
	t->lightest = t->mass;
	t->body.density = t->density.a;
	t->body.kind = (double)s->kind;
	ts_rigid_principal(&t->body, tensor);
	TS_TRY(read_free(self, sim, s->shift_words, t->body.free));
	TS_TRY(read_free(self, sim, s->turn_words, t->body.free + 3));
	for (int k = 0; k < 3; k++)
		if (!(t->body.inertia[k] > 0))
			return ts_fail(&sim->error, TS_RANGE, &self->where,
				       "fix particletemplate/multisphere: a principal moment of inertia is "
				       "%g, expected a number > 0; raise ntry, or correct inertia_tensor",
				       t->body.inertia[k]);
	t->rigid = true;
	return TS_OK;
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct ts_template *t = self->state;

	if (t->defined)
		return TS_OK;
	TS_TRY(check_mass(self, sim));
	TS_TRY(ts_clump_template_init(self, sim, true));
	TS_TRY(define_body(self, sim));
	t->defined = true;
	return TS_OK;
}

static const struct ts_arg args[] = {
	TS_TEMPLATE_ARGS(struct state),
	TS_CLUMP_TEMPLATE_ARGS(struct state),
	TS_INT("type", struct state, kind, .range = TS_POSITIVE,
	       .help = "number of the template, from 1; different for each template"),
	TS_REAL("mass", struct state, mass, .flags = TS_OPTIONAL, .range = TS_POSITIVE, .unit = "mass",
		.help = "mass of a clump; default: density times volume"),
	TS_SOME_KEYWORD("inertia_tensor", struct state, moment_words, 0,
			.help = "xx xy xz yy yz zz, together with mass: moments of inertia about the centre "
				"of mass"),
	TS_FLAG("use_volume", struct state, use_volume, .help = "with mass: the density is mass / volume"),
	TS_FLAG("use_density", struct state, use_density, .help = "with mass: the volume is mass / density"),
	TS_SOME_KEYWORD("fflag", struct state, shift_words, 0,
			.help = "on or off for x, y and z: whether clumps move in this direction"),
	TS_SOME_KEYWORD("tflag", struct state, turn_words, 0,
			.help = "on or off for x, y and z: whether clumps rotate about this axis"),
	TS_ARGS_END,
};

TS_STYLE(fix, ts_style, ts_fix_particletemplate_multisphere)
const struct ts_style ts_fix_particletemplate_multisphere = {
	.name = "particletemplate/multisphere",
	.kind = TS_KIND_FIX,
	.ranks = TS_RANKS_WHOLE,
	.summary = "Template of clumps of spheres that are inserted as rigid bodies",
	.doc = "Defines a rigid body of spheres, which may overlap; fix multisphere integrates its motion. "
	       "Volume, centre of mass and moments of inertia of the union of the spheres are computed by "
	       "Monte Carlo integration with ntry random points each, from the random stream of LIGGGHTS; "
	       "the relative error is about 1/sqrt(ntry). fix insert/... places the centre of mass; its "
	       "keyword orientation rotates the clump, and omega is its angular velocity.\n\n"
	       "LIGGGHTS 3.8 uses the mean of the products of inertia yz and xz for yz; so does `legacy "
	       "yes`.",
	.example =
		"fix stone all particletemplate/multisphere 15485863 atom_type 1 density constant 2500 "
		"nspheres 3 ntry 1000000 spheres 0 0 0 0.01 0.012 0 0 0.008 0.015 0.011 0.003 0.009 type 1",
	.args = args,
	.state_size = sizeof(struct state),
	.archive = ts_template_archive,
	.init = init,
};
