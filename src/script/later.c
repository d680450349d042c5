/* Checks before a run of commands and texts that are used during it: commands of `run every`, the text of
 * fix print. Formulas are checked without values of the simulation, commands without being executed. */
#include <string.h>

#include "formula/dry_run.h"
#include "formula/expr.h"
#include "script/check.h"

#include "base/banned.h"

enum { DEEPEST_IF = 50 };

/* `commands` are executed one after the other: each may use names that others define. */
struct later {
	struct ts_script *script;
	struct ts_words commands;
	int depth; /* nesting of `if` */
};

/* Whether one of the commands mentions the missing name, and so may define it. */
static bool is_defined_later(const struct ts_error *error, struct ts_words commands)
{
	bool found = false;

	for (size_t k = 0; k < commands.n && error->missing[0] && !found; k++)
		found = strstr(commands.word[k].text, error->missing) != NULL;
	return found;
}

static enum ts_status clear_error_of_later_name(struct later *later, enum ts_status status)
{
	struct ts_error *error = &later->script->sim->error;

	if (status == TS_OK || !is_defined_later(error, later->commands))
		return status;
	ts_error_clear(error);
	return TS_OK;
}

/* Checks the substitutions of a text. */
static enum ts_status check_text(struct later *later, const char *text, const struct ts_place *where,
				 struct ts_str *out)
{
	struct ts_dry_run before = ts_dry_run_begin(&later->script->formulas);
	enum ts_status status = ts_substitute_text(later->script, text, where, out);

	return ts_dry_run_end(&later->script->formulas, before, clear_error_of_later_name(later, status),
			      true);
}

static enum ts_status check_condition(struct later *later, const struct ts_word *word, enum ts_truth *truth)
{
	struct ts_script *script = later->script;
	struct ts_dry_run before = ts_dry_run_begin(&script->formulas);
	struct ts_str text = { 0 };
	enum ts_status status = ts_substitute_text(script, word->text, &word->place, &text);

	*truth = TS_OPEN;
	if (status == TS_OK)
		status = ts_expr_condition(&script->formulas, ts_str_text(&text), &word->place, truth);
	ts_str_release(&text);
	return ts_dry_run_end(&script->formulas, before, clear_error_of_later_name(later, status), true);
}

static enum ts_status check_command(struct later *later, const struct ts_word *word);

/* Checks the condition and the commands of each branch. Branches that the present values exclude are only
 * parsed, by ts_check_unreached. */
static enum ts_status check_if(struct later *later, struct ts_words words, const struct ts_place *where)
{
	enum ts_truth truth = TS_OPEN;
	bool condition = true, reached = true;

	TS_TRY(ts_condition_words(later->script->sim, words, where));
	for (size_t k = 0; k < words.n; k++) {
		const struct ts_word *word = &words.word[k];
		bool bare = !word->quoted;

		if (condition) {
			condition = false;
			TS_TRY(check_condition(later, word, &truth));
			reached = truth != TS_NO;
		} else if (bare && (ts_streq(word->text, "elif") || ts_streq(word->text, "else"))) {
			if (truth == TS_YES)
				return TS_OK;
			condition = ts_streq(word->text, "elif");
			reached = true;
		} else if (reached && !(bare && ts_streq(word->text, "then"))) {
			TS_TRY(check_command(later, word));
		}
	}
	return TS_OK;
}

static enum ts_status check_inner_if(struct later *later, const struct ts_line *line)
{
	struct ts_arena arena = { 0 };
	struct ts_words words = { 0 };
	enum ts_status status = ts_line_split(line, &later->script->sim->error, &arena, &words);

	later->depth++;
	if (status == TS_OK && words.n && ts_streq(words.word[0].text, "if") && later->depth < DEEPEST_IF)
		status = check_if(later, ts_words_from(words, 1), &words.word[0].place);
	later->depth--;
	ts_arena_release(&arena);
	return status;
}

static enum ts_status check_command(struct later *later, const struct ts_word *word)
{
	struct ts_script *script = later->script;
	struct ts_line line = { 0 };
	struct ts_str text = { 0 };
	enum ts_status status = check_text(later, word->text, &word->place, &text);

	ts_str_release(&text);
	if (status == TS_OK && ts_line_set(&line, word->text, strlen(word->text), &word->place) != TS_OK)
		status = ts_nomem(&script->sim->error);
	ts_line_uncomment(&line);
	if (status == TS_OK)
		status = ts_check_unreached(script, &line, "");
	if (status == TS_OK)
		status = check_inner_if(later, &line);
	ts_line_release(&line);
	return status;
}

enum ts_status ts_later_check_commands(struct ts_script *script, struct ts_words commands)
{
	struct later later = { .script = script, .commands = commands };

	for (size_t k = 0; k < commands.n; k++)
		if (!ts_streq(commands.word[k].text, "NULL")) /* no command */
			TS_TRY(check_command(&later, &commands.word[k]));
	return TS_OK;
}

enum ts_status ts_later_check_text(struct ts_script *script, const char *text, const struct ts_place *where)
{
	struct later later = { .script = script, .commands = script->expected };
	struct ts_str out = { 0 };
	enum ts_status status = check_text(&later, text, where, &out);

	ts_str_release(&out);
	return status;
}
