#include "mesh/mesh_scan.h"

#include <ctype.h>
#include <errno.h>
#include <inttypes.h>
#include <stdio.h>
#include <string.h>
#include <zlib.h>

#include "base/input_limit.h"
#include "base/str.h"
#include "io/textfile.h"

#include "base/banned.h"

enum { CHUNK = 1 << 16, LONGEST_NUMBER = 63 };

static enum ts_status start_scan(struct ts_scan *s, struct ts_error *err, struct ts_pool *pool,
				 const char *name)
{
	*s = (struct ts_scan){ .err = err, .pool = pool, .file = ts_pool_get(pool, name), .line = 1 };
	return s->file ? TS_OK : ts_nomem(err);
}

/* Some editors write a byte order mark before the first word. */
static void skip_byte_order_mark(struct ts_scan *s)
{
	if (s->n >= 3 && memcmp(s->bytes, "\xef\xbb\xbf", 3) == 0)
		s->at = s->line_start = 3;
}

enum ts_status ts_scan_check_stop(struct ts_scan *s)
{
	if (ts_files_stopped(s->files))
		return ts_scan_refuse(s, TS_STOPPED, "stopped on request while '%s' was read", s->file);
	return TS_OK;
}

static enum ts_status read_all(struct ts_scan *s, gzFile gz)
{
	size_t capacity = 0;

	for (;;) {
		int got, code;
		const char *text;

		TS_TRY(ts_scan_check_stop(s));
		if (TS_GROW(s->owned, capacity, s->n + CHUNK) != TS_OK)
			return ts_nomem(s->err);
		errno = 0;
		got = gzread(gz, s->owned + s->n, CHUNK);
		text = gzerror(gz, &code);
		if (got < 0 || code == Z_BUF_ERROR)
			return ts_scan_refuse(s, TS_IO, "reading '%s' failed: %s", s->file,
					      code == Z_ERRNO ? strerror(errno) : text);
		if (got == 0)
			return TS_OK;
		s->n += (size_t)got;
		if (!gzdirect(gz) && (double)s->n > ts_input_limit())
			return ts_scan_refuse(s, TS_RANGE,
					      "'%s' unfolds to more than %.6g GB; if that is meant, start "
					      "tsim with -input-limit GB",
					      s->file, ts_input_limit() / 1e9);
	}
}

enum ts_status ts_scan_open(struct ts_scan *s, struct ts_files *files, struct ts_error *err,
			    struct ts_pool *pool, const struct ts_place *where, const char *path)
{
	enum ts_status status;
	gzFile gz;

	TS_TRY(start_scan(s, err, pool, path));
	s->files = files;
	errno = 0;
	gz = ts_files_open_gz_of(files, path, where ? where->file : NULL);
	if (!gz)
		return errno ? ts_textfile_open_failed(err, files, where, path) : ts_nomem(err);
	status = read_all(s, gz);
	gzclose(gz);
	s->bytes = s->owned;
	skip_byte_order_mark(s);
	return status;
}

enum ts_status ts_scan_memory(struct ts_scan *s, struct ts_error *err, struct ts_pool *pool, const char *name,
			      const char *bytes, size_t n)
{
	TS_TRY(start_scan(s, err, pool, name));
	s->bytes = bytes;
	s->n = n;
	skip_byte_order_mark(s);
	return TS_OK;
}

void ts_scan_close(struct ts_scan *s)
{
	ts_free(s->owned);
	*s = (struct ts_scan){ 0 };
}

/* Line ends are LF, CR LF or CR. */
static bool ends_line(const struct ts_scan *s, size_t at)
{
	return s->bytes[at] == '\n' || (s->bytes[at] == '\r' && !(at + 1 < s->n && s->bytes[at + 1] == '\n'));
}

static bool is_blank(char c)
{
	return c == ' ' || (c >= '\t' && c <= '\r');
}

bool ts_scan_word_in_line(struct ts_scan *s)
{
	size_t at = s->at;

	while (at < s->n && is_blank(s->bytes[at]) && !ends_line(s, at))
		at++;
	if (at < s->n && s->comments && s->bytes[at] == '#')
		while (at < s->n && !ends_line(s, at))
			at++;
	s->word = s->bytes + at;
	s->length = 0;
	while (at + s->length < s->n && !is_blank(s->word[s->length]) &&
	       !(s->comments && s->word[s->length] == '#'))
		s->length++;
	s->at = at + s->length;
	return s->length > 0;
}

