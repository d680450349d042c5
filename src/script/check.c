#include "script/check.h"

#include <stdio.h>
#include <string.h>

#include "formula/unknown.h"
#include "script/diagnostic.h"

#include "base/banned.h"

/* Commands that define something: its kind, and the number of the word that is its name. */
static const struct {
	const char *command, *kind;
	size_t word;
} makes[] = {
	{ "variable", "variable", 1 }, { "fix", "fix", 1 },	   { "compute", "compute", 1 },
	{ "region", "region", 1 },     { "group", "group", 1 },	   { "dump", "dump", 1 },
	{ "molecule", "molecule", 1 }, { "create_box", "box", 0 }, { "read_data", "box", 0 },
	{ "read_restart", "box", 0 },
};

/* Commands on whose effect later lines do not depend. */
static const char *const harmless[] = {
	"print",    "echo",	     "log",	      "shell",	    "label",	"jump",	       "next",
	"thermo",   "thermo_style",  "thermo_modify", "thermo_log", "dump",	"dump_modify", "undump",
	"restart",  "write_restart", "write_dump",    "write_data", "info",	"if",	       "run",
	"variable", "timestep",	     "uncompute",     "compute",    "run_time",
};

/* Key of a line in `guessed`. */
enum { LINE_KEY = 300 };
static void line_key(const struct ts_place *place, char key[LINE_KEY])
{
	snprintf(key, LINE_KEY, "%s:%d", place->file ? place->file : "", place->line);
}

/* Whether the line at this place was executed with a number in place of an unknown value. */
static bool is_guessed(const struct ts_check *check, const struct ts_place *place)
{
	char key[LINE_KEY];

	line_key(place, key);
	return ts_map_get(&check->guessed, key) != NULL;
}

/* A warning of a run about what such a line has defined may follow from the number. */
static bool doubts_warning(void *data, const struct ts_place *place)
{
	struct ts_check *check = data;
	const bool doubtful = is_guessed(check, place);

	check->open += doubtful;
	return doubtful;
}

enum ts_status ts_check_new(struct ts_script *script)
{
	script->check = ts_alloc(1, sizeof *script->check);
	if (!script->check)
		return ts_nomem(&script->sim->error);
	script->check->last = &script->check->first;
	script->sim->log.doubts = doubts_warning;
	script->sim->log.doubts_data = script->check;
	return TS_OK;
}

void ts_check_free(struct ts_script *script)
{
	struct ts_check *check = script->check;

	if (!check)
		return;
	ts_str_release(&check->errors);
	ts_map_release(&check->seen);
	ts_map_release(&check->lost);
	ts_map_release(&check->events);
	ts_map_release(&check->guessed);
	for (struct ts_check_loop *loop = check->loop; loop; loop = loop->next)
		ts_free(loop->run);
	ts_arena_release(&check->arena);
	ts_free(check);
	script->check = NULL;
	script->sim->log.doubts = NULL;
}

static bool is_harmless(const char *command)
{
	for (size_t k = 0; k < sizeof harmless / sizeof *harmless; k++)
		if (ts_streq(harmless[k], command))
			return true;
	return false;
}

/* Whether the line names something that was defined with an unknown value. */
static bool names_unknown_value(const struct ts_check *check, const char *text)
{
	char name[64];

	while (text && *text) {
		size_t n = strcspn(text, " \t\"'"), kept = n < sizeof name ? n : 0;

		memcpy(name, text, kept);
		name[kept] = '\0';
		if (kept && ts_map_get(&check->guessed, name))
			return true;
		text += n + strspn(text + n, " \t\"'");
	}
	return false;
}

/* Whether the error is that a file does not exist which the script would have written before. */
static bool would_have_been_written(const struct ts_check *check, const struct ts_error *error)
{
	for (const struct ts_check_event *e = check->first; e && error->status == TS_IO; e = e->next) {
		size_t n = e->path ? strcspn(e->path, "*%?") : 0;
		const char *at = n ? strstr(error->message, e->path) : NULL;
		char head[256];

		if (n && !at && n < sizeof head && e->path[n]) {
			snprintf(head, sizeof head, "'%.*s", (int)n, e->path);
			at = strstr(error->message, head);
		}
		if (at)
			return true;
	}
	return false;
}

