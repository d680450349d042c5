/* Compute: temperature of each chunk. */
#include "average/chunk_user.h"

#include <math.h>

#include "core/name_list.h"
#include "core/units.h"
#include "math/vec3.h"
#include "particle/group_moments.h"

#include "base/banned.h"

struct state {
	struct ts_chunk_user user;
	struct ts_words words;
	struct ts_name_list list;
	bool com;
	double adof, cdof;
	struct ts_table tensor;
};

enum { TEMP, KECOM, INTERNAL };
static const char *const words[] = { [TEMP] = "temp", [KECOM] = "kecom", [INTERNAL] = "internal", NULL };

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	TS_TRY(ts_chunk_user_init(self, sim));
	return ts_name_list_read(sim, "compute temp/chunk", &self->arena, s->words, words, sizeof *words,
				 &s->list);
}

static void momentum(const struct tsim *sim, size_t i, size_t chunk, const void *context, double *term)
{
	(void)chunk, (void)context;
	term[3] = sim->particles->mass[i];
	for (int d = 0; d < 3; d++)
		term[d] = term[3] * sim->particles->v[i][d];
}

/* Context of the term: [chunk][4] momentum and mass. */
struct frame {
	const struct ts_table *momentum;
	bool relative; /* velocities are relative to the centre of mass of the chunk */
};

static void kinetic_tensor(const struct tsim *sim, size_t i, size_t chunk, const void *context, double *term)
{
	const struct frame *f = context;
	const double *sum = f->momentum->data + 4 * (chunk - 1);
	double u[3];

	for (int d = 0; d < 3; d++)
		u[d] = sim->particles->v[i][d] - (f->relative && sum[3] > 0 ? sum[d] / sum[3] : 0);
	for (int k = 0; k < 6; k++)
		term[k] = sim->particles->mass[i] * u[ts_tensor_row[k]] * u[ts_tensor_column[k]];
	term[6] = 1;
}

/* For each chunk: momentum and mass into user.centre; sum m u_a u_b (xx, yy, zz, xy, xz, yz) and number of
 * particles into s->tensor. */
static enum ts_status sum_tensors(struct ts_instance *self, struct ts_chunks **chunks, bool relative)
{
	struct state *s = self->state;
	struct frame frame = { &s->user.centre, relative };

	TS_TRY(ts_chunk_user_assign(self, chunks));
	TS_TRY(ts_chunk_sum(*chunks, self->group, 4, momentum, NULL, &s->user.centre));
	return ts_chunk_sum(*chunks, self->group, 7, kinetic_tensor, &frame, &s->tensor);
}

static double temperature(const struct tsim *sim, const struct state *s, double twice, double n,
			  double chunks)
{
	double freedom = (isnan(s->adof) ? sim->dimension : s->adof) * n + s->cdof * chunks;

	return freedom > 0 ? twice / (freedom * ts_boltzmann(sim)) : 0;
}

static double value_of_chunk(const struct tsim *sim, const struct state *s, size_t k, int what)
{
	const double *t = s->tensor.data + 7 * k, *p = s->user.centre.data + 4 * k;

	if (what == TEMP)
		return temperature(sim, s, t[0] + t[1] + t[2], t[6], t[6] > 0);
	return what == INTERNAL ? 0.5 * (t[0] + t[1] + t[2]) : p[3] > 0 ? 0.5 * ts_dot(p, p) / p[3] : 0;
}

static enum ts_status eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	struct state *s = self->state;
	struct ts_chunks *chunks;

	for (size_t k = 0; k < s->list.n; k++) {
		int what = s->list.item[k];

		TS_TRY(sum_tensors(self, &chunks, what == INTERNAL || s->com));
		if (k == 0)
			TS_TRY(ts_table_resize(out, chunks->n, s->list.n));
		for (size_t c = 0; c < chunks->n; c++)
			out->data[c * s->list.n + k] = value_of_chunk(sim, s, c, what);
	}
	return TS_OK;
}

