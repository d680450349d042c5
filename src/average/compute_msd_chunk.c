/* Compute: squared displacement of each chunk. */
#include "average/chunk_user.h"

#include "base/banned.h"

struct state {
	struct ts_chunk_user user;
	double *start; /* [chunk][3] centres of mass at the start (length); written to restart files */
	size_t n, capacity;
	bool started;
};

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	struct ts_chunks *chunks;

	TS_TRY(ts_chunk_user_init(self, sim));
	if (s->started)
		return TS_OK;
	s->started = true;
	TS_TRY(ts_chunk_user_assign(self, &chunks));
	TS_TRY(ts_chunk_centres(self, chunks, &s->user.centre));
	if (TS_GROW(s->start, s->capacity, 3 * chunks->n) != TS_OK)
		return ts_nomem(&sim->error);
	s->n = 3 * chunks->n;
	for (size_t k = 0; k < s->n; k++)
		s->start[k] = s->user.centre.data[4 * (k / 3) + k % 3];
	return TS_OK;
}

static enum ts_status eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	struct state *s = self->state;
	struct ts_chunks *chunks;

	(void)sim;
	TS_TRY(ts_chunk_user_assign(self, &chunks));
	if (3 * chunks->n != s->n)
		return ts_fail(&s->user.sim->error, TS_STATE, &self->where,
			       "compute msd/chunk: there were %zu chunks at the start, now there are %zu; "
			       "use `nchunk once` and `limit N exact` of chunk/atom",
			       s->n / 3, chunks->n);
	TS_TRY(ts_chunk_centres(self, chunks, &s->user.centre));
	TS_TRY(ts_table_resize(out, chunks->n, 4));
	for (size_t k = 0; k < chunks->n; k++) {
		double *row = out->data + 4 * k;

		row[3] = 0;
		for (size_t d = 0; d < 3; d++) {
			double displacement = s->user.centre.data[4 * k + d] - s->start[3 * k + d];

			row[d] = displacement * displacement;
			row[3] += row[d];
		}
	}
	return TS_OK;
}

static enum ts_status archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *a)
{
	struct state *s = self->state;

	(void)sim;
	return ts_archive_array(a, "start", TS_SAVED_F64, (void **)&s->start, &s->capacity, &s->n);
}

static void fini(struct ts_instance *self)
{
	ts_free(((struct state *)self->state)->start);
	ts_chunk_user_fini(self);
}

static const char *const names[] = { "x", "y", "z", "total", NULL };

static const struct ts_value values[] = {
	{ "msd", "length^2", "squared displacement of each chunk along the axes, and their sum", TS_ARRAY, 4,
	  names, eval },
	{ .name = NULL },
};

static const struct ts_arg args[] = {
	TS_CHUNK_USER_ARG(struct state),
	TS_ARGS_END,
};

TS_STYLE(compute, ts_style, ts_compute_msd_chunk)
const struct ts_style ts_compute_msd_chunk = {
	.name = "msd/chunk",
	.kind = TS_KIND_COMPUTE,
	.family = TS_FAMILY_CHUNK_USER,
	.ranks = TS_RANKS_WHOLE | TS_RANKS_PARTICLES,
	.summary = "Squared displacement of each chunk",
	.doc = "Calculates the squared displacement of the centre of mass of each chunk of compute "
	       "chunk/atom since this compute was defined: c_ID[i][1], c_ID[i][2], c_ID[i][3] along x, y, z, "
	       "and c_ID[i][4] their sum, for chunk i. Positions are without periodic wrapping. A chunk "
	       "should consist of the same particles all the time (`ids once`, or chunks by type). The "
	       "initial positions are saved in restart files.",
	.example = "compute way all msd/chunk pieces",
	.args = args,
	.state_size = sizeof(struct state),
	.values = values,
	.init = init,
	.archive = archive,
	.fini = fini,
};
