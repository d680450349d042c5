/* Command compute: defines a compute. */
#include "core/definition.h"

#include "base/banned.h"

static enum ts_status run_compute(struct tsim *sim, void *state, const struct ts_place *where)
{
	struct ts_definition *made = state;
	const struct ts_word *word = made->line.word;

	(void)where;
	/* behind the style's name: `reduce update_on_run_end yes sum ...` */
	if (made->line.n > 1 && ts_streq(word[1].text, "update_on_run_end")) {
		if (made->line.n == 2 || !(ts_streq(word[2].text, "yes") || ts_streq(word[2].text, "no")))
			return ts_fail(&sim->error, TS_SYNTAX, &word[made->line.n == 2 ? 1 : 2].place,
				       "compute: update_on_run_end takes yes or no");
		made->passed = 2;
	}
	return ts_define(sim, TS_KIND_COMPUTE, made);
}

static const struct ts_arg args[] = {
	TS_DEFINITION_ARGS("particles it is computed from", "style and its arguments"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_compute)
const struct ts_command_style ts_command_compute = {
	.style = {
		.name = "compute",
		.kind = TS_KIND_COMMAND,
		.summary = "Defines a quantity computed from particles",
		.doc = "A compute is evaluated when its value c_ID is needed: by a thermo keyword, a "
		       "variable, a fix or\n"
		       "a dump. See the pages of the compute styles. `update_on_run_end yes|no` of LIGGGHTS "
		       "behind the\n"
		       "style has no effect.\n\n"
		       "A compute with the id of one of the same style replaces it; LIGGGHTS and LAMMPS refuse "
		       "that.",
		.example = "compute energy all ke",
		.args = args,
		.ranks = TS_RANKS_FORMULAS,
		.state_size = sizeof(struct ts_definition),
	},
	.run = run_compute,
};
