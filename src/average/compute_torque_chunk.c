/* Compute: torque on each chunk. */
#include "average/chunk_user.h"

#include "base/axes.h"
#include "math/vec3.h"
#include "particle/group_moments.h"

#include "base/banned.h"

struct state {
	struct ts_chunk_user user;
};

static void torque(const struct tsim *sim, size_t i, size_t chunk, const void *context, double *term)
{
	double d[3];

	ts_unwrapped(sim, i, d);
	ts_sub(d, ts_chunk_centre(context, chunk), d);
	ts_cross(d, sim->particles->f[i], term);
}

static enum ts_status eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	struct ts_chunks *chunks;

	(void)sim;
	return ts_chunk_moments(self, 3, torque, &chunks, out);
}

static const struct ts_value values[] = {
	{ "torques", "force*length", "torque on each chunk", TS_ARRAY, 3, ts_axis_names, eval },
	{ .name = NULL },
};

static const struct ts_arg args[] = {
	TS_CHUNK_USER_ARG(struct state),
	TS_ARGS_END,
};

TS_STYLE(compute, ts_style, ts_compute_torque_chunk)
const struct ts_style ts_compute_torque_chunk = {
	.name = "torque/chunk",
	.kind = TS_KIND_COMPUTE,
	.family = TS_FAMILY_CHUNK_USER,
	.ranks = TS_RANKS_WHOLE | TS_RANKS_PARTICLES,
	.summary = "Torque on each chunk",
	.doc = "Calculates the torque on the particles of the group in each chunk of compute chunk/atom,\n\n"
	       "    T = sum d x F\n\n"
	       "with F the total force on the particle and d its vector from the centre of mass of the "
	       "chunk, from positions without periodic wrapping. c_ID[i][1], c_ID[i][2], c_ID[i][3] are the "
	       "components for chunk i.",
	.example = "compute t all torque/chunk pieces",
	.args = args,
	.state_size = sizeof(struct state),
	.values = values,
	.init = ts_chunk_user_init,
	.fini = ts_chunk_user_fini,
};
