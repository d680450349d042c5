/* An `if` with an unknown condition: all its branches are executed, one after the other, and their
 * definitions remain. Then the script continues below the `if`; each further time that the line is
 * executed it follows another of the jumps in the branches. */
#include <string.h>

#include "formula/dry_run.h"
#include "formula/expr.h"
#include "script/check.h"

#include "base/banned.h"

enum { MOST_EXITS = 8 };

/* Where the script may continue after the `if`. */
struct exits {
	const struct ts_word *jump[MOST_EXITS]; /* commands that jump forward */
	size_t n;
	const struct ts_word *back, *quit; /* a jump back, and `quit`: only if there is nothing else */
	bool falls_through, leaves;
};

static bool is_bare_word(const struct ts_word *word, const char *text)
{
	return !word->quoted && ts_streq(word->text, text);
}

/* Commands that delete something: its kind; its name is word 1; `last`: the last word must be this one. */
static const struct {
	const char *command, *kind, *last;
} takes[] = {
	{ "unfix", "fix", NULL },	{ "uncompute", "compute", NULL },
	{ "undump", "dump", NULL },	{ "region", "region", "delete" },
	{ "group", "group", "delete" }, { "variable", "variable", "delete" },
};

/* Names that are no names in formulas at all, and wrong syntax. The formula is evaluated when the variable is used, until when
 * other lines may define what it reads. */
static enum ts_status check_formula(struct ts_script *script, struct ts_variable *variable)
{
	struct ts_dry_run before = ts_dry_run_begin(&script->formulas);
	enum ts_status status;
	double number;

	script->sim->reading.unreached = true;
	status = ts_variable_number(&script->formulas, variable, NULL, &number);
	script->sim->reading.unreached = false;
	status = ts_dry_run_end(&script->formulas, before, status, !script->sim->error.missing[0]);
	return ts_check_defer_error(script, status);
}

/* After a command of a branch that may not be taken: what it has deleted may exist, and the variable it
 * has set may have another value. */
static enum ts_status mark_doubtful(struct ts_script *script, struct ts_words words)
{
	struct ts_variable *variable;

	for (size_t k = 0; words.n > 1 && k < sizeof takes / sizeof *takes; k++)
		if (ts_streq(takes[k].command, words.word[0].text) &&
		    (!takes[k].last || ts_streq(takes[k].last, words.word[words.n - 1].text)))
			TS_TRY(ts_check_mark_lost(script, takes[k].kind, words.word[1].text));
	if (words.n < 3 || !ts_streq(words.word[0].text, "variable"))
		return TS_OK;
	variable = ts_variable_find(&script->formulas, words.word[1].text);
	if (variable && ts_streq(variable->style->name, "equal"))
		TS_TRY(check_formula(script, variable));
	if (variable)
		variable->open = true;
	return TS_OK;
}

static enum ts_status record_jump(struct ts_script *script, const struct ts_word *command,
				  struct ts_words words, struct exits *exits)
{
	const char *label = words.n > 2 ? words.word[2].text : NULL;
	struct ts_check_loop *loop = NULL;

	exits->leaves = true;
	if (words.n > 1)
		TS_TRY(ts_check_loop_of(script, &command->place, words.word[1].text, label, &loop));
	if (loop) {
		ts_check_open_loop(script, loop);
		exits->back = command;
	} else if (exits->n < MOST_EXITS) {
		exits->jump[exits->n++] = command;
	}
	return TS_OK;
}

/* Executes one command of a branch, but records jumps and `quit`; *end: the branch ends with it. */
static enum ts_status run_branch_command(struct ts_script *script, const struct ts_word *command,
					 struct exits *exits, bool *end)
{
	const struct ts_source *source = script->source;
	size_t at = source ? source->at : 0;
	struct ts_arena arena = { 0 };
	struct ts_words words = { 0 };
	struct ts_str text = { 0 };
	enum ts_status status = ts_substitute_text(script, command->text, &command->place, &text);
	bool stays = true;

