#include "automaton/automaton.h"
#include "core/life.h"

#include "base/banned.h"

struct style_line {
	struct ts_words words;
};

static enum ts_status run(struct tsim *sim, void *state, const struct ts_place *where)
{
	return ts_sim_choose(sim, TS_KIND_AUTOMATON, ((const struct style_line *)state)->words, where);
}

static const struct ts_arg args[] = {
	TS_REST("style", struct style_line, words, .help = "an automaton style and its arguments, or `none`"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_automaton_style)
const struct ts_command_style ts_command_automaton_style = {
	.style = { .name = "automaton_style",
		   .kind = TS_KIND_COMMAND,
		   .summary = "Selects a cellular automaton",
		   .doc = "Replaces the present automaton: the new one begins anew, with its own granules. "
			  "`none` removes\n"
			  "it. The automaton takes one step in each step of a run. It is independent of "
			  "particles and\n"
			  "fluids, which neither feel it nor act on it.\n\n"
			  "Related: compute automaton/profile, dump automaton/png, dump automaton/vtk.",
		   .example = "automaton_style granular cell 1 fill 0.85 restitution 0.85 wall_restitution "
			      "0.65 roughness 0.65 lower 1 seed 1",
		   .args = args,
		   .state_size = sizeof(struct style_line) },
	.run = run,
};
