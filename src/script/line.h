/* One logical line of a script, with the place of every character in the script file.
 *
 * A logical line may consist of several rows of the file, joined by `&` or triple quotes. Characters that
 * were substituted for a variable have the place of the reference to it. */
#ifndef TS_SCRIPT_LINE_H
#define TS_SCRIPT_LINE_H

#include <stddef.h>

#include "base/quotes.h"
#include "base/str.h"
#include "base/words.h"

struct ts_mark {
	int row, column, length;
};

struct ts_line {
	struct ts_str text;
	struct ts_mark *mark; /* one per character */
	size_t mark_capacity;
	struct ts_place *row; /* the rows of the file */
	size_t rows, row_capacity;
};

void ts_line_clear(struct ts_line *line); /* empty, memory kept */
void ts_line_release(struct ts_line *line);
/* Starts a row, to which text added next belongs. */
enum ts_status ts_line_start_row(struct ts_line *line, const struct ts_place *row);
/* Appends text of the last row. length 0: its characters are those of the row from `column` on; else all
 * of them have the place column, length. Failure sets line->text.failed. */
void ts_line_add(struct ts_line *line, const char *text, size_t n, int column, int length);
/* Appends text that replaces the characters at..at+m of another line with the same rows. */
void ts_line_add_from(struct ts_line *line, const char *text, size_t n, const struct ts_line *from, size_t at,
		      size_t m);
enum ts_status ts_line_copy_rows(struct ts_line *line, const struct ts_line *from);
/* Makes a line of a text written at `where`. */
enum ts_status ts_line_set(struct ts_line *line, const char *text, size_t n, const struct ts_place *where);

/* The place of the characters at..at+n, for messages. */
struct ts_place ts_line_place(const struct ts_line *line, size_t at, size_t n);
/* Whether a triple quote is open at the end of the text. */
bool ts_line_quote_open(const char *text);

/* Removes the comment. */
void ts_line_uncomment(struct ts_line *line);
/* Splits the line into words and removes one level of quotes; memory comes from the arena. */
enum ts_status ts_line_split(const struct ts_line *line, struct ts_error *error, struct ts_arena *arena,
			     struct ts_words *out);

#endif
