/* The page of a record: one HTML file with its style sheet, plots and pictures in it, which needs no network. */
#ifndef TS_REPORT_PAGE_H
#define TS_REPORT_PAGE_H

#include "report/record.h"

/* A page in the making. */
struct ts_page {
	const struct ts_record *record;
	struct tsim *sim;
	struct ts_str out;
	double now; /* ts_clock(), s */
};

/* Writes the page in place of the one before. */
enum ts_status ts_page_write(const struct ts_record *record, struct tsim *sim);

/* Appends the style sheet. */
void ts_page_style(struct ts_str *out);

/* ---- page_text.c */

/* Appends a text with <, >, &, quotes replaced; bytes that HTML does not permit become `?`. */
void ts_page_text(struct ts_str *out, const char *text);
void ts_page_text_n(struct ts_str *out, const char *text, size_t n);
/* Begins a section with this id and heading; ts_page_end_section ends it. */
void ts_page_section(struct ts_str *out, const char *id, const char *title);
void ts_page_end_section(struct ts_str *out);
/* Appends a number with at most six digits; "-" if it is not finite. */
void ts_page_number(struct ts_str *out, double value);
/* Appends a duration (s) as "1.2 s", "3 min 5 s" ... */
void ts_page_duration(struct ts_str *out, double seconds);
/* Unit of the time in the units of the script; NULL: none. */
const char *ts_page_time_unit(const struct tsim *sim);

/* ---- sections */

void ts_page_head(struct ts_page *page);     /* page_head.c: title, how it ended, the main numbers */
void ts_page_results(struct ts_page *page);  /* page_head.c */
void ts_page_warnings(struct ts_page *page); /* page_head.c */
void ts_page_pictures(struct ts_page *page); /* page_pictures.c */
void ts_page_tables(struct ts_page *page);   /* page_tables.c */
void ts_page_limits(struct ts_page *page);   /* page_tables.c */
void ts_page_ledgers(struct ts_page *page);  /* page_times.c */
void ts_page_times(struct ts_page *page);    /* page_times.c */
void ts_page_script(struct ts_page *page);   /* page_script.c: what was run */

#endif
