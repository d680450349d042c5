/* Thermo output: the table of numbers in the log, and the progress line. */
#ifndef TS_THERMO_THERMO_H
#define TS_THERMO_THERMO_H

#include "core/ref_list.h"
#include "core/sim.h"
#include "group/temperature.h"
#include "io/format.h"
#include "io/textfile.h"
#include "thermo/progress.h"

struct ts_thermo_column {
	const char *title;
	struct ts_ref_input input; /* resolved at the start of a run */
	double value;		   /* in the last row */
	char format[TS_FORMAT_SIZE];
};

struct ts_thermo {
	int64_t every;		   /* steps between rows; 0: only the first and the last step */
	const char *variable;	   /* `thermo v_NAME`: evaluates to the step of the next row; NULL: `every` */
	int64_t next;		   /* with `variable`: step of the next row */
	bool multi;		   /* a row is a block of lines */
	struct ts_freedom freedom; /* degrees of freedom of the keyword temp (compute_modify thermo_temp) */
	bool norm, norm_default;   /* energies are divided by the number of particles; set by `units` */
	struct ts_thermo_column *column; /* [n] */
	size_t n;
	struct ts_arena arena; /* of columns and their names */
	struct ts_formats formats;
	struct ts_textfile file; /* of thermo_log */
	bool csv;		 /* `file` is a table of comma-separated values */
	struct ts_str table;	 /* the names of its columns; "": not yet written */
	struct ts_str table_row; /* its current row */
	struct ts_str line;	 /* current row of the log */
	struct ts_progress progress;
	double last_row_time; /* of the last row, in seconds since the start of the run */
	int64_t last_row_step;
	int64_t counted; /* 1 + step of the last row due by `every` or `variable`; in restart files */
};

extern const struct ts_system_style ts_thermo_system;

/* Whether a row is due in this step of a run, by `thermo` or because the run ends. */
bool ts_thermo_is_due(const struct tsim *sim);

/* Replaces the columns and restores the default formats. */
enum ts_status ts_thermo_columns(struct tsim *sim, struct ts_words names, bool multi);
/* Sets formats from the arguments of thermo_modify format; see io/format.h. */
enum ts_status ts_thermo_format(struct tsim *sim, struct ts_words words);

/* Keywords of thermo output and formulas. */
extern const struct ts_keyword ts_thermo_keywords[];

#endif
