/* Compute: properties of chunks. */
#include "average/chunk_user.h"

#include "core/name_list.h"
#include "particle/particles.h"

#include "base/banned.h"

struct state {
	struct ts_chunk_user user;
	struct ts_words words;
	struct ts_name_list list;
};

enum { COUNT, ID, COORD1 };
static const char *const words[] = { [COUNT] = "count", [ID] = "id", [COORD1] = "coord1",
				     "coord2",		"coord3",    NULL };

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	TS_TRY(ts_chunk_user_init(self, sim));
	return ts_name_list_read(sim, "compute property/chunk", &self->arena, s->words, words, sizeof *words,
				 &s->list);
}

static double property_of_chunk(const struct ts_instance *self, const struct ts_chunks *c, size_t chunk,
				int what)
{
	const struct ts_particles *p = c->sim->particles;
	double n = 0;

	if (what == ID)
		return c->compress ? (double)c->original[chunk - 1] : (double)chunk;
	if (what >= COORD1)
		return ts_chunks_coordinate(c, chunk, what - COORD1);
	for (size_t m = c->first[chunk]; m < c->first[chunk + 1]; m++)
		n += ts_in_group(p, (size_t)c->member[m], self->group);
	return n;
}

static enum ts_status eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	const struct state *s = self->state;
	struct ts_chunks *c;

	(void)sim;
	TS_TRY(ts_chunk_user_assign(self, &c));
	for (size_t k = 0; k < s->list.n; k++)
		if (s->list.item[k] - COORD1 >= ts_chunks_dimension(c))
			return ts_fail(&s->user.sim->error, TS_RANGE, &s->words.word[k].place,
				       "compute property/chunk: the chunks have %d coordinates",
				       ts_chunks_dimension(c));
	TS_TRY(ts_table_resize(out, c->n, s->list.n));
	for (size_t chunk = 1; chunk <= c->n; chunk++)
		for (size_t k = 0; k < s->list.n; k++)
			out->data[(chunk - 1) * s->list.n + k] =
				property_of_chunk(self, c, chunk, s->list.item[k]);
	return TS_OK;
}

static enum ts_status eval_vector(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	TS_TRY(eval(self, sim, out));
	return ts_table_resize(out, 1, out->rows);
}

static bool gives(const struct ts_instance *self, const struct ts_value *value)
{
	return (value->shape == TS_VECTOR) == (((const struct state *)self->state)->words.n == 1);
}

static const struct ts_value values[] = {
	{ "property", "", "of each chunk, for a single property", TS_VECTOR, 0, NULL, eval_vector },
	{ "properties", "", "of each chunk, a column for each property", TS_ARRAY, 0, NULL, eval },
	{ .name = NULL },
};

static const struct ts_arg args[] = {
	TS_CHUNK_USER_ARG(struct state),
	TS_REST("properties", struct state, words, .help = "count, id, coord1, coord2, coord3"),
	TS_ARGS_END,
};

TS_STYLE(compute, ts_style, ts_compute_property_chunk)
const struct ts_style ts_compute_property_chunk = {
	.name = "property/chunk",
	.kind = TS_KIND_COMPUTE,
	.family = TS_FAMILY_CHUNK_USER,
	.ranks = TS_RANKS_WHOLE | TS_RANKS_PARTICLES,
	.summary = "Particle count, original number and coordinates of chunks",
	.doc = "Lists properties of each chunk of compute chunk/atom: count, the number of its particles "
	       "that are in the group; id, its number before `compress`; coord1, coord2, coord3, the "
	       "coordinates of the centre of its bin. c_ID[i] is the property of chunk i; with several "
	       "properties c_ID[i][j] is the j-th.",
	.example = "compute n all property/chunk layers count coord1",
	.args = args,
	.state_size = sizeof(struct state),
	.values = values,
	.init = init,
	.gives = gives,
	.fini = ts_chunk_user_fini,
};
