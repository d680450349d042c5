/* Command rerun: computes forces and output for the frames of dumps. */
#include "base/clock.h"
#include "bond/bond_reference.h"
#include "core/plan.h"
#include "core/restored_models.h"
#include "io/series.h"
#include "restart/frames.h"

#include <string.h>

#include "base/banned.h"

struct rerun {
	struct ts_words files;
	int64_t first, last, every, skip, start, stop;
	bool post;
	struct ts_frame_use use;
	int64_t seen, done; /* number of frames within first .. last; of those computed */
};

static enum ts_status run_stages(struct ts_plan *plan, struct tsim *sim, enum ts_stage first,
				 enum ts_stage last)
{
	for (int stage = (int)first; stage <= (int)last; stage++)
		TS_TRY(ts_plan_stage(plan, sim, (enum ts_stage)stage));
	return TS_OK;
}

/* Runs the stages of the set-up of a run at the step of the frame, then END_OF_STEP (at the first frame
 * SETUP) and OUTPUT. */
static enum ts_status compute_frame(struct tsim *sim, struct ts_plan *plan, bool first)
{
	TS_TRY(run_stages(plan, sim, TS_STAGE_EXCHANGE, TS_STAGE_POST_BUILD));
	sim->run.in_setup = true;
	TS_TRY(run_stages(plan, sim, TS_STAGE_PRE_FORCE, TS_STAGE_POST_FORCE));
	sim->run.in_setup = false;
	if (first)
		TS_TRY(ts_plan_stage(plan, sim, TS_STAGE_SETUP));
	else
		TS_TRY(ts_plan_stage(plan, sim, TS_STAGE_END_OF_STEP));
	return ts_plan_stage(plan, sim, TS_STAGE_OUTPUT);
}

/* Whether the frame is selected by first, last, every and skip; the first frame is, whatever its step, as in LAMMPS. */
static bool is_selected(struct rerun *c, int64_t step)
{
	if (step < c->first || step > c->last || (c->seen && c->every && step % c->every != 0))
		return false;
	return c->seen++ % c->skip == 0;
}

static enum ts_status apply_and_compute(struct tsim *sim, struct rerun *c, struct ts_plan *plan,
					const struct ts_frames *f, const struct ts_place *where)
{
	bool first = c->done++ == 0;

	sim->clock.step = f->step;
	if (first) {
		sim->clock.first_step = f->step;
		sim->clock.ramp_first = c->start >= 0 ? c->start : f->step;
		sim->clock.ramp_last = sim->clock.last_step;
		sim->clock.elapsed_before = f->step - sim->clock.ramp_first;
		sim->clock.command_step = sim->clock.goal = f->step;
		sim->clock.wall_start = ts_clock();
	}
	TS_TRY(ts_frames_apply(sim, f, &c->use, where));
	return compute_frame(sim, plan, first);
}

static enum ts_status rerun_file(struct tsim *sim, struct rerun *c, struct ts_plan *plan, const char *path,
				 const struct ts_place *where)
{
	struct ts_frames f = { 0 };
	bool got = true;
	enum ts_status status = ts_frames_open(&f, sim, path, where);

	while (status == TS_OK && got && !sim->requests.stop) {
		status = ts_frames_next(&f, &got);
		/* frames that the file before has, too, are left out, as in LAMMPS */
		if (status == TS_OK && got && (!c->done || f.step > sim->clock.step) &&
		    is_selected(c, f.step))
			status = apply_and_compute(sim, c, plan, &f, where);
	}
	ts_frames_close(&f);
	return status;
}

/* One file, or those of a series in the order of their steps. */
static enum ts_status rerun_series(struct tsim *sim, struct rerun *c, struct ts_plan *plan,
				   const struct ts_word *word)
{
	struct ts_series series = { 0 };
	enum ts_status status = ts_series_find(&sim->files, word->text, &series);

	if (status != TS_OK)
		status = ts_nomem(&sim->error);
	else if (!series.n)
		status = ts_fail(&sim->error, TS_IO, &word->place,
				 "rerun: there is no file with a number for the * of '%s'", word->text);
	for (size_t k = 0; k < series.n && status == TS_OK; k++)
		status = rerun_file(sim, c, plan, series.file[k].path, &word->place);
	ts_series_release(&series);
	return status;
}

/* -check, -explain: whether the files are there, and can be read. Those of a series may be written by a run. */
static enum ts_status check_files(struct tsim *sim, const struct rerun *c)
{
	enum ts_status status = TS_OK;

	for (size_t k = 0; k < c->files.n && status == TS_OK; k++) {
		const struct ts_word *word = &c->files.word[k];
		struct ts_frames f = { 0 };

		if (strchr(word->text, '*'))
			continue;
		status = ts_frames_open(&f, sim, word->text, &word->place);
		ts_frames_close(&f);
	}
	return status;
}

/* Frames say nothing of a fluid, and the time between them is not a step. */
static enum ts_status refuse_advancing(struct tsim *sim, const struct ts_place *where)
{
	for (int kind = 0; kind < TS_NKIND; kind++)
		for (size_t k = 0; k < sim->instances[kind].n; k++) {
			const struct ts_instance *inst = sim->instances[kind].item[k];
			const char *what = inst->style->advances ? inst->style->advances(inst) : NULL;

			if (what)
				return ts_fail(&sim->error, TS_STATE, where,
					       "rerun integrates nothing in time, but %s of %s %s (%s:%d) "
					       "would make a time step at each frame, whatever the time "
					       "between frames: leave it out (flow_style none, or a flow "
					       "that is imposed)",
					       what, ts_kind_name((enum ts_kind)kind), inst->style->name,
					       TS_FILE_AND_LINE(inst->where));
		}
	return TS_OK;
}

