/* Fix ave/chunk: averages over the particles of chunks and over time. */
#include "average/chunk_average.h"

#include "base/banned.h"

struct state {
	struct ts_chunk_average common;
	const char *chunk_id;
};

static enum ts_status source(struct ts_instance *self, struct tsim *sim, struct ts_instance **owner,
			     struct ts_chunks **chunks)
{
	return ts_chunks_find(sim, self, ((struct state *)self->state)->chunk_id, owner, chunks);
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;
	struct ts_instance *owner;
	struct ts_chunks *chunks;

	s->common.source = source;
	TS_TRY(source(self, sim, &owner, &chunks));
	return ts_chunk_average_init(self, sim);
}

static const struct ts_arg window_row[] = { TS_AVERAGE_WINDOW_ROW(struct state, common.average),
					    TS_ARGS_END };
static const struct ts_mode combinations[] = TS_AVERAGE_MODES;

static const struct ts_arg args[] = {
	TS_AVERAGE_STEPS(struct state, common.average),
	TS_WORD("chunkID", struct state, chunk_id, .flags = TS_POSITIONAL | TS_STATEFUL,
		.help = "ID of the compute chunk/atom"),
	TS_LIST_STATEFUL("values", struct state, common.words,
			 .help = "vx, fx, mass ..., density/number, density/mass, temp, temp/granular, c_ID, "
				 "c_ID[k], c_ID[*], f_ID, f_ID[k] or v_name"),
	TS_CHUNK_AVERAGE_KEYWORDS(struct state),
	TS_AVERAGE_KEYWORDS(struct state, common.average),
	TS_AVERAGE_FILE_ARGS(struct state, common.file),
	TS_ARGS_END,
};

static const struct ts_saved saved[] = {
	TS_AVERAGE_SAVED(struct state, common.average),
	TS_CHUNK_AVERAGE_SAVED(struct state),
	TS_SAVED_ROWS_END,
};

static const struct ts_arg_group groups[] = {
	{ NULL, "Nevery Nrepeat Nfreq chunkID values norm ave file" },
	{ "Times and degrees of freedom", "start adof cdof" },
	TS_AVERAGE_FILE_GROUP,
	{ .words = NULL },
};

TS_STYLE(fix, ts_style, ts_fix_ave_chunk)
const struct ts_style ts_fix_ave_chunk = {
	.name = "ave/chunk",
	.kind = TS_KIND_FIX,
	.ranks = TS_RANKS_WHOLE | TS_RANKS_PARTICLES,
	.due = ts_average_waits,
	.summary = "Averages over chunks of particles and over time",
	.doc = "Calculates every Nfreq steps, from Nrepeat samples taken Nevery steps apart, the last at that step, for each chunk of compute chunk/atom the mean of each value over the particles of the group in it. density/number and density/mass are number and mass of the particles divided by the volume of the bin (of the box, for chunks that are not bins); temp is the temperature\n\n"
	       "    T = sum m v^2 / (k_B (adof N + cdof))\n\n"
	       "and temp/granular the granular temperature |v - u|^2/D in velocity^2, with u the mean velocity of the particles of the chunk in each sample and D the dimension (compute temp/granular).\n\n"
	       "`norm all` divides the sums over all samples by the number of particles in all samples; `norm sample` divides the sums of each sample by its number of particles and averages the quotients; `norm none` divides by the number of samples only; temp and temp/granular, which are quotients themselves, are then those of `norm sample`. `ave` combines successive averages.\n\n"
	       "The file has a block for each average: a line with step, number of chunks and total count, then for each chunk its number, with compress its original number, its coordinates, mean count, and values. f_ID[i][j] are the columns after the chunk number. Sums over particles are exact and rounded once; averages in progress are saved in restart files.",
	.example = "compute layers all chunk/atom bin/1d z lower 0.01 units box\n"
		   "fix profile all ave/chunk 10 10 1000 layers vx density/mass temp file post/profile.txt",
	.args = args,
	.groups = groups,
	.state_size = sizeof(struct state),
	.saved = saved,
	.archive = ts_chunk_average_archive,
	.values = ts_chunk_average_values,
	.init = init,
	.hook = {
		[TS_STAGE_SETUP] = ts_chunk_average_setup,
		[TS_STAGE_END_OF_STEP] = ts_chunk_average_sample,
	},
	.fini = ts_chunk_average_fini,
};
