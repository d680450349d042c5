#include "script/line.h"

#include <string.h>

#include "base/banned.h"

static const char blanks[] = " \t\r\n\f\v";

void ts_line_clear(struct ts_line *line)
{
	ts_str_clear(&line->text);
	line->text.failed = false;
	line->rows = 0;
}

void ts_line_release(struct ts_line *line)
{
	ts_str_release(&line->text);
	ts_free(line->mark);
	ts_free(line->row);
	*line = (struct ts_line){ 0 };
}

enum ts_status ts_line_start_row(struct ts_line *line, const struct ts_place *row)
{
	TS_TRY(TS_GROW(line->row, line->row_capacity, line->rows + 1));
	line->row[line->rows++] = *row;
	return TS_OK;
}

/* Appends text. step 1: columns of the characters are consecutive; 0: all have the same mark. */
static void append_marked(struct ts_line *line, const char *text, size_t n, struct ts_mark mark, int step)
{
	size_t first = line->text.length;

	if (TS_GROW(line->mark, line->mark_capacity, first + n + 1) != TS_OK)
		line->text.failed = true;
	ts_str_add_n(&line->text, text, n);
	if (line->text.failed)
		return;
	for (size_t k = 0; k < n; k++) {
		line->mark[first + k] = mark;
		mark.column += step;
	}
}

void ts_line_add(struct ts_line *line, const char *text, size_t n, int column, int length)
{
	struct ts_mark mark = { (int)line->rows - 1, column, length ? length : 1 };

	append_marked(line, text, n, mark, length == 0 && column != 0);
}

void ts_line_add_from(struct ts_line *line, const char *text, size_t n, const struct ts_line *from, size_t at,
		      size_t m)
{
	struct ts_place place = ts_line_place(from, at, m);
	struct ts_mark mark = { from->mark[at].row, place.column, place.length };

	append_marked(line, text, n, mark, 0);
}

enum ts_status ts_line_copy_rows(struct ts_line *line, const struct ts_line *from)
{
	for (size_t k = 0; k < from->rows; k++)
		TS_TRY(ts_line_start_row(line, &from->row[k]));
	return TS_OK;
}

enum ts_status ts_line_set(struct ts_line *line, const char *text, size_t n, const struct ts_place *where)
{
	ts_line_clear(line);
	TS_TRY(ts_line_start_row(line, where));
	ts_line_add(line, "", 0, 0, 0);
	for (size_t k = 0; k < n; k++) {
		struct ts_place place = ts_place_inside(where, n, k, 1);

		ts_line_add(line, text + k, 1, place.column, place.length);
	}
	return line->text.failed ? TS_NOMEM : TS_OK;
}

struct ts_place ts_line_place(const struct ts_line *line, size_t at, size_t n)
{
	const struct ts_mark *first, *last;
	struct ts_place place;

	if (!line->rows || at >= line->text.length)
		return line->rows ? line->row[line->rows - 1] : (struct ts_place){ 0 };
	first = &line->mark[at];
	last = &line->mark[at + n - (n > 0)];
	place = line->row[first->row];
	place.column = first->column;
	if (!first->column)
		place.length = 0;
	else if (last->row == first->row && last->column >= first->column)
		place.length = last->column + last->length - first->column;
	else
		place.length = (int)strlen(place.text) - place.column + 1;
	return place;
}

/* The position of the `#` of a comment, of a triple quote that is not closed, or of the end. */
static size_t find_comment(const char *text)
{
	size_t at = 0;

	while (text[at] && text[at] != '#') {
		size_t end = ts_quote_end(text, at);

		if (end == at && strncmp(text + at, "\"\"\"", 3) == 0)
			break;
		at = end > at ? end : at + 1;
	}
	return at;
}

bool ts_line_quote_open(const char *text)
{
	return text[find_comment(text)] == '"';
}

void ts_line_uncomment(struct ts_line *line)
{
	const char *text = ts_str_text(&line->text);
	size_t end = find_comment(text);

	if (text[end] != '#')
		return;
	line->text.length = end;
	line->text.text[end] = '\0';
}

/* Copies the word that begins at `at`; *next is the position behind it. */
static enum ts_status cut_word(const struct ts_line *line, struct ts_error *error, struct ts_arena *arena,
			       size_t at, size_t *next, struct ts_word *word)
{
	const char *text = line->text.text;
	size_t end = ts_quote_end(text, at), mark = 0;
	struct ts_place place;
	char *copy;

	if (end > at) {
		mark = strncmp(text + at, "\"\"\"", 3) == 0 ? 3 : 1;
		place = ts_line_place(line, end - 1, 2);
		if (text[end] && !strchr(blanks, text[end]))
			return ts_fail(error, TS_SYNTAX, &place,
				       "a blank must follow the closing quote, found '%c'", text[end]);
	} else if (text[at] == '"' || text[at] == '\'') {
		place = ts_line_place(line, at, 1);
		return ts_fail(error, TS_SYNTAX, &place, "this quote %c is never closed", text[at]);
	} else {
		end = at + strcspn(text + at, blanks);
	}
	copy = ts_arena_alloc(arena, end - at + 1, 1);
	if (!copy)
		return ts_nomem(error);
	memcpy(copy, text + at + mark, end - at - 2 * mark);
	*word = (struct ts_word){ copy, ts_line_place(line, at, end - at), mark > 0 };
	*next = end;
	return TS_OK;
}

enum ts_status ts_line_split(const struct ts_line *line, struct ts_error *error, struct ts_arena *arena,
			     struct ts_words *out)
{
	const char *text = ts_str_text(&line->text);
	struct ts_word *word = ts_arena_alloc(arena, line->text.length / 2 + 1, sizeof *word);
	size_t n = 0;

	if (!word)
		return ts_nomem(error);
	for (size_t at = strspn(text, blanks); text[at]; at += strspn(text + at, blanks))
		TS_TRY(cut_word(line, error, arena, at, &at, &word[n++]));
	*out = (struct ts_words){ word, n };
	return TS_OK;
}
