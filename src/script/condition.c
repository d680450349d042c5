/* if "condition" then commands [elif "condition" commands ...] [else commands] */
#include "formula/expr.h"
#include "script/check.h"
#include "script/internal.h"

#include "base/banned.h"

TS_STYLE(command, ts_command_style, ts_command_if)

struct condition {
	struct ts_words words;
};

static const struct ts_arg if_args[] = {
	TS_REST("condition then commands", struct condition, words,
		.help = "a condition in quotes, `then`, and one or more commands, each in quotes; `elif "
			"\"condition\" commands` and `else commands` may follow"),
	TS_ARGS_END
};

/* Also in quotes, which LIGGGHTS and LAMMPS take off first. */
static bool is_word(const struct ts_word *word, const char *text)
{
	return ts_streq(word->text, text);
}

static enum ts_status evaluate_condition(struct ts_script *script, const struct ts_word *word,
					 enum ts_truth *out)
{
	struct ts_str text = { 0 };
	enum ts_status status = ts_substitute_condition(script, word->text, &word->place, &text);

	if (status == TS_OK)
		status = ts_expr_condition(&script->formulas, ts_str_text(&text), &word->place, out);
	ts_str_release(&text);
	return status;
}

/* Index of the first word at or behind k that is elif or else. */
static size_t find_branch_end(struct ts_words words, size_t k)
{
	while (k < words.n && !is_word(&words.word[k], "elif") && !is_word(&words.word[k], "else"))
		k++;
	return k;
}

static enum ts_status fail_no_command(struct tsim *sim, const struct ts_word *word)
{
	return ts_fail(&sim->error, TS_SYNTAX, &word->place,
		       "expected a command for this branch, found none");
}

/* An `else` without a command is an error only when it is executed. */
enum ts_status ts_condition_words(struct tsim *sim, struct ts_words words, const struct ts_place *where)
{
	const struct ts_word *word = words.word;

	if (words.n < 3)
		return ts_fail(&sim->error, TS_SYNTAX, where,
			       "expected: if \"condition\" then \"command\" ...");
	if (!is_word(&word[1], "then"))
		return ts_fail(&sim->error, TS_SYNTAX, &word[1].place,
			       "expected 'then' after the condition, found '%s' (a condition with blanks "
			       "needs quotes)",
			       word[1].text);
	for (size_t k = 0, end; k < words.n; k = end) {
		bool otherwise = is_word(&word[k], "else");
		size_t first = k == 0 ? 2 : k + 2 - otherwise;

		if (first < words.n && k && !otherwise && is_word(&word[first], "then"))
			first++;
		end = find_branch_end(words, first);
		if ((first >= words.n || end == first) && !(otherwise && k))
			return fail_no_command(sim, &word[k]);
		if (otherwise && end < words.n)
			return ts_fail(&sim->error, TS_SYNTAX, &word[end].place,
				       "nothing may follow the else branch, found '%s'", word[end].text);
	}
	return TS_OK;
}

static enum ts_status run_branch(struct ts_script *script, struct ts_words words, size_t k)
{
	size_t end = find_branch_end(words, k);
	enum ts_status status = TS_OK;

	script->branches++;
	for (; status == TS_OK && k < end && !script->label && !script->quit; k++) {
		struct ts_source *source = script->source;
		size_t at = source ? source->at : 0;

		status = ts_script_execute(script, words.word[k].text, &words.word[k].place);
		if (source && source->at != at)
			break; /* jumped */
	}
	script->branches--;
	return status;
}

/* -check: parses the commands of all branches, also of those not taken, once. An error of the condition
 * (`waiting`) is restored afterwards. */
static enum ts_status check_all_branches(struct ts_script *script, struct ts_words words, bool *read,
					 enum ts_status waiting)
{
	struct ts_error *error = &script->sim->error, kept = *error;
	enum ts_status status;

	if (*read)
		return TS_OK;
	*read = true;
	if (waiting != TS_OK)
		ts_error_clear(error);
	status = ts_check_unreached_commands(script, words);
	if (status == TS_OK && waiting != TS_OK)
		*error = kept;
	return status;
}

static enum ts_status run_if(struct tsim *sim, void *state, const struct ts_place *where)
{
	struct ts_words words = ((const struct condition *)state)->words;
	struct ts_script *script;
	enum ts_status status;
	bool read = false;
	size_t k = 0;

	TS_TRY(ts_script_of(sim, where, &script));
	TS_TRY(ts_condition_words(sim, words, where));
	while (k < words.n) {
		bool otherwise = is_word(&words.word[k], "else");
		enum ts_truth yes = TS_YES;
		size_t test = k == 0 ? 0 : k + 1, first = otherwise ? k + 1 : test + 1;

		if (!otherwise) {
			status = evaluate_condition(script, &words.word[test], &yes);
			if (sim->reading.check && (status != TS_OK || yes != TS_OPEN))
				TS_TRY(check_all_branches(script, words, &read, status));
			TS_TRY(status);
			first += is_word(&words.word[first], "then");
		}
		if (yes != TS_NO && first >= words.n)
			return fail_no_command(sim, &words.word[k]);
		if (yes == TS_OPEN && script->check)
			return ts_check_run_all_branches(script, words, k, where);
		if (yes == TS_YES) {
			TS_TRY(ts_check_record_branch(script, where, k ? words.word[k].text : "then"));
			return run_branch(script, words, first);
		}
		k = find_branch_end(words, first);
	}
	return ts_check_record_branch(script, where, "no branch");
}

const struct ts_command_style ts_command_if = {
	.style = {
		.name = "if",
		.kind = TS_KIND_COMMAND,
		.ranks = TS_RANKS_FORMULAS,
		.summary = "executes commands if a condition is true",
		.doc = "The condition is a formula: numbers, v_NAME, c_ID, functions, comparisons, && and ||; "
		       "it is true if its value is not 0. Bare names are words, which can be compared by == "
		       "and !=; words with blanks need quotes. The word property_NAME is 1 if there is a "
		       "material property NAME (fix property/global), else 0. Variables in the condition and "
		       "in the commands are substituted when these are evaluated and executed. `include` is "
		       "not allowed among the commands; use `jump`.",
		.example = "if \"${n} > 3 && ${mode} == drill\" then \"print 'deep enough'\" \"quit\" else "
			   "\"print 'go on'\"",
		.args = if_args,
		.state_size = sizeof(struct condition),
	},
	.run = run_if,
};
