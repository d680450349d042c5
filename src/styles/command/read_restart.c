/* Command read_restart: continues from a saved state. */
#include "core/sim.h"
#include "io/restart.h"

#include <inttypes.h>

#include "particles/particles.h"

#include "base/banned.h"

struct state {
	const char *file;
};

static enum ts_status run(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct state *s = state;

	ts_log(&sim->log, "Reading restart file ...\n");
	TS_TRY(ts_restart_read(sim, s->file, where));
	ts_log(&sim->log, "  step %" PRId64 ", %zu atoms\n", sim->clock.step, sim->particles->n);
	return TS_OK;
}

static const struct ts_arg args[] = {
	TS_WORD("file", struct state, file, .flags = TS_POSITIONAL,
		.help = "a file made by write_restart or restart"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_read_restart)
const struct ts_command_style ts_command_read_restart = {
	.style = {
		.name = "read_restart",
		.kind = TS_KIND_COMMAND,
		.summary = "Continues from a saved state",
		.doc = "Takes the place of create_box. Restored at once: box, particles, groups, bonds, contacts, clock,\n"
		       "units. The script defines styles again; each whose kind, style and id match gets its state\n"
		       "back, coefficients of pairs and bonds included. A damaged file is refused and changes nothing.",
		.example = "read_restart rock.restart",
		.args = args,
		.state_size = sizeof(struct state),
	},
	.run = run,
};
