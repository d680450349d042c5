/* Command read_restart: reads the state of a simulation from a restart file. */
#include "core/sim.h"
#include "io/series.h"
#include "restart/restart.h"

#include <inttypes.h>

#include "particle/division.h"
#include "particle/particles.h"

#include "base/banned.h"

struct state {
	const char *file;
	bool remap;
};

static enum ts_status read_and_log(struct tsim *sim, const char *path, const struct ts_place *where)
{
	ts_log(&sim->log, "Reading restart file %s ...\n", path);
	TS_TRY(ts_restart_read(sim, path, where));
	ts_log(&sim->log, "  step %" PRId64 ", %zu atoms\n", sim->clock.step,
	       (size_t)ts_division_sum(sim, (int64_t)sim->particles->n));
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
		status = read_and_log(sim, series.file[series.n - 1].path, where);
	ts_series_release(&series);
	return status;
}

static const struct ts_arg args[] = {
	TS_WORD("file", struct state, file, .flags = TS_POSITIONAL,
		.help = "file of write_restart or restart; a name with `*` stands for the file with the "
			"largest number there"),
	TS_FLAG("remap", struct state, remap,
		.help = "no effect: particles are always wrapped into a periodic box"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_read_restart)
const struct ts_command_style ts_command_read_restart = {
	.style = {
		.name = "read_restart",
		.kind = TS_KIND_COMMAND,
		.summary = "Reads the state of a simulation from a restart file",
		.doc = "Replaces create_box. Box, particles, groups, bonds, contacts, clock, and units are "
		       "restored at once. The script defines its styles again; each style whose kind, name "
		       "and ID match gets its state back, including the coefficients of pair and bond styles. "
		       "A pair or bond style that is not defined again when a run begins is that of the file, "
		       "unless the script says `pair_style none`. A damaged file is an error and changes nothing.",
		.example = "read_restart rock.restart\nread_restart rock.*.restart",
		.args = args,
		.state_size = sizeof(struct state),
	},
	.run = run,
};
