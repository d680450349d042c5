/* Command atom_modify: accepted for compatibility. */
#include "core/sim.h"

#include "base/banned.h"

struct state {
	int map;
	const char *first;
	bool id;
	struct ts_words sort;
};

static const char *const maps[] = { "array", "hash", "yes", NULL };

/* sort EVERY SIZE */
static enum ts_status check_sort(struct tsim *sim, struct ts_words words)
{
	int64_t every;
	double size;

	if (!words.n || (words.n == 2 && ts_parse_int(words.word[0].text, &every) && every >= 0 &&
			 ts_parse_real(words.word[1].text, &size) && size >= 0))
		return TS_OK;
	return ts_fail(&sim->error, TS_SYNTAX, &words.word[0].place,
		       "atom_modify: sort takes a number of steps and the size of a bin, both >= 0");
}

static enum ts_status run(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct state *s = state;

	if (!s->id)
		return ts_fail(&sim->error, TS_RANGE, ts_sim_word_of(sim, "id", where),
			       "atom_modify: particles always have identities: contact histories, random "
			       "numbers and the order of sums hang on them; leave `id no` out");
	return check_sort(sim, s->sort);
}

static const struct ts_arg args[] = {
	TS_ENUM("map", struct state, map, maps, .fallback = "array",
		.help = "no effect: particles are found by identity when that is needed"),
	TS_BOOL("id", struct state, id, .fallback = "yes",
		.help = "yes; no is refused: histories and random numbers hang on identities"),
	TS_WORD("first", struct state, first, .flags = TS_OPTIONAL,
		.help = "no effect: the order in memory decides only the speed; see neigh_modify include"),
	TS_SOME_KEYWORD("sort", struct state, sort, 0,
			.help = "steps and size of bins: no effect, particles are sorted by place when "
				"that pays; results and dumps (sort id) do not depend on it"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_atom_modify)
const struct ts_command_style ts_command_atom_modify = {
	.style = {
		.name = "atom_modify",
		.kind = TS_KIND_COMMAND,
		.summary = "Accepted for compatibility; has no effect",
		.doc = "Elsewhere it says how particles are found by identity and when they are sorted. Here "
		       "both are\n"
		       "settled, and results do not depend on them: sums go by identity, and dumps are "
		       "sorted by\n"
		       "identity unless `dump_modify sort off` asks for the order in memory, which is that "
		       "of this\n"
		       "program and not of another.",
		.example = "atom_modify map array sort 0 0",
		.args = args,
		.state_size = sizeof(struct state),
	},
	.run = run,
};
