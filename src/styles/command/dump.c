/* Command dump: makes a dump. */
#include "core/sim.h"

#include "base/banned.h"

struct state {
	const char *id;
	int group;
	struct ts_words rest;
};

static enum ts_status run(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct state *s = state;
	const struct ts_style *style;

	TS_TRY(ts_style_require(sim, TS_KIND_DUMP, &s->rest.word[0], &style));
	return ts_sim_create(sim, TS_KIND_DUMP, style, s->id, s->group, ts_words_from(s->rest, 1),
			     where, NULL);
}

static const struct ts_arg args[] = {
	TS_WORD("id", struct state, id, .flags = TS_POSITIONAL, .help = "its name"),
	TS_GROUP("group", struct state, group, .flags = TS_POSITIONAL,
		 .help = "particles to write"),
	TS_REST("style", struct state, rest, .help = "style, steps between frames, file, columns"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_dump)
const struct ts_command_style ts_command_dump = {
	.style = {
		.name = "dump",
		.kind = TS_KIND_COMMAND,
		.summary = "Writes snapshots to files during runs",
		.doc = "See the pages of the dump styles. dump_modify changes a dump, undump ends it. The folder of the\n"
		       "file must exist.",
		.example = "shell mkdir post\n"
			   "dump rock all custom 1000 post/rock.dump id type x y z radius",
		.args = args,
		.state_size = sizeof(struct state),
	},
	.needs_box = true,
	.run = run,
};
