#include "core/coeff.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "core/settings.h"

#include "base/process.h"

#include "base/banned.h"

enum ts_status ts_coeffs_resize(struct tsim *sim, struct ts_coeffs *c, size_t n)
{
	char *data;
	bool *given;

	if (n <= c->n)
		return TS_OK;
	data = ts_alloc(n, c->size);
	given = ts_alloc(n, sizeof *given);
	if (!data || !given) {
		ts_free(data);
		ts_free(given);
		return ts_nomem(&sim->error);
	}
	if (c->n) {
		memcpy(data, c->data, c->n * c->size);
		memcpy(given, c->given, c->n * sizeof *given);
	}
	ts_free(c->data);
	ts_free(c->given);
	c->data = data;
	c->given = given;
	c->n = n;
	return TS_OK;
}

void ts_coeffs_release(struct ts_coeffs *c)
{
	ts_free(c->data);
	ts_free(c->given);
	ts_arena_release(&c->arena);
	c->data = NULL;
	c->given = NULL;
	c->n = 0;
}

#ifndef TS_POTENTIALS
#define TS_POTENTIALS "potentials"
#endif

/* The folder part of the path; false: it has none, or it is too long. */
static bool folder_of(const char *path, char *folder, size_t room)
{
	const char *slash = path ? strrchr(path, '/') : NULL;

	return slash && (size_t)snprintf(folder, room, "%.*s", (int)(slash - path), path) < room;
}

enum { PLACES = 5, LONGEST = 1024 };

/* Folders searched for coefficient files: that of the script, that given by TSIM_POTENTIALS, ./potentials,
 * potentials/ of the source tree of the program, and the installed one. Those that do not exist are "". */
static void list_folders(const char *script, char place[PLACES][LONGEST])
{
	const char *given = getenv("TSIM_POTENTIALS");
	struct ts_str self = { 0 };
	char build[LONGEST], tree[LONGEST - sizeof "/potentials"];

	memset(place, 0, sizeof(char[PLACES][LONGEST]));
	folder_of(script, place[0], LONGEST);
	snprintf(place[1], LONGEST, "%s", given ? given : "");
	snprintf(place[2], LONGEST, "potentials");
	ts_process_self("", &self);
	if (folder_of(ts_str_text(&self), build, sizeof build) && folder_of(build, tree, sizeof tree))
		snprintf(place[3], LONGEST, "%s/potentials", tree);
	snprintf(place[4], LONGEST, "%s", TS_POTENTIALS);
	ts_str_release(&self);
}

static FILE *open_potential(struct tsim *sim, const char *name, const char *ending,
			    char place[PLACES][LONGEST])
{
	struct ts_str path = { 0 };
	FILE *file = NULL;

	for (int k = -1; !file && k < PLACES; k++) {
		if (k >= 0 && (!place[k][0] || name[0] == '/'))
			continue;
		ts_str_clear(&path);
		ts_str_addf(&path, "%s%s%s%s", k < 0 ? "" : place[k], k < 0 ? "" : "/", name, ending);
		file = path.failed ? NULL : ts_files_open(&sim->files, ts_str_text(&path), "r");
	}
	ts_str_release(&path);
	return file;
}

static enum ts_status fail_not_found(struct tsim *sim, const struct ts_word *name, const char *ending,
				     char place[PLACES][LONGEST])
{
	const char *why = ts_files_why(&sim->files);
	struct ts_str places = { 0 };
	enum ts_status status;

	for (int k = 0; k < PLACES && name->text[0] != '/'; k++)
		if (place[k][0])
			ts_str_addf(&places, ", %s", place[k]);
	if (!getenv("TSIM_POTENTIALS"))
		ts_str_add(&places, "; the folder TSIM_POTENTIALS may name another place");
	status = ts_fail(&sim->error, TS_IO, &name->place,
			 "cannot read coefficient file '%s'%s%s: %s; looked for here%s", name->text,
			 *ending ? " nor with the ending " : "", ending, why, ts_str_text(&places));
	ts_str_release(&places);
	return status;
}

/* All words of the file, one after the other, each with its place. */
static enum ts_status read_file_words(struct tsim *sim, FILE *file, const char *name, struct ts_arena *arena,
				      struct ts_words *out)
{
	struct ts_word *all = NULL;
	size_t capacity = 0, n = 0;
	char line[1024];
	struct ts_place place = { .file = ts_pool_get(sim->pool, name) };
	enum ts_status status = place.file ? TS_OK : TS_NOMEM;

