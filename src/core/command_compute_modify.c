/* Command compute_modify: degrees of freedom of a temperature. */
#include "thermo/thermo.h"

#include "base/banned.h"

struct state {
	const char *id;
	struct ts_words words;
};

/* Computes that LIGGGHTS and LAMMPS define by themselves; here they are the keywords temp, press and pe. */
static bool is_standard(const char *id)
{
	return ts_streq(id, "thermo_temp") || ts_streq(id, "thermo_press") || ts_streq(id, "thermo_pe");
}

/* dynamic has no effect: particles are counted whenever a temperature is computed. */
static enum ts_status skip_ignored_option(struct tsim *sim, struct ts_words words, size_t *used)
{
	static const char *const names[] = { "dynamic", "dynamic/dof", NULL };
	const struct ts_word *word = words.word;
	struct ts_suggest suggest = ts_suggest_start(word->text);

	*used = 2;
	ts_suggest_try(&suggest, "extra");
	for (int k = 0; names[k]; k++) {
		ts_suggest_try(&suggest, names[k]);
		if (!ts_streq(word->text, names[k]))
			continue;
		if (words.n > 1 && (ts_streq(word[1].text, "yes") || ts_streq(word[1].text, "no")))
			return TS_OK;
		return ts_fail(&sim->error, TS_SYNTAX, &word->place, "compute_modify: %s takes yes or no",
			       word->text);
	}
	return ts_fail(&sim->error, TS_UNKNOWN, &word->place,
		       "compute_modify: the compute has no word '%s'%s", word->text,
		       ts_suggest_text(&suggest));
}

static enum ts_status apply_option(struct tsim *sim, const char *id, struct ts_instance *compute,
				   struct ts_words words, size_t *used)
{
	*used = 0;
	if (ts_streq(id, "thermo_temp"))
		TS_TRY(ts_freedom_read(&sim->thermo->freedom, sim, words, used));
	else if (compute && compute->style->modify)
		TS_TRY(compute->style->modify(compute, sim, words, used));
	return *used ? TS_OK : skip_ignored_option(sim, words, used);
}

static enum ts_status run_compute_modify(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct state *s = state;
	const struct ts_word id = { .text = s->id, .place = *ts_sim_word(sim, 1, where) };
	struct ts_instance *compute = NULL;
	struct ts_words rest = s->words;
	size_t used;

	if (!is_standard(s->id))
		TS_TRY(ts_sim_require(sim, TS_KIND_COMPUTE, &id, &compute));
	for (; rest.n; rest = ts_words_from(rest, used))
		TS_TRY(apply_option(sim, s->id, compute, rest, &used));
	return TS_OK;
}

static const struct ts_arg args[] = {
	TS_WORD("id", struct state, id, .flags = TS_POSITIONAL, .help = "name of the compute"),
	TS_REST("words", struct state, words,
		.help = "extra M or extra/dof M; dynamic yes|no or dynamic/dof yes|no: no effect, particles "
			"are counted whenever a temperature is computed"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_compute_modify)
const struct ts_command_style ts_command_compute_modify = {
	.style = {
		.name = "compute_modify",
		.kind = TS_KIND_COMMAND,
		.summary = "Changes the degrees of freedom of a temperature",
		.doc = "extra M: the temperature is computed with D N - M degrees of freedom instead of D (N "
		       "- 1),\n"
		       "where D is the dimension and N the number of particles. The id thermo_temp is the "
		       "temperature\n"
		       "of the thermo keyword temp; the ids thermo_press and thermo_pe are accepted, too.",
		.example = "compute_modify thermo_temp dynamic yes\ncompute_modify heat extra 0",
		.args = args,
		.state_size = sizeof(struct state),
	},
	.run = run_compute_modify,
};
