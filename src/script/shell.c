/* Command shell: operations on files and folders. Other programs are started, the environment is changed,
 * and files outside of the working folder are removed or moved only if the user has allowed it by -shell
 * yes. */
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/files_peers.h"
#include "base/mkdirs.h"
#include "core/ranks.h"
#include "script/internal.h"

#include "base/banned.h"

TS_STYLE(command, ts_command_style, ts_command_shell)

struct shell {
	struct ts_words words;
};

static const struct ts_arg shell_args[] = {
	TS_REST("action", struct shell, words,
		.help = "mkdir DIR ..., mv OLD NEW, rm FILE ..., rmdir DIR ..., or cd DIR; with -shell yes "
			"also putenv NAME=VALUE ... or a command of the system"),
	TS_ARGS_END
};

static int set_environment(struct ts_script *script, const char *text)
{
	const char *equal = strchr(text, '=');
	char name[256];

	(void)script;
	if (!equal || equal == text || (size_t)(equal - text) >= sizeof name) {
		errno = EINVAL;
		return -1;
	}
	snprintf(name, sizeof name, "%.*s", (int)(equal - text), text);
	return setenv(name, equal + 1, 1);
}

static int make_folder(struct ts_script *script, const char *path)
{
	return ts_mkdirs(&script->sim->files, path);
}

static int remove_file(struct ts_script *script, const char *path)
{
	return ts_files_remove(&script->sim->files, path);
}

static int remove_folder(struct ts_script *script, const char *path)
{
	return ts_files_remove_folder(&script->sim->files, path);
}

/* With -check and -explain, in a folder that a run would have made: follows a path, and returns what is left of it where
 * it leaves all such folders. An empty path stays in one. */
static const char *follow_missing_folders(struct ts_script *script, const char *path)
{
	if (path[0] == '/') {
		script->missing_folders = 0;
		return path;
	}
	while (path[0] && script->missing_folders) {
		const size_t n = strcspn(path, "/");

		if (n == 2 && !strncmp(path, "..", n))
			script->missing_folders--;
		else if (n && !(n == 1 && path[0] == '.'))
			script->missing_folders++;
		path += path[n] ? n + 1 : n;
	}
	return path;
}

/* Changes to a folder. With -check and -explain it may be one that a run would have made. */
static int change_folder(struct ts_script *script, const char *path)
{
	struct tsim *sim = script->sim;
	int result;

	if (script->missing_folders) {
		path = follow_missing_folders(script, path);
		if (!path[0])
			return 0;
	}
	result = ts_files_chdir(&sim->files, path);
	if (result && (sim->reading.check || sim->reading.explain)) {
		script->missing_folders = 1;
		follow_missing_folders(script, path);
		script->missing_folders--;
	}
	return result;
}

static const struct {
	const char *name;
	int (*act)(struct ts_script *script, const char *path);
	bool writes;	/* not done with -explain */
	bool removes;	/* only below the working folder, unless -shell yes */
	bool options;	/* words such as -p and -rf are ignored */
	bool forgiving; /* a failure is only a warning, since nothing depends on it; LIGGGHTS ignores it */
} actions[] = {
	{ "mkdir", make_folder, true, false, true, false },
	{ "rm", remove_file, true, true, true, true },
	{ "rmdir", remove_folder, true, true, true, true },
	{ "cd", change_folder, false, false, false, false },
	{ "putenv", set_environment, false, false, false, false },
};
enum { ACTIONS = sizeof actions / sizeof *actions };

static enum ts_status report_change(struct tsim *sim, const char *what, const struct ts_word *word)
{
	return sim->script_api->would_write(sim->script_api_data, &word->place, what, word->text);
}

/* A file, and the folder where tsim was started. */
struct place_of_file {
	const char *path, *home;
};

/* Whether a file is known to lie outside of the folder. Symbolic links in the path are resolved, but not the file itself,
 * which is removed or moved as a link. A file that does not exist cannot be changed. */
static int lies_outside(void *data)
{
	const struct place_of_file *file = data;
	struct ts_str path = { 0 };
	bool known = ts_files_resolve_name(file->path, &path) == 0;
	bool missing = !known && (errno == ENOENT || errno == ENOTDIR);
	bool below = known && ts_files_below(ts_str_text(&path), file->home) &&
		     !ts_streq(ts_str_text(&path), file->home);

	ts_str_release(&path);
	return !below && !missing;
}

