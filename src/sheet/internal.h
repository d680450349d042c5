/* For the readers of the formats. */
#ifndef TS_SHEET_INTERNAL_H
#define TS_SHEET_INTERNAL_H

#include "io/lines.h"
#include "sheet/sheet.h"

/* Names that may become those of columns. Zero-initialise. */
struct ts_sheet_names {
	const char **name;
	size_t n, capacity;
};

struct ts_sheet_reader {
	struct ts_sheets *sheets;
	struct ts_files *files;
	struct ts_error *err;
	struct ts_pool *pool;
	struct ts_lines lines; /* not of comma-separated values */
	const char *word; /* of the second line, which has as many as the first, and is no number; or NULL */
	size_t column;	  /* where it stands, from 1 */
};

/* Adds a name, copied. */
enum ts_status ts_sheet_add_name(struct ts_sheet_reader *r, struct ts_sheet_names *names, const char *name,
				 size_t bytes);
/* Begins a table without rows. A name that another column has already becomes NAME(2). names NULL: the columns are
 * called 1, 2 ... n. */
enum ts_status ts_sheet_begin(struct ts_sheet_reader *r, const struct ts_sheet_names *names, size_t n,
			      const char *title);
/* Adds a row to the last table: one cell for each of its columns. */
enum ts_status ts_sheet_add_row(struct ts_sheet_reader *r, const char *const *cell, int line);
/* Frees the values of a table. */
void ts_sheet_release(struct ts_sheet *table);
/* A number, or what stands for a missing one, which is NaN; false: another word. */
bool ts_sheet_number(const char *word, double *out);
/* Whether the line has words, all of them numbers. */
bool ts_sheet_is_row(const struct ts_lines *l);

/* Readers of files that are open at their beginning, and of a CSV file, which they open. */
enum ts_status ts_sheet_read_log(struct ts_sheet_reader *r);
enum ts_status ts_sheet_read_rows(struct ts_sheet_reader *r);
enum ts_status ts_sheet_read_csv(struct ts_sheet_reader *r);

#endif
