/* Command read_dump: particles as a frame of a dump has them. */
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
	return ts_frame_apply(sim, f, &c->use, where);
}

static enum ts_status run(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct read_dump *c = state;
	struct ts_frames f = { 0 };
	enum ts_status status = ts_frames_open(&f, sim, c->file, where);

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
	       .help = "step of the frame; it becomes the present step"),
	TS_LIST("fields", struct read_dump, use.fields,
		.help = "what is taken: x, vx, omegax, radius, mass, type, ix ..."),
	TS_BOOL("box", struct read_dump, use.box, .fallback = "yes",
		.help = "the box becomes that of the frame"),
	TS_BOOL("replace", struct read_dump, use.replace, .fallback = "yes",
		.help = "particles that are in both get the fields"),
	TS_BOOL("trim", struct read_dump, use.trim, .fallback = "no",
		.help = "particles that are not in the frame go"),
	TS_BOOL("purge", struct read_dump, use.purge, .fallback = "no", .help = "all go before"),
	TS_BOOL("add", struct read_dump, use.add, .fallback = "no",
		.help = "particles that are only in the frame are made; needs a column type"),
	{ .name = "label",
	  .type = TS_ARG_REST,
	  .flags = TS_OPTIONAL | TS_TO_KEYWORD | TS_REPEAT,
	  .offset = TS_FIELD(struct read_dump, use.labels, struct ts_words *),
	  .help = "a field and the name of the column it comes from" },
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_read_dump)
const struct ts_command_style ts_command_read_dump = {
	.style = {
		.name = "read_dump",
		.kind = TS_KIND_COMMAND,
		.summary = "Gives particles what a frame of a dump says",
		.doc = "Particles are found by their identities, which may stand in a frame once. Frames "
		       "that are not\n"
		       "whole, as a run leaves them that was killed or had a full disk, are told and left "
		       "out. Positions come from columns x, xs, xu or xsu. Numbers\n"
		       "are those of the text: what a dump wrote with %g has six digits.",
		.example = "read_dump post/rock.dump 1000 x y z vx vy vz\n"
			   "read_dump post/rock.dump.gz 1000 x y z radius box no purge yes add yes",
		.args = args,
		.state_size = sizeof(struct read_dump),
	},
	.needs_box = true,
	.run = run,
};
