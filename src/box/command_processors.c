/* Command processors: accepted for compatibility. */
#include "core/sim.h"

#include "base/banned.h"

struct state {
	struct ts_words grid, rest;
};

static enum ts_status check_grid(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct state *s = state;
	int64_t n;

	for (size_t k = 0; k < s->grid.n; k++) {
		const struct ts_word *word = &s->grid.word[k];

		if (k == 3 || (!ts_streq(word->text, "*") && (!ts_parse_int(word->text, &n) || n < 1)))
			return ts_fail(&sim->error, TS_SYNTAX, &word->place,
				       "processors: found '%s', expected three numbers > 0 or *, and then "
				       "grid, map, part, numa or file with their words",
				       word->text);
	}
	if (s->grid.n == 3)
		return TS_OK;
	return ts_fail(&sim->error, TS_SYNTAX, where,
		       "processors: expected three numbers of processes, found %zu", s->grid.n);
}

/* clang-format off */
#define WORDS(name, help_) TS_SOME_KEYWORD(name, struct state, rest, TS_REPEAT, .help = help_)
/* clang-format on */

static const struct ts_arg args[] = {
	TS_LIST("processes", struct state, grid,
		.help = "number of processes along x, y, z, or *: no effect, there is one process"),
	WORDS("grid", "method, with its arguments: no effect, there is one process"),
	WORDS("map", "order of the processes in the grid: no effect, there is one process"),
	WORDS("part",
	      "partitions whose grids are multiples of each other: no effect, there is one partition"),
	WORDS("numa", "mapping of processes to nodes: no effect, there is one process"),
	WORDS("file", "no effect: no map of processes is written"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_processors)
const struct ts_command_style ts_command_processors = {
	.style = {
		.name = "processors",
		.kind = TS_KIND_COMMAND,
		.summary = "Accepted for compatibility; has no effect",
		.doc = "In LAMMPS this command sets how the box is divided among processes. tsim distributes "
		       "particles over threads, independent of their positions, and results do not depend on "
		       "the number of threads.",
		.example = "processors 2 2 1",
		.args = args,
		.state_size = sizeof(struct state),
	},
	.run = check_grid,
};
