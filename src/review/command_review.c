/* Command review: treatment of the findings of the review before a run. */
#include "core/sim.h"

#include "base/banned.h"

struct state {
	int answer;
	struct ts_words names;
};

/* in the order of enum ts_review_answer */
static const char *const answers[] = { "warn", "error", "off", NULL };

static enum ts_status refuse_name(struct tsim *sim, const struct ts_word *word)
{
	struct ts_suggest suggest = ts_suggest_start(word->text);

	for (const struct ts_review_check *c = sim->tables->checks; c->name; c++)
		ts_suggest_try(&suggest, c->name);
	return ts_fail(&sim->error, TS_UNKNOWN, &word->place,
		       "review: unknown check '%s'%s; -help review lists all", word->text,
		       ts_suggest_text(&suggest));
}

static enum ts_status run(struct tsim *sim, void *state, const struct ts_place *where)
{
	const struct state *s = state;

	(void)where;
	if (!s->names.n)
		ts_review_set(sim, NULL, (enum ts_review_answer)s->answer);
	for (size_t k = 0; k < s->names.n; k++)
		if (!ts_review_set(sim, s->names.word[k].text, (enum ts_review_answer)s->answer))
			return refuse_name(sim, &s->names.word[k]);
	return TS_OK;
}

static const struct ts_arg args[] = {
	TS_ENUM("answer", struct state, answer, answers, .flags = TS_POSITIONAL,
		.help = "warn: print findings as warnings; error: refuse runs with findings; off: skip the "
			"checks"),
	TS_REST_OPTIONAL("names", struct state, names, .help = "names of checks; default: all"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_review)
const struct ts_command_style ts_command_review = {
	.style = {
		.name = "review",
		.kind = TS_KIND_COMMAND,
		.summary = "Sets the treatment of the findings of the review before a run",
		.doc = "Before the first step of a run the set-up is reviewed for settings that are allowed "
		       "but usually a mistake. Each finding is printed once per script, and again after "
		       "`clear`, as a warning with numbers, the line of the script, a proposed change, and at its end the name of the "
		       "check, such as `(review: overlap)`. `tsim -check` prints the findings without "
		       "running. doc/review.md describes all checks.\n\n"
		       "`review error` refuses runs with findings, `review off` makes no checks; both may be "
		       "restricted to the named checks. The default is `review warn`, also after `clear`.\n\n"
		       "The review takes no longer than about a step and changes no result. It is made when a "
		       "run begins, but not again by a run that continues it.",
		.example = "review error\n"
			   "review off overlap wall_overlap",
		.args = args,
		.state_size = sizeof(struct state),
	},
	.run = run,
};
