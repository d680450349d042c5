/* Command atom_modify: accepted for compatibility, without effect. */
#include "core/sim.h"

#include "base/banned.h"

struct state {
	int map;
	const char *first;
	bool id;
	struct ts_words sort;
};

static const char *const maps[] = { "array", "hash", "yes", NULL };

/* sort EVERY SIZE: steps and width of the bins */
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
			       "atom_modify: particles always have atom IDs: contact histories, random "
			       "numbers and the order of sums depend on them; leave `id no` out");
	return check_sort(sim, s->sort);
}

static const struct ts_arg args[] = {
	TS_ENUM("map", struct state, map, maps, .fallback = "array",
		.help = "no effect: particles are looked up by atom ID when that is needed"),
	TS_BOOL("id", struct state, id, .fallback = "yes",
		.help = "yes; no is an error, since histories and random numbers depend on atom IDs"),
	TS_WORD("first", struct state, first, .flags = TS_OPTIONAL,
		.help = "no effect: the order in memory affects only the speed; see neigh_modify include"),
	TS_SOME_KEYWORD("sort", struct state, sort, 0,
			.help = "steps and bin size: no effect, particles are sorted in space when that is "
				"faster; results and dumps (sort id) do not depend on it"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_atom_modify)
const struct ts_command_style ts_command_atom_modify = {
	.style = {
		.name = "atom_modify",
		.kind = TS_KIND_COMMAND,
		.summary = "Accepted for compatibility; has no effect",
		.doc = "In LAMMPS and LIGGGHTS this command selects how particles are looked up by their\n"
		       "atom ID and how often they are sorted in memory. tsim chooses both itself, and\n"
		       "results do not depend on them: sums are evaluated in the order of atom IDs, and\n"
		       "dumps are sorted by atom ID unless `dump_modify sort off` requests the order in\n"
		       "memory, which differs from that of other programs.",
		.example = "atom_modify map array sort 0 0",
		.args = args,
		.state_size = sizeof(struct state),
	},
	.run = run,
};
