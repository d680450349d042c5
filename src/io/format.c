#include "io/format.h"

#include <stdio.h>
#include <string.h>

#include "io/decimal.h"

#include "base/banned.h"

bool ts_format_check(const char *format, bool integer, char out[TS_FORMAT_SIZE])
{
	const char *percent = strchr(format, '%');
	size_t head, n;
	int wrote;
	char kind;

	if (!percent)
		return false;
	head = (size_t)(percent - format) + 1;
	head += strspn(format + head, "-+ #0");
	n = strspn(format + head, "0123456789");
	head += n;
	if (n > 3)
		return false;
	if (format[head] == '.') {
		n = strspn(format + head + 1, "0123456789");
		head += n + 1;
		if (n > 3)
			return false;
	}
	n = integer ? strspn(format + head, "lh") : 0;
	kind = format[head + n];
	if (!kind || !strchr(integer ? "di" : "eEfFgG", kind) || strchr(format + head + n, '%'))
		return false;
	wrote = snprintf(out, TS_FORMAT_SIZE, "%.*s%s%c%s", (int)head, format, integer ? "ll" : "", kind,
			 format + head + n + 1);
	return wrote > 0 && wrote < TS_FORMAT_SIZE;
}

static enum ts_status refuse_format(struct ts_error *err, const struct ts_word *word, bool integer)
{
	return ts_fail(err, TS_SYNTAX, &word->place,
		       "'%s' is not a format of one %s, expected for instance %s", word->text,
		       integer ? "integer" : "number", integer ? "%8d" : "%14.8g");
}

static enum ts_status set_kind(struct ts_error *err, const struct ts_word *word, bool integer,
			       char out[TS_FORMAT_SIZE])
{
	char checked[TS_FORMAT_SIZE];

	if (!ts_format_check(word->text, integer, checked) || strlen(word->text) >= TS_FORMAT_SIZE)
		return refuse_format(err, word, integer);
	snprintf(out, TS_FORMAT_SIZE, "%s", word->text);
	return TS_OK;
}

static enum ts_status set_line(struct ts_formats *f, struct ts_error *err, struct ts_arena *arena,
			       const struct ts_word *word, size_t columns)
{
	if (ts_words_split(arena, word->text, &word->place, &f->line) != TS_OK)
		return ts_nomem(err);
	for (size_t k = 0; k < f->line.n; k++) /* the line is one quoted word of the script */
		((struct ts_word *)f->line.word)[k].place = word->place;
	if (f->line.n == columns)
		return TS_OK;
	return ts_fail(err, TS_SYNTAX, &word->place, "format line has %zu formats, but there are %zu columns",
		       f->line.n, columns);
}

static enum ts_status set_column(struct ts_formats *f, struct ts_error *err, struct ts_arena *arena,
				 struct ts_words pair, size_t columns)
{
	struct ts_word *all = ts_arena_alloc(arena, f->column.n + 2, sizeof *all);
	int64_t k;

	if (!ts_parse_int(pair.word[0].text, &k) || k < 1 || (size_t)k > columns)
		return ts_fail(err, TS_SYNTAX, &pair.word[0].place,
			       "format is '%s', expected float, int, line, none or the number of a column "
			       "from 1 to %zu",
			       pair.word[0].text, columns);
	if (!all || ts_words_copy(arena, pair, &pair) != TS_OK)
		return ts_nomem(err);
	for (size_t n = 0; n < f->column.n; n++)
		all[n] = f->column.word[n];
	all[f->column.n] = pair.word[0];
	all[f->column.n + 1] = pair.word[1];
	f->column = (struct ts_words){ all, f->column.n + 2 };
	return TS_OK;
}

