/* Command neigh_modify: pairs without contact. */
#include "core/sim.h"

#include <string.h>

#include "core/group.h"
#include "neigh/neigh.h"
#include "particle/molecule.h"
#include "particle/particles.h"

#include "base/banned.h"

struct state {
	int64_t every, delay, page, one;
	bool check, once, cluster;
	double binsize, factor;
	int include;
	struct ts_words exclude, collections;
};

static enum ts_status read_type(struct tsim *sim, const struct ts_word *word, int32_t *type)
{
	int64_t value;

	if (!ts_parse_int(word->text, &value) || value < 1 || value > sim->particles->ntypes)
		return ts_fail(&sim->error, TS_RANGE, &word->place,
			       "neigh_modify exclude: '%s' is not a type from 1 to %d", word->text,
			       sim->particles->ntypes);
	*type = (int32_t)value;
	return TS_OK;
}

static enum ts_status read_group(struct tsim *sim, const struct ts_word *word, int32_t *bit)
{
	int value;

	TS_TRY(ts_group_require(sim, word, &value));
	*bit = value;
	return TS_OK;
}

static enum ts_status read_molecule_group(struct tsim *sim, struct ts_words words, struct ts_exclude *pair)
{
	TS_TRY(read_group(sim, &words.word[1], &pair->a));
	return ts_particles_need_molecules(sim, "neigh_modify exclude", &words.word[0].place);
}

static enum ts_status append_exclusion(struct tsim *sim, const struct ts_exclude *pair,
				       const struct ts_place *where)
{
	struct ts_neigh *neigh = sim->neigh;

	for (int k = 0; k < neigh->nexclude; k++) /* already there, e.g. given again after read_restart */
		if (memcmp(&neigh->exclude[k], pair, sizeof *pair) == 0)
			return TS_OK;
	if (neigh->nexclude == TS_MAX_EXCLUDE)
		return ts_fail(&sim->error, TS_RANGE, where, "neigh_modify exclude: there can be %d pairs",
			       TS_MAX_EXCLUDE);
	neigh->exclude[neigh->nexclude++] = *pair;
	return TS_OK;
}

static const struct {
	const char *name;
	size_t words; /* number of words after the name */
	enum ts_exclude_by by;
} kinds[] = {
	{ "type", 2, TS_EXCLUDE_TYPES },
	{ "group", 2, TS_EXCLUDE_GROUPS },
	{ "molecule/intra", 1, TS_EXCLUDE_WITHIN },
	{ "molecule", 1, TS_EXCLUDE_WITHIN },
	{ "molecule/inter", 1, TS_EXCLUDE_BETWEEN },
};

/* Reads one exclusion; *used: number of its words. */
static enum ts_status read_exclusion(struct tsim *sim, struct ts_words words, size_t *used)
{
	const struct ts_word *word = words.word;
	struct ts_exclude pair = { 0 };
	size_t kind = 0;

	*used = 1;
	if (ts_streq(word[0].text, "none")) {
		sim->neigh->nexclude = 0;
		memset(sim->neigh->exclude, 0, sizeof sim->neigh->exclude);
		return TS_OK;
	}
	while (kind < sizeof kinds / sizeof *kinds && !ts_streq(kinds[kind].name, word[0].text))
		kind++;
	if (kind == sizeof kinds / sizeof *kinds || words.n <= kinds[kind].words)
		return ts_fail(&sim->error, TS_SYNTAX, &word[0].place,
			       "neigh_modify exclude: expected type m n, group a b, molecule/intra a, "
			       "molecule/inter a or none");
	pair.by = (int32_t)kinds[kind].by;
	*used += kinds[kind].words;
	if (kinds[kind].words == 1) {
		TS_TRY(read_molecule_group(sim, words, &pair));
	} else {
		bool group = pair.by == TS_EXCLUDE_GROUPS;

		TS_TRY((group ? read_group : read_type)(sim, &word[1], &pair.a));
		TS_TRY((group ? read_group : read_type)(sim, &word[2], &pair.b));
	}
	return append_exclusion(sim, &pair, &word[0].place);
}