bool ts_scan_word(struct ts_scan *s)
{
	while (!ts_scan_word_in_line(s)) {
		if (s->at == s->n)
			return false;
		s->at++;
		s->line++;
		s->line_start = s->at;
	}
	return true;
}

const char *ts_scan_rest(struct ts_scan *s)
{
	char text[128];
	size_t n = 0;

	while (s->at < s->n && !ends_line(s, s->at)) {
		char c = s->bytes[s->at++];

		if ((n || !is_blank(c)) && n < sizeof text - 1)
			text[n++] = isprint((unsigned char)c) || (c & 0x80) ? c : ' ';
	}
	while (n && text[n - 1] == ' ')
		n--;
	text[n] = '\0';
	return ts_pool_get(s->pool, text);
}

bool ts_scan_is(const struct ts_scan *s, const char *text)
{
	for (size_t k = 0; k < s->length; k++)
		if (!text[k] || tolower((unsigned char)s->word[k]) != tolower((unsigned char)text[k]))
			return false;
	return !text[s->length];
}

/* The text of the line is limited to the length that messages need. */
struct ts_place ts_scan_place(const struct ts_scan *s)
{
	struct ts_place place = { .file = s->file, .line = s->line };
	size_t n = 0, column = s->word ? (size_t)(s->word - s->bytes) - s->line_start : 0;
	char text[512];

	if (s->binary) {
		snprintf(text, sizeof text, "%.400s, byte %zu", s->file, s->at);
		return (struct ts_place){ .file = ts_pool_get(s->pool, text) };
	}
	for (size_t at = s->line_start; at < s->n && n < sizeof text - 1 && !ends_line(s, at); at++)
		text[n++] = isprint((unsigned char)s->bytes[at]) ? s->bytes[at] : ' ';
	text[n] = '\0';
	place.text = ts_pool_get(s->pool, text);
	if (column + s->length <= n && s->length) {
		place.column = (int)column + 1;
		place.length = (int)s->length;
	}
	return place;
}

struct ts_scan_found ts_scan_found(const struct ts_scan *s)
{
	struct ts_scan_found found = { "the end of the file" };
	int n = s->length < 40 ? (int)s->length : 40;

	if (!s->length)
		return found;
	snprintf(found.text, sizeof found.text, "'%.*s'", n, s->word);
	for (char *p = found.text; *p; p++)
		*p = isprint((unsigned char)*p) ? *p : '?';
	return found;
}

/* Copies the last word; Fortran exponents (1d-3) are converted. */
static bool copy_number(const struct ts_scan *s, char text[LONGEST_NUMBER + 1])
{
	if (s->length > LONGEST_NUMBER || memchr(s->word, '\0', s->length))
		return false;
	for (size_t k = 0; k < s->length; k++)
		text[k] = s->word[k] == 'd' || s->word[k] == 'D' ? 'e' : s->word[k];
	text[s->length] = '\0';
	return true;
}

enum ts_status ts_scan_this_real(struct ts_scan *s, const char *what, double *out)
{
	char text[LONGEST_NUMBER + 1];

	if (s->length && copy_number(s, text) && ts_parse_real(text, out))
		return TS_OK;
	return ts_scan_fail(s, TS_SYNTAX, "%s should be a number, but here is %s", what,
			    ts_scan_found(s).text);
}

enum ts_status ts_scan_real(struct ts_scan *s, const char *what, double *out)
{
	ts_scan_word(s);
	return ts_scan_this_real(s, what, out);
}

enum ts_status ts_scan_this_int(struct ts_scan *s, const char *what, int64_t lo, int64_t hi, int64_t *out)
{
	char text[LONGEST_NUMBER + 1];

	if (!s->length || !copy_number(s, text) || !ts_parse_int(text, out))
		return ts_scan_fail(s, TS_SYNTAX, "%s should be an integer, but here is %s", what,
				    ts_scan_found(s).text);
	if (*out >= lo && *out <= hi)
		return TS_OK;
	return ts_scan_fail(s, TS_RANGE,
			    "%s is %" PRId64 ", expected an integer from %" PRId64 " to %" PRId64, what, *out,
			    lo, hi);
}

enum ts_status ts_scan_int(struct ts_scan *s, const char *what, int64_t lo, int64_t hi, int64_t *out)
{
	ts_scan_word(s);
	return ts_scan_this_int(s, what, lo, hi, out);
}

enum ts_status ts_scan_expect(struct ts_scan *s, const char *text)
{
	ts_scan_word(s);
	if (ts_scan_is(s, text))
		return TS_OK;
	return ts_scan_fail(s, TS_SYNTAX, "expected '%s', but here is %s", text, ts_scan_found(s).text);
}
