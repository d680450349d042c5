#include "study/study_script.h"

#include <ctype.h>
#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#include "base/hash.h"
#include "base/script_folders.h"
#include "io/lines.h"

#include "base/banned.h"

enum { DEEPEST = 10 };

struct reading {
	struct ts_study_script *script;
	struct tsim *sim;
	struct ts_arena *arena;
	struct ts_hash hash;
	int depth;
};

static enum ts_status add_variable(struct reading *r, const char *name)
{
	struct ts_study_script *s = r->script;
	const char *copy;

	for (size_t k = 0; k < s->variables; k++)
		if (ts_streq(s->variable[k], name))
			return TS_OK;
	copy = ts_arena_strdup(r->arena, name);
	if (!copy || TS_GROW(s->variable, s->capacity, s->variables + 1) != TS_OK)
		return ts_nomem(&r->sim->error);
	s->variable[s->variables++] = copy;
	return TS_OK;
}

static enum ts_status read_file(struct reading *r, const char *path);

static bool is_file(struct reading *r, const char *path)
{
	struct stat info;

	return ts_files_stat(&r->sim->files, path, &info) == 0 && S_ISREG(info.st_mode);
}

/* Like command include: in the working folder, or beside the script `by`. A name with variables is no file. */
static enum ts_status read_included(struct reading *r, const char *by, const char *path)
{
	struct ts_str beside = { 0 };
	enum ts_status status = TS_OK;

	if (r->depth >= DEEPEST)
		return TS_OK;
	r->depth++;
	if (is_file(r, path))
		status = read_file(r, path);
	else if (ts_files_beside(&r->sim->files, &beside, by, path) && !beside.failed &&
		 is_file(r, beside.text))
		status = read_file(r, beside.text);
	else if (beside.failed)
		status = ts_nomem(&r->sim->error);
	ts_str_release(&beside);
	r->depth--;
	return status;
}

/* Reads a file and those it includes. */
static enum ts_status read_file(struct reading *r, const char *path)
{
	struct ts_lines l = { 0 };
	bool more = true;
	enum ts_status status = ts_lines_open(&l, &r->sim->files, &r->sim->error, r->sim->pool,
					      &(struct ts_place){ 0 }, path);

	while (status == TS_OK) {
		status = ts_lines_next_filled(&l, &more);
		if (status != TS_OK || !more)
			break;
		for (size_t k = 0; k < l.nwords; k++) {
			ts_hash_text(&r->hash, l.word[k]);
			ts_str_addf(&r->script->text, " %s", l.word[k]);
		}
		ts_hash_text(&r->hash, "\n");
		if (l.nwords < 2)
			continue;
		if (ts_streq(l.word[0], "variable"))
			status = add_variable(r, l.word[1]);
		else if (ts_streq(l.word[0], "include"))
			status = read_included(r, path, l.word[1]);
	}
	ts_lines_close(&l);
	return status;
}

enum ts_status ts_study_script_read(struct ts_study_script *script, const char *path, struct tsim *sim,
				    struct ts_arena *arena)
{
	struct reading r = { .script = script, .sim = sim, .arena = arena, .hash = ts_hash_start() };

	script->path = path;
	TS_TRY(read_file(&r, path));
	if (script->text.failed)
		return ts_nomem(&sim->error);
	snprintf(script->version, sizeof script->version, "%016" PRIx64, ts_hash_value(&r.hash));
	return TS_OK;
}

static bool is_name(char c)
{
	return isalnum((unsigned char)c) || c == '_';
}

bool ts_study_script_mentions(const struct ts_study_script *script, const char *name)
{
	const char *text = ts_str_text(&script->text), *at = text;
	size_t n = strlen(name);

	for (; (at = strstr(at, name)) != NULL; at++) {
		bool begins = at == text || !is_name(at[-1]);

		begins |= at - text >= 2 && at[-2] == 'v' && at[-1] == '_' &&
			  (at - text == 2 || !is_name(at[-3]));
		if (begins && !is_name(at[n]))
			return true;
		if (n == 1 && at > text && at[-1] == '$')
			return true;
	}
	return false;
}

void ts_study_script_suggest(const struct ts_study_script *script, const char *name, struct ts_str *out)
{
	struct ts_suggest suggest = ts_suggest_start(name);

	for (size_t k = 0; k < script->variables; k++)
		ts_suggest_try(&suggest, script->variable[k]);
	ts_str_add(out, ts_suggest_text(&suggest));
}

void ts_study_script_release(struct ts_study_script *script)
{
	ts_str_release(&script->text);
	ts_free(script->variable);
	script->variable = NULL;
}
