/* Command read_restart: continues from a saved state. */
#include "core/sim.h"
#include "io/series.h"
#include "restart/restart.h"

#include <inttypes.h>

#include "particle/particles.h"

#include "base/banned.h"

struct state {
	const char *file;
	bool remap;
};

static enum ts_status read_path(struct tsim *sim, const char *path, const struct ts_place *where)
{
	ts_log(&sim->log, "Reading restart file %s ...\n", path);
	TS_TRY(ts_restart_read(sim, path, where));
	ts_log(&sim->log, "  step %" PRId64 ", %zu atoms\n", sim->clock.step, sim->particles->n);
	return TS_OK;
}

static enum ts_status run(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct state *s = state;
	struct ts_series series = { 0 };
	enum ts_status status = ts_series_find(&sim->files, s->file, &series);

	if (status != TS_OK)
		status = ts_nomem(&sim->error);
	else if (!series.n)
		status = ts_fail(&sim->error, TS_IO, where,
				 "there is no restart file with a number for the * of '%s'", s->file);
	else
		status = read_path(sim, series.file[series.n - 1].path, where);
	ts_series_release(&series);
	return status;
}

static const struct ts_arg args[] = {
	TS_WORD("file", struct state, file, .flags = TS_POSITIONAL,
		.help = "a file made by write_restart or restart; of a name with `*` the one with the "
			"largest number there"),
	TS_FLAG("remap", struct state, remap,
		.help = "no effect: particles are put into a periodic box in any case"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_read_restart)
const struct ts_command_style ts_command_read_restart = {
	.style = {
		.name = "read_restart",
		.kind = TS_KIND_COMMAND,
		.summary = "Continues from a saved state",
		.doc = "Takes the place of create_box. Restored at once: box, particles, groups, bonds, "
		       "contacts, clock,\n"
		       "units. The script defines styles again; each whose kind, style and id match gets its "
		       "state\n"
		       "back, coefficients of pairs and bonds included. A damaged file is refused and "
		       "changes nothing.",
		.example = "read_restart rock.restart\nread_restart rock.*.restart",
		.args = args,
		.state_size = sizeof(struct state),
	},
	.run = run,
};
