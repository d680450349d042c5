/* Command newton: accepted for compatibility. */
#include "core/sim.h"

#include "base/banned.h"

struct state {
	bool pair, bond;
};

static enum ts_status set_newton(struct tsim *sim, void *state, const struct ts_place *where)
{
	(void)where;
	sim->newton_on = ((const struct state *)state)->pair;
	return TS_OK;
}

static const struct ts_arg args[] = {
	TS_BOOL("pair", struct state, pair, .flags = TS_POSITIONAL,
		.help = "on or off: no effect; pair_style gran with tangential history requires off"),
	TS_BOOL("bond", struct state, bond, .flags = TS_POSITIONAL | TS_OPTIONAL,
		.help = "on or off: no effect"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_newton)
const struct ts_command_style ts_command_newton = {
	.style = {
		.name = "newton",
		.kind = TS_KIND_COMMAND,
		.ranks = TS_RANKS_FORMULAS,
		.summary = "Accepted for compatibility; has no effect on results",
		.doc = "In LAMMPS this command sets whether forces between processes are computed once or "
		       "twice. tsim computes each force once, and results do not depend on this command. As "
		       "in LIGGGHTS, pair_style gran with tangential history refuses `newton on`.",
		.example = "newton off",
		.args = args,
		.state_size = sizeof(struct state),
	},
	.run = set_newton,
};
