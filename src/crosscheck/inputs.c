#include "crosscheck/inputs.h"

#include <errno.h>
#include <glob.h>
#include <string.h>
#include <sys/stat.h>

#include "crosscheck/folder.h"
#include "crosscheck/meaning.h"
#include "io/lines.h"

#include "base/banned.h"

enum { DEEPEST = 10 };

/* Commands that write files: only the folders of the files are needed. */
static const char *const writers[] = { "dump",	     "dump_modify", "restart",	  "write_restart", "log",
				       "write_data", "write_dump",  "thermo_log", "print",	   NULL };
/* Commands whose file is a script. */
static const char *const readers[] = { "include", "jump", NULL };

static bool is_listed(const char *const *list, const char *word)
{
	while (*list && !ts_streq(*list, word))
		list++;
	return *list != NULL;
}

static enum ts_status add_path(struct ts_inputs *in, const char ***list, size_t *capacity, size_t *n,
			       const char *path)
{
	const char *kept = ts_pool_get(in->pool, path);
	int up = 0;

	if (!kept || TS_GROW(*list, *capacity, *n + 1) != TS_OK)
		return ts_nomem(in->err);
	if (ts_map_get(&in->seen, kept))
		return TS_OK;
	for (const char *c = kept; strncmp(c, "../", 3) == 0; c += 3)
		up++;
	in->up = up > in->up ? up : in->up;
	(*list)[(*n)++] = kept;
	return ts_map_set(&in->seen, kept, in);
}

/* Adds a file or folder, if it exists. Those with absolute names need no copy. */
static enum ts_status add_if_exists(struct ts_inputs *in, const char *path, bool folders_only, bool *is_file)
{
	struct stat info;

	*is_file = false;
	if (stat(path, &info) != 0)
		return TS_OK;
	*is_file = S_ISREG(info.st_mode);
	if (path[0] == '/')
		return TS_OK;
	if (S_ISDIR(info.st_mode) && !ts_streq(path, ".") && !ts_streq(path, ".."))
		return add_path(in, &in->folder, &in->folder_capacity, &in->folders, path);
	if (S_ISREG(info.st_mode) && !folders_only)
		return add_path(in, &in->file, &in->file_capacity, &in->files, path);
	return TS_OK;
}

static const char *value_of(struct ts_words vars, const char *name, size_t n)
{
	for (size_t k = 0; k + 2 < vars.n; k++) {
		bool more = k + 3 < vars.n && !ts_streq(vars.word[k + 3].text, "-var");

		if (ts_streq(vars.word[k].text, "-var") && !more && strlen(vars.word[k + 1].text) == n &&
		    strncmp(vars.word[k + 1].text, name, n) == 0)
			return vars.word[k + 2].text;
	}
	return NULL;
}

/* Replaces `$x`, `${name}` or `$(formula)` at c by its value or by `*`; returns the position after it. */
static const char *substitute_variable(const char *c, struct ts_words vars, struct ts_str *out)
{
	const char *name = c + 1, *end, *value = NULL;

	if (*name == '{' || *name == '(') {
		end = strchr(name, *name == '{' ? '}' : ')');
		if (!end)
			end = name + strlen(name);
		if (*name == '{')
			value = value_of(vars, name + 1, (size_t)(end - name - 1));
		end += *end != '\0';
	} else {
		value = value_of(vars, name, *name != '\0');
		end = name + (*name != '\0');
	}
	ts_str_add(out, value ? value : "*");
	return end;
}

/* Makes of the word a pattern for glob(): without quotes, variables replaced. *letters: it contains more than
 * wildcards. */
static void pattern_of(const char *word, struct ts_words vars, struct ts_str *out, bool *letters)
{
	ts_str_clear(out);
	*letters = false;
	while (*word) {
		if (*word == '$') {
			word = substitute_variable(word, vars, out);
			continue;
		}
		*letters |= !strchr("*\"'./", *word);
		if (strchr("[?\\", *word))
			ts_str_add(out, "\\");
		ts_str_add_n(out, word, !strchr("\"'", *word));
		word++;
	}
	for (const char *c = ts_str_text(out); *c; c++)
		*letters |= !strchr("*./", *c);
}

static enum ts_status scan_script(struct ts_inputs *in, const char *script, struct ts_words vars, int depth);

/* Adds all files and folders that match the word, and the folder of a file that does not exist yet. */
static enum ts_status scan_word(struct ts_inputs *in, const char *word, struct ts_words vars,
				const char *command, int depth)
{
	struct ts_str pattern = { 0 };
	glob_t found = { 0 };
	enum ts_status status = TS_OK;
	const char *slash;
	bool letters, is_file;

	pattern_of(word, vars, &pattern, &letters);
	if (letters && !pattern.failed && glob(pattern.text, 0, NULL, &found) == 0)
		for (size_t k = 0; k < found.gl_pathc && status == TS_OK; k++) {
			status = add_if_exists(in, found.gl_pathv[k], is_listed(writers, command), &is_file);
			if (status == TS_OK && is_file && is_listed(readers, command))
				status = scan_script(in, found.gl_pathv[k], vars, depth + 1);
		}
	globfree(&found);
	slash = strrchr(ts_str_text(&pattern), '/');
	if (letters && slash && slash > pattern.text && status == TS_OK) {
		pattern.text[slash - pattern.text] = '\0';
		status = add_if_exists(in, pattern.text, true, &is_file);
	}
	status = pattern.failed ? ts_nomem(in->err) : status;
	ts_str_release(&pattern);
	return status;
}

