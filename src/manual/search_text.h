/* What a search reads: pages of styles and topics, pages of doc/, comments of examples; cut into passages. */
#ifndef TS_MANUAL_SEARCH_TEXT_H
#define TS_MANUAL_SEARCH_TEXT_H

#include <stdbool.h>
#include <stddef.h>

#include "base/str.h"
#include "core/tables.h"

struct ts_search_page {
	struct ts_str command;	   /* arguments of `tsim -help` that print the page */
	struct ts_str title;	   /* in small letters */
	const char *shown;	   /* the title of a page of doc/ or of an example; NULL for others */
	struct ts_str text, small; /* of all passages, as it is and in small letters */
};

struct ts_search_passage {
	size_t page, begin, length; /* in the text of the page */
	const char *heading;	    /* or "" */
	bool example;		    /* lines of the example of a style, or its line of related styles */
};

struct ts_search_text {
	struct ts_search_page *page;
	struct ts_search_passage *passage;
	size_t pages, passages, page_capacity, passage_capacity;
	bool failed; /* out of memory */
};

void ts_search_text_make(const struct ts_tables *tables, struct ts_search_text *out);
void ts_search_text_release(struct ts_search_text *text);

#endif
