#include "io/lines.h"

#include <ctype.h>
#include <errno.h>
#include <inttypes.h>
#include <string.h>
#include <sys/stat.h>
#include <zlib.h>

#include "base/input_limit.h"
#include "io/textfile.h"

#include "base/banned.h"

enum { CHUNK = 1 << 16 };

static enum ts_status init_lines(struct ts_lines *l, struct ts_error *err, struct ts_pool *pool,
				 const char *name)
{
	*l = (struct ts_lines){ .err = err, .pool = pool, .file = ts_pool_get(pool, name) };
	l->comment = "";
	l->most_unfolded = ts_input_limit();
	l->longest = ts_input_longest_line();
	return l->file ? TS_OK : ts_nomem(err);
}

enum ts_status ts_lines_open(struct ts_lines *l, struct ts_files *files, struct ts_error *err,
			     struct ts_pool *pool, const struct ts_place *where, const char *path)
{
	TS_TRY(init_lines(l, err, pool, path));
	l->buffer = ts_alloc(CHUNK, 1);
	if (!l->buffer)
		return ts_nomem(err);
	l->chunk = l->buffer;
	errno = 0;
	l->files = files;
	l->gz = ts_files_open_gz_of(files, path, where ? where->file : NULL);
	if (l->gz)
		return TS_OK;
	ts_lines_close(l);
	return errno ? ts_textfile_open_failed(err, files, where, path) : ts_nomem(err);
}

/* One that can be opened again, as a pipe cannot. */
static bool is_regular(struct ts_files *files, const char *path)
{
	struct stat info;

	return ts_files_stat(files, path, &info) == 0 && S_ISREG(info.st_mode);
}

/* The bytes that a file of gzip begins with. */
static bool is_compressed(const char *bytes, size_t n)
{
	return n == 2 && (unsigned char)bytes[0] == 0x1f && (unsigned char)bytes[1] == 0x8b;
}

enum ts_status ts_lines_open_along(struct ts_lines *l, struct ts_files *files, struct ts_error *err,
				   struct ts_pool *pool, const struct ts_place *where, const char *path)
{
	FILE *along = NULL;
	char start[2];
	size_t n = 0;

	if (ts_files_shared(files) && is_regular(files, path))
		along = ts_files_open_along(files, path);
	if (along)
		n = fread(start, 1, sizeof start, along);
	if (!along || is_compressed(start, n)) {
		if (along)
			fclose(along);
		return ts_lines_open(l, files, err, pool, where, path);
	}
	if (init_lines(l, err, pool, path) == TS_OK)
		l->buffer = ts_alloc(CHUNK, 1);
	if (!l->buffer) {
		fclose(along);
		return ts_nomem(err);
	}
	l->files = files;
	l->along = along;
	l->chunk = l->buffer;
	memcpy(l->buffer, start, n);
	l->end = n;
	return TS_OK;
}

enum ts_status ts_lines_memory(struct ts_lines *l, struct ts_error *err, struct ts_pool *pool,
			       const char *name, const char *bytes, size_t n)
{
	TS_TRY(init_lines(l, err, pool, name));
	l->chunk = bytes;
	l->end = n;
	return TS_OK;
}

void ts_lines_close(struct ts_lines *l)
{
	if (l->gz)
		gzclose(l->gz);
	if (l->along)
		fclose(l->along);
	ts_free(l->buffer);
	ts_free(l->line);
	ts_free(l->word);
	*l = (struct ts_lines){ 0 };
}

static enum ts_status read_along(struct ts_lines *l)
{
	l->end = fread(l->buffer, 1, CHUNK, l->along);
	if (!l->end && ferror(l->along))
		return ts_lines_fail(l, TS_IO, SIZE_MAX, "reading '%s' failed: %s", l->file, strerror(errno));
	return TS_OK;
}

/* Reads the next chunk. At the end of a file that is cut off within its compressed data gzread reports no
 * error: gzerror tells. */
static enum ts_status read_chunk(struct ts_lines *l)
{
	int got, code;
	const char *text;

	l->at = l->end = 0;
	if (!l->gz && !l->along)
		return TS_OK;
	if (ts_files_stopped(l->files))
		return ts_lines_fail(l, TS_STOPPED, SIZE_MAX, "stopped on request while '%s' was read",
				     l->file);
	errno = 0;
	if (l->along)
		return read_along(l);
	got = gzread(l->gz, l->buffer, CHUNK);
	text = gzerror(l->gz, &code);
	if (l->may_be_torn && (code == Z_BUF_ERROR || code == Z_DATA_ERROR)) {
		l->torn = true;
		l->end = got > 0 ? (size_t)got : 0;
		return TS_OK;
	}
	if (got < 0 || code == Z_BUF_ERROR)
		return ts_lines_fail(l, TS_IO, SIZE_MAX, "reading '%s' failed: %s", l->file,
				     code == Z_ERRNO ? strerror(errno) : text);
	l->end = (size_t)got;
	l->unfolded += gzdirect(l->gz) ? 0 : got;
	if (l->unfolded > l->most_unfolded)
		return ts_lines_fail(l, TS_RANGE, SIZE_MAX,
				     "'%s' unfolds to more than %.6g GB; if that is meant, start tsim with "
				     "-input-limit GB",
				     l->file, l->most_unfolded / 1e9);
	return TS_OK;
}

static enum ts_status append_to_line(struct ts_lines *l, size_t n)
{
	if (l->length + n > l->longest) {
		const struct ts_place place = { .file = l->file, .text = "", .line = l->number + 1 };

		return ts_fail(l->err, TS_RANGE, &place,
			       "the line has more than %zu bytes; if that is meant, start tsim with "
			       "-input-limit GB, of which a line may have a thousandth",
			       l->longest);
	}
	if (TS_GROW(l->line, l->capacity, l->length + n + 1) != TS_OK)
		return ts_nomem(l->err);
	memcpy(l->line + l->length, l->chunk + l->at, n);
	l->length += n;
	l->line[l->length] = '\0';
	l->at += n;
	return TS_OK;
}

