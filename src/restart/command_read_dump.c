/* Command read_dump: sets properties of particles from a frame of a dump. */
#include "bond/bond_reference.h"
#include "restart/frames.h"

#include "base/banned.h"

struct read_dump {
	const char *file;
	int64_t step;
	struct ts_frame_use use;
};

static enum ts_status read_frame(struct tsim *sim, const struct read_dump *c, struct ts_frames *f,
				 const struct ts_place *where)
{
	bool got;

	do {
		TS_TRY(ts_frames_next(f, &got));
		if (!got)
			return ts_fail(&sim->error, TS_UNKNOWN, where, "'%s' has no %sframe of step %lld",
				       c->file, f->broken ? "whole " : "", (long long)c->step);
	} while (f->step != c->step);
	return ts_frames_apply(sim, f, &c->use, where);
}

static enum ts_status run(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct read_dump *c = state;
	struct ts_frames f = { 0 };
	enum ts_status status = ts_frames_open(&f, sim, c->file, where);

	ts_bond_reference_doubt(sim, "read_dump", where);
	if (status == TS_OK)
		status = read_frame(sim, c, &f, where);
	if (status == TS_OK) {
		sim->clock.step = sim->clock.base_step = c->step;
		sim->clock.base_time = (double)c->step * sim->clock.dt;
		ts_log(&sim->log, "Read %zu atoms of step %lld\n", f.n, (long long)c->step);
	}
	ts_frames_close(&f);
	return status;
}

static const struct ts_arg args[] = {
	TS_WORD("file", struct read_dump, file, .flags = TS_POSITIONAL,
		.help = "a file of dump atom or dump custom; it may be compressed with gzip"),
	TS_INT("step", struct read_dump, step, .flags = TS_POSITIONAL, .range = TS_NOT_NEGATIVE,
	       .help = "step of the frame; it becomes the current step"),
	TS_LIST("fields", struct read_dump, use.fields,
		.help = "quantities to read: x, vx, omegax, radius, mass, type, ix ..."),
	TS_BOOL("box", struct read_dump, use.box, .fallback = "yes",
		.help = "whether the box becomes that of the frame"),
	TS_BOOL("replace", struct read_dump, use.replace, .fallback = "yes",
		.help = "whether existing particles get the values of the frame"),
	TS_BOOL("trim", struct read_dump, use.trim, .fallback = "no",
		.help = "whether particles that are not in the frame are deleted"),
	TS_BOOL("purge", struct read_dump, use.purge, .fallback = "no",
		.help = "whether all particles are deleted first"),
	TS_BOOL("add", struct read_dump, use.add, .fallback = "no",
		.help = "whether particles that are only in the frame are created; needs a column type"),
	{ .name = "label",
	  .type = TS_ARG_REST,
	  .flags = TS_OPTIONAL | TS_TO_KEYWORD | TS_REPEAT,
	  .offset = TS_FIELD(struct read_dump, use.labels, struct ts_words *),
	  .help = "a quantity and the name of its column in the file" },
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_read_dump)
const struct ts_command_style ts_command_read_dump = {
	.style = {
		.name = "read_dump",
		.kind = TS_KIND_COMMAND,
		.summary = "Sets properties of particles from a frame of a dump",
		.doc = "Sets the quantities of particles from a frame of a dump. Particles are identified by "
		       "their ids, which must be unique in a frame. Incomplete frames, as left by a run that "
		       "was killed or had a full disk, are skipped with a warning. Positions are read from "
		       "columns x, xs, xu or xsu. Numbers have the precision of the text: a dump with the "
		       "format %g has six digits.",
		.example = "read_dump post/rock.dump 1000 x y z vx vy vz\n"
			   "read_dump post/rock.dump.gz 1000 x y z radius box no purge yes add yes",
		.args = args,
		.state_size = sizeof(struct read_dump),
	},
	.needs_box = true,
	.run = run,
};
