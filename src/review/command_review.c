/* Command review: what becomes of the findings before a run. */
#include "core/sim.h"

#include "base/banned.h"

struct state {
	int answer;
	struct ts_words names;
};

/* in the order of enum ts_review_answer */
static const char *const answers[] = { "warn", "error", "off", NULL };

static enum ts_status refuse(struct tsim *sim, const struct ts_word *word)
{
	struct ts_suggest suggest = ts_suggest_start(word->text);

	for (const struct ts_review_check *c = sim->tables->checks; c->name; c++)
		ts_suggest_try(&suggest, c->name);
	return ts_fail(&sim->error, TS_UNKNOWN, &word->place,
		       "review: there is no check '%s'%s; -help review lists them", word->text,
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
			return refuse(sim, &s->names.word[k]);
	return TS_OK;
}

static const struct ts_arg args[] = {
	TS_ENUM("answer", struct state, answer, answers, .flags = TS_POSITIONAL,
		.help = "findings are warnings, errors that refuse the run, or not looked for"),
	TS_REST_OPTIONAL("names", struct state, names, .help = "of these checks; none: of all"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_review)
const struct ts_command_style ts_command_review = {
	.style = {
		.name = "review",
		.kind = TS_KIND_COMMAND,
		.summary = "What becomes of the findings of the review of the scene before a run",
		.doc = "Before the first step of a run the scene is reviewed: is there something that is "
		       "allowed, but most\n"
		       "often a mistake? Each finding is told once in a script, as a warning with numbers, "
		       "the line of the\n"
		       "script, what to change, and at its end the name of the check: `(review: overlap)`. "
		       "`tsim -check` tells\n"
		       "the findings without running. doc/review.md lists all checks and what each of them "
		       "looks for.\n\n"
		       "`review error` refuses runs with findings, `review off` does not look; both may name "
		       "checks. The\n"
		       "default is `review warn`, also after `clear`.\n\n"
		       "The review takes as long as a step or less, and changes no result. It is made when a "
		       "run begins, and\n"
		       "not again by a run that only goes on.",
		.example = "review error\n"
			   "review off overlap wall_overlap",
		.args = args,
		.state_size = sizeof(struct state),
	},
	.run = run,
};