static enum ts_status read_line(struct ts_lines *l, bool *more)
{
	*more = false;
	l->hash = NULL;
	l->length = 0;
	l->ended = false;
	for (;;) {
		const char *stop;

		if (l->at == l->end)
			TS_TRY(read_chunk(l));
		if (l->at == l->end)
			return TS_OK;
		*more = true;
		stop = memchr(l->chunk + l->at, '\n', l->end - l->at);
		TS_TRY(append_to_line(l, (stop ? (size_t)(stop - l->chunk) : l->end) - l->at));
		if (!stop)
			continue;
		l->at++;
		l->ended = true;
		return TS_OK;
	}
}

#define BLANKS " \t\r\v\f"

static bool is_blank(char c)
{
	return c == ' ' || (c >= '\t' && c <= '\r' && c != '\n');
}

static bool separates(const struct ts_lines *l, char c)
{
	return is_blank(c) || (l->commas && c == ',');
}

/* Splits the line in place: the blank after each word is replaced by a zero. */
static enum ts_status split_words(struct ts_lines *l)
{
	char *p = l->line;

	l->nwords = 0;
	l->comment = "";
	l->hash = strchr(l->line, '#');
	if (l->hash) {
		*l->hash = '\0';
		l->comment = l->hash + 1 + strspn(l->hash + 1, BLANKS);
	}
	for (;;) {
		while (separates(l, *p))
			p++;
		if (!*p)
			return TS_OK;
		if (TS_GROW(l->word, l->word_capacity, l->nwords + 1) != TS_OK)
			return ts_nomem(l->err);
		l->word[l->nwords++] = p;
		while (*p && !separates(l, *p))
			p++;
		if (!*p)
			return TS_OK;
		*p++ = '\0';
	}
}

static enum ts_status split_line(struct ts_lines *l)
{
	while (l->length && strchr(" \t\r", l->line[l->length - 1]))
		l->line[--l->length] = '\0';
	if (l->length && memchr(l->line, '\0', l->length))
		return ts_lines_fail(l, TS_DAMAGED, SIZE_MAX,
				     "this is not a text file: the line contains a zero byte");
	return split_words(l);
}

enum ts_status ts_lines_next(struct ts_lines *l, bool *more)
{
	l->nwords = 0;
	TS_TRY(read_line(l, more));
	l->number += *more;
	return *more ? split_line(l) : TS_OK;
}

enum ts_status ts_lines_next_filled(struct ts_lines *l, bool *more)
{
	do
		TS_TRY(ts_lines_next(l, more));
	while (*more && !l->nwords);
	return TS_OK;
}

enum ts_status ts_lines_pass_filled(struct ts_lines *l, bool *more)
{
	l->nwords = 0;
	l->comment = "";
	for (;;) {
		char first;

		TS_TRY(read_line(l, more));
		l->number += *more;
		if (!*more)
			return TS_OK;
		first = l->line[strspn(l->line, BLANKS)];
		if (isalpha((unsigned char)first))
			return split_line(l);
		if (first && first != '#')
			return TS_OK;
	}
}

/* The line before it was split, at most 1023 bytes, for messages. */
static const char *uncut_text(struct ts_lines *l)
{
	char text[1024];
	size_t n = l->length < sizeof text - 1 ? l->length : sizeof text - 1;

	if (!l->line)
		return "";
	for (size_t k = 0; k < n; k++)
		text[k] = l->line[k] ? l->line[k] : l->line + k == l->hash ? '#' : ' ';
	text[n] = '\0';
	return ts_pool_get(l->pool, text);
}

struct ts_place ts_lines_place(struct ts_lines *l, size_t k)
{
	struct ts_place place = { .file = l->file, .text = uncut_text(l), .line = l->number };

	if (k < l->nwords) {
		place.column = (int)(l->word[k] - l->line) + 1;
		place.length = (int)strlen(l->word[k]);
	}
	return place;
}

enum ts_status ts_lines_real(struct ts_lines *l, size_t k, const char *what, double *out)
{
	if (k >= l->nwords)
		return ts_lines_fail(l, TS_SYNTAX, k, "%s is missing, expected a number", what);
	if (ts_parse_real(l->word[k], out))
		return TS_OK;
	return ts_lines_fail(l, TS_SYNTAX, k, "%s is '%.60s', expected a number", what, l->word[k]);
}

enum ts_status ts_lines_int(struct ts_lines *l, size_t k, const char *what, int64_t lo, int64_t hi,
			    int64_t *out)
{
	if (k >= l->nwords)
		return ts_lines_fail(l, TS_SYNTAX, k, "%s is missing, expected an integer", what);
	if (!ts_parse_int(l->word[k], out))
		return ts_lines_fail(l, TS_SYNTAX, k, "%s is '%.60s', expected an integer", what, l->word[k]);
	if (*out >= lo && *out <= hi)
		return TS_OK;
	return ts_lines_fail(l, TS_RANGE, k,
			     "%s is %" PRId64 ", expected an integer from %" PRId64 " to %" PRId64, what,
			     *out, lo, hi);
}

bool ts_lines_match(const struct ts_lines *l, size_t k, const char *text)
{
	if (k < l->nwords && l->word[k][0] != text[0])
		return false;
	for (; k < l->nwords; k++) {
		size_t n = strlen(l->word[k]);

		if (strncmp(text, l->word[k], n) != 0 || (text[n] && text[n] != ' '))
			return false;
		text += n + (text[n] == ' ');
	}
	return !*text;
}
