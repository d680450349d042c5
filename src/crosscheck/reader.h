/* What the readers of the kinds of files share. */
#ifndef TS_CROSSCHECK_READER_H
#define TS_CROSSCHECK_READER_H

#include "crosscheck/frame.h"

/* Adds a column; a second one of the same name becomes "name (2)". */
enum ts_status ts_reader_add_name(struct ts_reader *r, struct ts_frame *frame, const char *name);
enum ts_status ts_reader_damaged(struct ts_reader *r, const char *what);
/* reader_vtk.c: the next table of the open file. */
enum ts_status ts_reader_next_vtk(struct ts_reader *r, bool *got);

#endif
