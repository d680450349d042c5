/* What the readers of the kinds of files share. */
#ifndef TS_CROSSCHECK_READER_H
#define TS_CROSSCHECK_READER_H

#include "crosscheck/frame.h"

/* Zero-initialise. Reads the files one after the other. */
struct ts_reader {
	enum ts_frame_kind kind;
	struct ts_error *err;
	struct ts_pool *pool;
	const struct ts_meanings *meanings; /* NULL: nothing is known of the columns */
	const char *folder;
	const char *const *file; /* closed by NULL */
	struct ts_frame frame;
	/* the rest is for the readers */
	struct ts_lines lines;
	bool open, table;      /* a file; a table in it */
	struct ts_frame title; /* the words above, which may be names */
	struct ts_frame inner; /* the same, of the last comment */
	int64_t line;
	size_t at, data_rows; /* VTK: the next word of the line; rows of the next array */
};
enum ts_status ts_reader_open(struct ts_reader *reader);
/* The next frame; *got is false after the last. */
enum ts_status ts_reader_next(struct ts_reader *reader, bool *got);
void ts_reader_close(struct ts_reader *reader);

/* ---- for the readers of the formats */

/* Adds a column; a second one of the same name becomes "name (2)". */
enum ts_status ts_reader_add_name(struct ts_reader *r, struct ts_frame *frame, const char *name);
enum ts_status ts_reader_damaged(struct ts_reader *r, const char *what);
/* reader_vtk.c: the next table of the open file. */
enum ts_status ts_reader_next_vtk(struct ts_reader *r, bool *got);

#endif
