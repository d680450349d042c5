/* Command comm_modify: accepted for compatibility. */
#include "box/comm.h"

#include "base/banned.h"

struct state {
	struct ts_comm comm;
};

static enum ts_status run(struct tsim *sim, void *state, const struct ts_place *where)
{
	return ts_comm_accept(sim, &((const struct state *)state)->comm, where);
}

static const struct ts_arg args[] = {
	TS_ENUM("mode", struct state, comm.mode, ts_comm_modes, .fallback = "single",
		.help = TS_COMM_MODE_HELP),
	TS_COMM_ROWS(struct state),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_comm_modify)
const struct ts_command_style ts_command_comm_modify = {
	.style = {
		.name = "comm_modify",
		.kind = TS_KIND_COMMAND,
		.summary = "Accepted for compatibility; has no effect",
		.doc = "Elsewhere it says how processes exchange ghost particles. Here there is one process; "
		       "ghosts are\n"
		       "images across periodic faces, always carry velocities, and reach as far as the "
		       "contacts need,\n"
		       "so no word of it changes a result.",
		.example = "comm_modify mode single vel yes",
		.args = args,
		.state_size = sizeof(struct state),
	},
	.run = run,
};
