/* Command run_style: accepted for compatibility. */
#include "core/sim.h"

#include "base/banned.h"

struct state {
	int style;
};

static const char *const styles[] = { "verlet", NULL };

static const struct ts_arg args[] = {
	TS_ENUM("style", struct state, style, styles, .flags = TS_POSITIONAL,
		.help = "verlet: no effect; the fixes that integrate (nve ...) select the scheme"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_run_style)
const struct ts_command_style ts_command_run_style = {
	.style = {
		.name = "run_style",
		.kind = TS_KIND_COMMAND,
		.ranks = TS_RANKS_FORMULAS,
		.summary = "Accepted for compatibility; has no effect",
		.doc = "In LAMMPS this command selects the time integrator, velocity Verlet by default. In tsim the fixes "
		       "that integrate do so. Steps of several lengths (respa) are not supported.",
		.example = "run_style verlet",
		.args = args,
		.state_size = sizeof(struct state),
	},
};
