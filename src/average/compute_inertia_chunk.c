/* Compute: tensor of inertia of each chunk. */
#include "average/chunk_user.h"

#include "rigid/mass_moments.h"

#include "base/banned.h"

struct state {
	struct ts_chunk_user user;
};

/* Order of components as in compute inertia/chunk of LAMMPS: yz before xz. */
static const char *const names[] = { "xx", "yy", "zz", "xy", "yz", "xz", NULL };

static void inertia(const struct tsim *sim, size_t i, size_t chunk, const void *context, double *term)
{
	double xz;

	ts_mass_inertia(sim, i, ts_chunk_centre(context, chunk), term);
	xz = term[4];
	term[4] = term[5];
	term[5] = xz;
}

static enum ts_status eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	struct ts_chunks *chunks;

	(void)sim;
	return ts_chunk_moments(self, 6, inertia, &chunks, out);
}

static const struct ts_value values[] = {
	{ "inertia", "mass*length^2", "tensor of inertia of each chunk", TS_ARRAY, 6, names, eval },
	{ .name = NULL },
};

static const struct ts_arg args[] = {
	TS_CHUNK_USER_ARG(struct state),
	TS_ARGS_END,
};

TS_STYLE(compute, ts_style, ts_compute_inertia_chunk)
const struct ts_style ts_compute_inertia_chunk = {
	.name = "inertia/chunk",
	.kind = TS_KIND_COMPUTE,
	.family = TS_FAMILY_CHUNK_USER,
	.ranks = TS_RANKS_WHOLE | TS_RANKS_PARTICLES,
	.summary = "Tensor of inertia of each chunk",
	.doc = "Calculates the inertia tensor of the particles of the group in each chunk of compute "
	       "chunk/atom,\n\n"
	       "    I_ab = sum m (d^2 delta_ab - d_a d_b)\n\n"
	       "with d the vector from the centre of mass of the chunk, from positions without periodic "
	       "wrapping. Particles are point masses: their own moment of inertia is not included. "
	       "c_ID[i][1] ... c_ID[i][6] are xx, yy, zz, xy, yz, xz for chunk i. " TS_CHUNK_OF_CLUMPS
	       " See also compute omega/chunk.",
	.example = "compute i all inertia/chunk pieces",
	.args = args,
	.state_size = sizeof(struct state),
	.values = values,
	.init = ts_chunk_user_init,
	.fini = ts_chunk_user_fini,
};
