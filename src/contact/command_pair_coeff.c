#include "contact/pair.h"

#include "base/banned.h"

struct pair_coeff {
	struct ts_types a, b;
	struct ts_words words;
};

static enum ts_status run(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct pair_coeff *c = state;
	const struct ts_instance *pair = ts_sim_only(sim, TS_KIND_PAIR);
	bool named = pair && c->words.n && ts_streq(c->words.word[0].text, pair->style->name);

	return ts_pair_set(sim, c->a, c->b, ts_words_from(c->words, named), where);
}

static const struct ts_arg args[] = {
	TS_TYPES("I", struct pair_coeff, a, .flags = TS_POSITIONAL, .help = "types of one particle"),
	TS_TYPES("J", struct pair_coeff, b, .flags = TS_POSITIONAL, .help = "types of the other particle"),
	TS_REST_OPTIONAL("coefficients", struct pair_coeff, words,
			 .help = "coefficients as the pair style defines them, or `file NAME`"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_pair_coeff)
const struct ts_command_style ts_command_pair_coeff = {
	.style = { .name = "pair_coeff",
		   .kind = TS_KIND_COMMAND,
		   .summary = "sets the coefficients of the contact law for pairs of particle types",
		   .doc = "I and J are types or ranges of types (*, 2*, *3, 1*3). The coefficients are "
			  "defined by the pair style, whose name may stand in front of them, as behind "
			  "LAMMPS' pair_style hybrid. `file NAME` reads keyword-value lines from the file "
			  "NAME, which is searched for in the working folder, in the folder TSIM_POTENTIALS "
			  "and among the installed potentials.",
		   .example = "pair_coeff * * stiffness 2.0e5 restitution 0.5",
		   .args = args,
		   .ranks = TS_RANKS_FORMULAS,
		   .state_size = sizeof(struct pair_coeff) },
	.needs_box = true,
	.run = run,
};