enum ts_status ts_formats_change(struct ts_formats *f, struct ts_error *err, struct ts_arena *arena,
				 const char *what, struct ts_words words, size_t columns)
{
	while (words.n) {
		const char *kind = words.word[0].text;

		if (ts_streq(kind, "none")) {
			*f = (struct ts_formats){ 0 };
			words = ts_words_from(words, 1);
			continue;
		}
		if (strchr(kind, '%')) { /* as in LIGGGHTS: formats without a keyword are a line */
			TS_TRY(set_line(f, err, arena, &words.word[0], columns));
			words = ts_words_from(words, 1);
			continue;
		}
		if (words.n < 2)
			return ts_fail(err, TS_SYNTAX, &words.word[0].place, "%s: format %s lacks its text",
				       what, kind);
		if (ts_streq(kind, "float"))
			TS_TRY(set_kind(err, &words.word[1], false, f->real));
		else if (ts_streq(kind, "int"))
			TS_TRY(set_kind(err, &words.word[1], true, f->whole));
		else if (ts_streq(kind, "line"))
			TS_TRY(set_line(f, err, arena, &words.word[1], columns));
		else
			TS_TRY(set_column(f, err, arena, (struct ts_words){ words.word, 2 }, columns));
		words = ts_words_from(words, 2);
	}
	return TS_OK;
}

/* The format of this column alone, or that of the line; NULL: none. */
static const struct ts_word *format_of_column(const struct ts_formats *f, size_t k, bool whole_line)
{
	const struct ts_word *word = k < f->line.n && whole_line ? &f->line.word[k] : NULL;

	for (size_t n = 0; n < f->column.n; n += 2) {
		int64_t column;

		if (ts_parse_int(f->column.word[n].text, &column) && column == (int64_t)k + 1)
			word = &f->column.word[n + 1]; /* the last one applies */
	}
	return word;
}

enum ts_status ts_formats_choose_text(const struct ts_formats *f, struct ts_error *err, size_t k,
				      char out[TS_FORMAT_SIZE])
{
	const struct ts_word *word = format_of_column(f, k, true);
	const char *text = word ? word->text : "%s";
	size_t width = *text ? strspn(text + 1, "-") : 0;

	width += *text ? strspn(text + 1 + width, "0123456789") : 0;
	if (*text != '%' || width > 3 || !ts_streq(text + 1 + width, "s"))
		return ts_fail(err, TS_SYNTAX, &word->place,
			       "'%s' is not a format of a name, expected %%s or for instance %%4s", text);
	snprintf(out, TS_FORMAT_SIZE, "%s", text);
	return TS_OK;
}

enum ts_status ts_formats_choose(const struct ts_formats *f, struct ts_error *err, size_t k, bool integer,
				 const char *fallback, char out[TS_FORMAT_SIZE])
{
	const char *kind = integer ? f->whole : f->real;
	const struct ts_word *word = format_of_column(f, k, !*kind);

	if (!word)
		return ts_format_check(*kind ? kind : fallback, integer, out) ? TS_OK : TS_SYNTAX;
	return ts_format_check(word->text, integer, out) ? TS_OK : refuse_format(err, word, integer);
}

/* The digits of a format %g or %.Ng; 0 for all others. */
static int digits_of_g(const char *format)
{
	int n = 6;

	if (*format++ != '%')
		return 0;
	if (*format == '.')
		for (n = 0, format++; *format >= '0' && *format <= '9' && n <= TS_DECIMAL_DIGITS; format++)
			n = 10 * n + (*format - '0');
	return n <= TS_DECIMAL_DIGITS && format[0] == 'g' && !format[1] ? n : 0;
}

#pragma GCC diagnostic ignored "-Wformat-nonliteral"
void ts_format_add_text(struct ts_str *out, const char *format, const char *text)
{
	ts_str_addf(out, format, text);
}

void ts_format_add(struct ts_str *out, const char *format, bool integer, double value)
{
	char text[TS_DECIMAL_SIZE];
	int digits = integer ? 0 : digits_of_g(format);

	if (integer && ts_streq(format, "%lld"))
		ts_str_add_n(out, text, ts_decimal_lld((long long)value, text));
	else if (digits)
		ts_str_add_n(out, text, ts_decimal_g(value, digits, text));
	else if (integer)
		ts_str_addf(out, format, (long long)value);
	else
		ts_str_addf(out, format, value);
}
