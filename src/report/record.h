/* The record of a script while it runs, which its report is made of (page.h): what was run, rows of the log, results,
 * warnings, pictures, times. All of it is bounded, however long the run is. One for a simulation; it survives `clear`.
 *
 * Writing the page takes less than half a percent of the run: the next one is due after two hundred times the duration
 * of the last. */
#ifndef TS_REPORT_RECORD_H
#define TS_REPORT_RECORD_H

#include <time.h>

#include "core/plan.h"
#include "report/rows.h"

enum {
	TS_RECORD_TABLES = 12,
	TS_RECORD_COLUMNS = 40, /* of a table */
	TS_RECORD_RUNS = 60,
	TS_RECORD_LINES = 300, /* results, warnings, settings: each */
	TS_RECORD_LEDGERS = 4,
	TS_RECORD_VIEWS = 4,
	TS_RECORD_PICTURES = 12,   /* of a view, besides the first and the last */
	TS_RECORD_BYTES = 6000000, /* all pictures, as they are in the page */
	TS_RECORD_RENEW = 10	   /* s, between pages, if nothing else is said */
};

/* Lines of text; equal ones are counted. */
struct ts_record_line {
	const char *text;
	int64_t count;
};
struct ts_record_lines {
	struct ts_record_line line[TS_RECORD_LINES];
	size_t n;
	int64_t more; /* lines without a place */
};

struct ts_record_column {
	const char *title, *name, *help, *unit; /* help and unit: NULL: none */
	bool clock;				/* step, time, processor time ...: known, not plotted */
	bool integer;
};

/* Rows of the log with the same columns and steps that do not fall, of one or several runs. */
struct ts_record_table {
	struct ts_record_column *column; /* [n] */
	size_t n;
	struct ts_rows rows; /* over the time; a further column is the time step as a fraction of its limit */
	double *last;	     /* [n] numbers of the row added last */
	int64_t first_step, last_step;
	double first_time, last_time; /* [time] */
	size_t runs;
};

struct ts_record_run {
	int64_t first, last, goal;  /* steps */
	double time, dt;	    /* at its end; [time] */
	double wall;		    /* s */
	double part[TS_PLAN_PARTS]; /* s */
	size_t particles;
	double limit;	      /* the least stability limit at its start [time]; NaN: none */
	const char *limit_of; /* what limits, NULL: nothing */
};

/* Outputs of a fix energy/ledger after the last run in which it was. */
struct ts_record_ledger {
	const char *id;
	int64_t step;
	const char *const *name; /* [n] */
	double *value;		 /* [n] energy */
	size_t n;
};

struct ts_record_picture {
	int64_t step;
	double time; /* [time] */
	uint32_t width, height;
	char *data; /* PNG in base64 */
	size_t length;
};

/* Pictures with the same words. */
struct ts_record_view {
	struct ts_words words; /* of dump image, from the colour on */
	struct ts_words modify;
	int64_t every;	/* steps between pictures; 0: only the first and the last state */
	int64_t stride; /* only every so manieth of them is drawn: so their number is bounded */
	struct ts_place where;
	char id[16]; /* of its dump */
	struct ts_record_picture first, last, *picture;
	size_t n;
	bool automatic;	     /* nobody has asked for it: nothing to see is no picture */
	bool tried;	     /* its words have been checked in a run without a report */
	const char *trouble; /* why the last state could not be drawn; NULL: nothing */
	int64_t too_large;   /* pictures without a place */
};

enum ts_record_end { TS_RECORD_RUNNING, TS_RECORD_ENDED, TS_RECORD_FAILED, TS_RECORD_STOPPED };

struct ts_record {
	struct ts_recorder base;
	const char *file, *title; /* NULL: not given; without a file nothing is written */
	bool by_option;		  /* the file is that of the command line */
	struct ts_place where;
	double renew;	     /* least time between pages, s */
	const char *command; /* the command line; NULL: a program around the library */
	struct ts_arena arena;
	bool failed; /* out of memory */

	struct ts_record_lines results, warnings, settings;
	struct ts_str line; /* the unfinished line of the log */
	struct ts_record_table table[TS_RECORD_TABLES];
	size_t ntables;
	int64_t tables_left; /* tables without a place */
	bool left_out;	     /* the present one */
	struct ts_record_run run[TS_RECORD_RUNS];
	size_t nruns;
	int64_t runs, steps;	   /* of the script so far; steps of runs that have ended */
	struct ts_record_run rest; /* sums of runs without a place */
	double limit;
	const char *limit_of;
	struct ts_str plan; /* of the last run: what is modelled and what is not */
	struct ts_record_ledger ledger[TS_RECORD_LEDGERS];
	size_t nledgers;
	struct ts_record_view view[TS_RECORD_VIEWS];
	size_t nviews;
	bool no_pictures; /* `picture none` */

	/* times */
	time_t begun;
	double start;		    /* ts_clock() at the beginning, s */
	double due;		    /* ts_clock() at which the next page is due */
	int64_t countdown, checked; /* steps until the clock is read, and how many they were */
	double read;		    /* ts_clock() then */
	double cost;		    /* wall time spent on pages so far, s */
	double drawing;		    /* and on pictures, s */
	int64_t pages;
	bool warned; /* that a page could not be written */

	enum ts_record_end end;
	const char *message; /* of the error; NULL: none */
	struct ts_place error_at;
};

#define TS_REPORT_OPTION "-report" /* the file of the places of its words on the command line */

/* The record of the simulation; made if there is none. NULL: out of memory. */
struct ts_record *ts_record_of(struct tsim *sim);
/* The report is written to this file from now on. */
enum ts_status ts_record_open(struct ts_record *record, struct tsim *sim, const char *file,
			      const struct ts_place *where, bool by_option);
/* Words after `picture`: none, or N or ends, COLOR, DIAMETER, keywords of dump image, `modify` and those of dump_modify. */
enum ts_status ts_record_add_view(struct ts_record *record, struct tsim *sim, struct ts_words words,
				  const struct ts_place *where);
/* The script has ended in this way: draws the last state, writes the last page. */
enum ts_status ts_record_close(struct tsim *sim, enum ts_record_end end, const char *message);

/* ---- record_lines.c */

/* Adds a line, or counts it if it is there. */
void ts_record_line(struct ts_record *record, struct ts_record_lines *lines, const char *text);
/* The callback of struct ts_log. */
void ts_record_log(void *record, enum ts_log_level level, const char *text);

/* ---- record_rows.c: functions of struct ts_recorder */

void ts_record_row(struct ts_record *record, struct tsim *sim);
void ts_record_run(struct ts_record *record, struct tsim *sim, const struct ts_plan *plan);
void ts_record_plan(struct ts_record *record, struct tsim *sim, const struct ts_plan_report *plan);

/* ---- record_views.c */

/* Before a run: defines the dumps of the views. */
enum ts_status ts_record_views_begin(struct ts_record *record, struct tsim *sim);
/* Draws the last state of all views. */
void ts_record_views_end(struct ts_record *record, struct tsim *sim);
void ts_record_views_release(struct ts_record *record);

#endif
