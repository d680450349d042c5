/* Command box: accepted for compatibility. */
#include "core/sim.h"

#include "base/banned.h"

struct state {
	int tilt;
};

static const char *const tilts[] = { "small", "large", NULL };

static const struct ts_arg args[] = {
	TS_ENUM("tilt", struct state, tilt, tilts, .flags = TS_OPTIONAL,
		.help = "no effect: the box is orthogonal"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_box)
const struct ts_command_style ts_command_box = {
	.style = {
		.name = "box",
		.kind = TS_KIND_COMMAND,
		.summary = "Accepted for compatibility; has no effect",
		.doc = "In LAMMPS this command sets properties of triclinic boxes. The box of tsim is always "
		       "orthogonal.",
		.example = "box tilt large",
		.args = args,
		.state_size = sizeof(struct state),
	},
};
