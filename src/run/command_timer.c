/* Command timer: limits the wall time of runs. */
#include "core/sim.h"

#include <string.h>

#include "base/clock.h"

#include "base/banned.h"

struct state {
	struct ts_words words;
};

/* Parses seconds, minutes:seconds or hours:minutes:seconds; off, unlimited: -1. */
static bool read_time(const char *text, double *seconds)
{
	*seconds = 0;
	if (ts_streq(text, "off") || ts_streq(text, "unlimited")) {
		*seconds = -1;
		return true;
	}
	for (int part = 0; part < 3; part++) {
		size_t n = strcspn(text, ":");
		char number[24] = "";
		double value;

		if (n >= sizeof number)
			return false;
		memcpy(number, text, n);
		if (!ts_parse_real(number, &value) || !(value >= 0))
			return false;
		*seconds = 60 * *seconds + value;
		if (!text[n])
			return true;
		text += n + 1;
	}
	return false;
}

static enum ts_status refuse_value(struct tsim *sim, const struct ts_word *word, const char *expected)
{
	return ts_fail(&sim->error, TS_SYNTAX, &word->place, "timer: %s takes %s", word->text, expected);
}

static enum ts_status set_timeout(struct tsim *sim, struct ts_words words)
{
	double seconds;

	sim->run.halted = false;
	if (words.n > 1 && ts_streq(words.word[1].text, "reset"))
		return TS_OK;
	if (words.n < 2 || !read_time(words.word[1].text, &seconds))
		return refuse_value(sim, words.word, "seconds, m:s, h:m:s, off, unlimited or reset");
	sim->run.timeout = seconds < 0 ? 0 : ts_clock() + seconds;
	return TS_OK;
}

static enum ts_status set_interval(struct tsim *sim, struct ts_words words)
{
	if (words.n < 2 || !ts_parse_int(words.word[1].text, &sim->run.timeout_every) ||
	    sim->run.timeout_every < 1) {
		sim->run.timeout_every = 10;
		return refuse_value(sim, words.word, "a number of steps > 0");
	}
	return TS_OK;
}

static enum ts_status run(struct tsim *sim, void *state, const struct ts_place *where)
{
	static const char *const ignored[] = { "off", "loop", "normal", "full", "sync", "nosync", NULL };
	const struct state *s = state;

	(void)where;
	for (struct ts_words rest = s->words; rest.n;) {
		const struct ts_word *word = rest.word;
		size_t used = 2;
		int k = 0;

		while (ignored[k] && !ts_streq(ignored[k], word->text))
			k++;
		if (ts_streq(word->text, "timeout"))
			TS_TRY(set_timeout(sim, rest));
		else if (ts_streq(word->text, "every"))
			TS_TRY(set_interval(sim, rest));
		else if (ignored[k])
			used = 1;
		else
			return ts_fail(&sim->error, TS_SYNTAX, &word->place,
				       "timer: found '%s', expected off, loop, normal, full, sync, nosync, "
				       "timeout or every",
				       word->text);
		rest = ts_words_from(rest, used);
	}
	return TS_OK;
}

static const struct ts_arg args[] = {
	TS_REST("words", struct state, words,
		.help = "timeout T (seconds, m:s, h:m:s, off or unlimited): runs end when this wall time has "
			"elapsed from now, and later ones do nothing; timeout reset: runs are possible "
			"again; every N: steps between checks; off, loop, normal, full, sync, nosync: no "
			"effect"),
	TS_ARGS_END,
};

TS_STYLE(command, ts_command_style, ts_command_timer)
const struct ts_command_style ts_command_timer = {
	.style = {
		.name = "timer",
		.kind = TS_KIND_COMMAND,
		.ranks = TS_RANKS_FORMULAS,
		.summary = "Limits the wall time of runs",
		.doc = "A run that reaches the limit ends after the current step in the same way as at its "
		       "last step; later runs do nothing until the next `timer timeout`, so that a script can "
		       "still write a restart file. The wall time is checked every 10 steps of a run, or as "
		       "`every` says. With several ranks the clock of the first one decides, and all end "
		       "after the same step. The wall times of the stages of a step are always measured and printed "
		       "after a run.",
		.example = "timer timeout 2:30:00 every 100\ntimer timeout reset",
		.args = args,
		.state_size = sizeof(struct state),
	},
	.run = run,
};
