/* Command undump: ends a dump. */
#include "core/life.h"
#include "dump/dump.h"

#include "base/banned.h"

struct state {
	struct ts_words ids;
};

static enum ts_status run(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct state *s = state;
	struct ts_instance *dump;

	(void)where;
	for (size_t k = 0; k < s->ids.n; k++) {
		struct ts_dump_common *common;

		TS_TRY(ts_sim_require(sim, TS_KIND_DUMP, &s->ids.word[k], &dump));
		common = dump->state;
		TS_TRY(ts_textfile_close(&common->out));
		TS_TRY(ts_sim_destroy(sim, TS_KIND_DUMP, &s->ids.word[k]));
	}
	return TS_OK;
}

static const struct ts_arg args[] = {
	TS_REST("ids", struct state, ids, .help = "IDs of dumps"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_undump)
const struct ts_command_style ts_command_undump = {
	.style = {
		.name = "undump",
		.kind = TS_KIND_COMMAND,
		.summary = "Ends dumps and closes their files",
		.doc = "The files keep the frames written so far.",
		.example = "undump rock",
		.args = args,
		.ranks = TS_RANKS_FORMULAS,
		.state_size = sizeof(struct state),
	},
	.run = run,
};
