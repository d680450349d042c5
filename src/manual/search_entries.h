/* Tasks of doc/how-to.md and terms of doc/glossary.md as an index: words of the reader beside the pages for them. */
#ifndef TS_MANUAL_SEARCH_ENTRIES_H
#define TS_MANUAL_SEARCH_ENTRIES_H

#include <stddef.h>

#include "manual/search_query.h"
#include "manual/search_text.h"

/* How well the entries that name the page agree with the query, 0 to 1; rarity is the weight of each word. */
double ts_search_entry_value(const struct ts_search_text *text, const struct ts_query *query,
			     const double *rarity, size_t page);

#endif
