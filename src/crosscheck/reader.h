/* Reads output files frame by frame; and the functions that the readers of the formats share. */
#ifndef TS_CROSSCHECK_READER_H
#define TS_CROSSCHECK_READER_H

#include "crosscheck/frame.h"

/* Zero-initialise, and set the inputs. The files are read one after the other. */
struct ts_reader {
	enum ts_frame_kind kind;
	struct ts_error *err;
	struct ts_pool *pool;
	const struct ts_meanings *meanings; /* NULL: no information on the columns */
	const char *folder;
	const char *const *file; /* NULL-terminated */
	struct ts_frame frame;
	/* state of the readers */
	struct ts_lines lines;
	bool open, table;      /* a file is open; within a table */
	struct ts_frame title; /* the line or comment above, which may contain the names of columns */
	struct ts_frame inner; /* the same, of the last comment */
	int64_t line;
	size_t at, data_rows; /* VTK: index of the next word of the line; number of rows of the next array */
};
enum ts_status ts_reader_open(struct ts_reader *reader);
/* Reads the next frame; *got is false after the last one. */
enum ts_status ts_reader_next(struct ts_reader *reader, bool *got);
void ts_reader_close(struct ts_reader *reader);

/* ---- for the readers of the formats */

/* Adds a column; a second one with the same name is called "name (2)". */
enum ts_status ts_reader_add_name(struct ts_reader *r, struct ts_frame *frame, const char *name);
enum ts_status ts_reader_damaged(struct ts_reader *r, const char *what);
/* Reads the next table of the open VTK file. */
enum ts_status ts_reader_next_vtk(struct ts_reader *r, bool *got);

#endif
