/* Compute: velocity of each chunk. */
#include "average/chunk_user.h"

#include "base/axes.h"
#include "rigid/mass_moments.h"

#include "base/banned.h"

struct state {
	struct ts_chunk_user user;
};

static void momentum(const struct tsim *sim, size_t i, size_t chunk, const void *context, double *term)
{
	(void)chunk, (void)context;
	ts_mass_momentum(sim, i, term);
}

static enum ts_status eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	struct ts_chunk_user *user = self->state;
	struct ts_chunks *chunks;

	(void)sim;
	TS_TRY(ts_chunk_user_assign(self, &chunks));
	TS_TRY(ts_chunk_sum(chunks, self->group, 4, momentum, NULL, &user->centre));
	TS_TRY(ts_table_resize(out, chunks->n, 3));
	for (size_t k = 0; k < chunks->n; k++) {
		const double *sum = user->centre.data + 4 * k;

		for (size_t d = 0; d < 3; d++)
			out->data[3 * k + d] = sum[3] > 0 ? sum[d] / sum[3] : 0;
	}
	return TS_OK;
}

static const struct ts_value values[] = {
	{ "velocities", "velocity", "velocity of the centre of mass of each chunk", TS_ARRAY, 3,
	  ts_axis_names, eval },
	{ .name = NULL },
};

static const struct ts_arg args[] = {
	TS_CHUNK_USER_ARG(struct state),
	TS_ARGS_END,
};

TS_STYLE(compute, ts_style, ts_compute_vcm_chunk)
const struct ts_style ts_compute_vcm_chunk = {
	.name = "vcm/chunk",
	.kind = TS_KIND_COMPUTE,
	.family = TS_FAMILY_CHUNK_USER,
	.ranks = TS_RANKS_WHOLE | TS_RANKS_PARTICLES,
	.summary = "Velocity of the center of mass of each chunk",
	.doc = "Calculates the velocity of the centre of mass, sum m v / sum m, of the particles of the "
	       "group in each chunk of compute chunk/atom. c_ID[i][1], c_ID[i][2], c_ID[i][3] are the "
	       "components for chunk i; a chunk without particles has 0. " TS_CHUNK_OF_CLUMPS,
	.example = "compute v all vcm/chunk pieces",
	.args = args,
	.state_size = sizeof(struct state),
	.values = values,
	.init = ts_chunk_user_init,
	.fini = ts_chunk_user_fini,
};
