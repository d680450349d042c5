/* Command neigh_modify: which pairs never touch. */
#include "core/sim.h"

#include <string.h>

#include "core/group.h"
#include "neigh/neigh.h"
#include "particles/particles.h"

#include "base/banned.h"

struct state {
	int64_t every, delay, page, one;
	bool check, once, cluster;
	double binsize;
	struct ts_words exclude;
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

/* "type m n" or "group a b" */
static enum ts_status add_pair(struct tsim *sim, struct ts_words words)
{
	struct ts_neigh *neigh = sim->neigh;
	struct ts_exclude pair = { .by_group = ts_streq(words.word[0].text, "group") };

	if (words.n < 3 || !(pair.by_group || ts_streq(words.word[0].text, "type")))
		return ts_fail(&sim->error, TS_SYNTAX, &words.word[0].place,
			       "neigh_modify exclude: expected type m n, group a b or none");
	TS_TRY((pair.by_group ? read_group : read_type)(sim, &words.word[1], &pair.a));
	TS_TRY((pair.by_group ? read_group : read_type)(sim, &words.word[2], &pair.b));
	for (int k = 0; k < neigh->nexclude; k++) /* said again, as after read_restart */
		if (memcmp(&neigh->exclude[k], &pair, sizeof pair) == 0)
			return TS_OK;
	if (neigh->nexclude == TS_MAX_EXCLUDE)
		return ts_fail(&sim->error, TS_RANGE, &words.word[0].place,
			       "neigh_modify exclude: there can be %d pairs", TS_MAX_EXCLUDE);
	neigh->exclude[neigh->nexclude++] = pair;
	return TS_OK;
}

static enum ts_status run(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct state *s = state;
	struct ts_words rest = s->exclude;

	(void)where;
	while (rest.n) {
		size_t used = 3;

		if (ts_streq(rest.word[0].text, "none")) {
			sim->neigh->nexclude = 0;
			used = 1;
		} else {
			TS_TRY(add_pair(sim, rest));
		}
		rest = ts_words_from(rest, used);
		if (!rest.n)
			break;
		if (!ts_streq(rest.word[0].text, "exclude") || rest.n < 2)
			return ts_fail(
				&sim->error, TS_SYNTAX, &rest.word[0].place,
				"neigh_modify: expected another exclude or the end of the line");
		rest = ts_words_from(rest, 1);
	}
	return TS_OK;
}

static const struct ts_arg args[] = {
	TS_INT("every", struct state, every, .flags = TS_OPTIONAL, .range = TS_POSITIVE,
	       .unit = "steps", .help = "no effect: each step is checked"),
	TS_INT("delay", struct state, delay, .flags = TS_OPTIONAL, .range = TS_NOT_NEGATIVE,
	       .unit = "steps", .help = "no effect: each step is checked"),
	TS_BOOL("check", struct state, check, .fallback = "yes", .help = "no effect"),
	TS_REAL("binsize", struct state, binsize, .flags = TS_OPTIONAL, .unit = "length",
		.help = "no effect: cells adapt to the radii"),
	TS_INT("page", struct state, page, .flags = TS_OPTIONAL, .help = "no effect"),
	TS_INT("one", struct state, one, .flags = TS_OPTIONAL, .help = "no effect"),
	TS_BOOL("once", struct state, once, .fallback = "no", .help = "no effect"),
	TS_BOOL("cluster", struct state, cluster, .fallback = "no", .help = "no effect"),
	{ .name = "exclude",
	  .type = TS_ARG_REST,
	  .flags = TS_OPTIONAL,
	  .offset = offsetof(struct state, exclude),
	  .help = "type m n, group a b, or none to forget all; repeated, and last" },
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_neigh_modify)
const struct ts_command_style ts_command_neigh_modify = {
	.style = {
		.name = "neigh_modify",
		.kind = TS_KIND_COMMAND,
		.summary = "Sets which pairs never touch",
		.doc = "Neighbours are searched anew exactly when a particle has moved half the skin, so that no\n"
		       "contact is missed: when to look need not be said. exclude takes pairs of particles of two\n"
		       "types or two groups out of the search: they pass through each other.",
		.example = "neigh_modify delay 0\n"
		       "neigh_modify exclude type 1 2 exclude group wall wall",
		.args = args,
		.state_size = sizeof(struct state),
	},
	.run = run,
};
