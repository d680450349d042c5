/* Computes ke/multisphere and erotate/multisphere: translational and rotational kinetic energy of rigid
 * bodies. */
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

static double sum_over_bodies(const struct ts_rigid *rigid, double (*energy)(const struct ts_body *body))
{
	struct ts_exactsum sum = ts_exactsum_start();

	for (size_t b = 0; b < rigid->n; b++)
		ts_exactsum_add(&sum, energy(&rigid->body[b]));
	return ts_exactsum_value(&sum);
}

static enum ts_status eval_translation(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	(void)self;
	out->data[0] = sum_over_bodies(sim->rigid, translational_energy);
	return TS_OK;
}

static enum ts_status eval_rotation(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	(void)self;
	out->data[0] = sum_over_bodies(sim->rigid, rotational_energy);
	return TS_OK;
}

static const struct ts_value translations[] = {
	{ "energy", "energy", "translational kinetic energy of all rigid bodies", TS_SCALAR, 1, NULL,
	  eval_translation },
	{ .name = NULL },
};

static const struct ts_value rotations[] = {
	{ "energy", "energy", "rotational kinetic energy of all rigid bodies", TS_SCALAR, 1, NULL,
	  eval_rotation },
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