static enum ts_status run(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct state *s = state;
	struct ts_words rest = s->exclude;
	size_t used;

	(void)where;
	if (s->include >= 0)
		sim->neigh->include = s->include;
	for (; rest.n; rest = ts_words_from(rest, used))
		TS_TRY(read_exclusion(sim, rest, &used));
	return TS_OK;
}

static const struct ts_arg args[] = {
	TS_INT("every", struct state, every, .flags = TS_OPTIONAL, .range = TS_POSITIVE, .unit = "steps",
	       .help = "no effect: displacements are checked in every step"),
	TS_INT("delay", struct state, delay, .flags = TS_OPTIONAL, .range = TS_NOT_NEGATIVE, .unit = "steps",
	       .help = "no effect: displacements are checked in every step"),
	TS_BOOL("check", struct state, check, .fallback = "yes",
		.help = "no effect: the list is rebuilt when a particle has moved half the skin"),
	TS_REAL("binsize", struct state, binsize, .flags = TS_OPTIONAL, .unit = "length",
		.help = "no effect: the cell size adapts to the radii"),
	TS_REAL("contact_distance_factor", struct state, factor, .flags = TS_OPTIONAL, .range = TS_POSITIVE,
		.unit = "", .help = "no effect: the search distance is the range of the contact laws"),
	TS_INT("page", struct state, page, .flags = TS_OPTIONAL,
	       .help = "no effect: memory is allocated as needed"),
	TS_INT("one", struct state, one, .flags = TS_OPTIONAL,
	       .help = "no effect: memory is allocated as needed"),
	TS_BOOL("once", struct state, once, .fallback = "no",
		.help = "no effect: the list is rebuilt when contacts could be missed otherwise"),
	TS_BOOL("cluster", struct state, cluster, .fallback = "no",
		.help = "no effect: bonded particles are found by their IDs"),
	TS_SOME_KEYWORD("collection/type", struct state, collections, TS_REPEAT,
			.help = "no effect, as binsize"),
	TS_SOME_KEYWORD("collection/interval", struct state, collections, TS_REPEAT,
			.help = "no effect, as binsize"),
	TS_GROUP("include", struct state, include, .flags = TS_OPTIONAL,
		 .help = "only members of this group have contacts; all: no restriction"),
	TS_SOME_KEYWORD("exclude", struct state, exclude, TS_REPEAT,
			.help = "type m n, group a b, molecule/intra a (or molecule a), molecule/inter a, or "
				"none, which removes all earlier exclusions; may be repeated"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_neigh_modify)
const struct ts_command_style ts_command_neigh_modify = {
	.style = {
		.name = "neigh_modify",
		.kind = TS_KIND_COMMAND,
		.summary = "Sets which pairs of particles have no contact",
		.doc = "Sets which pairs of particles are left out of the neighbour list and so have no "
		       "contact force. `exclude type m n` excludes pairs of particles of types m and n, "
		       "`exclude group a b` pairs with one particle in group a and the other in group b. "
		       "`exclude molecule/intra a` excludes pairs of members of group a with the same "
		       "molecule ID, `molecule/inter a` those with different ones (`fix property/atom mol`). "
		       "`include a`: only members of group a have contacts.\n\n"
		       "The neighbour list is rebuilt exactly when a particle has moved half the skin (see "
		       "neighbor), so no contact is missed, and keywords that say when and how to build it "
		       "have no effect.",
		.example = "neigh_modify delay 0\n"
		       "neigh_modify exclude type 1 2 exclude group wall wall include bed check yes",
		.args = args,
		.ranks = TS_RANKS_FORMULAS,
		.state_size = sizeof(struct state),
	},
	.run = run,
};