/* Stores a word of the present command with the values of -var; one with unknown variables is not changed. */
static enum ts_status store_word(struct ts_inputs *in, const char *word, struct ts_words vars)
{
	struct ts_str filled = { 0 };
	bool letters, known;

	if (TS_GROW(in->word, in->word_capacity, in->words + 1) != TS_OK)
		return ts_nomem(in->err);
	if (strchr(word, '$'))
		pattern_of(word, vars, &filled, &letters);
	known = filled.length && !strchr(filled.text, '*');
	in->word[in->words] = filled.failed ? NULL : ts_pool_get(in->pool, known ? filled.text : word);
	ts_str_release(&filled);
	return in->word[in->words++] ? TS_OK : ts_nomem(in->err);
}

static enum ts_status store_words(struct ts_inputs *in, const struct ts_lines *l, struct ts_words vars)
{
	bool goes_on = ts_streq(l->word[l->nwords - 1], "&");

	for (size_t k = 0; k + goes_on < l->nwords; k++)
		TS_TRY(store_word(in, l->word[k], vars));
	if (goes_on)
		return TS_OK;
	TS_TRY(ts_meanings_read_command(in->meanings, in->word, in->words));
	in->words = 0;
	return TS_OK;
}

static enum ts_status scan_lines(struct ts_inputs *in, struct ts_lines *l, struct ts_words vars, int depth)
{
	bool more;

	for (;;) {
		TS_TRY(ts_lines_next_filled(l, &more));
		if (!more)
			return TS_OK;
		if (in->meanings)
			TS_TRY(store_words(in, l, vars));
		for (size_t k = 0; k < l->nwords; k++)
			TS_TRY(scan_word(in, l->word[k], vars, l->word[0], depth));
	}
}

static enum ts_status scan_script(struct ts_inputs *in, const char *script, struct ts_words vars, int depth)
{
	struct ts_lines lines;
	enum ts_status status;
	struct ts_str key = { 0 };
	const char *kept;

	ts_str_addf(&key, "script %s", script);
	kept = key.failed ? NULL : ts_pool_get(in->pool, ts_str_text(&key));
	ts_str_release(&key);
	if (!kept)
		return ts_nomem(in->err);
	if (ts_map_get(&in->seen, kept) || depth > DEEPEST)
		return TS_OK;
	TS_TRY(ts_map_set(&in->seen, kept, in));
	status = ts_lines_open(&lines, NULL, in->err, in->pool, NULL, script);
	if (status == TS_OK)
		status = scan_lines(in, &lines, vars, depth);
	ts_lines_close(&lines);
	return status;
}

enum ts_status ts_inputs_find(struct ts_inputs *in, const char *script, struct ts_words vars)
{
	bool is_file;

	TS_TRY(add_if_exists(in, script, false, &is_file));
	for (size_t k = 0; k < vars.n; k++)
		TS_TRY(scan_word(in, vars.word[k].text, vars, "-var", 0));
	return scan_script(in, script, vars, 0);
}

void ts_inputs_release(struct ts_inputs *in)
{
	ts_free(in->file);
	ts_free(in->folder);
	ts_free(in->word);
	ts_map_release(&in->seen);
}

enum ts_status ts_inputs_copy(struct ts_inputs *in, const char *root, struct ts_str *place)
{
	struct ts_str path = { 0 };
	enum ts_status status;

	ts_str_clear(place);
	ts_str_add(place, root);
	for (int k = in->up; k > 0; k--)
		ts_str_addf(place, "/%d", k);
	status = place->failed ? ts_nomem(in->err) : ts_folder_make(ts_str_text(place), in->err);
	for (size_t k = 0; k < in->folders && status == TS_OK; k++) {
		ts_str_clear(&path);
		ts_str_addf(&path, "%s/%s", ts_str_text(place), in->folder[k]);
		status = path.failed ? ts_nomem(in->err) : ts_folder_make(path.text, in->err);
	}
	for (size_t k = 0; k < in->files && status == TS_OK; k++) {
		ts_str_clear(&path);
		ts_str_addf(&path, "%s/%s", ts_str_text(place), in->file[k]);
		status = path.failed ? ts_nomem(in->err)
				     : ts_folder_copy(in->file[k], path.text, TS_INPUT_DATE, in->err);
	}
	ts_str_release(&path);
	return status;
}