static enum ts_status require_below_home(struct ts_script *script, const char *what,
					 const struct ts_word *word)
{
	struct place_of_file file = { word->text, script->home };

	if (script->programs || script->missing_folders ||
	    !ts_peers_by_first(&script->sim->files, lies_outside, &file))
		return TS_OK;
	return ts_fail(&script->sim->error, TS_STATE, &word->place,
		       "shell %s '%s': this is not below '%s', where tsim was started; files elsewhere are "
		       "removed and moved only with the option -shell yes",
		       what, word->text, script->home);
}

static enum ts_status move_file(struct ts_script *script, struct ts_words words)
{
	struct tsim *sim = script->sim;

	if (words.n != 3)
		return ts_fail(&sim->error, TS_SYNTAX, &words.word[0].place, "expected: shell mv OLD NEW");
	TS_TRY(require_below_home(script, "mv", &words.word[1]));
	TS_TRY(require_below_home(script, "mv", &words.word[2]));
	if (sim->reading.check)
		return report_change(sim, "shell mv", &words.word[1]);
	if (sim->reading.explain || ts_files_move(&sim->files, words.word[1].text, words.word[2].text) == 0)
		return TS_OK;
	return ts_fail(&sim->error, TS_IO, &words.word[1].place, "cannot move '%s' to '%s': %s",
		       words.word[1].text, words.word[2].text, ts_files_why(&sim->files));
}

/* Executes the words as a command line of the system's shell. */
static enum ts_status run_program(struct tsim *sim, struct ts_words words)
{
	const struct ts_word *first = &words.word[0];
	struct ts_str line = { 0 };
	int result = 0;

	TS_TRY(ts_ranks_refuse(sim, "shell with a program", &first->place));
	for (size_t k = 0; k < words.n; k++)
		ts_str_addf(&line, "%s%s", k ? " " : "", words.word[k].text);
	if (line.failed)
		return ts_nomem(&sim->error);
	if (sim->log.file)
		fflush(sim->log.file);
	if (sim->log.screen)
		fflush(sim->log.screen);
	if (!sim->reading.explain)
		result = system(line.text);
	ts_str_release(&line);
	if (result < 0)
		return ts_fail(&sim->error, TS_IO, &first->place, "cannot start a shell: %s",
			       strerror(errno));
	if (result)
		ts_warn(&sim->log, &first->place, "'%s' did not succeed", first->text);
	return TS_OK;
}

static enum ts_status unknown_action(struct tsim *sim, const struct ts_word *word)
{
	struct ts_suggest suggest = ts_suggest_start(word->text);

	for (size_t a = 0; a < ACTIONS; a++)
		ts_suggest_try(&suggest, actions[a].name);
	return ts_fail(&sim->error, TS_UNKNOWN, &word->place,
		       "shell knows mkdir, mv, rm, rmdir and cd, not '%s'%s; tsim starts other programs only "
		       "with the option -shell yes",
		       word->text, suggest.best ? ts_suggest_text(&suggest) : "");
}

static enum ts_status run_action(struct ts_script *script, size_t a, const struct ts_word *word)
{
	struct tsim *sim = script->sim;
	char what[32];

	if (actions[a].options && word->text[0] == '-')
		return TS_OK;
	if (actions[a].removes)
		TS_TRY(require_below_home(script, actions[a].name, word));
	if (sim->reading.check && actions[a].writes) {
		snprintf(what, sizeof what, "shell %s", actions[a].name);
		return report_change(sim, what, word);
	}
	if ((sim->reading.explain && actions[a].writes) || actions[a].act(script, word->text) == 0)
		return TS_OK;
	if (!actions[a].forgiving)
		return ts_fail(&sim->error, TS_IO, &word->place, "shell %s '%s' failed: %s", actions[a].name,
			       word->text, ts_files_why(&sim->files));
	ts_warn(&sim->log, &word->place, "shell %s '%s' failed: %s", actions[a].name, word->text,
		ts_files_why(&sim->files));
	return TS_OK;
}

