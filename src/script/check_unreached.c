/* Checks of commands that are not executed: does the command exist, do its arguments match its table?
 * Lines with variables are checked only for the command; names of groups, regions and variables need not
 * exist. */
#include <string.h>

#include "core/unsupported_names.h"
#include "script/check.h"

#include "base/banned.h"

/* Commands with a style: the kind, and the number of the word that is the style's name. */
static const struct {
	const char *command;
	enum ts_kind kind;
	size_t word;
} hands_on[] = {
	{ "fix", TS_KIND_FIX, 3 },
	{ "compute", TS_KIND_COMPUTE, 3 },
	{ "region", TS_KIND_REGION, 2 },
	{ "dump", TS_KIND_DUMP, 3 },
	{ "pair_style", TS_KIND_PAIR, 1 },
	{ "bond_style", TS_KIND_BOND, 1 },
	{ "flow_style", TS_KIND_FLOW, 1 },
	{ "pressure_style", TS_KIND_PRESSURE, 1 },
	{ "automaton_style", TS_KIND_AUTOMATON, 1 },
};

static enum ts_status parse_arguments(struct ts_script *script, const struct ts_style *style,
				      struct ts_words words, const struct ts_place *where)
{
	struct ts_arena arena = { 0 };
	void *state = ts_alloc_aligned(1, style->state_size + 1);
	enum ts_status status;

	if (!state)
		return ts_nomem(&script->sim->error);
	script->sim->reading.unreached = true;
	status = ts_args_parse(script->sim, style->name, style->args, words, where, &arena, state);
	script->sim->reading.unreached = false;
	ts_arena_release(&arena);
	ts_free(state);
	return status;
}

/* Names of other programs that tsim does not support are no error in a line that is not executed: *style
 * is NULL. */
static enum ts_status find_style_unless_foreign(struct ts_script *script, enum ts_kind kind,
						const struct ts_word *name, const struct ts_style **style)
{
	*style = ts_style_find(script->sim->tables, kind, name->text);
	if (*style || strchr(name->text, '$') || ts_unsupported_find(kind, name->text))
		return TS_OK;
	return ts_style_require(script->sim, kind, name, style);
}

/* `region ID delete`, `flow_style none`: a word that stands for no style. */
static bool removes(struct ts_words words, size_t n)
{
	return ts_streq(words.word[n].text, "delete") ||
	       (n == 1 && words.n == 2 && ts_streq(words.word[n].text, "none"));
}

static enum ts_status parse_command(struct ts_script *script, struct ts_words words, bool open)
{
	const struct ts_style *style;

	TS_TRY(find_style_unless_foreign(script, TS_KIND_COMMAND, &words.word[0], &style));
	if (!style)
		return TS_OK;
	if (ts_streq(style->name, "if"))
		return ts_check_unreached_commands(script, ts_words_from(words, 1));
	if (!open)
		TS_TRY(parse_arguments(script, style, ts_words_from(words, 1), &words.word[0].place));
	for (size_t k = 0; k < sizeof hands_on / sizeof *hands_on; k++) {
		size_t n = hands_on[k].word;

		if (!ts_streq(hands_on[k].command, style->name) || n >= words.n || removes(words, n))
			continue;
		TS_TRY(find_style_unless_foreign(script, hands_on[k].kind, &words.word[n], &style));
		return style && !open ? parse_arguments(script, style, ts_words_from(words, n + 1),
							&words.word[n].place)
				      : TS_OK;
	}
	return TS_OK;
}

enum ts_status ts_check_unreached(struct ts_script *script, const struct ts_line *line, const char *remark)
{
	struct ts_error *error = &script->sim->error;
	bool open = strchr(ts_str_text(&line->text), '$') != NULL;
	struct ts_arena arena = { 0 };
	struct ts_words words = { 0 };
	enum ts_status status = ts_line_split(line, error, &arena, &words);

	if (status == TS_OK && words.n)
		status = parse_command(script, words, open);
	if (status != TS_OK && script->sim->reading.check)
		status = ts_check_keep_error(script, remark);
	ts_arena_release(&arena);
	return status;
}

enum ts_status ts_check_unreached_commands(struct ts_script *script, struct ts_words words)
{
	struct ts_line line = { 0 };
	enum ts_status status = TS_OK;
	bool condition = true;

	for (size_t k = 0; k < words.n && status == TS_OK; k++) {
		const struct ts_word *word = &words.word[k];

		if (condition || (!word->quoted && ts_streq(word->text, "then"))) {
			condition = false;
			continue;
		}
		condition = !word->quoted && ts_streq(word->text, "elif");
		if (condition || (!word->quoted && ts_streq(word->text, "else")))
			continue;
		if (ts_line_set(&line, word->text, strlen(word->text), &word->place) != TS_OK)
			status = ts_nomem(&script->sim->error);
		ts_line_uncomment(&line);
		if (status == TS_OK)
			status = ts_check_unreached(script, &line, " (in a branch that is not taken)");
	}
	ts_line_release(&line);
	return status;
}
