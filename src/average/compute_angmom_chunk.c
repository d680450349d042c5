/* Compute: angular momentum of each chunk. */
#include "average/chunk_user.h"

#include "base/axes.h"
#include "rigid/mass_moments.h"

#include "base/banned.h"

struct state {
	struct ts_chunk_user user;
};

/* L = sum m d x v; the velocity of the centre of mass cancels in the sum. */
static void angular_momentum(const struct tsim *sim, size_t i, size_t chunk, const void *context,
			     double *term)
{
	ts_mass_angular_momentum(sim, i, ts_chunk_centre(context, chunk), term);
}

static enum ts_status eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	struct ts_chunks *chunks;

	(void)sim;
	return ts_chunk_moments(self, 3, angular_momentum, &chunks, out);
}

static const struct ts_value values[] = {
	{ "momenta", "mass*length*velocity", "angular momentum of each chunk", TS_ARRAY, 3, ts_axis_names,
	  eval },
	{ .name = NULL },
};

static const struct ts_arg args[] = {
	TS_CHUNK_USER_ARG(struct state),
	TS_ARGS_END,
};

TS_STYLE(compute, ts_style, ts_compute_angmom_chunk)
const struct ts_style ts_compute_angmom_chunk = {
	.name = "angmom/chunk",
	.kind = TS_KIND_COMPUTE,
	.family = TS_FAMILY_CHUNK_USER,
	.ranks = TS_RANKS_WHOLE | TS_RANKS_PARTICLES,
	.summary = "Angular momentum of each chunk",
	.doc = "Calculates the angular momentum of the particles of the group in each chunk of compute "
	       "chunk/atom,\n\n"
	       "    L = sum m d x v\n\n"
	       "with d the vector from the centre of mass of the chunk, from positions without periodic "
	       "wrapping. The spin of the particles themselves is not included. c_ID[i][1], c_ID[i][2], "
	       "c_ID[i][3] are the components for chunk i. " TS_CHUNK_OF_CLUMPS
	       " See also compute omega/chunk, inertia/chunk.",
	.example = "compute l all angmom/chunk pieces",
	.args = args,
	.state_size = sizeof(struct state),
	.values = values,
	.init = ts_chunk_user_init,
	.fini = ts_chunk_user_fini,
};
