#include "contact/pair.h"
#include "core/life.h"

#include "base/banned.h"

struct style_line {
	struct ts_words words;
};

static enum ts_status run(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct style_line *line = state;

	struct ts_instance *pair;

	TS_TRY(ts_sim_choose(sim, TS_KIND_PAIR, line->words, where));
	pair = ts_sim_only(sim, TS_KIND_PAIR);
	if (!pair || !ts_pair_style_of(pair)->chosen)
		return TS_OK;
	return ts_pair_style_of(pair)->chosen(pair, sim);
}

static const struct ts_arg args[] = {
	TS_REST("style", struct style_line, words, .help = "a pair style and its arguments, or none"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_pair_style)
const struct ts_command_style ts_command_pair_style = {
	.style = { .name = "pair_style",
		   .kind = TS_KIND_COMMAND,
		   .summary = "chooses the contact law between particles",
		   .doc = "Replaces the present pair style and its coefficients. Without a pair style there "
			  "are no contact forces between particles; `none` removes the present one.",
		   .example = "pair_style spring/dashpot",
		   .args = args,
		   .state_size = sizeof(struct style_line) },
	.run = run,
};
