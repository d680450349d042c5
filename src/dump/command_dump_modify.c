/* Command dump_modify: changes the settings of a dump. */
#include "dump/dump_modify.h"

#include "base/banned.h"

struct state {
	const char *id;
	struct ts_dump_changes changes;
};

static enum ts_status run(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct state *s = state;
	const struct ts_word id = { .text = s->id, .place = *ts_sim_word(sim, 1, where) };
	struct ts_instance *dump;

	TS_TRY(ts_sim_require(sim, TS_KIND_DUMP, &id, &dump));
	return ts_dump_modify(sim, dump, &s->changes, where);
}

static const struct ts_arg args[] = {
	TS_WORD("id", struct state, id, .flags = TS_POSITIONAL, .help = "ID of the dump"),
	TS_DUMP_MODIFY_ROWS(struct state),
	TS_ARGS_END,
};

static const struct ts_arg_group groups[] = {
	{ NULL, "id every first append pad sort format thresh region" },
	{ "Frames and files", "delay maxfiles refresh binary" },
	{ "Text of frames", "header label time units element scale image" },
	{ "Pictures: particles and bonds", "acolor adiam amap atrans bcolor bdiam bmap" },
	{ "Pictures: surfaces, slices, contacts", "smap gmap cmap" },
	{ "Pictures: background, box, colours, light", "backcolor backcolor2 boxcolor color lights" },
	{ "Movies", "framerate bitrate" },
	{ "Accepted for compatibility, without effect", "buffer compressor flush pbc fileper nfile" },
	{ .words = NULL },
};

TS_STYLE(command, ts_command_style, ts_command_dump_modify)
const struct ts_command_style ts_command_dump_modify = {
	.style = {
		.name = "dump_modify",
		.kind = TS_KIND_COMMAND,
		.ranks = TS_RANKS_FORMULAS,
		.summary = "Changes the settings of a dump",
		.purpose = "Which frames a dump writes, their format, and the colours of pictures.",
		.doc = "Defaults: sort id, pad 0, first no, append no, format float %g, format int %d. The "
		       "format of a column takes precedence over those of float and int, and these over the "
		       "format of the line. thresh, region and sorting by columns apply to dumps of "
		       "particles. A keyword that does not change the frames of the dump is warned of, as by "
		       "LIGGGHTS.",
		.example = "dump_modify rock pad 8 format float %.15g format 1 %08d\n"
			   "dump_modify fast thresh vz < -0.5 thresh c_load >= 2.385 region shaft sort -4",
		.args = args,
		.groups = groups,
		.state_size = sizeof(struct state),
	},
	.run = run,
};
