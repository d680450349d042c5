/* The table of numbers in the log, and the progress line. */
#ifndef TS_THERMO_THERMO_H
#define TS_THERMO_THERMO_H

#include "core/ref_list.h"
#include "core/sim.h"
#include "group/temperature.h"
#include "io/format.h"
#include "io/textfile.h"

struct ts_thermo_column {
	const char *title;
	struct ts_ref_input input; /* resolved when a run begins */
	char format[TS_FORMAT_SIZE];
};

struct ts_thermo {
	int64_t every;	      /* 0: only the first and the last step */
	const char *variable; /* instead: says the step of the next row; NULL: none */
	int64_t next;
	bool multi;		   /* a row is a block of lines */
	struct ts_freedom freedom; /* of the keyword temp: compute_modify thermo_temp */
	bool norm, norm_default;   /* energies are divided by the number of particles */
	struct ts_thermo_column *column;
	size_t n;
	struct ts_arena arena; /* columns and their names */
	struct ts_formats formats;
	struct ts_textfile file; /* `thermo_log` */
	struct ts_str line;
	double progress_due, last_row_time; /* ts_clock(); seconds since the start of the run */
	int64_t last_row_step;
	int64_t counted; /* one more than the step of the last row that its interval asked for */
};

extern const struct ts_system_style ts_thermo_system;

/* Replaces the columns; formats are the defaults again. */
enum ts_status ts_thermo_columns(struct tsim *sim, struct ts_words names, bool multi);
/* What thermo_modify format says; see io/format.h. */
enum ts_status ts_thermo_format(struct tsim *sim, struct ts_words words);

/* The keywords of this system. */
extern const struct ts_keyword ts_thermo_keywords[];

#endif
