/* Search for pages of the manual by name or by words. The pages are generated from the tables. */
#ifndef TS_MANUAL_MANUAL_H
#define TS_MANUAL_MANUAL_H

#include <stdbool.h>

#include "base/str.h"
#include "core/tables.h"

/* Appends everything with this name: topic, kind, style, function, keyword ...; for "KIND NAME" the page of
 * that style, where the kind may also be written as in scripts ("pair_style gran"); for "doc/PAGE" and examples
 * that text; otherwise the best passages that contain the words. Returns false and appends a message if nothing is found. */
bool ts_manual_find(const struct ts_tables *tables, const char *words, struct ts_str *out);
/* Appends the best passages that contain the words, ignoring case and endings, and returns the number of
 * pages. If there are none it appends a message, with the most similar word of the text. */
size_t ts_manual_search(const struct ts_tables *tables, const char *words, struct ts_str *out);
/* Appends the index of all pages. */
void ts_manual_index(const struct ts_tables *tables, struct ts_str *out);

#endif
