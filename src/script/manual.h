/* Pages of the manual that are not of styles, and finding any page by a word. All come from the tables. */
#ifndef TS_SCRIPT_MANUAL_H
#define TS_SCRIPT_MANUAL_H

#include <stdbool.h>

#include "base/str.h"

struct ts_topic {
	const char *name, *summary;
	void (*page)(bool markdown, struct ts_str *out);
};
extern const struct ts_topic ts_topics[]; /* closed by .name NULL */

/* Whatever goes by the name: topic, kind, style, function, keyword ...; "KIND NAME" is one style, the kind also as
 * scripts say it ("pair_style gran"); else pages in whose text the words stand. false: there is nothing, and out
 * says so. */
bool ts_manual_find(const char *words, struct ts_str *out);
/* Pages on which the words stand, in whatever case; false: there are none, or no memory. */
bool ts_manual_search(const char *words, struct ts_str *out);
/* The page that lists all others. */
void ts_manual_index(struct ts_str *out);

/* Grammar files of editors. */
void ts_grammar_vim(struct ts_str *out);
void ts_grammar_textmate(struct ts_str *out);

#endif
