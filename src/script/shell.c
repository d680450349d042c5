/* The few things scripts ask of the operating system. No other program is started. */
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "script/interpreter.h"

#include "base/banned.h"

TS_STYLE(command, ts_command_style, ts_command_shell)

struct shell {
	struct ts_words words;
};

static const struct ts_arg shell_args[] = {
	TS_REST("action", struct shell, words,
		.help = "mkdir DIR ..., mv OLD NEW, rm FILE ..., rmdir DIR ..., cd DIR, or putenv "
			"NAME=VALUE ..."),
	TS_ARGS_END
};

static int make_directory(const char *path)
{
	struct stat info;

	if (mkdir(path, 0777) == 0)
		return 0;
	return errno == EEXIST && stat(path, &info) == 0 && S_ISDIR(info.st_mode) ? 0 : -1;
}

static int set_environment(const char *text)
{
	const char *equal = strchr(text, '=');
	char name[256];

	if (!equal || equal == text || (size_t)(equal - text) >= sizeof name) {
		errno = EINVAL;
		return -1;
	}
	snprintf(name, sizeof name, "%.*s", (int)(equal - text), text);
	return setenv(name, equal + 1, 1);
}

static const struct {
	const char *name;
	int (*act)(const char *path);
	bool writes; /* left out by -explain */
} actions[] = {
	{ "mkdir", make_directory, true },
	{ "rm", unlink, true },
	{ "rmdir", rmdir, true },
	{ "cd", chdir, false },
	{ "putenv", set_environment, false },
};

static enum ts_status note(struct tsim *sim, const char *what, const struct ts_word *word)
{
	return sim->host->would_write(sim->host_data, &word->place, what, word->text);
}

static enum ts_status move(struct tsim *sim, struct ts_words words)
{
	if (words.n != 3)
		return ts_fail(&sim->error, TS_SYNTAX, &words.word[0].place,
			       "expected: shell mv OLD NEW");
	if (sim->check)
		return note(sim, "shell mv", &words.word[1]);
	if (sim->explain || rename(words.word[1].text, words.word[2].text) == 0)
		return TS_OK;
	return ts_fail(&sim->error, TS_IO, &words.word[1].place, "cannot move '%s' to '%s': %s",
		       words.word[1].text, words.word[2].text, strerror(errno));
}

static enum ts_status run_shell(struct tsim *sim, void *state, const struct ts_place *where)
{
	struct ts_words words = ((const struct shell *)state)->words;
	struct ts_suggest suggest;
	char what[32];
	size_t a = 0, n = sizeof actions / sizeof *actions;

	(void)where;
	if (ts_streq(words.word[0].text, "mv"))
		return move(sim, words);
	suggest = ts_suggest_start(words.word[0].text);
	while (a < n && !ts_streq(actions[a].name, words.word[0].text))
		ts_suggest_try(&suggest, actions[a++].name);
	if (a == n)
		return ts_fail(&sim->error, TS_UNKNOWN, &words.word[0].place,
			       "shell knows mkdir, mv, rm, rmdir, cd and putenv, not '%s'%s",
			       words.word[0].text,
			       suggest.best ? ts_suggest_text(&suggest) : "");
	if (words.n < 2)
		return ts_fail(&sim->error, TS_SYNTAX, &words.word[0].place,
			       "expected a name after '%s'", actions[a].name);
	for (size_t k = 1; k < words.n && sim->check && actions[a].writes; k++) {
		snprintf(what, sizeof what, "shell %s", actions[a].name);
		TS_TRY(note(sim, what, &words.word[k]));
	}
	for (size_t k = 1; k < words.n && !(sim->explain && actions[a].writes); k++)
		if (actions[a].act(words.word[k].text) != 0)
			return ts_fail(&sim->error, TS_IO, &words.word[k].place,
				       "shell %s '%s' failed: %s", actions[a].name,
				       words.word[k].text, strerror(errno));
	return TS_OK;
}

const struct ts_command_style ts_command_shell = {
	.style = {
		.name = "shell",
		.kind = TS_KIND_COMMAND,
		.summary = "makes directories, moves and removes files",
		.doc = "mkdir of a directory that exists is no error. Other programs cannot be "
		       "started.",
		.example = "shell mkdir post",
		.args = shell_args,
		.state_size = sizeof(struct shell),
	},
	.run = run_shell,
};
