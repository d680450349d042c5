#include "core/life.h"

#include "base/banned.h"

struct style_line {
	struct ts_words words;
};

static enum ts_status run(struct tsim *sim, void *state, const struct ts_place *where)
{
	struct ts_words line = ((const struct style_line *)state)->words;
	const struct ts_word chosen = { .text = "", .place = *where };

	if (line.n == 1 && ts_streq(line.word[0].text, "auto"))
		return ts_sim_find(sim, TS_KIND_PRESSURE, "") ? ts_sim_destroy(sim, TS_KIND_PRESSURE, &chosen)
							      : TS_OK;
	return ts_sim_choose(sim, TS_KIND_PRESSURE, line, where);
}

static const struct ts_arg args[] = {
	TS_REST("style", struct style_line, words, .help = "a pressure style and its arguments, or auto"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_pressure_style)
const struct ts_command_style ts_command_pressure_style = {
	.style = { .name = "pressure_style",
		   .kind = TS_KIND_COMMAND,
		   .summary = "chooses the solver for the pressure of a fluid",
		   .doc = "Replaces the pressure style there was. Without one, or with `auto`, the fluid "
			  "takes the one that says it will be the fastest, by measured times for each cell: "
			  "`direct` where no particles take room or are held by the fluid implicitly, on "
			  "even and on graded grids; else `cg` with `direct` as its preconditioner, which "
			  "takes multigrid instead for weights that differ much; `multigrid` where two axes "
			  "or more are graded and have more than about two thousand cells. -explain says "
			  "which, and how long a solve will take. All give the same pressure to their "
			  "tolerance; that of `direct` is round-off.",
		   .example = "pressure_style auto",
		   .args = args,
		   .state_size = sizeof(struct style_line) },
	.run = run,
};