/* Whether the error may follow from an unknown value, or from a file that is not written. */
static bool may_be_unknown(const struct ts_script *script, const struct ts_error *error)
{
	const struct ts_check *check = script->check;

	if (would_have_been_written(check, error) || ts_unknown_in_text(script->sim, error->message))
		return true;
	if (error->status == TS_SYNTAX || error->status == TS_UNKNOWN)
		return false;
	if (check->alternatives || error->conflict)
		return check->alternatives;
	return is_guessed(check, &error->place) || names_unknown_value(check, error->place.text);
}

/* Whether the error may follow from an earlier one, or from a number in place of an unknown one. No such number makes
 * definitions exclude each other. */
static bool may_follow_from_error(const struct ts_check *check, const struct ts_error *error)
{
	if (error->missing[0] && ts_map_get(&check->lost, error->missing))
		return true;
	if (check->cut && error->missing[0])
		return true;
	if (check->unread && strncmp(error->missing, "group ", 6) == 0)
		return true;
	if (error->status == TS_STATE || error->status == TS_PHYSICS)
		return check->weak || check->substitute_box || (check->guesses && !error->conflict);
	return error->status == TS_RANGE && check->substitute_box;
}

/* By this key each error is reported once; NULL: out of memory. */
static const char *key_of_place(struct ts_script *script, const struct ts_error *error)
{
	const struct ts_place *place = &error->place;
	struct ts_str key = { 0 };
	const char *kept;

	/* several findings of the review may be reported at the same run command: the name of the check is
	 * part of the key */
	if (place->line)
		ts_str_addf(&key, "%s:%d:%d%s", place->file, place->line, place->column,
			    error->source_line ? "" : error->source);
	else
		ts_str_add(&key, error->message);
	kept = key.failed ? NULL : ts_pool_get(script->sim->pool, ts_str_text(&key));
	ts_str_release(&key);
	return kept;
}

enum ts_status ts_check_keep_error(struct ts_script *script, const char *remark)
{
	struct ts_check *check = script->check;
	struct ts_error error = script->sim->error;
	size_t n = strlen(error.message);
	const char *key = key_of_place(script, &error);

	if (error.status == TS_NOMEM || error.status == TS_STOPPED)
		return error.status;
	ts_error_clear(&script->sim->error);
	if (!key)
		return ts_nomem(&script->sim->error);
	if (may_be_unknown(script, &error) || may_follow_from_error(check, &error)) {
		*(check->nerrors ? &check->left_out : &check->open) += 1;
		return TS_OK;
	}
	if (ts_map_get(&check->seen, key))
		return TS_OK;
	snprintf(error.message + n, sizeof error.message - n, "%s", remark);
	ts_diagnostic(&error, &check->errors);
	check->nerrors++;
	if (check->errors.failed || ts_map_set(&check->seen, key, check) != TS_OK)
		return ts_nomem(&script->sim->error);
	return TS_OK;
}

enum ts_status ts_check_defer_error(struct ts_script *script, enum ts_status status)
{
	const struct ts_error *error = &script->sim->error;

	if (status == TS_OK || !script->check || status == TS_NOMEM || status == TS_STOPPED)
		return status;
	if (!script->sim->reading.check && !may_be_unknown(script, error) &&
	    !may_follow_from_error(script->check, error))
		return status;
	return ts_check_keep_error(script, "");
}

/* Creates a box in place of one whose command has failed, so that later lines can be checked. */
static enum ts_status create_substitute_box(struct ts_script *script, struct ts_words words)
{
	struct ts_check *check = script->check;
	const bool guesses = check->guesses;
	char text[160];
	int64_t types;
	enum ts_status status;

	check->substitute_box = true;
	script->sim->reading.planned = true; /* particles are unknown, as after a run that is left out */
	if (ts_sim_has_box(script->sim) || check->creating_box)
		return TS_OK;
	if (words.n < 2 || !ts_parse_int(words.word[1].text, &types) || types < 1 || types > 1000)
		types = 8;
	snprintf(text, sizeof text,
		 "%sregion box-of-check block 0 1 0 1 -0.5 0.5 units box\n"
		 "create_box %d box-of-check\nregion box-of-check delete",
		 script->sim->dimension == 2 ? "boundary f f p\n" : "", (int)types);
	check->weak = check->guesses = false;
	check->creating_box = true;
	status = ts_script_execute(script, text, NULL);
	check->creating_box = false;
	check->weak = true;
	check->guesses = guesses;
	return status;
}

