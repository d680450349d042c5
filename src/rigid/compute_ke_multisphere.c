/* Computes ke/multisphere, erotate/multisphere, ke/rigid and erotate/rigid: translational and rotational kinetic
 * energy of all rigid bodies, or of those of a fix. */
#include "math/exactsum.h"
#include "math/vec3.h"
#include "rigid/rigid.h"

#include "base/banned.h"

static double translational_energy(const struct ts_body *body)
{
	return 0.5 * body->mass * ts_dot(body->v, body->v);
}

static double rotational_energy(const struct ts_body *body)
{
	return 0.5 * ts_dot(body->spin, body->omega);
}

/* State of those of a fix. */
struct of_fix {
	const char *fix;
};

static double sum_over_bodies(const struct ts_instance *self, const struct tsim *sim,
			      double (*energy)(const struct ts_body *body))
{
	const struct ts_rigid *rigid = sim->rigid;
	const struct of_fix *of = self->style->args ? self->state : NULL;
	const int64_t owner = of ? ts_rigid_owner(of->fix) : 0;
	struct ts_exactsum sum = ts_exactsum_start();

	for (size_t b = 0; b < rigid->n; b++)
		if (!of || rigid->owner[b] == owner)
			ts_exactsum_add(&sum, energy(&rigid->body[b]));
	return ts_exactsum_value(&sum);
}

static enum ts_status eval_translation(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	out->data[0] = sum_over_bodies(self, sim, translational_energy);
	return TS_OK;
}

static enum ts_status eval_rotation(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	out->data[0] = sum_over_bodies(self, sim, rotational_energy);
	return TS_OK;
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	const struct of_fix *of = self->state;
	const struct ts_word word = { .text = of->fix, .place = self->where };
	struct ts_instance *fix;

	TS_TRY(ts_sim_require(sim, TS_KIND_FIX, &word, &fix));
	if (!ts_streq(fix->style->name, "rigid") && !ts_streq(fix->style->name, "multisphere"))
		return ts_fail(&sim->error, TS_STATE, &self->where,
			       "%s: fix %s is of style %s, expected a fix rigid or multisphere",
			       self->style->name, fix->id, fix->style->name);
	return TS_OK;
}

static const struct ts_arg args[] = {
	TS_WORD("fix", struct of_fix, fix, .flags = TS_POSITIONAL,
		.help = "ID of a fix rigid or multisphere, whose bodies count"),
	TS_ARGS_END,
};

static const struct ts_value translations[] = {
	{ "energy", "energy", "translational kinetic energy of the bodies", TS_SCALAR, 1, NULL,
	  eval_translation },
	{ .name = NULL },
};

static const struct ts_value rotations[] = {
	{ "energy", "energy", "rotational kinetic energy of the bodies", TS_SCALAR, 1, NULL, eval_rotation },
	{ .name = NULL },
};

TS_STYLE(compute, ts_style, ts_compute_ke_multisphere)
const struct ts_style ts_compute_ke_multisphere = {
	.name = "ke/multisphere",
	.kind = TS_KIND_COMPUTE,
	.ranks = TS_RANKS_WHOLE,
	.summary = "Translational kinetic energy of rigid bodies",
	.doc = "Sum of M V^2 / 2 over all rigid bodies, exact and rounded once. The group has no effect.",
	.example = "compute energy all ke/multisphere",
	.values = translations,
};

TS_STYLE(compute, ts_style, ts_compute_erotate_multisphere)
const struct ts_style ts_compute_erotate_multisphere = {
	.name = "erotate/multisphere",
	.kind = TS_KIND_COMPUTE,
	.ranks = TS_RANKS_WHOLE,
	.summary = "Rotational kinetic energy of rigid bodies",
	.doc = "Sum of L . omega / 2 over all rigid bodies, exact and rounded once. The group has no effect.",
	.example = "compute rotation all erotate/multisphere",
	.values = rotations,
};

TS_STYLE(compute, ts_style, ts_compute_ke_rigid)
const struct ts_style ts_compute_ke_rigid = {
	.name = "ke/rigid",
	.kind = TS_KIND_COMPUTE,
	.ranks = TS_RANKS_WHOLE,
	.summary = "Translational kinetic energy of the bodies of a fix",
	.doc = "Sum of M V^2 / 2 over the bodies of the fix, exact and rounded once. The group has no "
	       "effect.",
	.example = "fix parts all rigid molecule\ncompute energy all ke/rigid parts",
	.args = args,
	.state_size = sizeof(struct of_fix),
	.init = init,
	.values = translations,
};

TS_STYLE(compute, ts_style, ts_compute_erotate_rigid)
const struct ts_style ts_compute_erotate_rigid = {
	.name = "erotate/rigid",
	.kind = TS_KIND_COMPUTE,
	.ranks = TS_RANKS_WHOLE,
	.summary = "Rotational kinetic energy of the bodies of a fix",
	.doc = "Sum of L . omega / 2 over the bodies of the fix, exact and rounded once. The group has no "
	       "effect.",
	.example = "fix parts all rigid molecule\ncompute rotation all erotate/rigid parts",
	.args = args,
	.state_size = sizeof(struct of_fix),
	.init = init,
	.values = rotations,
};
