/* Command reset_timestep: sets the step counter. */
#include "core/sim.h"

#include "bond/bonds.h"
#include "dump/dump.h"
#include "thermo/thermo.h"

#include "base/banned.h"

struct state {
	int64_t step;
	double time;
};

/* Fixes that sample at fixed intervals, such as ave/..., store the step of their next sample. */
static bool samples_by_step(const struct ts_instance *fix)
{
	for (const struct ts_arg *row = fix->style->args; row && row->type != TS_ARG_END; row++)
		if (row->type == TS_ARG_INT && row->flags & TS_STATEFUL)
			return true;
	return false;
}

/* Files of which a frame at an earlier step would replace others. */
static enum ts_status refuse_ordered_files(struct tsim *sim, int64_t step, const struct ts_place *where)
{
	const struct ts_instances *dumps = &sim->instances[TS_KIND_DUMP];

	for (size_t k = 0; k < dumps->n; k++) {
		const struct ts_dump_common *d = dumps->item[k]->state;

		if (d->in_order && d->frames && step <= d->last)
			return ts_fail(&sim->error, TS_STATE, where,
				       "dump %s (%s:%d): frames of its file are in the order of their steps, "
				       "and that of step %lld would replace those from there on: undump it "
				       "before reset_timestep, and write to another file",
				       dumps->item[k]->id, TS_FILE_AND_LINE(dumps->item[k]->where),
				       (long long)step);
	}
	return TS_OK;
}

/* Dumps may write a frame at the new step even if they have written one of this number. */
static void clear_last_frames(struct tsim *sim)
{
	const struct ts_instances *dumps = &sim->instances[TS_KIND_DUMP];

	for (size_t k = 0; k < dumps->n; k++)
		((struct ts_dump_common *)dumps->item[k]->state)->last = -1;
}

static enum ts_status run(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct state *s = state;
	double time = isnan(s->time) ? (double)s->step * sim->clock.dt : s->time;

	for (size_t k = 0; k < sim->instances[TS_KIND_FIX].n; k++) {
		const struct ts_instance *fix = sim->instances[TS_KIND_FIX].item[k];

		if (samples_by_step(fix))
			return ts_fail(&sim->error, TS_STATE, where,
				       "fix %s (%s, %s:%d) counts steps: unfix it before reset_timestep",
				       fix->id, fix->style->name, TS_FILE_AND_LINE(fix->where));
		if (fix->style->moves_by_time && fix->style->moves_by_time(fix) && time != ts_sim_time(sim))
			return ts_fail(&sim->error, TS_STATE, where,
				       "fix %s (%s, %s:%d) moves by the time since its definition, now %g: "
				       "unfix it before reset_timestep, or keep the time: `reset_timestep "
				       "%lld time $(time)`",
				       fix->id, fix->style->name, TS_FILE_AND_LINE(fix->where),
				       ts_sim_time(sim), (long long)s->step);
	}
	TS_TRY(refuse_ordered_files(sim, s->step, where));
	if (s->step != sim->clock.step) {
		clear_last_frames(sim);
		sim->continued =
			false; /* its steps are no longer those of the run that wrote the restart file */
		sim->bonds->past_events = sim->bonds->nevents;
		sim->thermo->counted = 0;
	}
	if (s->step != sim->clock.step || time != ts_sim_time(sim)) {
		sim->era++;
		sim->clock.resets++;
	}
	sim->clock.step = sim->clock.base_step = s->step;
	sim->clock.base_time = time;
	return TS_OK;
}

static const struct ts_arg args[] = {
	TS_INT("step", struct state, step, .flags = TS_POSITIONAL | TS_CUT, .range = TS_NOT_NEGATIVE,
	       .help = "new value of the step counter; of a number with a fraction the whole part"),
	TS_REAL("time", struct state, time, .flags = TS_OPTIONAL, .unit = "time",
		.help = "new simulated time; default: step times dt"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_reset_timestep)
const struct ts_command_style ts_command_reset_timestep = {
	.style = {
		.name = "reset_timestep",
		.kind = TS_KIND_COMMAND,
		.summary = "Sets the step counter",
		.doc = "Sets the step counter. The simulated time is set to step times dt unless it is given. "
		       "It is an error if there are fixes that average or sample over steps, such as fix "
		       "ave/time, or if the time changes and there are fixes whose motion is a function of "
		       "it, such as fix move, or fix wall/gran with `wiggle`. The next run computes all forces "
		       "anew, as in LIGGGHTS and LAMMPS: those of dashpots from the velocities at the end of the "
		       "last step, not from those half a step before.",
		.example = "reset_timestep 0\n"
			   "reset_timestep 0 time $(time)",
		.args = args,
		.state_size = sizeof(struct state),
	},
	.run = run,
};
