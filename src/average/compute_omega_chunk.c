/* Compute: angular velocity of each chunk. */
#include "average/chunk_user.h"

#include "base/axes.h"
#include "math/symmetric3.h"
#include "rigid/mass_moments.h"

#include "base/banned.h"

struct state {
	struct ts_chunk_user user;
	struct ts_table sums;
};

/* The six components of the inertia tensor, then the angular momentum. */
static void inertia_and_momentum(const struct tsim *sim, size_t i, size_t chunk, const void *context,
				 double *term)
{
	const double *centre = ts_chunk_centre(context, chunk);

	ts_mass_inertia(sim, i, centre, term);
	ts_mass_angular_momentum(sim, i, centre, term + 6);
}

static enum ts_status eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	struct state *s = self->state;
	struct ts_chunks *chunks;

	(void)sim;
	TS_TRY(ts_chunk_moments(self, 9, inertia_and_momentum, &chunks, &s->sums));
	TS_TRY(ts_table_resize(out, chunks->n, 3));
	for (size_t k = 0; k < chunks->n; k++)
		ts_symmetric3_solve(s->sums.data + 9 * k, s->sums.data + 9 * k + 6, out->data + 3 * k);
	return TS_OK;
}

static void fini(struct ts_instance *self)
{
	ts_table_release(&((struct state *)self->state)->sums);
	ts_chunk_user_fini(self);
}

static const struct ts_value values[] = {
	{ "omega", "1/time", "angular velocity of each chunk", TS_ARRAY, 3, ts_axis_names, eval },
	{ .name = NULL },
};

static const struct ts_arg args[] = {
	TS_CHUNK_USER_ARG(struct state),
	TS_ARGS_END,
};

TS_STYLE(compute, ts_style, ts_compute_omega_chunk)
const struct ts_style ts_compute_omega_chunk = {
	.name = "omega/chunk",
	.kind = TS_KIND_COMPUTE,
	.family = TS_FAMILY_CHUNK_USER,
	.ranks = TS_RANKS_WHOLE | TS_RANKS_PARTICLES,
	.summary = "Angular velocity of each chunk",
	.doc = "Calculates the angular velocity of each chunk of compute chunk/atom,\n\n"
	       "    omega = I^-1 L\n\n"
	       "with the inertia tensor I of compute inertia/chunk and the angular momentum L of compute "
	       "angmom/chunk. About an axis without inertia, such as that through two particles, it is 0. "
	       "c_ID[i][1], c_ID[i][2], c_ID[i][3] are the components for chunk i.",
	.example = "compute w all omega/chunk pieces",
	.args = args,
	.state_size = sizeof(struct state),
	.values = values,
	.init = ts_chunk_user_init,
	.fini = fini,
};
