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
		   .ranks = TS_RANKS_FORMULAS,
		   .summary = "Selects the solver for the pressure of a fluid",
		   .doc = "Replaces the present pressure style. Without this command, or with `auto`, the\n"
			  "solver with the smallest estimated time is used, from measured times per cell:\n"
			  "`direct` if no particles occupy volume or exchange momentum implicitly, on\n"
			  "uniform and graded grids; otherwise `cg` with the preconditioner `direct`, which\n"
			  "uses multigrid instead if the weights differ much; `multigrid` if two or more\n"
			  "axes are graded and have more than about two thousand cells. -explain prints the\n"
			  "selected solver and the estimated time of a solve. All solvers give the same\n"
			  "pressure to their tolerance; that of `direct` is round-off.",
		   .example = "pressure_style auto",
		   .args = args,
		   .state_size = sizeof(struct style_line) },
	.run = run,
};
