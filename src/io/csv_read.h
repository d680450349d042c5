/* Reads files of comma-separated values: RFC 4180, but a cell does not extend over lines. */
#ifndef TS_IO_CSV_READ_H
#define TS_IO_CSV_READ_H

#include "base/files.h"
#include "base/status.h"

/* Zero-initialise. */
struct ts_csv {
	struct ts_error *err;
	struct ts_place where; /* file, and number of the current line */
	const char **cell;     /* [cells]: of the current line, without quotes */
	size_t cells;
	/* for the reader */
	struct ts_str text;
	char *at, *line; /* next cell, NULL: end of the line; next line */
	size_t capacity;
};

/* Reads the file into memory; `path` must live as long as messages about it. */
enum ts_status ts_csv_open(struct ts_csv *csv, struct ts_files *files, struct ts_error *err,
			   const char *path);
/* Splits the next line that is not empty; *more is false at the end. */
enum ts_status ts_csv_next(struct ts_csv *csv, bool *more);
void ts_csv_close(struct ts_csv *csv);

#endif
