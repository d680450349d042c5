/* Tables of numbers in text files:
 *   logs of tsim, LIGGGHTS and LAMMPS: the thermo tables, one of each run, also `thermo_modify line multi`;
 *   files of fix ave/time, ave/histo, ave/chunk, ave/correlate, print, and other rows of numbers, the names of whose
 *   columns stand in the comment or the line above; blocks of rows are tables of their own;
 *   comma-separated values with names in the first line.
 * Files may be compressed (.gz), except for comma-separated values. */
#ifndef TS_SHEET_SHEET_H
#define TS_SHEET_SHEET_H

#include "base/files.h"
#include "base/status.h"

struct ts_sheet_column {
	const char *name;  /* unique in the table */
	double *value;	   /* [rows]; NaN: no number was given: nan, inf, -, NA, ? or an empty cell */
	const char **cell; /* [rows]: as they were written; NULL unless values are separated by commas */
	size_t capacity, cell_capacity;
	const char *text; /* first cell that is another word; NULL: none */
	int text_line;	  /* its line */
};

struct ts_sheet {
	const char *title; /* "run 2", "step 500"; "": the only table */
	struct ts_sheet_column *column;
	size_t columns, rows;
};

enum ts_sheet_kind { TS_SHEET_LOG, TS_SHEET_ROWS, TS_SHEET_BLOCKS, TS_SHEET_CSV };

/* Zero-initialise. */
struct ts_sheets {
	struct ts_arena arena;
	const char *path;
	enum ts_sheet_kind kind;
	struct ts_sheet *sheet; /* [n]; n >= 1 after reading */
	size_t n, capacity;
	int torn; /* line of a last row that is not complete, and left out; 0: none */
};

void ts_sheets_release(struct ts_sheets *t);

/* Index of a column by its name, or by its number from 1 if no column has that name; SIZE_MAX: there is none. */
size_t ts_sheet_find(const struct ts_sheet *table, const char *name);
/* Whether all columns have the same names. */
bool ts_sheet_alike(const struct ts_sheet *a, const struct ts_sheet *b);

#endif