	if (status == TS_OK)
		status = ts_words_split(&arena, ts_str_text(&text), &command->place, &words);
	else
		status = ts_check_defer_error(script, status);
	if (status == TS_OK && words.n && ts_streq(words.word[0].text, "jump")) {
		status = record_jump(script, command, words, exits);
		stays = false;
	} else if (status == TS_OK && words.n && ts_streq(words.word[0].text, "quit")) {
		exits->quit = command;
		exits->leaves = true;
		stays = false;
	} else if (status == TS_OK) {
		status = ts_script_execute(script, command->text, &command->place);
		stays = !script->label && !script->quit && (!source || source->at == at);
		if (status == TS_OK)
			status = mark_doubtful(script, words);
	}
	*end = !stays;
	ts_arena_release(&arena);
	ts_str_release(&text);
	return status;
}

static enum ts_status run_branch(struct ts_script *script, struct ts_words words, size_t from, size_t to,
				 struct exits *exits, bool *falls_through)
{
	enum ts_status status = TS_OK;
	bool end = false;

	script->branches++;
	for (size_t k = from; k < to && status == TS_OK && !end; k++)
		status = run_branch_command(script, &words.word[k], exits, &end);
	script->branches--;
	script->check->alternatives++;
	*falls_through |= !end;
	return status;
}

/* Evaluates the condition of an elif. */
static enum ts_status evaluate_elif(struct ts_script *script, const struct ts_word *condition,
				    enum ts_truth *truth)
{
	struct ts_str text = { 0 };
	enum ts_status status = ts_substitute_condition(script, condition->text, &condition->place, &text);

	*truth = TS_OPEN;
	if (status == TS_OK)
		status = ts_expr_condition(&script->formulas, ts_str_text(&text), &condition->place, truth);
	ts_str_release(&text);
	return ts_check_defer_error(script, status);
}

static enum ts_status run_all_branches(struct ts_script *script, struct ts_words words, size_t k,
				       struct exits *exits)
{
	bool last = false;

	while (k < words.n && !last) {
		bool otherwise = is_bare_word(&words.word[k], "else");
		size_t first = otherwise ? k + 1 : k + 2 - (k == 0), end;
		enum ts_truth truth = TS_OPEN;

		if (!otherwise && k && words.n > k + 1)
			TS_TRY(evaluate_elif(script, &words.word[k + 1], &truth));
		if (!otherwise && first < words.n && is_bare_word(&words.word[first], "then"))
			first++;
		for (end = first; end < words.n && !is_bare_word(&words.word[end], "elif") &&
				  !is_bare_word(&words.word[end], "else");)
			end++;
		if (truth != TS_NO)
			TS_TRY(run_branch(script, words, first, end, exits, &exits->falls_through));
		last = otherwise || truth == TS_YES;
		k = end;
	}
	exits->falls_through |= !last; /* no branch at all */
	return TS_OK;
}

/* Continues the script at its k-th execution of the `if`. */
static enum ts_status continue_after_branches(struct ts_script *script, const struct exits *exits, int64_t k)
{
	int64_t most = (int64_t)exits->n + exits->falls_through;
	const struct ts_word *next = NULL;

	if (k > most)
		k = most;
	if (k > 0 && !(exits->falls_through && k == 1))
		next = exits->jump[k - 1 - exits->falls_through];
	else if (!exits->falls_through)
		next = exits->back ? exits->back : exits->quit;
	if (!next || script->label || script->quit)
		return TS_OK;
	return ts_script_execute(script, next->text, &next->place);
}

enum ts_status ts_check_run_all_branches(struct ts_script *script, struct ts_words words, size_t k,
					 const struct ts_place *where)
{
	struct ts_check *check = script->check;
	const struct ts_source *source = script->source;
	size_t at = source ? source->at : 0;
	int alternatives = check->alternatives;
	struct ts_check_event *event;
	struct exits exits = { 0 };
	enum ts_status status;

	check->branches++;
	TS_TRY(ts_check_record_event(script, TS_CHECK_STEP, where, script->sim->reading.from_run, &event,
				     "if: any branch"));
	event->open = true;
	status = run_all_branches(script, words, k, &exits);
	check->alternatives = alternatives;
	event->leaves |= exits.leaves;
	if (status != TS_OK || (source && source->at != at))
		return status; /* a command of a branch has jumped */
	return continue_after_branches(script, &exits, event->count);
}
