/* The file of a series: "rock.*.restart" stands for the one with the largest number. */
#ifndef TS_IO_NEWEST_H
#define TS_IO_NEWEST_H

#include "base/str.h"

/* `*` is where the step stands, in the last part of the path only. Without `*` the path itself. `*out`
 * stays empty if there is no such file. */
void ts_newest_path(const char *pattern, struct ts_str *out);

#endif
