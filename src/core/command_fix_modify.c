/* Command fix_modify: what counts of a fix, and words that are its own. */
#include "core/sim.h"

#include "base/banned.h"

struct state {
	const char *id;
	struct ts_words words;
};

typedef enum ts_status answer_fn(struct tsim *sim, struct ts_instance *fix, const struct ts_word *answer);

static enum ts_status read_answer(struct tsim *sim, const struct ts_word *word, bool *out)
{
	*out = ts_streq(word->text, "yes");
	if (*out || ts_streq(word->text, "no"))
		return TS_OK;
	return ts_fail(&sim->error, TS_SYNTAX, &word->place, "fix_modify: found '%s', expected yes or no",
		       word->text);
}

static enum ts_status energy(struct tsim *sim, struct ts_instance *fix, const struct ts_word *answer)
{
	bool yes;

	TS_TRY(read_answer(sim, answer, &yes));
	if (yes && !fix->style->energy)
		return ts_fail(&sim->error, TS_RANGE, &answer->place,
			       "fix_modify: fix %s has no potential energy that could be counted",
			       fix->style->name);
	fix->counts_energy = yes;
	return TS_OK;
}

static enum ts_status virial(struct tsim *sim, struct ts_instance *fix, const struct ts_word *answer)
{
	bool yes;

	TS_TRY(read_answer(sim, answer, &yes));
	if (!yes)
		return TS_OK;
	return ts_fail(&sim->error, TS_RANGE, &answer->place,
		       "fix_modify: pressures are of contacts, bonds and motion; fix %s has no part in them",
		       fix->style->name);
}

/* The number of degrees of freedom is counted anew whenever a temperature is taken. */
static enum ts_status dynamic(struct tsim *sim, struct ts_instance *fix, const struct ts_word *answer)
{
	bool ignored;

	(void)fix;
	return read_answer(sim, answer, &ignored);
}

/* There are no levels of time steps. */
static enum ts_status respa(struct tsim *sim, struct ts_instance *fix, const struct ts_word *answer)
{
	int64_t level;

	(void)fix;
	if (ts_parse_int(answer->text, &level) && level >= 0)
		return TS_OK;
	return ts_fail(&sim->error, TS_SYNTAX, &answer->place,
		       "fix_modify: respa is '%s', expected an integer >= 0", answer->text);
}

static enum ts_status other_compute(struct tsim *sim, struct ts_instance *fix, const struct ts_word *answer)
{
	return ts_fail(&sim->error, TS_RANGE, &answer->place,
		       "fix_modify: fix %s takes no temperature or pressure from another compute",
		       fix->style->name);
}

static const struct {
	const char *name;
	answer_fn *take;
} common[] = {
	{ "energy", energy },	    { "virial", virial }, { "dynamic", dynamic },
	{ "dynamic/dof", dynamic }, { "respa", respa },	  { "temp", other_compute },
	{ "press", other_compute },
};
enum { NCOMMON = sizeof common / sizeof *common };

static enum ts_status unknown(struct tsim *sim, const struct ts_instance *fix, const struct ts_word *word)
{
	struct ts_suggest suggest = ts_suggest_start(word->text);

	for (int k = 0; k < NCOMMON; k++)
		ts_suggest_try(&suggest, common[k].name);
	return ts_fail(&sim->error, TS_UNKNOWN, &word->place, "fix_modify: fix %s has no word '%s'%s",
		       fix->style->name, word->text, ts_suggest_text(&suggest));
}

/* The first words, which belong together; *used of them. */
static enum ts_status modify(struct tsim *sim, struct ts_instance *fix, struct ts_words words, size_t *used)
{
	const struct ts_word *word = words.word;
	int k = 0;

	*used = 0;
	if (fix->style->modify)
		TS_TRY(fix->style->modify(fix, sim, words, used));
	if (*used)
		return TS_OK;
	while (k < NCOMMON && !ts_streq(common[k].name, word->text))
		k++;
	if (k == NCOMMON)
		return unknown(sim, fix, word);
	if (words.n < 2)
		return ts_fail(&sim->error, TS_SYNTAX, &word->place, "fix_modify: %s lacks its value",
			       word->text);
	*used = 2;
	return common[k].take(sim, fix, &word[1]);
}

static enum ts_status run(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct state *s = state;
	const struct ts_word id = { .text = s->id, .place = *ts_sim_word(sim, 1, where) };
	struct ts_words rest = s->words;
	struct ts_instance *fix;
	size_t used;

	TS_TRY(ts_sim_require(sim, TS_KIND_FIX, &id, &fix));
	for (; rest.n; rest = ts_words_from(rest, used))
		TS_TRY(modify(sim, fix, rest, &used));
	return TS_OK;
}

static const struct ts_arg args[] = {
	TS_WORD("id", struct state, id, .flags = TS_POSITIONAL, .help = "name of the fix"),
	TS_REST("words", struct state, words,
		.help = "energy yes|no, virial no, dynamic/dof yes|no, respa N, or words of the fix itself"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_fix_modify)
const struct ts_command_style ts_command_fix_modify = {
	.style = {
		.name = "fix_modify",
		.kind = TS_KIND_COMMAND,
		.summary = "Whether the energy of a fix counts, and words of the fix itself",
		.doc = "energy yes: the potential energy of the fix (gravity, addforce, spring, spring/self) "
		       "is part\n"
		       "of pe, etotal and compute pe; from the start it is not. dynamic/dof and respa have "
		       "no effect:\n"
		       "degrees of freedom are counted whenever a temperature is taken, and there is one "
		       "time step.\n"
		       "virial yes, temp and press are refused: pressures are of contacts, bonds and motion, "
		       "and no\n"
		       "fix takes a temperature or a pressure from another compute. What else there is, the "
		       "pages of\n"
		       "the fixes say.",
		.example = "fix_modify fall energy yes",
		.args = args,
		.state_size = sizeof(struct state),
	},
	.run = run,
};
