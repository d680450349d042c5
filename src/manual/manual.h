/* Search for pages of the manual by name or by words. The pages are generated from the tables. */
#ifndef TS_MANUAL_MANUAL_H
#define TS_MANUAL_MANUAL_H

#include <stdbool.h>

#include "base/str.h"
#include "core/tables.h"

/* Appends everything with this name: topic, kind, style, function, keyword ...; for "KIND NAME" the page of
 * that style, where the kind may also be written as in scripts ("pair_style gran"); otherwise the list of
 * pages that contain the words. Returns false and appends a message if nothing is found. */
bool ts_manual_find(const struct ts_tables *tables, const char *words, struct ts_str *out);
/* Appends the list of pages that contain the words, ignoring case; false if there are none, or no memory. */
bool ts_manual_search(const struct ts_tables *tables, const char *words, struct ts_str *out);
/* Appends the index of all pages. */
void ts_manual_index(const struct ts_tables *tables, struct ts_str *out);

#endif
