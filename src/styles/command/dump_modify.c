/* Command dump_modify: changes how a dump writes. */
#include "core/sim.h"
#include "io/dump.h"

#include "base/banned.h"

struct state {
	const char *id;
	struct ts_dump_changes changes;
	int flush;
};

static const char *const sorts[] = { "off", "id", NULL };
static const char *const answers[] = { "no", "yes", NULL };

static enum ts_status run(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct state *s = state;
	const struct ts_word id = { .text = s->id, .place = *ts_sim_word(sim, 1, where) };
	struct ts_instance *dump;

	TS_TRY(ts_sim_require(sim, TS_KIND_DUMP, &id, &dump));
	return ts_dump_modify(sim, dump, &s->changes, where);
}

#define FORMAT_ROWS(help_)                                                                         \
	(const struct ts_arg[])                                                                    \
	{                                                                                          \
		TS_WORD("text", struct state, changes.format, .flags = TS_POSITIONAL,              \
			.help = (help_)),                                                          \
			TS_ARGS_END                                                                \
	}

/* in the order of enum ts_dump_format */
static const struct ts_mode formats[] = {
	{ "float", "columns of real numbers", FORMAT_ROWS("a C format such as %.15g") },
	{ "int", "columns of integers", FORMAT_ROWS("a C format such as %d") },
	{ "line", "every column", FORMAT_ROWS("one C format for each column, in quotes") },
	{ .name = NULL },
};

static const struct ts_arg args[] = {
	TS_WORD("id", struct state, id, .flags = TS_POSITIONAL, .help = "name of the dump"),
	TS_INT("every", struct state, changes.every, .flags = TS_OPTIONAL, .range = TS_POSITIVE,
	       .help = "steps between frames"),
	TS_ENUM("sort", struct state, changes.sort, sorts, .flags = TS_OPTIONAL,
		.help = "order of rows: by id (as from the start), or as they lie in memory"),
	TS_INT("pad", struct state, changes.pad, .flags = TS_OPTIONAL, .range = TS_WITHIN, .lo = 0,
	       .hi = 20, .help = "digits of the step in file names, filled with zeros"),
	TS_ENUM("first", struct state, changes.first, answers, .flags = TS_OPTIONAL,
		.help = "write a frame at the start of the next run in any case"),
	TS_ENUM("append", struct state, changes.append, answers, .flags = TS_OPTIONAL,
		.help = "go on with a file that exists instead of writing it anew"),
	TS_WORD("label", struct state, changes.label, .flags = TS_OPTIONAL,
		.help = "text of an additional ITEM: LABEL of each frame"),
	TS_ENUM("flush", struct state, flush, answers, .flags = TS_OPTIONAL,
		.help = "no effect: every frame is handed to the system at once"),
	{ .name = "format",
	  .type = TS_ARG_MODE,
	  .flags = TS_OPTIONAL,
	  .offset = TS_FIELD(struct state, changes.format_kind, int *),
	  .modes = formats,
	  .help = "how numbers are written" },
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_dump_modify)
const struct ts_command_style ts_command_dump_modify = {
	.style = {
		.name = "dump_modify",
		.kind = TS_KIND_COMMAND,
		.summary = "Changes how a dump writes",
		.doc = "Defaults: sort id, pad 0, first no, append no, format float %g, format int %d.",
		.example = "dump_modify rock pad 8 format float %.15g",
		.args = args,
		.state_size = sizeof(struct state),
	},
	.run = run,
};
