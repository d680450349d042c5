/* Compute: which chunk each particle is in. */
#include "average/chunk.h"
#include "particle/particles.h"

#include "base/banned.h"

struct state {
	struct ts_chunks chunks;
	bool fixed; /* static, the older word for ids once */
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

	TS_TRY(ts_chunks_assign(self, &s->chunks, TS_CHUNK_LOOK));
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
	{ "chunk", "", "number of its chunk, from 1; 0: in none", TS_PERATOM, 1, NULL, eval },
	{ .name = NULL },
};

static const struct ts_saved saved[] = { TS_CHUNK_SAVED(struct state), TS_SAVED_ROWS_END };

static const struct ts_arg args[] = {
	TS_LIST_STATEFUL("style", struct state, chunks.words,
			 .help = "bin/1d, bin/2d or bin/3d and for each axis dim origin delta; bin/sphere "
				 "x y z rmin rmax nbin; bin/cylinder dim origin delta c1 c2 rmin rmax "
				 "nbin; type; or c_ID, f_ID, v_NAME, whose whole part is the chunk"),
	TS_CHUNK_KEYWORDS(struct state),
	TS_ENUM("nchunk", struct state, chunks.number, ts_chunk_numbers, .fallback = "default",
		.flags = TS_STATEFUL,
		.help = "whether the number and place of chunks stay as found first; default: every"),
	TS_LIST_KEYWORD("limit", struct state, chunks.limit_words,
			.flags = TS_OPTIONAL | TS_TO_KEYWORD | TS_STATEFUL,
			.help = "0: none; N max: at most N chunks; N exact: just N"),
	TS_ENUM("ids", struct state, chunks.ids, ts_chunk_id_words, .fallback = "every", .flags = TS_STATEFUL,
		.help = "whether particles are sorted whenever chunks are needed, once, or once in each "
			"average of a fix (nfreq)"),
	TS_BOOL("compress", struct state, chunks.compress, .flags = TS_STATEFUL, .fallback = "no",
		.help = "only chunks that have particles count"),
	TS_BOOL("pbc", struct state, chunks.periodic, .flags = TS_STATEFUL, .fallback = "no",
		.help = "distances from the centre of spheres and cylinders are to the nearest image"),
	TS_BOOL("static", struct state, fixed, .flags = TS_STATEFUL, .fallback = "no",
		.help = "older word for ids once"),
	TS_ARGS_END,
};

TS_STYLE(compute, ts_style, ts_compute_chunk_atom)
const struct ts_style ts_compute_chunk_atom = {
	.name = "chunk/atom",
	.kind = TS_KIND_COMPUTE,
	.summary = "Sorts particles into chunks",
	.doc = "Gives each particle of the group the number of a chunk, from 1 on, or 0 if it is in none. "
	       "fix ave/chunk and\n"
	       "the computes with /chunk in their names sum over the particles of each chunk.\n\n"
	       "Bins along an axis are delta wide; one of them begins at the origin, and they reach just "
	       "beyond the box, or\n"
	       "the `bound` of that axis. In 2d and 3d the last axis counts fastest. Shells of spheres and "
	       "cylinders divide\n"
	       "rmin to rmax evenly; of cylinders the bins along the axis count fastest, and c1 c2 are the "
	       "centre along\n"
	       "the other two axes in alphabetical order. Coordinates across periodic faces are wrapped "
	       "first. Particles\n"
	       "beyond the bins are in the nearest one, but with `discard yes`, or beyond a `bound`, in "
	       "none.\n\n"
	       "With `compress yes` the chunks that have particles are numbered from 1. `limit` says how "
	       "many chunks there are\n"
	       "at most or exactly; of bins only together with `compress yes`; particles of chunks beyond it "
	       "are in none, with\n"
	       "`discard no` in the last.",
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
