/* Output file of a fix ave/...: up to three title lines, then a block of lines for each average. */
#ifndef TS_AVERAGE_AVERAGE_FILE_H
#define TS_AVERAGE_AVERAGE_FILE_H

#include "core/report.h"
#include "core/sim.h"
#include "io/format.h"
#include "io/textfile.h"

struct ts_average_file {
	const char *file, *append, *title[3], *format;
	bool overwrite;
	struct ts_textfile out;
	struct ts_str text;	      /* the current block */
	char checked[TS_FORMAT_SIZE]; /* `format` after ts_format_check */
	bool csv;		      /* a table of comma-separated values: io/csv.h */
	bool blocks; /* otherwise a line with the step, then numbered ones; false: a row for each step */
};
#define TS_AVERAGE_FILE_ARGS(T, F)                                                                          \
	TS_WORD("file", T, F.file, .flags = TS_OPTIONAL | TS_WRITES,                                        \
		.help = "file to write; an existing one is replaced; a table of comma-separated values if " \
			"its name ends in .csv"),                                                           \
		TS_WORD("append", T, F.append, .flags = TS_OPTIONAL | TS_WRITES,                            \
			.help = "file to append to"),                                                       \
		TS_FLAG("overwrite", T, F.overwrite, .help = "the file holds only the last average"),       \
		TS_WORD("format", T, F.format, .fallback = "%g", .help = "format of a number in the file"), \
		TS_WORD("title1", T, F.title[0], .flags = TS_OPTIONAL, .help = "first line of the file"),   \
		TS_WORD("title2", T, F.title[1], .flags = TS_OPTIONAL, .help = "second line of the file"),  \
		TS_WORD("title3", T, F.title[2], .flags = TS_OPTIONAL, .help = "third line of the file")

/* Called by init: checks the arguments. */
enum ts_status ts_average_file_init(struct ts_instance *self, struct tsim *sim, struct ts_average_file *f);
bool ts_average_file_wanted(const struct ts_average_file *f);
/* Begins a block in f->text, opening the file if necessary. *titles: the file is new, and the caller adds
 * the title lines first with ts_average_file_title. */
enum ts_status ts_average_file_begin(struct ts_instance *self, struct tsim *sim, struct ts_average_file *f,
				     bool *titles);
/* Adds title line k (0, 1, 2): that of the keyword title1 ... title3, else `usual`. */
void ts_average_file_title(struct ts_average_file *f, int k, const char *usual);
/* Adds a blank and the number in the format of the keyword `format`; to a table a cell, with all digits unless a
 * format is given. */
void ts_average_file_number(struct ts_average_file *f, double value);
/* Adds a number with all digits to a table, else a blank and the number by %g. */
void ts_average_file_place(struct ts_average_file *f, double value);
/* After the names of the columns of a table have been added instead of titles. */
enum ts_status ts_average_file_names_done(struct tsim *sim, struct ts_average_file *f);
/* Writes the block. */
enum ts_status ts_average_file_end(struct tsim *sim, struct ts_average_file *f);
/* For the slot `plan`: the size of the file in a run, with a block of rows each `every` steps. */
enum ts_status ts_average_file_plan(const struct ts_average_file *f, struct tsim *sim, int64_t every,
				    size_t rows, size_t columns, struct ts_plan_report *report);
void ts_average_file_release(struct ts_average_file *f);

/* Order of TS_AVERAGE_FILE_ARGS in the manual pages, but for `file`, which is needed. */
#define TS_AVERAGE_FILE_GROUP                                              \
	{                                                                  \
		"The file", "append overwrite format title1 title2 title3" \
	}

#endif
