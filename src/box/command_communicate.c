/* Command communicate: accepted for compatibility. */
#include "box/comm.h"

#include "base/banned.h"

struct state {
	struct ts_comm comm;
};

static enum ts_status check_arguments(struct tsim *sim, void *state, const struct ts_place *where)
{
	return ts_comm_accept(sim, &((const struct state *)state)->comm, where);
}

static const struct ts_arg args[] = {
	TS_ENUM("mode", struct state, comm.mode, ts_comm_modes, .flags = TS_POSITIONAL,
		.help = TS_COMM_MODE_HELP),
	TS_COMM_ROWS(struct state),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_communicate)
const struct ts_command_style ts_command_communicate = {
	.style = {
		.name = "communicate",
		.kind = TS_KIND_COMMAND,
		.ranks = TS_RANKS_FORMULAS,
		.summary = "Accepted for compatibility; has no effect",
		.doc = "In LAMMPS this command controls how processes exchange ghost particles. In tsim ghosts "
		       "are periodic images, and copies of particles of other ranks; they always carry velocities and "
		       "reach as far as contacts need, so no argument changes a result.",
		.example = "communicate single vel yes",
		.args = args,
		.state_size = sizeof(struct state),
	},
	.run = check_arguments,
};
