/* Search for pages of the manual by name or by words. The pages are generated from the tables. */
#ifndef TS_MANUAL_MANUAL_H
#define TS_MANUAL_MANUAL_H

#include <stdbool.h>

#include "base/str.h"
#include "core/tables.h"

/* Whatever goes by the name: topic, kind, style, function, keyword ...; "KIND NAME" is one style, the kind
 * also as scripts say it ("pair_style gran"); else pages in whose text the words stand. false: there is
 * nothing, and out says so. */
bool ts_manual_find(const struct ts_tables *tables, const char *words, struct ts_str *out);
/* Pages on which the words stand, in whatever case; false: there are none, or no memory. */
bool ts_manual_search(const struct ts_tables *tables, const char *words, struct ts_str *out);
/* The page that lists all others. */
void ts_manual_index(const struct ts_tables *tables, struct ts_str *out);

#endif