enum ts_status ts_check_mark_lost(struct ts_script *script, const char *kind, const char *name)
{
	struct ts_str key = { 0 };
	const char *kept;

	ts_str_addf(&key, "%s %s", kind, name);
	kept = key.failed ? NULL : ts_pool_get(script->sim->pool, ts_str_text(&key));
	ts_str_release(&key);
	if (!kept || ts_map_set(&script->check->lost, kept, script->check) != TS_OK)
		return ts_nomem(&script->sim->error);
	return TS_OK;
}

static enum ts_status mark_names_lost(struct ts_script *script, struct ts_words words)
{
	const char *command = words.word[0].text;

	script->check->weak |= !is_harmless(command);
	script->sim->reading.broken |= !is_harmless(command) && script->check->nerrors;
	script->sim->review.doubtful = script->check->weak || script->check->guesses;
	script->check->unread |= ts_streq(command, "read_restart");
	for (size_t k = 0; k < sizeof makes / sizeof *makes; k++) {
		if (!ts_streq(makes[k].command, command))
			continue;
		if (makes[k].word == 0)
			return create_substitute_box(script, words);
		if (makes[k].word < words.n)
			return ts_check_mark_lost(script, makes[k].kind, words.word[makes[k].word].text);
	}
	if (ts_script_command_runs(command) && script->sim->clock.step < script->sim->clock.last_step)
		script->sim->clock.step = script->sim->clock.last_step;
	return TS_OK;
}

static enum ts_status mark_guessed(struct ts_script *script, const char *text)
{
	const char *kept = ts_pool_get(script->sim->pool, text);

	if (!kept || ts_map_set(&script->check->guessed, kept, script->check) != TS_OK)
		return ts_nomem(&script->sim->error);
	return TS_OK;
}

/* Whether the line defines or deletes something whose name has an unknown value: what there is then is not known. */
static bool names_by_guess(const struct ts_script *script, struct ts_words words)
{
	static const char *const commands[] = { "fix", "unfix", "region", "group", "molecule" };

	for (size_t k = 0; words.n > 1 && k < sizeof commands / sizeof *commands; k++)
		if (ts_streq(commands[k], words.word[0].text))
			return ts_unknown_in_text(script->sim, words.word[1].text);
	return false;
}

enum ts_status ts_check_mark_guessed(struct ts_script *script, const struct ts_line *line,
				     struct ts_words words)
{
	const char *command = words.word[0].text;
	struct ts_check *check = script->check;
	char key[LINE_KEY];

	check->guesses |= !is_harmless(command) || ts_streq(command, "timestep");
	check->weak |= names_by_guess(script, words);
	if (script->sim->reading.from_run[0])
		script->formulas.unknown = ts_pool_get(script->sim->pool, script->sim->reading.from_run);
	line_key(&line->row[0], key);
	TS_TRY(mark_guessed(script, key));
	for (size_t k = 0; k < sizeof makes / sizeof *makes; k++)
		if (ts_streq(makes[k].command, command) && makes[k].word && makes[k].word < words.n &&
		    !ts_streq(command, "variable"))
			TS_TRY(mark_guessed(script, words.word[makes[k].word].text));
	return TS_OK;
}

enum ts_status ts_check_recover(struct ts_script *script, const struct ts_line *line, struct ts_words words,
				enum ts_status status)
{
	struct ts_error *error = &script->sim->error;
	struct ts_arena arena = { 0 };

	if (status == TS_NOMEM || status == TS_STOPPED)
		return status;
	if (error->status == TS_OK)
		ts_fail(error, status, line->rows ? &line->row[0] : NULL, "%s", ts_status_text(status));
	status = ts_check_defer_error(script, error->status);
	if (status == TS_OK && !words.n && line->rows)
		status = ts_words_split(&arena, line->row[0].text, &line->row[0], &words);
	if (status == TS_OK && words.n)
		status = mark_names_lost(script, words);
	ts_arena_release(&arena);
	return status == TS_NOMEM ? ts_nomem(error) : status;
}