static enum ts_status set_home(struct ts_script *script)
{
	struct ts_str home = { 0 };

	if (!script->home && ts_files_resolve(".", &home) == 0)
		script->home = ts_pool_get(script->sim->pool, ts_str_text(&home));
	ts_str_release(&home);
	return script->home ? TS_OK
			    : ts_fail(&script->sim->error, TS_IO, NULL, "shell: no working folder: %s",
				      strerror(errno));
}

/* ACTIONS: it is none of them. */
static size_t find_action(const char *name)
{
	size_t a = 0;

	while (a < ACTIONS && !ts_streq(actions[a].name, name))
		a++;
	return a;
}

static bool is_move(const char *name)
{
	return ts_streq(name, "mv");
}

static enum ts_status run_words(struct ts_script *script, struct ts_words words)
{
	const struct ts_word *first = &words.word[0];
	const size_t a = find_action(first->text);
	struct tsim *sim = script->sim;

	if (is_move(first->text))
		return move_file(script, words);
	if (a == ACTIONS)
		return script->programs ? run_program(sim, words) : unknown_action(sim, first);
	if (words.n < 2)
		return ts_fail(&sim->error, TS_SYNTAX, &first->place, "expected a name after '%s'",
			       actions[a].name);
	if (actions[a].act == set_environment && !script->programs)
		return ts_fail(&sim->error, TS_STATE, &first->place,
			       "shell putenv changes the environment only with the option -shell yes");
	for (size_t k = 1; k < words.n; k++)
		TS_TRY(run_action(script, a, &words.word[k]));
	return TS_OK;
}

/* The words of a command that is one word in quotes, as `shell "mkdir -p post"`; others are left as they are. */
static enum ts_status split_quoted(struct ts_arena *arena, struct ts_words *words)
{
	const struct ts_word *quoted = &words->word[0];
	struct ts_words parts;
	struct ts_word *word;

	if (words->n != 1 || !quoted->quoted)
		return TS_OK;
	TS_TRY(ts_words_split(arena, quoted->text, &quoted->place, &parts));
	if (parts.n < 2 || (find_action(parts.word[0].text) == ACTIONS && !is_move(parts.word[0].text)))
		return TS_OK;
	word = ts_arena_alloc(arena, parts.n, sizeof *word);
	if (!word)
		return TS_NOMEM;
	for (size_t k = 0; k < parts.n; k++)
		word[k] = (struct ts_word){ parts.word[k].text, quoted->place, true };
	*words = (struct ts_words){ word, parts.n };
	return TS_OK;
}

static enum ts_status run_shell(struct tsim *sim, void *state, const struct ts_place *where)
{
	struct ts_words words = ((const struct shell *)state)->words;
	struct ts_arena arena = { 0 };
	struct ts_script *script;
	enum ts_status status;

	TS_TRY(ts_script_of(sim, where, &script));
	TS_TRY(set_home(script));
	status = split_quoted(&arena, &words) == TS_OK ? run_words(script, words) : ts_nomem(&sim->error);
	ts_arena_release(&arena);
	return status;
}

const struct ts_command_style ts_command_shell = {
	.style = {
		.name = "shell",
		.kind = TS_KIND_COMMAND,
		.summary = "creates folders, moves and removes files",
		.doc = "mkdir also creates the parent folders; a folder that exists is no error. rm or rmdir "
		       "of a name that does not exist gives a warning; rm does not remove folders. Options "
		       "such as -p and -rf have no effect. The whole may be one word in quotes: shell \"mkdir -p "
		       "post\". rm, rmdir and mv act only below the folder in "
		       "which tsim was started; symbolic links are resolved. With the option -shell yes of "
		       "the command line they act everywhere, putenv sets environment variables, and any "
		       "other words are executed by the system's shell; without it these are refused. The "
		       "only program that a script can start without it is ffmpeg, with fixed arguments, for "
		       "movies (dump automaton/png). doc/language.md describes which files a script may "
		       "change by other commands; scripts from unknown sources can be run with -sandbox.",
		.example = "shell mkdir post\nshell mv profile.txt post/profile_old.txt",
		.args = shell_args,
		.state_size = sizeof(struct shell),
	},
	.run = run_shell,
};
