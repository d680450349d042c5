/* Compute: kinetic energy of translation of rigid bodies. */
#include "math/exactsum.h"
#include "math/vec3.h"
#include "particles/rigid.h"

#include "base/banned.h"

static enum ts_status eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	struct ts_exactsum sum = ts_exactsum_start();

	(void)self;
	for (size_t b = 0; b < sim->rigid->n; b++) {
		const struct ts_body *body = &sim->rigid->body[b];

		ts_exactsum_add(&sum, 0.5 * body->mass * ts_dot(body->v, body->v));
	}
	out->data[0] = ts_exactsum_value(&sum);
	return TS_OK;
}

static const struct ts_value values[] = {
	{ "energy", "energy", "kinetic energy of translation of all rigid bodies", TS_SCALAR, 1,
	  NULL, eval },
	{ .name = NULL },
};

TS_STYLE(compute, ts_style, ts_compute_ke_multisphere)
const struct ts_style ts_compute_ke_multisphere = {
	.name = "ke/multisphere",
	.kind = TS_KIND_COMPUTE,
	.summary = "Kinetic energy of translation of rigid bodies",
	.doc = "The sum of M V^2 / 2 over all rigid bodies, rounded once. The group is without effect.",
	.example = "compute energy all ke/multisphere",
	.values = values,
};