	while (status == TS_OK && fgets(line, sizeof line, file)) {
		struct ts_words words;

		if (!strchr(line, '\n') && !feof(file)) { /* the rest would be parsed as another line */
			place.line++;
			status = ts_fail(&sim->error, TS_RANGE, &place,
					 "a line of a coefficient file has at most %zu bytes",
					 sizeof line - 2);
			break;
		}
		line[strcspn(line, "\r\n")] = '\0';
		place.line++;
		place.text = ts_pool_get(sim->pool, line);
		status = place.text ? ts_words_split(arena, line, &place, &words) : TS_NOMEM;
		if (status == TS_OK)
			status = TS_GROW(all, capacity, n + words.n);
		for (size_t k = 0; status == TS_OK && k < words.n; k++)
			all[n++] = words.word[k];
	}
	if (status == TS_OK)
		status = ts_words_copy(arena, (struct ts_words){ all, n }, out);
	ts_free(all);
	return status == TS_OK || sim->error.status ? status : ts_nomem(&sim->error);
}

enum ts_status ts_coeff_words(struct tsim *sim, const struct ts_word *name, const char *ending,
			      struct ts_arena *arena, struct ts_words *out)
{
	char place[PLACES][LONGEST];
	enum ts_status status;
	FILE *file;

	list_folders(name->place.file, place);
	errno = 0;
	file = open_potential(sim, name->text, "", place);
	if (!file && *ending)
		file = open_potential(sim, name->text, ending, place);
	if (!file)
		return fail_not_found(sim, name, ending, place);
	status = read_file_words(sim, file, name->text, arena, out);
	fclose(file);
	return status;
}

static enum ts_status parse_coefficient_file(struct tsim *sim, const char *what, const struct ts_coeffs *c,
					     const struct ts_word *name, struct ts_arena *arena, void *entry)
{
	struct ts_words words;

	TS_TRY(ts_coeff_words(sim, name, "", arena, &words));
	return ts_args_parse(sim, what, c->rows, words, &name->place, arena, entry);
}

enum ts_status ts_coeff_parse(struct tsim *sim, const char *what, struct ts_coeffs *c, struct ts_words words,
			      const struct ts_place *where, void *entry)
{
	enum ts_status status;

	if (words.n == 2 && ts_streq(words.word[0].text, "file"))
		status = parse_coefficient_file(sim, what, c, &words.word[1], &c->arena, entry);
	else
		status = ts_args_parse(sim, what, c->rows, words, where, &c->arena, entry);
	if (status == TS_OK)
		ts_settings_log(sim, what, c->rows, entry, words);
	return status;
}

static enum ts_status archive_coefficients(struct ts_archive *archive, struct tsim *sim, struct ts_coeffs *c,
					   size_t k)
{
	const struct ts_place where = { .file = "restart file" };
	struct ts_str record = { 0 };
	struct ts_words words;
	char name[32];
	const char *text;
	enum ts_status status;

	snprintf(name, sizeof name, "coeff%zu", k);
	if (c->given[k])
		ts_args_record(sim, c->rows, ts_coeff(c, k), &record);
	text = ts_str_text(&record);
	status = ts_archive_string(archive, name, &text);
	if (status == TS_OK && !ts_archive_writing(archive) && *text) {
		status = ts_words_split(&c->arena, text, &where, &words);
		if (status == TS_OK)
			status = ts_args_parse(sim, "restart file", c->rows, words, &where, &c->arena,
					       ts_coeff(c, k));
		c->given[k] = status == TS_OK;
	}
	ts_str_release(&record);
	return status;
}

enum ts_status ts_coeffs_archive(struct ts_archive *archive, struct tsim *sim, struct ts_coeffs *c)
{
	int64_t n = (int64_t)c->n;

	TS_TRY(ts_archive_fixed(archive, "ncoeffs", TS_SAVED_I64, &n, 1));
	if (n < 0 || n > 1000000)
		return ts_fail(&sim->error, TS_DAMAGED, NULL, "impossible number of coefficients");
	TS_TRY(ts_coeffs_resize(sim, c, (size_t)n));
	for (size_t k = 0; k < (size_t)n; k++)
		TS_TRY(archive_coefficients(archive, sim, c, k));
	return TS_OK;
}

void ts_coeffs_fingerprint(const struct ts_coeffs *c, const struct tsim *sim, struct ts_hash *hash)
{
	for (size_t k = 0; k < c->n; k++) {
		struct ts_str record = { 0 };

		if (c->given[k])
			ts_args_record(sim, c->rows, ts_coeff(c, k), &record);
		ts_hash_text(hash, ts_str_text(&record));
		ts_str_release(&record);
	}
}
