/* Tables of comma-separated values (RFC 4180), for files whose name ends in .csv or .csv.gz: a line with the names
 * of the columns, then the rows. Numbers have as many digits as are needed to read the same ones. */
#ifndef TS_IO_CSV_H
#define TS_IO_CSV_H

#include "io/textfile.h"

bool ts_csv_is(const char *path);

/* Adds the text, in quotes if it has a comma, a quote, or a blank at an end. A line feed becomes a blank: a row is a
 * line. */
void ts_csv_add_cell(struct ts_str *out, const char *text);
/* Each adds a cell to the row at the end of the text. */
void ts_csv_text(struct ts_str *row, const char *text);
void ts_csv_real(struct ts_str *row, double value);
void ts_csv_int(struct ts_str *row, int64_t value);
/* Cells of several names. */
void ts_csv_names(struct ts_str *row, const char *const *name, size_t n);
/* Ends the row. */
void ts_csv_end(struct ts_str *row);

/* Begins a file that has just been opened: writes the names, or, if the file was opened to append to it and has some
 * text, checks that it begins with them. `names` is a row and is released. */
enum ts_status ts_csv_begin(struct ts_textfile *file, struct tsim *sim, struct ts_str *names);
/* Writes and flushes the rows and releases them. */
enum ts_status ts_csv_write(struct ts_textfile *file, struct tsim *sim, struct ts_str *rows);

#endif
