/* Compute: assigns each particle to a chunk. */
#include "average/chunk.h"
#include "particle/particles.h"

#include "base/banned.h"

struct state {
	struct ts_chunks chunks;
	bool fixed; /* keyword static, the older spelling of `ids once` */
};

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	if (s->fixed)
		s->chunks.ids = TS_CHUNK_IDS_ONCE;
	return ts_chunks_init(self, sim, &s->chunks);
}

static enum ts_status eval(struct ts_instance *self, const struct tsim *sim, struct ts_table *out)
{
	struct state *s = self->state;
	size_t n = sim->particles->n;

	TS_TRY(ts_chunks_assign(self, &s->chunks, TS_CHUNK_NO_SAMPLE));
	TS_TRY(ts_table_resize(out, n, 1));
	for (size_t i = 0; i < n; i++)
		out->data[i] = s->chunks.id[i];
	return TS_OK;
}

static enum ts_status archive(struct ts_instance *self, struct tsim *sim, struct ts_archive *a)
{
	return ts_chunks_archive(a, sim, &((struct state *)self->state)->chunks);
}

static void fini(struct ts_instance *self)
{
	ts_chunks_release(&((struct state *)self->state)->chunks);
}

static const struct ts_value values[] = {
	{ "chunk", "", "chunk number of the particle, from 1; 0: in no chunk", TS_PERATOM, 1, NULL, eval },
	{ .name = NULL },
};

static const struct ts_saved saved[] = { TS_CHUNK_SAVED(struct state), TS_SAVED_ROWS_END };

static const struct ts_arg args[] = {
	TS_LIST_STATEFUL("style", struct state, chunks.words,
			 .help = "bin/1d, bin/2d or bin/3d and for each axis dim origin delta; bin/sphere x "
				 "y z rmin rmax nbin; bin/cylinder dim origin delta c1 c2 rmin rmax nbin; "
				 "type; molecule (fix property/atom mol); or c_ID, f_ID, v_NAME, whose "
				 "integer part is the chunk"),
	TS_CHUNK_KEYWORDS(struct state),
	TS_ENUM("nchunk", struct state, chunks.number, ts_chunk_numbers, .fallback = "default",
		.flags = TS_STATEFUL,
		.help = "whether number and position of chunks are determined once or at each evaluation "
			"(every); default: every"),
	TS_LIST_KEYWORD("limit", struct state, chunks.limit_words,
			.flags = TS_OPTIONAL | TS_TO_KEYWORD | TS_STATEFUL,
			.help = "0: no limit; N max: at most N chunks; N exact: exactly N"),
	TS_ENUM("ids", struct state, chunks.ids, ts_chunk_id_words, .fallback = "every", .flags = TS_STATEFUL,
		.help = "whether particles are assigned to chunks at each evaluation, once, or once for each "
			"average of a fix (nfreq)"),
	TS_BOOL("compress", struct state, chunks.compress, .flags = TS_STATEFUL, .fallback = "no",
		.help = "whether chunks without particles are removed from the numbering"),
	TS_BOOL("pbc", struct state, chunks.periodic, .flags = TS_STATEFUL, .fallback = "no",
		.help = "whether distances from the centre of spheres and cylinders are to the nearest "
			"periodic image"),
	TS_BOOL("static", struct state, fixed, .flags = TS_STATEFUL, .fallback = "no",
		.help = "older spelling of ids once"),
	TS_ARGS_END,
};

TS_STYLE(compute, ts_style, ts_compute_chunk_atom)
const struct ts_style ts_compute_chunk_atom = {
	.name = "chunk/atom",
	.kind = TS_KIND_COMPUTE,
	.ranks = TS_RANKS_WHOLE | TS_RANKS_PARTICLES,
	.summary = "Assigns particles to chunks",
	.doc = "Assigns each particle of the group to a chunk and gives it the number of that chunk, from 1, "
	       "or 0 if it is in none. fix ave/chunk and the computes with /chunk in their names sum over "
	       "the particles of each chunk.\n\n"
	       "Bins along an axis have the width delta. One of them starts at the origin, and they extend "
	       "to just beyond the box, or the `bound` of that axis. In 2d and 3d the bin index along the "
	       "last axis varies fastest. The shells of spheres and cylinders divide the range rmin to rmax "
	       "evenly; for cylinders the bin index along the axis varies fastest, and c1 c2 are the "
	       "coordinates of the axis along the other two directions in the order x, y, z. Coordinates are "
	       "wrapped into a periodic box first. Particles beyond a `bound` are in no chunk. Particles "
	       "below the box are in the lowest bin, since faces of style s and m follow the particles only "
	       "when contact lists are built; those above the bins are in no chunk, as in LAMMPS. Those "
	       "outside the shells are in the nearest shell. `discard` changes that.\n\n"
	       "While fix ave/chunk, or fix ave/time of a compute with /chunk in its name, takes the samples "
	       "of an average, number and places of chunks stay those of the first sample, though a "
	       "shrink-wrapped box may grow; with `ave running` and `window`, for all averages.\n\n"
	       "With `compress yes` the chunks that have particles are renumbered from 1. `limit` sets the "
	       "largest (max) or the exact number of chunks; for bins it requires `compress yes`. Particles "
	       "in chunks beyond the limit are in no chunk, with `discard no` in the last one.",
	.example =
		"compute layers all chunk/atom bin/1d z lower 0.01 units box\n"
		"compute rings all chunk/atom bin/cylinder z lower 0.1 0 0 0 0.05 10 units box discard yes\n"
		"compute pieces all chunk/atom c_cluster compress yes\n"
		"fix profile all ave/chunk 10 10 1000 layers vx density/mass file post/profile.txt",
	.args = args,
	.state_size = sizeof(struct state),
	.saved = saved,
	.archive = archive,
	.values = values,
	.init = init,
	.fini = fini,
};
