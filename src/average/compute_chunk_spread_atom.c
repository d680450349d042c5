/* Compute: spreads values of chunks to their particles. */
#include "average/chunk_user.h"
#include "core/ref_list.h"
#include "particle/particles.h"

#include "base/banned.h"

struct state {
	struct ts_chunk_user user;
	struct ts_words words;
	struct ts_ref_list input;
	struct ts_table each;
};

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	TS_TRY(ts_chunk_user_init(self, sim));
	return ts_ref_list_init(sim, "compute chunk/spread/atom", &self->arena, s->words, TS_WANT(VECTOR),
				&s->input);
}

static enum ts_status spread_input(struct ts_instance *self, const struct ts_chunks *chunks, size_t k,
				   struct ts_table *out)
{
	struct state *s = self->state;
	const struct ts_ref_input *input = &s->input.item[k];
	const struct ts_particles *p = s->user.sim->particles;

	TS_TRY(ts_ref_input_eval(s->user.sim, input, &s->each));
	if (s->each.rows != chunks->n)
		return ts_fail(&s->user.sim->error, TS_STATE, &input->where,
			       "compute chunk/spread/atom: '%s' has %zu numbers, but there are %zu chunks in "
			       "'%s'",
			       input->name, s->each.rows, chunks->n, s->user.id);
	for (size_t i = 0; i < p->n; i++) {
		bool has = chunks->id[i] > 0 && ts_in_group(p, i, self->group);

		out->data[i * s->input.n + k] = has ? s->each.data[chunks->id[i] - 1] : 0;
	}
	return TS_OK;
}

static enum ts_status eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	struct state *s = self->state;
	struct ts_chunks *chunks;

	TS_TRY(ts_table_resize(out, sim->particles->n, s->input.n));
	for (size_t k = 0; k < s->input.n; k++) {
		/* evaluating an input may reassign the particles to chunks */
		TS_TRY(ts_chunk_user_assign(self, &chunks));
		TS_TRY(spread_input(self, chunks, k, out));
	}
	return TS_OK;
}

static void fini(struct ts_instance *self)
{
	struct state *s = self->state;

	ts_chunk_user_fini(self);
	ts_ref_list_release(&s->input);
	ts_table_release(&s->each);
}

static size_t width(const struct ts_instance *self)
{
	return ((const struct state *)self->state)->input.n;
}

static const struct ts_value values[] = {
	{ "values", "", "values of its chunk, one for each input; 0 outside chunks or group", TS_PERATOM, 0,
	  NULL, eval },
	{ .name = NULL },
};

static const struct ts_arg args[] = {
	TS_CHUNK_USER_ARG(struct state),
	TS_LIST("values", struct state, words,
		.help = "vectors with one number per chunk: c_ID, f_ID, columns of arrays c_ID[k], f_ID[k], "
			"or vector-style variables v_name"),
	TS_ARGS_END,
};

TS_STYLE(compute, ts_style, ts_compute_chunk_spread_atom)
const struct ts_style ts_compute_chunk_spread_atom = {
	.name = "chunk/spread/atom",
	.kind = TS_KIND_COMPUTE,
	.family = TS_FAMILY_CHUNK_USER,
	.ranks = TS_RANKS_WHOLE | TS_RANKS_PARTICLES,
	.summary = "Spreads values of chunks to their particles",
	.doc = "Gives each particle of the group the values of the chunk to which compute chunk/atom assigns "
	       "it; particles in no chunk have 0. Thus the size of a cluster, or the mean velocity of a "
	       "layer, can colour its particles in a dump, or be used in an atom-style variable.",
	.example = "compute heap all cluster/atom 0.01\n"
		   "compute heaps all chunk/atom c_heap compress yes\n"
		   "compute mass all reduce/chunk heaps sum mass\n"
		   "compute mine all chunk/spread/atom heaps c_mass\n"
		   "dump d all custom 1000 post/*.dump id x y z c_mine",
	.args = args,
	.state_size = sizeof(struct state),
	.values = values,
	.width = width,
	.init = init,
	.fini = fini,
};
