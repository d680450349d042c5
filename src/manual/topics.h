/* Pages of the manual on topics other than styles: functions, variables, keywords, quantities. */
#ifndef TS_MANUAL_TOPICS_H
#define TS_MANUAL_TOPICS_H

#include <stdbool.h>

#include "base/str.h"
#include "core/tables.h"

struct ts_topic {
	const char *name, *summary;
	void (*page)(const struct ts_tables *tables, bool markdown, struct ts_str *out);
};
extern const struct ts_topic ts_topics[]; /* terminated by .name NULL */

/* Appends an entry "name(arguments)  help (unit)"; arguments and unit may be NULL. */
void ts_topic_entry(const char *name, const char *arguments, const char *help, const char *unit,
		    bool markdown, struct ts_str *out);

#endif
