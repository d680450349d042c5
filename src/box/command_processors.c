/* Command processors: how the box is cut into blocks, one for each rank. */
#include <string.h>

#include "box/domain.h"
#include "core/ranks.h"
#include "rank/blocks.h"

#include "base/banned.h"

struct state {
	struct ts_words grid, rest;
};

/* The product of the numbers must be that of the ranks, unless one of them is free. Without ranks they have no effect. */
static enum ts_status check_product(struct tsim *sim, const int processors[3], const struct ts_place *where)
{
	int64_t product = 1;
	bool open = false;

	for (int d = 0; d < 3; d++) {
		product *= processors[d] ? processors[d] : 1;
		open |= !processors[d];
	}
	if (ts_ranks(sim) == 1 || (open ? ts_ranks(sim) % product == 0 : product == ts_ranks(sim)))
		return TS_OK;
	return ts_fail(&sim->error, TS_RANGE, where,
		       "processors: the product of the numbers is %lld, which does not fit the %d ranks",
		       (long long)product, ts_ranks(sim));
}

static enum ts_status set_grid(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct state *s = state;
	int processors[3] = { 0 };

	for (size_t k = 0; k < s->grid.n; k++) {
		const struct ts_word *word = &s->grid.word[k];
		int64_t n = 0;

		if (k < 3 && !ts_streq(word->text, "*") && ts_parse_int(word->text, &n) && n > TS_BLOCKS_MOST)
			n = -1;
		if (k < 3)
			processors[k] = (int)n;
		if (k == 3 || (!ts_streq(word->text, "*") && n < 1))
			return ts_fail(&sim->error, TS_SYNTAX, &word->place,
				       "processors: found '%s', expected three numbers > 0 or *, and then "
				       "grid, map, part, numa or file with their words",
				       word->text);
	}
	if (s->grid.n == 3) {
		TS_TRY(check_product(sim, processors, ts_sim_word(sim, 1, where)));
		memcpy(sim->domain->processors, processors, sizeof processors);
		return TS_OK;
	}
	return ts_fail(&sim->error, TS_SYNTAX, where,
		       "processors: expected three numbers of processes, found %zu", s->grid.n);
}

/* clang-format off */
#define WORDS(name, help_) TS_SOME_KEYWORD(name, struct state, rest, TS_REPEAT, .help = help_)
/* clang-format on */

static const struct ts_arg args[] = {
	TS_LIST("processes", struct state, grid,
		.help = "number of blocks along x, y and z; *: chosen by tsim"),
	WORDS("grid", "method, with its arguments, of no effect: blocks have equal numbers of particles"),
	WORDS("map", "order of the processes in the grid: no effect, x varies fastest, then y"),
	WORDS("part",
	      "partitions whose grids are multiples of each other: no effect, there is one partition"),
	WORDS("numa", "mapping of processes to nodes: no effect, mpirun maps them"),
	WORDS("file", "no effect: no map of processes is written"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_processors)
const struct ts_command_style ts_command_processors = {
	.style = {
		.name = "processors",
		.kind = TS_KIND_COMMAND,
		.summary = "Sets how the box is cut into blocks, one for each rank of mpirun",
		.doc = "The product of the three numbers must be the number of ranks, unless one of them is *. "
		       "Without this command the blocks are chosen with the least area between them. Results do "
		       "not depend on it, nor on the number of ranks and threads (doc/ranks.md). Without mpirun "
		       "it has no effect.",
		.example = "processors 2 2 1",
		.args = args,
		.state_size = sizeof(struct state),
	},
	.run = set_grid,
};
