/* Fix ave/spatial: averages over spatial bins and over time. */
#include "average/chunk_average.h"

#include "particle/particles.h"

#include "base/banned.h"

struct state {
	struct ts_chunk_average common;
	struct ts_words words; /* dim origin delta, up to three times, and the values */
	struct ts_chunks chunks;
};

static enum ts_status source(struct ts_instance *self, struct tsim *sim, struct ts_instance **owner,
			     struct ts_chunks **chunks)
{
	(void)sim;
	*owner = self;
	*chunks = &((struct state *)self->state)->chunks;
	return TS_OK;
}

static bool names_axis(const char *word)
{
	return ts_streq(word, "x") || ts_streq(word, "y") || ts_streq(word, "z");
}

/* Splits the arguments into those of the bins and the values. */
static enum ts_status split_bins_and_values(struct ts_instance *self, struct tsim *sim)
{
	static const char *const styles[] = { "bin/1d", "bin/2d", "bin/3d" };
	struct state *s = self->state;
	struct ts_word style = { .place = s->words.word[0].place };
	size_t axes = 0;

	while (axes < 3 && 3 * axes < s->words.n && names_axis(s->words.word[3 * axes].text))
		axes++;
	if (axes == 0 || 3 * axes >= s->words.n)
		return ts_fail(&sim->error, TS_SYNTAX, axes ? &self->where : &s->words.word[0].place,
			       axes ? "fix ave/spatial: no value is named"
				    : "fix ave/spatial: expected x, y or z");
	style.text = styles[axes - 1];
	if (ts_words_join(&self->arena, (struct ts_words){ &style, 1 },
			  (struct ts_words){ s->words.word, 3 * axes }, &s->chunks.words) != TS_OK)
		return ts_nomem(&sim->error);
	s->common.words = ts_words_from(s->words, 3 * axes);
	return TS_OK;
}

static enum ts_status init(struct ts_instance *self, struct tsim *sim)
{
	struct state *s = self->state;

	s->common.source = source;
	s->common.spatial = true;
	if (!s->chunks.words.n)
		TS_TRY(split_bins_and_values(self, sim));
	TS_TRY(ts_chunks_init(self, sim, &s->chunks));
	return ts_chunk_average_init(self, sim);
}

static void fini(struct ts_instance *self)
{
	ts_chunks_release(&((struct state *)self->state)->chunks);
	ts_chunk_average_fini(self);
}

static const struct ts_arg window_row[] = { TS_AVERAGE_WINDOW_ROW(struct state, common.average),
					    TS_ARGS_END };
static const struct ts_mode combinations[] = TS_AVERAGE_MODES;

static const struct ts_arg args[] = {
	TS_AVERAGE_STEPS(struct state, common.average),
	TS_LIST_STATEFUL("bins", struct state, words,
			 .help = "dim origin delta, once to three times; then the values: vx, fx ..., "
				 "density/number, density/mass, c_ID, c_ID[k], f_ID, f_ID[k] or v_name"),
	TS_CHUNK_KEYWORDS(struct state),
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
	{ NULL, "Nevery Nrepeat Nfreq bins norm ave file" },
	{ "The bins", "region discard bound units" },
	{ "Times and degrees of freedom", "start adof cdof" },
	TS_AVERAGE_FILE_GROUP,
	{ .words = NULL },
};

TS_STYLE(fix, ts_style, ts_fix_ave_spatial)
const struct ts_style ts_fix_ave_spatial = {
	.name = "ave/spatial",
	.kind = TS_KIND_FIX,
	.ranks = TS_RANKS_WHOLE | TS_RANKS_PARTICLES,
	.due = ts_average_waits,
	.summary = "Averages over spatial bins and over time",
	.doc = "As fix ave/chunk with the bins of compute chunk/atom bin/1d, bin/2d or bin/3d, in the syntax of LIGGGHTS and older versions of LAMMPS. Particles outside the bins count in the nearest bin, but outside a `bound` in none. The file has a block for each average: a line with step and number of bins, then for each bin its number, coordinates, mean count, and values; f_ID[i][j] are the columns from the coordinates on.",
	.example = "fix profile all ave/spatial 10 10 1000 z lower 0.01 vx density/mass units box file post/p.txt",
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
	.fini = fini,
};
