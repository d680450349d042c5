/* Command fix_modify: whether the energy of a fix is part of pe, and options of single fixes. */
#include "core/sim.h"

#include "base/banned.h"

struct state {
	const char *id;
	struct ts_words words;
};

typedef enum ts_status answer_fn(struct tsim *sim, struct ts_instance *fix, const struct ts_word *answer);

static enum ts_status read_yes_or_no(struct tsim *sim, const struct ts_word *word, bool *out)
{
	*out = ts_streq(word->text, "yes");
	if (*out || ts_streq(word->text, "no"))
		return TS_OK;
	return ts_fail(&sim->error, TS_SYNTAX, &word->place, "fix_modify: found '%s', expected yes or no",
		       word->text);
}

static enum ts_status set_energy(struct tsim *sim, struct ts_instance *fix, const struct ts_word *answer)
{
	bool yes;

	TS_TRY(read_yes_or_no(sim, answer, &yes));
	if (yes && !fix->style->energy)
		ts_warn(&sim->log, &answer->place,
			"fix_modify: `energy yes` has no effect: fix %s has no potential energy that could "
			"be counted",
			fix->style->name);
	fix->counts_energy = yes && fix->style->energy;
	return TS_OK;
}

static enum ts_status set_virial(struct tsim *sim, struct ts_instance *fix, const struct ts_word *answer)
{
	bool yes;

	TS_TRY(read_yes_or_no(sim, answer, &yes));
	if (!yes)
		return TS_OK;
	return ts_fail(&sim->error, TS_RANGE, &answer->place,
		       "fix_modify: pressures are of contacts, bonds and motion; fix %s has no part in them",
		       fix->style->name);
}

/* No effect: degrees of freedom are counted whenever a temperature is computed. */
static enum ts_status accept_dynamic(struct tsim *sim, struct ts_instance *fix, const struct ts_word *answer)
{
	bool ignored;

	(void)fix;
	return read_yes_or_no(sim, answer, &ignored);
}

/* No effect: there is one time step, no r-RESPA levels. */
static enum ts_status accept_respa(struct tsim *sim, struct ts_instance *fix, const struct ts_word *answer)
{
	int64_t level;

	(void)fix;
	if (ts_parse_int(answer->text, &level) && level >= 0)
		return TS_OK;
	return ts_fail(&sim->error, TS_SYNTAX, &answer->place,
		       "fix_modify: respa is '%s', expected an integer >= 0", answer->text);
}

static enum ts_status refuse_other_compute(struct tsim *sim, struct ts_instance *fix,
					   const struct ts_word *answer)
{
	return ts_fail(&sim->error, TS_RANGE, &answer->place,
		       "fix_modify: fix %s takes no temperature or pressure from another compute",
		       fix->style->name);
}

static const struct {
	const char *name;
	answer_fn *take;
} common[] = {
	{ "energy", set_energy },	   { "virial", set_virial },  { "dynamic", accept_dynamic },
	{ "dynamic/dof", accept_dynamic }, { "respa", accept_respa }, { "temp", refuse_other_compute },
	{ "press", refuse_other_compute },
};
enum { NCOMMON = sizeof common / sizeof *common };

static enum ts_status fail_unknown_option(struct tsim *sim, const struct ts_instance *fix,
					  const struct ts_word *word)
{
	struct ts_suggest suggest = ts_suggest_start(word->text);

	for (int k = 0; k < NCOMMON; k++)
		ts_suggest_try(&suggest, common[k].name);
	return ts_fail(&sim->error, TS_UNKNOWN, &word->place, "fix_modify: fix %s has no word '%s'%s",
		       fix->style->name, word->text, ts_suggest_text(&suggest));
}

/* Applies the option at the start of `words`; *used: how many words it has. */
static enum ts_status apply_option(struct tsim *sim, struct ts_instance *fix, struct ts_words words,
				   size_t *used)
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
		return fail_unknown_option(sim, fix, word);
	if (words.n < 2)
		return ts_fail(&sim->error, TS_SYNTAX, &word->place, "fix_modify: %s lacks its value",
			       word->text);
	*used = 2;
	return common[k].take(sim, fix, &word[1]);
}

static enum ts_status run_fix_modify(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct state *s = state;
	const struct ts_word id = { .text = s->id, .place = *ts_sim_word(sim, 1, where) };
	struct ts_words rest = s->words;
	struct ts_instance *fix;
	size_t used;

	TS_TRY(ts_sim_require(sim, TS_KIND_FIX, &id, &fix));
	for (; rest.n; rest = ts_words_from(rest, used))
		TS_TRY(apply_option(sim, fix, rest, &used));
	return TS_OK;
}

static const struct ts_arg args[] = {
	TS_WORD("id", struct state, id, .flags = TS_POSITIONAL, .help = "name of the fix"),
	TS_REST("words", struct state, words,
		.help = "energy yes|no, virial no, dynamic/dof yes|no, respa N, or options of this fix"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_fix_modify)
const struct ts_command_style ts_command_fix_modify = {
	.style = {
		.name = "fix_modify",
		.kind = TS_KIND_COMMAND,
		.summary = "Changes options of a fix",
		.doc = "energy yes: the potential energy of the fix (gravity, addforce, spring, spring/self) "
		       "is part of\n"
		       "the thermo keywords pe and etotal and of compute pe; by default it is not. "
		       "dynamic/dof and respa\n"
		       "have no effect: degrees of freedom are counted whenever a temperature is computed, "
		       "and all forces\n"
		       "have the same time step. virial yes, temp and press are refused: pressures have "
		       "contributions of\n"
		       "contacts, bonds and motion, and no fix takes a temperature or a pressure from another "
		       "compute.\n"
		       "Further options are described on the pages of the fixes that have them.",
		.example = "fix_modify fall energy yes",
		.args = args,
		.state_size = sizeof(struct state),
	},
	.run = run_fix_modify,
};
