/* The text of the pages in doc/ and of the comments that examples begin with; generated when tsim is built. */
#ifndef TS_MANUAL_PAGE_TEXT_H
#define TS_MANUAL_PAGE_TEXT_H

/* A paragraph, list or table, or a part of a long one. */
struct ts_page_text {
	const char *page;    /* "doc/film", "examples/everyday/in.heap" */
	const char *title;   /* of the page */
	const char *heading; /* of the part of the page */
	const char *text;
};
extern const struct ts_page_text ts_page_texts[]; /* by pages, in their order; terminated by .page NULL */

#endif
