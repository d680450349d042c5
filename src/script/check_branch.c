/* An `if` whose condition only a run can tell: all its branches are gone through, one after the other, and
 * what they define is there afterwards. Then the script goes on where it may: below, or, when it comes
 * here again, behind one of the jumps. */
#include <string.h>

#include "formula/expr.h"
#include "script/check.h"

#include "base/banned.h"

enum { MOST_WAYS = 8 };

/* Where the script may go on. */
struct ways {
	const struct ts_word *jump[MOST_WAYS]; /* forward; the command */
	size_t n;
	const struct ts_word *back, *quit; /* a jump back, and `quit`: only if there is nothing else */
	bool below, leaves;
};

static bool is(const struct ts_word *word, const char *text)
{
	return !word->quoted && ts_streq(word->text, text);
}

/* Things that a command takes away, named by its k-th word; `last`: only with this word at the end. */
static const struct {
	const char *command, *kind, *last;
} takes[] = {
	{ "unfix", "fix", NULL },	{ "uncompute", "compute", NULL },
	{ "undump", "dump", NULL },	{ "region", "region", "delete" },
	{ "group", "group", "delete" }, { "variable", "variable", "delete" },
};

/* After a branch that may not be the one: what it has taken away may be there, what it has set may be
 * otherwise. */
static enum ts_status doubt(struct ts_script *script, struct ts_words words)
{
	struct ts_variable *variable;

	for (size_t k = 0; words.n > 1 && k < sizeof takes / sizeof *takes; k++)
		if (ts_streq(takes[k].command, words.word[0].text) &&
		    (!takes[k].last || ts_streq(takes[k].last, words.word[words.n - 1].text)))
			TS_TRY(ts_check_mark_lost(script, takes[k].kind, words.word[1].text));
	if (words.n < 3 || !ts_streq(words.word[0].text, "variable"))
		return TS_OK;
	variable = ts_variable_find(&script->formulas, words.word[1].text);
	if (variable)
		variable->open = true;
	return TS_OK;
}

static enum ts_status note_jump(struct ts_script *script, const struct ts_word *command,
				struct ts_words words, struct ways *ways)
{
	const char *label = words.n > 2 ? words.word[2].text : NULL;
	struct ts_check_loop *loop = NULL;

	ways->leaves = true;
	if (words.n > 1)
		TS_TRY(ts_check_loop_of(script, &command->place, words.word[1].text, label, &loop));
	if (loop) {
		ts_check_open_loop(script, loop);
		ways->back = command;
	} else if (ways->n < MOST_WAYS) {
		ways->jump[ways->n++] = command;
	}
	return TS_OK;
}

/* One command of a branch; *end: nothing behind it is run. */
static enum ts_status go_through(struct ts_script *script, const struct ts_word *command, struct ways *ways,
				 bool *end)
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
		status = note_jump(script, command, words, ways);
		stays = false;
	} else if (status == TS_OK && words.n && ts_streq(words.word[0].text, "quit")) {
		ways->quit = command;
		ways->leaves = true;
		stays = false;
	} else if (status == TS_OK) {
		status = ts_script_execute(script, command->text, &command->place);
		stays = !script->label && !script->quit && (!source || source->at == at);
		if (status == TS_OK)
			status = doubt(script, words);
	}
	*end = !stays;
	ts_arena_release(&arena);
	ts_str_release(&text);
	return status;
}

static enum ts_status branch(struct ts_script *script, struct ts_words words, size_t from, size_t to,
			     struct ways *ways, bool *below)
{
	enum ts_status status = TS_OK;
	bool end = false;

	script->branches++;
	for (size_t k = from; k < to && status == TS_OK && !end; k++)
		status = go_through(script, &words.word[k], ways, &end);
	script->branches--;
	script->check->alternatives++;
	*below |= !end;
	return status;
}

/* Whether the condition of an elif may hold; after one that holds there is no other. */
static enum ts_status may_hold(struct ts_script *script, const struct ts_word *condition,
			       enum ts_truth *truth)
{
	struct ts_str text = { 0 };
	enum ts_status status = ts_substitute_text(script, condition->text, &condition->place, &text);

	*truth = TS_OPEN;
	if (status == TS_OK)
		status = ts_expr_condition(&script->formulas, ts_str_text(&text), &condition->place, truth);
	ts_str_release(&text);
	return ts_check_defer_error(script, status);
}

static enum ts_status all_branches(struct ts_script *script, struct ts_words words, size_t k,
				   struct ways *ways)
{
	bool last = false;

	while (k < words.n && !last) {
		bool otherwise = is(&words.word[k], "else");
		size_t first = otherwise ? k + 1 : k + 2 - (k == 0), end;
		enum ts_truth truth = TS_OPEN;

		if (!otherwise && k && words.n > k + 1)
			TS_TRY(may_hold(script, &words.word[k + 1], &truth));
		if (!otherwise && first < words.n && is(&words.word[first], "then"))
			first++;
		for (end = first;
		     end < words.n && !is(&words.word[end], "elif") && !is(&words.word[end], "else");)
			end++;
		if (truth != TS_NO)
			TS_TRY(branch(script, words, first, end, ways, &ways->below));
		last = otherwise || truth == TS_YES;
		k = end;
	}
	ways->below |= !last; /* no branch at all */
	return TS_OK;
}

/* The k-th time that it comes here. */
static enum ts_status go_on(struct ts_script *script, const struct ways *ways, int64_t k)
{
	int64_t most = (int64_t)ways->n + ways->below;
	const struct ts_word *way = NULL;

	if (k > most)
		k = most;
	if (k > 0 && !(ways->below && k == 1))
		way = ways->jump[k - 1 - ways->below];
	else if (!ways->below)
		way = ways->back ? ways->back : ways->quit;
	if (!way || script->label || script->quit)
		return TS_OK;
	return ts_script_execute(script, way->text, &way->place);
}

enum ts_status ts_check_branches(struct ts_script *script, struct ts_words words, size_t k,
				 const struct ts_place *where)
{
	struct ts_check *check = script->check;
	const struct ts_source *source = script->source;
	size_t at = source ? source->at : 0;
	int alternatives = check->alternatives;
	struct ts_check_event *event;
	struct ways ways = { 0 };
	enum ts_status status;

	check->branches++;
	TS_TRY(ts_check_note(script, TS_CHECK_STEP, where, script->sim->reading.from_run, &event,
			     "if: any branch"));
	event->open = true;
	status = all_branches(script, words, k, &ways);
	check->alternatives = alternatives;
	event->leaves |= ways.leaves;
	if (status != TS_OK || (source && source->at != at))
		return status; /* a command of a branch has jumped */
	return go_on(script, &ways, event->count);
}
