/* Reads tables from files of all formats. */
#ifndef TS_SHEET_SHEET_READ_H
#define TS_SHEET_SHEET_READ_H

#include "sheet/sheet.h"

struct ts_pool;

/* Reads a file. A row that has not as many numbers as its table has columns is an error, in a log a line that is no
 * row. */
enum ts_status ts_sheets_read(struct ts_sheets *t, struct ts_files *files, struct ts_error *err,
			      struct ts_pool *pool, const char *path);

#endif
