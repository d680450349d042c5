/* Compute temp/granular/chunk: granular temperature of each chunk. */
#include "average/chunk_user.h"
#include "average/granular_temperature.h"

#include "base/banned.h"

struct state {
	struct ts_chunk_user user;
	struct ts_granular granular;
	struct ts_granular_field *field; /* [chunk] */
	size_t capacity;
	struct ts_table sums; /* [chunk][TS_GRANULAR_WIDTH] of a pass */
};

struct pass {
	const struct state *s;
	int number;
};

static void term_of_pass(const struct tsim *sim, size_t i, size_t chunk, const void *context, double *term)
{
	const struct pass *pass = context;

	ts_granular_term(sim, i, &pass->s->granular, pass->number, &pass->s->field[chunk - 1], term);
}

/* The fields of all chunks, and the sums of the last pass. */
static enum ts_status sum_passes(struct ts_instance *self, const struct tsim *sim, struct ts_chunks **chunks)
{
	struct state *s = self->state;

	(void)sim;
	TS_TRY(ts_chunk_user_assign(self, chunks));
	if (TS_GROW(s->field, s->capacity, (*chunks)->n + 1) != TS_OK) /* never NULL */
		return TS_NOMEM;
	for (int k = 1; k <= 3; k++) {
		struct pass pass = { s, k };

		TS_TRY(ts_chunk_sum(*chunks, self->group, TS_GRANULAR_WIDTH, term_of_pass, &pass, &s->sums));
		for (size_t c = 0; k < 3 && c < (*chunks)->n; c++)
			ts_granular_enter(&s->granular, k, s->sums.data + c * TS_GRANULAR_WIDTH,
					  &s->field[c]);
	}
	return TS_OK;
}

static enum ts_status eval_chunks(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	struct state *s = self->state;
	struct ts_chunks *chunks;

	TS_TRY(sum_passes(self, sim, &chunks));
	TS_TRY(ts_table_resize(out, chunks->n, TS_GRANULAR_COLUMNS));
	for (size_t c = 0; c < chunks->n; c++)
		ts_granular_result(sim, &s->granular, &s->field[c], s->sums.data + c * TS_GRANULAR_WIDTH,
				   out->data + c * TS_GRANULAR_COLUMNS);
	return TS_OK;
}

static enum ts_status eval_mean(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	struct state *s = self->state;
	struct ts_chunks *chunks;
	double sum = 0, weight = 0;

	TS_TRY(sum_passes(self, sim, &chunks));
	for (size_t c = 0; c < chunks->n; c++) {
		double result[TS_GRANULAR_COLUMNS];

		ts_granular_result(sim, &s->granular, &s->field[c], s->sums.data + c * TS_GRANULAR_WIDTH,
				   result);
		sum += s->field[c].weight * result[0];
		weight += s->field[c].weight;
	}
	out->data[0] = weight > 0 ? sum / weight : 0;
	return TS_OK;
}

static void fini(struct ts_instance *self)
{
	struct state *s = self->state;

	ts_free(s->field);
	ts_table_release(&s->sums);
	ts_chunk_user_fini(self);
}

static const char *const names[] = { "T", "xx", "yy", "zz", "xy", "xz", "yz", "count", NULL };

static const struct ts_value values[] = {
	{ "mean", "velocity^2", "mean of the temperatures of the particles' chunks", TS_SCALAR, 1, NULL,
	  eval_mean },
	{ "chunks", "velocity^2",
	  "granular temperature, tensor of the fluctuations and number of particles of each chunk", TS_ARRAY,
	  TS_GRANULAR_COLUMNS, names, eval_chunks },
	{ .name = NULL },
};

static const struct ts_arg args[] = { TS_CHUNK_USER_ARG(struct state),
				      TS_GRANULAR_ROWS(struct state, granular), TS_ARGS_END };

TS_STYLE(compute, ts_style, ts_compute_temp_granular_chunk)
const struct ts_style ts_compute_temp_granular_chunk = {
	.name = "temp/granular/chunk",
	.kind = TS_KIND_COMPUTE,
	.family = TS_FAMILY_CHUNK_USER,
	.ranks = TS_RANKS_WHOLE | TS_RANKS_PARTICLES,
	.summary = "Granular temperature of chunks",
	.doc = "The granular temperature of the particles of the group in each chunk of compute chunk/atom, "
	       "as by compute temp/granular with the mean velocity of each chunk: c_ID[i][1] is T, "
	       "c_ID[i][2] to c_ID[i][7] the tensor <u'_a u'_b>, c_ID[i][8] the number N of particles of "
	       "chunk i. T is 0 in chunks where it is not defined, with a single particle or without any. "
	       "c_ID is the mean of T over the particles, those of a chunk with its T.\n\n"
	       "`fix ave/time ... c_ID[1] mode vector` averages the temperatures over time, every sample "
	       "alike, and `fix ave/error` gives their standard errors; the value temp/granular of fix "
	       "ave/chunk averages over the particles of all samples. In chunks of few particles use "
	       "`unbiased yes`.",
	.example = "compute layers all chunk/atom bin/1d y lower 0.001 units box\n"
		   "compute T grains temp/granular/chunk layers unbiased yes",
	.cite = "C. K. K. Lun, S. B. Savage, D. J. Jeffrey, N. Chepurniy, J. Fluid Mech. 140 (1984) 223",
	.args = args,
	.state_size = sizeof(struct state),
	.values = values,
	.init = ts_chunk_user_init,
	.fini = fini,
};
