/* One logical line of a script. Every character knows where it was written.
 *
 * A logical line may be joined from several rows of the file by `&` or triple quotes, and parts of
 * it may have been put in for variables; these carry the place of the reference. */
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
	struct ts_place *row; /* the lines of the file */
	size_t rows, row_capacity;
};

void ts_line_clear(struct ts_line *line); /* empty, memory kept */
void ts_line_release(struct ts_line *line);
/* Starts a row; what is added next belongs to it. */
enum ts_status ts_line_row(struct ts_line *line, const struct ts_place *row);
/* Adds text of the last row: from `column` on if length is 0, else all of it standing for the
 * stretch column, length. Failure shows in line->text.failed. */
void ts_line_add(struct ts_line *line, const char *text, size_t n, int column, int length);
/* Adds text that stands for the stretch at..at+m of another line with the same rows; exact: it is
 * that stretch, character by character. */
void ts_line_add_from(struct ts_line *line, const char *text, size_t n, const struct ts_line *from, size_t at,
		      size_t m);
enum ts_status ts_line_same_rows(struct ts_line *line, const struct ts_line *from);
/* Makes a line from a text that stands at `where`. */
enum ts_status ts_line_set(struct ts_line *line, const char *text, size_t n, const struct ts_place *where);

/* The place of the characters at..at+n. */
struct ts_place ts_line_place(const struct ts_line *line, size_t at, size_t n);
/* Whether a triple quote is open at the end of the text. */
bool ts_line_quote_open(const char *text);

/* Cuts off the comment. */
void ts_line_uncomment(struct ts_line *line);
/* Cuts the line into words, quotes stripped one level; memory comes from the arena. */
enum ts_status ts_line_cut(const struct ts_line *line, struct ts_error *error, struct ts_arena *arena,
			   struct ts_words *out);

#endif