static enum ts_status rerun_files(struct tsim *sim, struct rerun *c, struct ts_plan *plan,
				  const struct ts_place *where)
{
	enum ts_status status;

	sim->clock.base_step = 0;
	sim->clock.base_time = 0;
	sim->clock.last_step = c->stop >= 0 ? c->stop : INT64_MAX;
	TS_TRY(ts_restore_models(sim));
	TS_TRY(ts_plan_compile(plan, sim));
	TS_TRY(refuse_advancing(sim, where));
	ts_bond_reference_doubt(sim, "rerun", where);
	if (sim->reading.explain)
		return check_files(sim, c);
	sim->run.inside = true;
	status = TS_OK;
	for (size_t k = 0; k < c->files.n && status == TS_OK; k++)
		status = rerun_series(sim, c, plan, &c->files.word[k]);
	if (status == TS_OK)
		status = ts_plan_stage(plan, sim, TS_STAGE_FINISH);
	sim->run.inside = sim->run.in_setup = sim->run.rebuild = false;
	sim->clock.last_step = sim->clock.step;
	sim->clock.elapsed_before = 0;
	sim->run.fingerprint = 0; /* the next run computes all forces again */
	return status == TS_OK ? ts_plan_stopped(sim) : status;
}

static enum ts_status run(struct tsim *sim, void *state, const struct ts_place *where)
{
	struct rerun *c = state;
	struct ts_plan plan = { 0 };
	enum ts_status status;

	c->use.replace = true;
	status = rerun_files(sim, c, &plan, where);
	ts_plan_release(&plan);
	if (status == TS_OK)
		ts_log(&sim->log, "Rerun of %lld frames\n", (long long)c->done);
	return status;
}

#define STEP(name, field, default_, help_) \
	TS_INT(name, struct rerun, field, .fallback = default_, .range = TS_NOT_NEGATIVE, .help = help_)

static const struct ts_arg args[] = {
	TS_LIST("files", struct rerun, files,
		.help = "files of dump atom or dump custom, in the order of their steps; a name with `*` "
			"stands for all files with a number there"),
	STEP("first", first, "0", "frames of earlier steps are skipped"),
	STEP("last", last, "9000000000000000000", "frames of later steps are skipped"),
	STEP("every", every, "0", "only the first frame and those whose step is a multiple of this; 0: all"),
	TS_INT("skip", struct rerun, skip, .fallback = "1", .range = TS_POSITIVE,
	       .help = "use every N-th of the remaining frames, starting with the first"),
	TS_INT("start", struct rerun, start, .fallback = "-1", .range = TS_WITHIN, .lo = -1, .hi = 9e18,
	       .help = "step from which `elapsed` and ramp() count; -1: that of the first frame"),
	TS_INT("stop", struct rerun, stop, .fallback = "-1", .range = TS_WITHIN, .lo = -1, .hi = 9e18,
	       .help = "step that is regarded as the last; -1: none"),
	{ .name = "dump",
	  .type = TS_ARG_REST,
	  .flags = TS_TO_KEYWORD,
	  .offset = TS_FIELD(struct rerun, use.fields, struct ts_words *),
	  .help = "quantities to read from the frames, as in read_dump: x y z vx ..." },
	TS_BOOL("post", struct rerun, post, .fallback = "yes", .help = "no effect: no timings are printed"),
	TS_BOOL("box", struct rerun, use.box, .fallback = "yes",
		.help = "whether the box becomes that of the frame"),
	TS_BOOL("trim", struct rerun, use.trim, .fallback = "no",
		.help = "whether particles that are not in the frame are deleted"),
	TS_BOOL("purge", struct rerun, use.purge, .fallback = "no",
		.help = "whether all particles are deleted first"),
	TS_BOOL("add", struct rerun, use.add, .fallback = "no",
		.help = "whether particles that are only in the frame are created; needs a column type"),
	{ .name = "label",
	  .type = TS_ARG_REST,
	  .flags = TS_OPTIONAL | TS_TO_KEYWORD | TS_REPEAT,
	  .offset = TS_FIELD(struct rerun, use.labels, struct ts_words *),
	  .help = "a quantity and the name of its column in the file" },
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_rerun)
const struct ts_command_style ts_command_rerun = {
	.style = {
		.name = "rerun",
		.kind = TS_KIND_COMMAND,
		.summary = "Computes forces and output for the frames of dumps",
		.doc = "For each frame the quantities of the particles are set from the file, neighbours and "
		       "forces are computed as at the start of a run (contact histories do not evolve), fixes "
		       "that act at the end of a step are invoked, and thermo output and dumps are written "
		       "when they are due. No time integration is done: flow_style projection, and flow_style "
		       "reynolds with `transient yes`, whose fluid follows from the steps before, are refused. "
		       "What moves by an integrator or by `fix move/mesh` stays where it was before the "
		       "command, unless the frames say where it is. Incomplete frames, as left by a run "
		       "that was killed or had a full disk, are skipped with a warning; a .gz file is read up "
		       "to the position where it is cut off. A frame in which a particle id occurs twice is "
		       "an error.",
		.example = "rerun post/rock.dump first 1000 every 500 dump x y z vx vy vz\n"
			   "rerun post/rock_*.dump.gz dump x y z",
		.args = args,
		.state_size = sizeof(struct rerun),
	},
	.needs_box = true,
	.run = run,
};
