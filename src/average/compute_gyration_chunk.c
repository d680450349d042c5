/* Compute: radius of gyration of each chunk. */
#include "average/chunk_user.h"

#include <math.h>

#include "particle/group_moments.h"
#include "rigid/mass_moments.h"

#include "base/banned.h"

struct state {
	struct ts_chunk_user user;
	bool tensor;
};

static void second_moment(const struct tsim *sim, size_t i, size_t chunk, const void *context, double *term)
{
	ts_mass_second_moment(sim, i, ts_chunk_centre(context, chunk), term);
}

static enum ts_status eval_tensor(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct state *s = self->state;
	struct ts_chunks *chunks;

	(void)sim;
	TS_TRY(ts_chunk_moments(self, 6, second_moment, &chunks, out));
	for (size_t k = 0; k < 6 * chunks->n; k++) {
		double mass = s->user.centre.data[4 * (k / 6) + 3];

		out->data[k] = mass > 0 ? out->data[k] / mass : 0;
	}
	return TS_OK;
}

static enum ts_status eval_radius(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	TS_TRY(eval_tensor(self, sim, out));
	for (size_t k = 0; k < out->rows; k++)
		out->data[k] = sqrt(out->data[6 * k] + out->data[6 * k + 1] + out->data[6 * k + 2]);
	return ts_table_resize(out, 1, out->rows);
}

static bool gives(const struct ts_instance *self, const struct ts_value *value)
{
	return (value->shape == TS_ARRAY) == ((const struct state *)self->state)->tensor;
}

static const struct ts_value values[] = {
	{ "radii", "length", "radius of gyration of each chunk", TS_VECTOR, 0, NULL, eval_radius },
	{ "tensors", "length^2", "with `tensor`: the gyration tensor of each chunk", TS_ARRAY, 6,
	  ts_tensor_names, eval_tensor },
	{ .name = NULL },
};

static const struct ts_arg args[] = {
	TS_CHUNK_USER_ARG(struct state),
	TS_FLAG("tensor", struct state, tensor, .help = "output the tensor instead of the radius"),
	TS_ARGS_END,
};

TS_STYLE(compute, ts_style, ts_compute_gyration_chunk)
const struct ts_style ts_compute_gyration_chunk = {
	.name = "gyration/chunk",
	.kind = TS_KIND_COMPUTE,
	.family = TS_FAMILY_CHUNK_USER,
	.ranks = TS_RANKS_WHOLE | TS_RANKS_PARTICLES,
	.summary = "Radius of gyration of each chunk",
	.doc = "As compute gyration, for the particles of the group in each chunk of compute chunk/atom: "
	       "c_ID[i] is the radius of gyration of chunk i; with `tensor` c_ID[i][1] ... c_ID[i][6] are "
	       "the components xx, yy, zz, xy, xz, yz of the gyration tensor. A chunk without particles has "
	       "0.",
	.example = "compute size all gyration/chunk pieces\ncompute shape all gyration/chunk pieces tensor",
	.args = args,
	.state_size = sizeof(struct state),
	.values = values,
	.init = ts_chunk_user_init,
	.gives = gives,
	.fini = ts_chunk_user_fini,
};