static enum ts_status eval_tensor(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	struct state *s = self->state;
	struct ts_chunks *chunks;

	(void)sim;
	TS_TRY(sum_tensors(self, &chunks, s->com));
	for (size_t k = 0; k < 6; k++) {
		out->data[k] = 0;
		for (size_t c = 0; c < chunks->n; c++)
			out->data[k] += s->tensor.data[7 * c + k];
	}
	return TS_OK;
}

static enum ts_status eval_scalar(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	struct state *s = self->state;
	double twice = 0, n = 0, used = 0;
	struct ts_chunks *chunks;

	TS_TRY(sum_tensors(self, &chunks, s->com));
	for (size_t c = 0; c < chunks->n; c++) {
		const double *t = s->tensor.data + 7 * c;

		twice += t[0] + t[1] + t[2];
		n += t[6];
		used += t[6] > 0;
	}
	out->data[0] = temperature(sim, s, twice, n, used);
	return TS_OK;
}

static bool gives(const struct ts_instance *self, const struct ts_value *value)
{
	return value->shape != TS_ARRAY || ((const struct state *)self->state)->words.n > 0;
}

static void fini(struct ts_instance *self)
{
	ts_table_release(&((struct state *)self->state)->tensor);
	ts_chunk_user_fini(self);
}

static const struct ts_value values[] = {
	{ "temperature", "temperature", "of all particles in chunks together", TS_SCALAR, 1, NULL,
	  eval_scalar },
	{ "tensor", "energy", "sum m u_a u_b over all particles in chunks", TS_VECTOR, 6, ts_tensor_names,
	  eval_tensor },
	{ "chunks", "", "of each chunk, a column for each value", TS_ARRAY, 0, NULL, eval },
	{ .name = NULL },
};

static const struct ts_arg args[] = {
	TS_CHUNK_USER_ARG(struct state),
	{ .name = "values",
	  .type = TS_ARG_REST,
	  .flags = TS_POSITIONAL | TS_OPTIONAL | TS_TO_KEYWORD,
	  .offset = TS_FIELD(struct state, words, struct ts_words *),
	  .help = "temp, kecom, internal" },
	TS_BOOL("com", struct state, com, .fallback = "no",
		.help = "whether velocities are relative to the centre of mass of the chunk"),
	TS_REAL("adof", struct state, adof, .flags = TS_OPTIONAL, .unit = "",
		.help = "degrees of freedom per particle; default: the dimension"),
	TS_REAL("cdof", struct state, cdof, .fallback = "0", .unit = "",
		.help = "degrees of freedom added per chunk; may be negative"),
	TS_ARGS_END,
};

TS_STYLE(compute, ts_style, ts_compute_temp_chunk)
const struct ts_style ts_compute_temp_chunk = {
	.name = "temp/chunk",
	.kind = TS_KIND_COMPUTE,
	.family = TS_FAMILY_CHUNK_USER,
	.ranks = TS_RANKS_WHOLE | TS_RANKS_PARTICLES,
	.summary = "Temperature of chunks",
	.doc = "Calculates for each chunk of compute chunk/atom a column for each of the values: temp, the "
	       "temperature\n\n"
	       "    T = sum m u^2 / (k_B (adof N + cdof))\n\n"
	       "kecom, the kinetic energy of the motion of the centre of mass; internal, the kinetic energy "
	       "of the motion relative to it. u is the velocity v of the particle, with `com yes` its "
	       "velocity relative to the centre of mass of the chunk. The default of adof is 3, in two "
	       "dimensions 2; that of cdof 0. c_ID alone is the temperature of all particles in chunks "
	       "together, c_ID[k] their sums of m u_a u_b for xx, yy, zz, xy, xz, yz.",
	.example = "compute t all temp/chunk layers temp com yes cdof -3",
	.args = args,
	.state_size = sizeof(struct state),
	.values = values,
	.init = init,
	.gives = gives,
	.fini = fini,
};
