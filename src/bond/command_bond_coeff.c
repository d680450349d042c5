#include "bond/bond_force.h"

#include "base/banned.h"

struct bond_coeff {
	struct ts_types types;
	struct ts_words words;
};

static enum ts_status set_bond_coeff(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct bond_coeff *c = state;

	return ts_bond_set_coeffs(sim, c->types, c->words, where);
}

static const struct ts_arg args[] = {
	TS_TYPES("T", struct bond_coeff, types, .flags = TS_POSITIONAL, .help = "bond types"),
	TS_REST_OPTIONAL("coefficients", struct bond_coeff, words,
			 .help = "keywords and values as the bond style defines them, or `file NAME`"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_bond_coeff)
const struct ts_command_style ts_command_bond_coeff = {
	.style = { .name = "bond_coeff",
		   .kind = TS_KIND_COMMAND,
		   .summary = "sets the coefficients of a bond type",
		   .doc = "The keywords and their values are those of the current bond style, which must be "
			  "set before; `file NAME` reads them from a file of keyword-value lines.",
		   .example = "bond_coeff 1 stiffness 2.0e5 ultimate 3.0",
		   .args = args,
		   .state_size = sizeof(struct bond_coeff) },
	.run = set_bond_coeff,
};
