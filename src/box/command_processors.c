/* Command processors: accepted for compatibility. */
#include "core/sim.h"

#include "base/banned.h"

struct state {
	struct ts_words grid, rest;
};

static enum ts_status run(struct tsim *sim, void *state, const struct ts_place *where)
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
		.help = "numbers along x, y, z, each may be *: no effect, there is one process"),
	WORDS("grid", "how the grid is made, with its words: no effect, as above"),
	WORDS("map", "how processes lie in the grid: no effect, as above"),
	WORDS("part", "partitions whose grids are multiples: no effect, there is one partition"),
	WORDS("numa", "how processes lie on nodes: no effect, as above"),
	WORDS("file", "no effect: there is no map of processes to write"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_processors)
const struct ts_command_style ts_command_processors = {
	.style = {
		.name = "processors",
		.kind = TS_KIND_COMMAND,
		.summary = "Accepted for compatibility; has no effect",
		.doc = "Elsewhere it says how processes share the box. Here threads share the particles, "
		       "whatever their\n"
		       "places, and results do not depend on their number.",
		.example = "processors 2 2 1",
		.args = args,
		.state_size = sizeof(struct state),
	},
	.run = run,
};
