#include "bond/bond_reference.h"
#include "core/life.h"

#include "base/banned.h"

struct style_line {
	struct ts_words words;
};

static enum ts_status choose_bond_style(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct style_line *line = state;

	struct ts_instance *bond;

	TS_TRY(ts_sim_choose(sim, TS_KIND_BOND, line->words, where));
	bond = ts_sim_only(sim, TS_KIND_BOND);
	if (bond && ts_bond_style_of(bond)->chosen)
		TS_TRY(ts_bond_style_of(bond)->chosen(bond, sim));
	return ts_bond_reference_require(sim);
}

static const struct ts_arg args[] = {
	TS_REST("style", struct style_line, words, .help = "a bond style and its arguments, or none"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_bond_style)
const struct ts_command_style ts_command_bond_style = {
	.style = { .name = "bond_style",
		   .kind = TS_KIND_COMMAND,
		   .summary = "sets the bond style",
		   .doc = "Sets the force law of all bonds. An earlier bond style and its coefficients are "
			  "discarded. Lengths that it gave to bonds (bond_style harmonic) are "
			  "discarded as well: the rest length is again the distance when the bond "
			  "was created. Without a bond style bonds exert no force. A bond that extends over "
			  "half a periodic box is an error, as it is ambiguous which image of the partner it "
			  "holds.",
		   .example = "bond_style contact",
		   .args = args,
		   .state_size = sizeof(struct style_line) },
	.run = choose_bond_style,
};
