#include "contact/pair.h"
#include "core/life.h"
#include "core/unsupported_names.h"

#include "base/banned.h"

struct style_line {
	struct ts_words words;
};

/* LAMMPS' `hybrid STYLE arguments`: with one style it is that style; all pairs have one contact law here. */
static enum ts_status only_style(struct tsim *sim, struct ts_words *words, const struct ts_place *where)
{
	if (!ts_streq(words->word[0].text, "hybrid") && !ts_streq(words->word[0].text, "hybrid/overlay"))
		return TS_OK;
	if (words->n < 2)
		return ts_fail(&sim->error, TS_SYNTAX, where,
			       "pair_style %s: expected a pair style behind it", words->word[0].text);
	for (size_t k = 2; k < words->n; k++) {
		const char *word = words->word[k].text;

		if (ts_style_find(sim->tables, TS_KIND_PAIR, word) || ts_unsupported_find(TS_KIND_PAIR, word))
			return ts_fail(&sim->error, TS_SYNTAX, &words->word[k].place,
				       "pair_style %s: a second style, '%s', but all pairs have the same "
				       "contact law; its coefficients can differ by types (pair_coeff, fix "
				       "property/global)",
				       words->word[0].text, word);
	}
	*words = ts_words_from(*words, 1);
	return TS_OK;
}

static enum ts_status run(struct tsim *sim, void *state, const struct ts_place *where)
{
	struct ts_words words = ((const struct style_line *)state)->words;
	struct ts_instance *pair;

	TS_TRY(only_style(sim, &words, where));
	TS_TRY(ts_sim_choose(sim, TS_KIND_PAIR, words, where));
	pair = ts_sim_only(sim, TS_KIND_PAIR);
	if (!pair || !ts_pair_style_of(pair)->chosen)
		return TS_OK;
	return ts_pair_style_of(pair)->chosen(pair, sim);
}

static const struct ts_arg args[] = {
	TS_REST("style", struct style_line, words, .help = "a pair style and its arguments, or none"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_pair_style)
const struct ts_command_style ts_command_pair_style = {
	.style = { .name = "pair_style",
		   .kind = TS_KIND_COMMAND,
		   .summary = "chooses the contact law between particles",
		   .doc = "Replaces the present pair style and its coefficients. Without a pair style there "
			  "are no contact forces between particles; `none` removes the present one. `hybrid` "
			  "and `hybrid/overlay` of LAMMPS are accepted in front of one pair style, without "
			  "effect.",
		   .example = "pair_style spring/dashpot",
		   .args = args,
		   .ranks = TS_RANKS_FORMULAS,
		   .state_size = sizeof(struct style_line) },
	.run = run,
};
